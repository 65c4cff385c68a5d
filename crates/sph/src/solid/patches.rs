//! Compact patches of eight particles: the clusters of a solid.

use crate::simd::LANES;

/// Particles above which two halves are ordered by two threads; results do not depend on it.
const PARALLEL: usize = 4096;

/// All particles in patches of [`LANES`], patch after patch; neighbours of each other stand in the order where they can be. Each
/// is ascending within its patch, and only the last patch may have fewer.
///
/// The body is halved along its longest side until eight are left.
pub(super) fn order<const D: usize>(position: &[[f64; D]]) -> Vec<u32> {
    let mut order: Vec<u32> = (0..position.len() as u32).collect();
    halve(position, &mut order);
    order
}

fn halve<const D: usize>(position: &[[f64; D]], order: &mut [u32]) {
    if order.len() <= LANES {
        return order.sort_unstable();
    }
    let k = longest_side(position, order);
    let half = (order.len() / 2).div_ceil(LANES) * LANES;
    order.select_nth_unstable_by(half, |&a, &b| {
        let at = |i: u32| position[i as usize][k];
        at(a).total_cmp(&at(b)).then(a.cmp(&b))
    });
    let (first, second) = order.split_at_mut(half);
    if second.len() < PARALLEL {
        halve(position, first);
        halve(position, second);
    } else {
        rayon::join(|| halve(position, first), || halve(position, second));
    }
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
        assert_eq!(mean_box([16, 16, 16]), 8.0);
    }
}
