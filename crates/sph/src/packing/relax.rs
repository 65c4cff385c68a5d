//! Relaxation of the graded part, and areas for which a uniform pressure is at rest.
//!
//! Shifting: dx_a = -K s_a^2 sum_b A_b (1 + R (W_ab/W(s))^4) grad W_ab + BETA x the last move, A = s^2, h = 1.3 s.
//! With R = 0 the cubic spline lets particles form pairs, and any R leaves a force behind. So R falls from 0.22 (orders
//! the particles) to 0.02, and a few steps with R = 0 and without memory follow, too few for pairs to form.
//! Positions are mirrored at the walls; the core stays.

use super::cloud::{Cloud, SLACK};
use super::domain::Domain;
use super::measure::area_without;
use super::{Filled, Packing, Residual, SMOOTHING};
use crate::geometry::Vec2;
use crate::kernel::{self, SUPPORT};
use rayon::prelude::*;
use std::f64::consts::PI;

/// Step of the shifting, dimensionless.
const K: f64 = 0.4;
/// Part of the last move that is kept.
const BETA: f64 = 0.9;
/// Repulsion at the start (on top of the last) and before the final steps.
const REPULSION: [f64; 2] = [0.2, 0.02];
/// Final steps without repulsion and memory.
const FINAL_STEPS: usize = 10;
/// 1/(W(s) h^2 7 pi/10): q = 1/1.3, W h^2 7 pi/10 = (2 - q)^3/4 - (1 - q)^3.
const SHAPE_AT_SPACING: f64 = {
    let q = 1.0 / SMOOTHING;
    let (t, u) = (2.0 - q, 1.0 - q);
    1.0 / (0.25 * t * t * t - u * u * u)
};
/// Largest move per step in units of the spacing.
const LONGEST_MOVE: f64 = 0.1;

/// Strengths of one step of shifting.
#[derive(Clone, Copy)]
struct Strength {
    repulsion: f64,
    memory: f64,
}

impl Strength {
    fn at(step: usize, steps: usize) -> Self {
        let main = steps.saturating_sub(FINAL_STEPS);
        if step >= main {
            return Self {
                repulsion: 0.0,
                memory: 0.0,
            };
        }
        let rest = 1.0 - step as f64 / main as f64;
        Self {
            repulsion: REPULSION[1] + REPULSION[0] * rest * rest,
            memory: BETA,
        }
    }
}

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
    let steps = if loose > 0 { steps } else { 0 };
    for step in 0..steps {
        shift(&mut cloud, &mut moved, &mut path, Strength::at(step, steps));
        cloud.update(&filled.spacing, loose);
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
    cloud.spacing.truncate(n_real);
    cloud.position.rotate_left(loose);
    cloud.area.rotate_left(loose);
    cloud.spacing.rotate_left(loose);
    Packing {
        position: cloud.position,
        area: cloud.area,
        spacing: cloud.spacing,
        undisturbed: filled.fixed.len(),
        residual,
        steps,
    }
}

fn rebuilt(domain: &Domain, filled: &Filled, mut old: Cloud, rows: usize) -> Cloud {
    let n_real = old.n_real();
    old.position.truncate(n_real);
    old.area.truncate(n_real);
    let loose = filled.loose.len();
    Cloud::new(domain, &filled.spacing, old.position, old.area, loose, rows)
}

/// One step of shifting.
fn shift(cloud: &mut Cloud, moved: &mut [Vec2], path: &mut [f64], strength: Strength) {
    let gradient = |r, h| repelling_gradient(r, h, strength.repulsion);
    let force: Vec<Vec2> = (0..moved.len())
        .into_par_iter()
        .map(|a| cloud.vector_sum(a, gradient))
        .collect();
    for (a, force) in force.iter().enumerate() {
        let s = cloud.spacing[a];
        let mut step = [0, 1].map(|k| strength.memory * moved[a][k] - K * s * s * force[k]);
        let length = step[0].hypot(step[1]) / s;
        if length > LONGEST_MOVE {
            step = step.map(|d| d * LONGEST_MOVE / length);
        }
        let x = cloud.position[a];
        cloud.position[a] = [x[0] + step[0], x[1] + step[1]];
        moved[a] = step;
        path[a] += length.min(LONGEST_MOVE);
    }
}

/// The gradient factor of the kernel times (1 + R (W/W(s))^4), in one go because all time goes here.
fn repelling_gradient(r: f64, h: f64, repulsion: f64) -> f64 {
    // Half of all pairs of the widened list are too far: no branch, max(2 - q, 0) does it.
    let inverse = 1.0 / h;
    let q = (r * inverse).max(1e-9);
    let t = (2.0 - q).max(0.0);
    let u = (1.0 - q).max(0.0);
    let scale = 10.0 / (7.0 * PI) * (inverse * inverse).powi(2);
    let near = (SHAPE_AT_SPACING * (0.25 * t * t * t - u * u * u)).powi(2);
    scale * (1.0 + repulsion * near * near) * (3.0 * u * u - 0.75 * t * t) / q
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn repelling_gradient_is_the_kernel_gradient_times_the_repulsion() {
        let h = 0.3;
        for i in 1..100 {
            let r = 0.007 * f64::from(i);
            let near = kernel::value(r, h) / kernel::value(h / SMOOTHING, h);
            let expected = (1.0 + 0.2 * near.powi(4)) * kernel::gradient_factor(r, h);
            assert!((repelling_gradient(r, h, 0.2) - expected).abs() < 1e-9);
        }
    }
}
