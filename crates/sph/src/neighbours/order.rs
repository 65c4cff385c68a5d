//! The order of particles in which each eight that follow each other lie close together.
//!
//! Particles are halved across the longest side of the box around them, the halves again, down to [`LANES`]. The first part
//! always has a power of two of clusters, so that 8, 64, 512 ... clusters that follow each other are compact as well. No
//! spacing enters: graded and uniform particles are the same.

use crate::simd::LANES;
use std::cmp::Ordering;

/// Parts with fewer particles are not given to other threads.
const SERIAL: usize = 2048;

struct Point<const D: usize> {
    position: [f64; D],
    index: u32,
}

/// The order: place i is taken by particle `order[i]`. It depends on the positions alone, except for coincident ones.
pub fn compact_order<const D: usize>(position: &[[f64; D]]) -> Vec<u32> {
    let point = |(i, x): (usize, &[f64; D])| Point {
        position: *x,
        index: i as u32,
    };
    let mut points: Vec<Point<D>> = position.iter().enumerate().map(point).collect();
    halve(&mut points);
    points.iter().map(|p| p.index).collect()
}

fn halve<const D: usize>(points: &mut [Point<D>]) {
    if points.len() <= LANES {
        points.sort_unstable_by_key(|p| p.index);
        return;
    }
    let clusters = points.len().div_ceil(LANES);
    let first = clusters.next_power_of_two() / 2 * LANES;
    let k = longest_side(points);
    points.select_nth_unstable_by(first, |p, q| {
        // Along the side first, then along the others.
        let mut order = Ordering::Equal;
        for i in 0..D {
            let axis = (k + i) % D;
            order = order.then_with(|| p.position[axis].total_cmp(&q.position[axis]));
        }
        order.then_with(|| p.index.cmp(&q.index))
    });
    let serial = points.len() < SERIAL;
    let (left, right) = points.split_at_mut(first);
    if serial {
        halve(left);
        halve(right);
    } else {
        rayon::join(|| halve(left), || halve(right));
    }
}

/// The coordinate along which the points reach farthest.
fn longest_side<const D: usize>(points: &[Point<D>]) -> usize {
    let (mut lower, mut upper) = ([f64::INFINITY; D], [f64::NEG_INFINITY; D]);
    for p in points {
        for k in 0..D {
            lower[k] = lower[k].min(p.position[k]);
            upper[k] = upper[k].max(p.position[k]);
        }
    }
    let mut longest = 0;
    for k in 1..D {
        if upper[k] - lower[k] > upper[longest] - lower[longest] {
            longest = k;
        }
    }
    longest
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Vec2;

    #[test]
    fn clusters_of_a_lattice_are_compact() {
        let lattice: Vec<Vec2> = (0..4096)
            .map(|i| [f64::from(i % 64), f64::from(i / 64)])
            .collect();
        let order = compact_order(&lattice);
        let mut seen = order.clone();
        seen.sort_unstable();
        assert!(
            seen.iter().enumerate().all(|(i, s)| i as u32 == *s),
            "a permutation"
        );
        for cluster in order.chunks(LANES) {
            let extent = |k: usize| {
                let all = || cluster.iter().map(|&i| lattice[i as usize][k]);
                all().fold(0.0, f64::max) - all().fold(f64::INFINITY, f64::min)
            };
            // Blocks of 2 x 4.
            assert_eq!(extent(0).min(extent(1)), 1.0);
            assert_eq!(extent(0).max(extent(1)), 3.0);
        }
    }

    #[test]
    fn clusters_in_space_are_cubes() {
        let lattice: Vec<[f64; 3]> = (0..4096)
            .map(|i| [i % 16, i / 16 % 16, i / 256].map(f64::from))
            .collect();
        for cluster in compact_order(&lattice).chunks(LANES) {
            for k in 0..3 {
                let all = || cluster.iter().map(|&i| lattice[i as usize][k]);
                let extent = all().fold(0.0, f64::max) - all().fold(f64::INFINITY, f64::min);
                assert_eq!(extent, 1.0);
            }
        }
    }

    #[test]
    fn the_present_order_does_not_matter() {
        let x: Vec<Vec2> = (0..777)
            .map(|i| [f64::from(i * 37 % 101), f64::from(i * i % 97)])
            .collect();
        let mirrored: Vec<Vec2> = x.iter().rev().copied().collect();
        let (one, other) = (compact_order(&x), compact_order(&mirrored));
        let clusters = |order: &[u32], x: &[Vec2]| -> Vec<Vec<Vec2>> {
            let places = order.iter().map(|&i| x[i as usize]).collect::<Vec<_>>();
            let sorted = |c: &[Vec2]| {
                let mut c = c.to_vec();
                c.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
                c
            };
            places.chunks(LANES).map(sorted).collect()
        };
        assert_eq!(clusters(&one, &x), clusters(&other, &mirrored));
        assert!(compact_order::<2>(&[]).is_empty());
    }
}
