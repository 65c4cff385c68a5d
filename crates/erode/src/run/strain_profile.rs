//! Largest plastic strain beneath each point of the surface, and its maximum off the axis.

use crate::analysis::largest_in_column;
use erode_sph::solid::{Side, Solid};

/// A maximum counts when it rises above the lowest value between it and the axis by this share of itself: more than the
/// scatter from column to column (about 1 %).
const PROMINENCE: f64 = 0.03;

/// One column of metal beneath a point of the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Column {
    /// Distance of the point from the axis in the reference configuration, m.
    pub r: f64,
    /// Largest plastic strain beneath it.
    pub plastic_strain: f64,
}

/// Columns from the axis outwards; none without an upper face.
#[must_use]
pub fn columns(solid: &Solid) -> Vec<Column> {
    let Some(top) = solid.surface(Side::Top) else {
        return Vec::new();
    };
    let radii: Vec<f64> = top.reference_position.iter().map(|x| x[0]).collect();
    let (position, strain) = (&solid.reference.position, &solid.state.plastic_strain);
    let largest = largest_in_column(position, strain, &radii).into_iter();
    let column = |(r, plastic_strain)| Column { r, plastic_strain };
    radii.into_iter().zip(largest).map(column).collect()
}

/// The largest plastic strain that is separated from the axis by lower values, each column averaged with its two
/// neighbours; none when the strain only falls from the axis outwards.
#[must_use]
pub fn off_axis_maximum(columns: &[Column]) -> Option<Column> {
    let mut dip = f64::INFINITY;
    let mut best: Option<Column> = None;
    for k in columns.windows(3) {
        let mean = k.iter().map(|c| c.plastic_strain).sum::<f64>() / 3.0;
        if mean - dip > PROMINENCE * mean && best.is_none_or(|b| mean > b.plastic_strain) {
            best = Some(Column {
                r: k[1].r,
                plastic_strain: mean,
            });
        }
        dip = dip.min(mean);
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    fn profile(strain: impl Fn(f64) -> f64) -> Vec<Column> {
        (0..100)
            .map(|i| (f64::from(i) + 0.5) * 2e-6)
            .map(|r| Column {
                r,
                plastic_strain: strain(r),
            })
            .collect()
    }

    #[test]
    fn a_ring_is_found_beside_a_higher_centre() {
        let bell = |r: f64, at: f64, width: f64| (-((r - at) / width).powi(2)).exp();
        let found = off_axis_maximum(&profile(|r| {
            2e-3 * bell(r, 0.0, 3e-5) + 1.5e-3 * bell(r, 1.2e-4, 3e-5)
        }))
        .unwrap();
        assert!((found.r - 1.2e-4).abs() <= 2e-6);
        assert!((found.plastic_strain / 1.5e-3 - 1.0).abs() < 0.01);
    }

    #[test]
    fn a_single_centre_has_none() {
        assert_eq!(
            off_axis_maximum(&profile(|r| 1e-3 * (-(r / 5e-5).powi(2)).exp())),
            None
        );
        assert_eq!(off_axis_maximum(&profile(|_| 0.0)), None);
        assert_eq!(off_axis_maximum(&[]), None);
    }
}
