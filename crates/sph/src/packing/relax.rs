//! Relaxation of the graded part, and areas for which a uniform pressure is at rest.
//!
//! Shifting: dx_a = -K s_a^2 sum_b A_b (1 + R (W_ab/W(s))^4) grad W_ab + BETA x the last move, A = s^2, h = 1.3 s.
//! With R = 0 the cubic spline lets particles form pairs; R = 0.02 keeps them 0.75 s apart and disturbs the balance
//! least. Positions are mirrored at the walls; the core stays.

use super::cloud::{Cloud, SLACK};
use super::domain::Domain;
use super::measure::area_without;
use super::{Filled, Packing, Residual, SMOOTHING};
use crate::geometry::Vec2;
use crate::kernel::{self, SUPPORT};
use rayon::prelude::*;

/// Step of the shifting, dimensionless.
const K: f64 = 0.4;
/// Part of the last move that is kept.
const BETA: f64 = 0.9;
/// Strength of the repulsion that prevents pairs.
const REPULSION: f64 = 0.02;
/// Largest move per step in units of the spacing.
const LONGEST_MOVE: f64 = 0.1;
/// Shifting ends when no move is longer than this, in units of the spacing.
const SHORTEST_MOVE: f64 = 1e-4;

/// Relaxes the loose particles and gives all of them areas; the fixed ones come first in the result.
pub(super) fn relax(domain: &Domain, filled: Filled, steps: usize) -> Packing {
    let loose = filled.loose.len();
    let outside = loose_area(domain, &filled);
    let all = || filled.loose.iter().chain(&filled.fixed);
    let mut cloud = Cloud::new(
        domain,
        &filled.spacing,
        all().map(|seed| seed.position).collect(),
        all().map(|seed| seed.area).collect(),
        loose,
        loose,
    );
    let mut moved = vec![[0.0; 2]; loose];
    let mut path = vec![0.0; loose];
    let mut done = 0;
    while done < steps && loose > 0 {
        let longest = shift(&mut cloud, &mut moved, &mut path);
        cloud.update(&filled.spacing, loose);
        done += 1;
        if longest < SHORTEST_MOVE {
            break;
        }
        if path.iter().any(|&p| p > SLACK - LONGEST_MOVE) {
            path.fill(0.0);
            cloud = rebuilt(domain, &filled, cloud, loose);
        }
    }
    let n_real = cloud.n_real();
    cloud.update(&filled.spacing, loose);
    cloud = rebuilt(domain, &filled, cloud, n_real);
    balance_areas(&mut cloud, loose, outside);
    let residual = residual(&cloud, domain);
    cloud.position.truncate(n_real);
    cloud.area.truncate(n_real);
    cloud.position.rotate_left(loose);
    cloud.area.rotate_left(loose);
    Packing {
        position: cloud.position,
        area: cloud.area,
        undisturbed: filled.fixed.len(),
        residual,
        steps: done,
    }
}

fn rebuilt(domain: &Domain, filled: &Filled, mut old: Cloud, rows: usize) -> Cloud {
    let n_real = old.n_real();
    old.position.truncate(n_real);
    old.area.truncate(n_real);
    let loose = filled.loose.len();
    Cloud::new(domain, &filled.spacing, old.position, old.area, loose, rows)
}

/// One step of shifting. Returns the longest move in units of the spacing.
fn shift(cloud: &mut Cloud, moved: &mut [Vec2], path: &mut [f64]) -> f64 {
    let force: Vec<Vec2> = (0..moved.len())
        .into_par_iter()
        .map(|a| cloud.vector_sum(a, repelling_gradient))
        .collect();
    let mut longest = 0.0_f64;
    for (a, force) in force.iter().enumerate() {
        let s = cloud.spacing[a];
        let mut step = [0, 1].map(|k| BETA * moved[a][k] - K * s * s * force[k]);
        let length = step[0].hypot(step[1]) / s;
        if length > LONGEST_MOVE {
            step = step.map(|d| d * LONGEST_MOVE / length);
        }
        cloud.position[a] = [
            cloud.position[a][0] + step[0],
            cloud.position[a][1] + step[1],
        ];
        moved[a] = step;
        path[a] += length.min(LONGEST_MOVE);
        longest = longest.max(length);
    }
    longest
}

fn repelling_gradient(r: f64, h: f64) -> f64 {
    let near = (kernel::value(r, h) / kernel::value(h / SMOOTHING, h)).powi(2);
    (1.0 + REPULSION * near * near) * kernel::gradient_factor(r, h)
}

/// sum A W of an endless square lattice, the value areas are balanced to (1 - 5e-5 for h = 1.3 s).
fn lattice_partition() -> f64 {
    let at = |i: i32, j: i32| kernel::value(f64::from(i * i + j * j).sqrt(), SMOOTHING);
    (-2..=2).flat_map(|i| (-2..=2).map(move |j| at(i, j))).sum()
}

/// One step of A_a <- A_a / sum_b A_b W_ab, then a common factor that makes the sum exact.
///
/// Against A = s^2 alone it halves the error of an interpolated constant and leaves the force as it is; A = 1/sum W
/// doubles both.
fn balance_areas(cloud: &mut Cloud, loose: usize, total: f64) {
    let goal = lattice_partition();
    let balanced: Vec<f64> = (0..loose)
        .map(|a| cloud.area[a] * goal / cloud.partition(a))
        .collect();
    let factor = total / balanced.iter().sum::<f64>();
    for (area, balanced) in cloud.area.iter_mut().zip(balanced) {
        *area = balanced * factor;
    }
    cloud.update_images();
}

/// Area that belongs to the loose particles, m2: all outside the core, their cells inside of it, and what a ragged
/// edge of the core leaves over.
fn loose_area(domain: &Domain, filled: &Filled) -> f64 {
    let Some(core) = &filled.spacing.core else {
        return 0.0;
    };
    let outside_holes: Vec<_> = std::iter::once(core).chain(&domain.region.holes).collect();
    let inside: f64 = filled
        .loose
        .iter()
        .filter(|seed| core.contains(seed.position))
        .map(|seed| seed.area)
        .sum();
    area_without(domain, &outside_holes) + inside + filled.left_over
}

fn residual(cloud: &Cloud, domain: &Domain) -> Residual {
    let reach = SUPPORT * SMOOTHING;
    let forces: Vec<f64> = (0..cloud.n_real())
        .filter(|&a| domain.hole_distance(cloud.position[a]) > 1.1 * reach * cloud.spacing[a])
        .map(|a| {
            let g = cloud.vector_sum(a, kernel::gradient_factor);
            g[0].hypot(g[1]) * cloud.spacing[a]
        })
        .collect();
    Residual {
        max: forces.iter().copied().fold(0.0, f64::max),
        mean: forces.iter().sum::<f64>() / forces.len().max(1) as f64,
    }
}
