//! Where the ring of void that a jet leaves behind collapses.

/// The ring at its last sight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Toroid {
    /// When, s.
    pub time: f64,
    /// Distance of its centroid from the axis, m.
    pub r: f64,
    /// Height of its centroid above the wall, m.
    pub z: f64,
}

/// The last row in which a ring is seen: `inner_radius` of the largest void is positive for a ring, zero for a void on the
/// axis and not a number without a void. `centre` is that of the largest void. All in m, one entry per row of `time` (s).
#[must_use]
pub fn last_toroid(time: &[f64], inner_radius: &[f64], centre: [&[f64]; 2]) -> Option<Toroid> {
    let k = (0..time.len()).rev().find(|k| inner_radius[*k] > 0.0)?;
    Some(Toroid {
        time: time[k],
        r: centre[0][k],
        z: centre[1][k],
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_ring_counts() {
        let nan = f64::NAN;
        let inner = [0.0, 0.0, 2e-5, 3e-5, nan];
        let (r, z) = ([0.0, 0.0, 4e-5, 5e-5, nan], [1e-4, 1e-4, 5e-5, 4e-5, nan]);
        let time = [0.0, 1.0, 2.0, 3.0, 4.0];
        let found = last_toroid(&time, &inner, [&r, &z]).unwrap();
        assert_eq!((found.time, found.r, found.z), (3.0, 5e-5, 4e-5));
        assert_eq!(last_toroid(&time[..2], &inner, [&r, &z]), None);
    }
}
