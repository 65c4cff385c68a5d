//! What a user needs to see when a run fails: the particles around the place.

use super::error::OutputError;
use super::vtu::{Encoding, Snapshot};
use std::path::Path;

/// Writes the particles of `snapshot` within `radius` (m) of `place` (m) to `path`; returns how many. A particle whose
/// place is not a number cannot be said to be outside, so it is written; if `place` is none, all are.
///
/// # Errors
/// [`OutputError::Write`], [`OutputError::Content`] as [`Snapshot::write`].
pub fn write_failure(
    path: &Path,
    snapshot: &Snapshot,
    place: [f64; 3],
    radius: f64,
) -> Result<usize, OutputError> {
    let outside = |point: &[f64; 3]| {
        let square: f64 = point
            .iter()
            .zip(place)
            .map(|(a, b)| (a - b) * (a - b))
            .sum();
        square > radius * radius
    };
    let near: Vec<usize> = (0..snapshot.points.len())
        .filter(|&particle| !outside(&snapshot.points[particle]))
        .collect();
    snapshot.select(&near)?.write(path, Encoding::Raw)?;
    Ok(near.len())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::vtu::{Data, Field};

    #[test]
    fn writes_the_particles_around_the_place() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("failure.vtu");
        let positions: Vec<[f64; 2]> = (0..10)
            .map(|i| [f64::from(i), if i == 8 { f64::NAN } else { 0.0 }])
            .collect();
        let numbers = Field::scalar("index", "-", Data::I64((0..10).collect()));
        let snapshot = Snapshot::new(2.0, &positions).with(numbers);
        assert_eq!(
            write_failure(&path, &snapshot, [3.0, 0.0, 0.0], 1.5).unwrap(),
            4
        );
        let read = Snapshot::read(&path).unwrap();
        assert_eq!(
            read.field("index").unwrap().data,
            Data::I64(vec![2, 3, 4, 8])
        );
        assert_eq!(
            write_failure(&path, &snapshot, [f64::NAN; 3], 1.5).unwrap(),
            10
        );
    }
}
