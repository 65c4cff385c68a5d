//! Number of particles before they are made.

use super::{PackingError, Spacing};
use crate::geometry::Vec2;
use crate::shapes::Region;

/// Cells across the core in the sum of [`estimate_count`].
const CORE_CELLS: u32 = 128;
/// Cell size outside the core per distance from it.
const CELL_GROWTH: f64 = 0.05;

/// About how many particles [`super::pack`] makes: the integral of dA/s^2, to about 1 %; with `axis` only over r > 0.
#[must_use]
pub fn estimate_count(region: &Region, spacing: &Spacing, axis: bool) -> f64 {
    let (mut lower, upper) = region.bounding_box();
    if axis {
        lower[0] = lower[0].max(0.0);
    }
    let (core_lower, core_upper) = spacing
        .core
        .as_ref()
        .map_or((lower, upper), |core| core.bounding_box());
    let cuts = [0, 1].map(|k| cuts(lower[k], upper[k], core_lower[k], core_upper[k]));
    let mut count = 0.0;
    for y in cuts[1].windows(2) {
        for x in cuts[0].windows(2) {
            let middle: Vec2 = [0.5 * (x[0] + x[1]), 0.5 * (y[0] + y[1])];
            if region.contains(middle) {
                count += (x[1] - x[0]) * (y[1] - y[0]) / spacing.at(middle).powi(2);
            }
        }
    }
    count
}

/// Edges of intervals from `lower` to `upper`: equal inside the core, growing outside.
fn cuts(lower: f64, upper: f64, core_lower: f64, core_upper: f64) -> Vec<f64> {
    let from = core_lower.clamp(lower, upper);
    let to = core_upper.clamp(lower, upper);
    let width = if to > from { to - from } else { upper - lower };
    let fine = width / f64::from(CORE_CELLS);
    let mut below = outwards(from - lower, fine);
    below.reverse();
    let mut edges: Vec<f64> = below.into_iter().map(|d| from - d).collect();
    if to > from {
        edges.extend((0..=CORE_CELLS).map(|i| from + f64::from(i) * fine));
    } else {
        edges.push(from);
    }
    edges.extend(outwards(upper - to, fine).into_iter().map(|d| to + d));
    edges
}

/// Distances of the edges beyond the first one, the last at `extent`.
fn outwards(extent: f64, fine: f64) -> Vec<f64> {
    let mut edges = Vec::new();
    let mut d = 0.0;
    while d < extent {
        d += fine.max(CELL_GROWTH * d);
        edges.push(d.min(extent));
    }
    edges
}

pub(super) fn check_count(
    region: &Region,
    spacing: &Spacing,
    axis: bool,
) -> Result<(), PackingError> {
    let count = estimate_count(region, spacing, axis);
    if count < 4e9 {
        return Ok(());
    }
    Err(PackingError::TooMany { count })
}
