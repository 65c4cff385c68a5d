//! Largest plastic strain beneath each point of the surface, and its maximum off the axis.

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
    let mut columns: Vec<Column> = top
        .reference_position
        .iter()
        .map(|x| Column {
            r: x[0],
            plastic_strain: 0.0,
        })
        .collect();
    for (x, &strain) in solid
        .reference
        .position
        .iter()
        .zip(&solid.state.plastic_strain)
    {
        let after = columns.partition_point(|c| c.r < x[0]);
        let nearest = match after {
            0 => 0,
            k if k == columns.len() || x[0] - columns[k - 1].r <= columns[k].r - x[0] => k - 1,
            k => k,
        };
        let column = &mut columns[nearest];
        column.plastic_strain = column.plastic_strain.max(strain);
    }
    columns
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
