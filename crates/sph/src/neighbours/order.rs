//! The order of particles in which each eight that follow each other lie close together.
//!
//! Particles are halved across the longer side of the box around them, the halves again, down to [`LANES`]. The first part
//! always has a power of two of clusters, so that 8, 64, 512 ... clusters that follow each other are compact as well. No
//! spacing enters: graded and uniform particles are the same.

use crate::geometry::Vec2;
use crate::simd::LANES;

/// Parts with fewer particles are not given to other threads.
const SERIAL: usize = 2048;

struct Point {
    position: Vec2,
    index: u32,
}

/// The order: place i is taken by particle `order[i]`. It depends on the positions alone, except for coincident ones.
pub(crate) fn compact_order(position: &[Vec2]) -> Vec<u32> {
    let point = |(i, x): (usize, &Vec2)| Point {
        position: *x,
        index: i as u32,
    };
    let mut points: Vec<Point> = position.iter().enumerate().map(point).collect();
    halve(&mut points);
    points.iter().map(|p| p.index).collect()
}

fn halve(points: &mut [Point]) {
    if points.len() <= LANES {
        points.sort_unstable_by_key(|p| p.index);
        return;
    }
    let clusters = points.len().div_ceil(LANES);
    let first = clusters.next_power_of_two() / 2 * LANES;
    let k = longer_side(points);
    points.select_nth_unstable_by(first, |p, q| {
        let along = p.position[k].total_cmp(&q.position[k]);
        let across = || p.position[1 - k].total_cmp(&q.position[1 - k]);
        along.then_with(across).then_with(|| p.index.cmp(&q.index))
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

/// The coordinate along which the points reach farther.
fn longer_side(points: &[Point]) -> usize {
    let (mut lower, mut upper) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for p in points {
        for k in 0..2 {
            lower[k] = lower[k].min(p.position[k]);
            upper[k] = upper[k].max(p.position[k]);
        }
    }
    usize::from(upper[1] - lower[1] > upper[0] - lower[0])
}

#[cfg(test)]
mod tests {
    use super::*;

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
        assert!(compact_order(&[]).is_empty());
    }
}
