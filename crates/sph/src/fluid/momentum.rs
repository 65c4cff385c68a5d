//! Second sweep: accelerations.
//!
//! dv_a/dt = -(1/rho_a) G_a sum_b A_b (p_a + p_b + q_ab - 2 p_x) grad W
//!
//! q_ab = rho c u for pairs that approach with speed u: the dissipation of an acoustic Riemann solver, u being what the
//! velocity gradient does not explain (third order in smooth flow). G_a = L_a inside the liquid; near a free surface it is the
//! identity, since the deficit of the plain sum is the condition p = 0 half a spacing outside the first particle. p_x is
//! the pressure outside a far field, zero elsewhere.

use crate::fluid::Fluid;
use crate::fluid::extended::{Extended, limited};
use crate::fluid::kinematics::Kinematics;
use crate::fluid::moments::{Sym2, apply};
use crate::fluid::step::Sweep;
use crate::geometry::Vec2;
use rayon::prelude::*;

/// Above this eigenvalue of the moment matrix the corrected gradient is used.
const INSIDE: f64 = 0.85;

/// Forces on one particle per unit of its mass, m/s2, and what they come from.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Forces {
    /// Total.
    pub(crate) acceleration: Vec2,
    /// Part of the numerical dissipation.
    pub(crate) dissipation: Vec2,
    /// Part of the walls that can be pushed (the surfaces of solids).
    pub(crate) wall: Vec2,
}

/// Forces on every particle; `outside` is the far-field pressure of each, Pa.
pub(crate) fn sweep(fluid: &Fluid, x: &Extended, outside: &[f64], sweep: &Sweep) -> Vec<Forces> {
    let gradient: Vec<[Vec2; 2]> = sweep.kinematics.iter().map(|k| k.gradient).collect();
    let gradient = sweep.ghosts.extend(&gradient, |p, g| p.mirror_tensor(g));
    (0..fluid.len())
        .into_par_iter()
        .map(|a| forces_on(a, fluid, x, outside[a], &gradient, sweep))
        .collect()
}

fn forces_on(
    a: usize,
    fluid: &Fluid,
    x: &Extended,
    outside: f64,
    gradient: &[[Vec2; 2]],
    sweep: &Sweep,
) -> Forces {
    let (mut pressure, mut friction, mut plain, mut wall) =
        ([0.0; 2], [0.0; 2], [0.0; 2], [0.0; 2]);
    for &b in sweep.list.of(a) {
        let b = b as usize;
        let Some(pair) = x.pair(a, b) else { continue };
        let d = pair.separation;
        let factor = x.area[b] * pair.factor;
        let q = dissipation(x, gradient, a, b, d, pair.distance);
        let p = x.pressure[a] + x.pressure[b];
        let pushes = sweep.ghosts.is_surface(fluid.len(), b);
        for i in 0..2 {
            let gw = factor * d[i];
            pressure[i] += p * gw;
            friction[i] += q * gw;
            plain[i] += gw;
            if pushes {
                wall[i] += (p + q) * gw;
            }
        }
    }
    let scale =
        |v: Vec2, s: f64| apply(correction(&sweep.kinematics[a]), v).map(|c| c * s / x.density[a]);
    let dissipation = scale(friction, -1.0);
    let far_field = scale(plain, 2.0 * outside);
    let inner = scale(pressure, -1.0);
    Forces {
        acceleration: [0, 1].map(|i| inner[i] + dissipation[i] + far_field[i]),
        dissipation,
        wall: scale(wall, -1.0),
    }
}

fn correction(k: &Kinematics) -> Sym2 {
    if k.support > INSIDE {
        k.correction
    } else {
        [1.0, 0.0, 1.0]
    }
}

/// q_ab, Pa.
#[inline]
fn dissipation(
    x: &Extended,
    gradient: &[[Vec2; 2]],
    a: usize,
    b: usize,
    d: Vec2,
    distance: f64,
) -> f64 {
    let (va, vb) = (x.velocity[a], x.velocity[b]);
    let jump = -((va[0] - vb[0]) * d[0] + (va[1] - vb[1]) * d[1]) / distance;
    if jump <= 0.0 {
        return 0.0;
    }
    let (ga, gb) = (&gradient[a], &gradient[b]);
    let along = |i: usize, j: usize| (ga[i][j] + gb[i][j]) * d[i] * d[j];
    let linear = -0.5 * (along(0, 0) + along(0, 1) + along(1, 0) + along(1, 1)) / distance;
    let u = limited(jump, linear);
    let c = 0.5 * (x.sound_speed[a] + x.sound_speed[b]);
    let rho = 0.5 * (x.density[a] + x.density[b]);
    rho * c * u
}
