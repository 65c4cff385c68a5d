//! Compact patches of eight particles: the clusters of a solid.
//!
//! The body is cut across its longest side until eight are left, each time at the widest gap between particles in the middle third: on
//! a lattice that is between two of its planes, so that patches are cubes or squares where the numbers allow it.

use crate::simd::LANES;
use std::cmp::Reverse;

/// Particles above which two parts are ordered by two threads; results do not depend on it.
const PARALLEL: usize = 4096;
/// Gaps narrower than the widest by less than this share count as equal.
const EQUAL: f64 = 1e-6;

/// All particles in patches of [`LANES`], patch after patch; neighbours of each other stand in the order where they can be. Each
/// is ascending within its patch, and only the last patch may have fewer.
pub(super) fn order<const D: usize>(position: &[[f64; D]]) -> Vec<u32> {
    let mut order: Vec<u32> = (0..position.len() as u32).collect();
    cut(position, &mut order);
    order
}

fn cut<const D: usize>(position: &[[f64; D]], order: &mut [u32]) {
    if order.len() <= LANES {
        return order.sort_unstable();
    }
    let k = longest_side(position, order);
    let place = widest_gap(order, |a| position[a as usize][k]);
    let (first, second) = order.split_at_mut(place);
    if second.len() < PARALLEL {
        cut(position, first);
        cut(position, second);
    } else {
        rayon::join(|| cut(position, first), || cut(position, second));
    }
}

/// Orders particles about the place of their widest gap among the multiples of [`LANES`] in the middle third, and returns it.
fn widest_gap(order: &mut [u32], at: impl Fn(u32) -> f64) -> usize {
    let n = order.len();
    let ascending = |a: &u32, b: &u32| at(*a).total_cmp(&at(*b)).then(a.cmp(b));
    let middle = (n / 2).div_ceil(LANES) * LANES;
    let first = (n / 3).next_multiple_of(LANES).clamp(LANES, middle);
    let last = (2 * n / 3 / LANES * LANES).max(middle);
    // Only the window has to be in full order.
    order.select_nth_unstable_by(first - 1, ascending);
    let rest = &mut order[first - 1..];
    let end = (last + 1 - (first - 1)).min(rest.len());
    if end < rest.len() {
        rest.select_nth_unstable_by(end - 1, ascending);
    }
    rest[..end].sort_unstable_by(ascending);
    let gap = |place: usize| at(order[place]) - at(order[place - 1]);
    let places = || (first..=last).step_by(LANES);
    let widest = places().map(gap).fold(0.0, f64::max);
    let wide = places().filter(|&p| gap(p) >= widest * (1.0 - EQUAL));
    // An odd number of planes of a lattice could not be cut into cubes any more.
    let preference = |p: &usize| (Reverse(p.trailing_zeros()), p.abs_diff(middle));
    wide.min_by_key(preference).unwrap_or(middle)
}

/// Coordinate in which these particles extend the farthest; the first of several.
fn longest_side<const D: usize>(position: &[[f64; D]], order: &[u32]) -> usize {
    let (mut low, mut high) = ([f64::INFINITY; D], [f64::NEG_INFINITY; D]);
    for &a in order {
        for k in 0..D {
            let x = position[a as usize][k];
            (low[k], high[k]) = (low[k].min(x), high[k].max(x));
        }
    }
    let extent = |k: usize| high[k] - low[k];
    (1..D).fold(0, |best, k| if extent(k) > extent(best) { k } else { best })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Mean volume of the boxes around the patches of a lattice of unit cells, the cells included.
    fn mean_box<const D: usize>(size: [usize; D]) -> f64 {
        let n: usize = size.iter().product();
        let place = |mut k: usize| -> [f64; D] {
            size.map(|s| {
                let x = k % s;
                k /= s;
                x as f64
            })
        };
        let position: Vec<[f64; D]> = (0..n).map(place).collect();
        let order = order(&position);
        let mut seen = order.clone();
        seen.sort_unstable();
        assert_eq!(seen, (0..n as u32).collect::<Vec<_>>());
        let volume = |patch: &[u32]| -> f64 {
            let extent = |k: usize| {
                let at = patch.iter().map(|&a| position[a as usize][k]);
                at.clone().fold(0.0, f64::max) - at.fold(f64::INFINITY, f64::min)
            };
            (0..D).map(|k| extent(k) + 1.0).product()
        };
        let patches = order.chunks(LANES);
        patches.clone().map(volume).sum::<f64>() / patches.len() as f64
    }

    #[test]
    fn patches_hold_every_particle_once_and_are_compact() {
        // Eight cells fill eight units; odd sizes leave gaps in some boxes.
        let (plane, space) = (mean_box([37, 29]), mean_box([23, 19, 29]));
        assert!(plane < 13.0 && space < 18.0, "{plane} {space}");
        // Even numbers allow cubes and squares everywhere, odd ones only inside.
        assert_eq!(mean_box([46, 22, 30]), 8.0);
        assert_eq!(mean_box([40, 62]), 8.0);
    }
}
