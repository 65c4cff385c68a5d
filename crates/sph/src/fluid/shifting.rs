//! Particle shifting that carries mass: keeps particles evenly spaced while the flow strains them.
//!
//! Shifting velocity d = -k h^2 |grad v| sum A_b (1 + 0.2 (W/W(dx))^4) grad W, tied to the strain rate because the disorder
//! comes from strain. A particle that moves relative to the liquid exchanges volume with its neighbours,
//! q_ab = 2 pi r_ab A_a A_b (d_a + d_b) . grad W, antisymmetric; mass and momentum go with the volume, upwind. Uniform
//! density stays uniform and mass is conserved to rounding wherever both images of a pair exist.
//!
//! The areas A drift apart in strong strain, first at the axis, where a small change of r is a large change of A = V/(2 pi r);
//! unequal weights then spoil the sums. The same exchange therefore also levels the sizes of neighbours,
//! q_ab += 10 |grad v| 2 pi r_ab A_a A_b W 2 (A_b - A_a)/(A_a + A_b). (Without it the pressure along the axis of a jet is noisy by
//! 20 %, and particles near the axis swell to many times their size.)

use crate::fluid::Fluid;
use crate::fluid::corrected::Settings;
use crate::fluid::extended::Extended;
use crate::fluid::ghosts::Ghosts;
use crate::fluid::kinematics::Kinematics;
use crate::geometry::{Geometry, Vec2};
use crate::kernel;
use crate::neighbours::Neighbours;
use rayon::prelude::*;
use std::f64::consts::PI;

/// Below this eigenvalue of the moment matrix a particle lies at a free surface and is not moved across it.
const SURFACE: f64 = 0.6;

/// A particle gives at most this share of its volume per step.
const LARGEST_SHARE: f64 = 0.1;

/// Rate of levelling of areas in units of |grad v|; 3 and 20 serve as well.
const LEVELLING: f64 = 10.0;

/// Shifting velocities, m/s.
pub(crate) fn velocities(fluid: &Fluid, kinematics: &[Kinematics], s: &Settings) -> Vec<Vec2> {
    (0..fluid.len())
        .into_par_iter()
        .map(|a| velocity_of(a, fluid, &kinematics[a], s))
        .collect()
}

fn velocity_of(a: usize, fluid: &Fluid, k: &Kinematics, s: &Settings) -> Vec2 {
    let h = fluid.smoothing_length[a];
    let strain = norm(&k.gradient);
    let mut d = [0, 1].map(|i| -s.shifting * h * h * strain * k.crowding[i]);
    let size = k.crowding[0].hypot(k.crowding[1]);
    if k.support < SURFACE && size > 0.0 {
        let n = k.crowding.map(|c| c / size);
        let along = d[0] * n[0] + d[1] * n[1];
        d = [d[0] - along * n[0], d[1] - along * n[1]];
    }
    let limit = s.shifting_limit * h * strain;
    let speed = d[0].hypot(d[1]);
    if speed > limit {
        d.map(|c| c * limit / speed)
    } else {
        d
    }
}

/// Frobenius norm of a velocity gradient, 1/s.
pub(crate) fn norm(g: &[Vec2; 2]) -> f64 {
    (g[0][0].powi(2) + g[0][1].powi(2) + g[1][0].powi(2) + g[1][1].powi(2)).sqrt()
}

/// Moves volume, mass and momentum between neighbours for one step of shifting with velocities `shift`.
pub(crate) fn exchange(
    fluid: &mut Fluid,
    ghosts: &Ghosts,
    list: &Neighbours,
    shift: &[Vec2],
    dt: f64,
) {
    let n = fluid.len();
    let x = Extended::new(fluid, ghosts, &fluid.velocity);
    let shift = ghosts.extend(shift, |p, d| p.mirror_direction(d));
    let before = fluid.kinetic_energy() + fluid.compression_energy();
    // A curved surface mirrors each particle in a plane of its own: images of a pair do not match, mass would leak.
    let partners = |a: usize| {
        list.of(a)
            .iter()
            .map(|&b| b as usize)
            .filter(|&b| !ghosts.is_surface(n, b))
    };
    let share: Vec<f64> = (0..n)
        .into_par_iter()
        .map(|a| {
            let given: f64 = partners(a)
                .map(|b| flow(fluid, &x, &shift, a, b).min(0.0))
                .sum();
            (LARGEST_SHARE * fluid.volume[a] / (-dt * given).max(f64::MIN_POSITIVE)).min(1.0)
        })
        .collect();
    fluid.account.limited_exchanges += share.iter().filter(|s| **s < 1.0).count() as u64;
    let share = ghosts.extend_even(&share);
    let gains: Vec<Gain> = (0..n)
        .into_par_iter()
        .map(|a| {
            let mut gain = Gain::default();
            for b in partners(a) {
                let q = dt * flow(fluid, &x, &shift, a, b);
                let donor = if q > 0.0 { b } else { a };
                gain.add(q * share[donor], x.density[donor], x.velocity[donor]);
            }
            gain
        })
        .collect();
    for (a, gain) in gains.iter().enumerate() {
        let m = fluid.mass[a] + gain.mass;
        fluid.velocity[a] =
            [0, 1].map(|i| (fluid.mass[a] * fluid.velocity[a][i] + gain.momentum[i]) / m);
        fluid.mass[a] = m;
        fluid.volume[a] += gain.volume;
    }
    fluid.account.dissipation += before - fluid.kinetic_energy() - fluid.compression_energy();
}

/// What a particle gets in one step.
#[derive(Default)]
struct Gain {
    volume: f64,
    mass: f64,
    momentum: Vec2,
}

impl Gain {
    fn add(&mut self, volume: f64, density: f64, velocity: Vec2) {
        let mass = volume * density;
        self.volume += volume;
        self.mass += mass;
        self.momentum = [
            self.momentum[0] + mass * velocity[0],
            self.momentum[1] + mass * velocity[1],
        ];
    }
}

/// Volume rate (m3/s) from b to a; exactly antisymmetric.
fn flow(fluid: &Fluid, x: &Extended, shift: &[Vec2], a: usize, b: usize) -> f64 {
    let Some(pair) = x.pair(a, b) else { return 0.0 };
    let ring = match fluid.geometry {
        Geometry::Plane => 1.0,
        Geometry::Axisymmetric => PI * (x.position[a][0] + x.position[b][0]).abs(),
    };
    let d = pair.separation;
    let along = (shift[a][0] + shift[b][0]) * d[0] + (shift[a][1] + shift[b][1]) * d[1];
    let (aa, ab) = (x.area[a], x.area[b]);
    let strain = 0.5 * (x.strain_rate[a] + x.strain_rate[b]);
    let levelling =
        LEVELLING * strain * kernel::value(pair.distance, pair.h) * 2.0 * (ab - aa) / (aa + ab);
    ring * aa * ab * (along * pair.factor + levelling)
}
