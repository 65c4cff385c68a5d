//! First sweep: moment matrix, velocity gradient, rate of volume, crowding.
//!
//! dV_a/dt = V_a [ sum_b A_b (v_b - v_a) . L_a grad W + v_r/r ] + sum_b 2 pi r_ab A_a A_b (p_a - p_b)/(rho c) (-dW/dx)
//!
//! The first bracket is exact for linear velocities, also at a free surface (without L_a the surface sees half its
//! divergence and the wall of a bubble is 5 to 10 % too fast). The last sum is the volume that the middle state of an acoustic
//! Riemann problem moves between neighbours of unequal pressure; the linear part of the pressure, known from the
//! acceleration (grad p = -rho a), is taken out first, which makes the first-order smoothing third order.

use crate::fluid::Fluid;
use crate::fluid::extended::{Extended, limited};
use crate::fluid::moments::{Sym2, apply, inverse, smaller_eigenvalue};
use crate::geometry::{Geometry, Vec2};
use crate::kernel;
use crate::neighbours::Neighbours;
use rayon::prelude::*;
use std::f64::consts::PI;

/// Sums over the neighbours of one particle that need no other sums.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Kinematics {
    /// Inverse moment matrix L.
    pub(crate) correction: Sym2,
    /// Smaller eigenvalue of the moment matrix.
    pub(crate) support: f64,
    /// Velocity gradient, dv_i/dx_j in [i][j], 1/s.
    pub(crate) gradient: [Vec2; 2],
    /// Relative rate of volume by motion, 1/s.
    pub(crate) divergence: f64,
    /// Rate of volume by unequal pressure, m3/s.
    pub(crate) exchange: f64,
    /// Sum of A_b grad W with a short-range term, 1/m: points to where particles are lacking.
    pub(crate) crowding: Vec2,
}

/// Strength of the short-range term in the crowding.
const CLUMPING: f64 = 0.2;

/// Kinematics of every particle.
pub(crate) fn sweep(fluid: &Fluid, x: &Extended, list: &Neighbours) -> Vec<Kinematics> {
    (0..fluid.len())
        .into_par_iter()
        .map(|a| sums_of(a, fluid, x, list))
        .collect()
}

fn sums_of(a: usize, fluid: &Fluid, x: &Extended, list: &Neighbours) -> Kinematics {
    let rings = fluid.geometry == Geometry::Axisymmetric;
    let va = x.velocity[a];
    let (mut m, mut g, mut crowding, mut exchange) = ([0.0; 3], [[0.0; 2]; 2], [0.0; 2], 0.0);
    for &b in list.of(a) {
        let b = b as usize;
        let Some(pair) = x.pair(a, b) else { continue };
        let d = pair.separation;
        let factor = x.area[b] * pair.factor;
        let gw = [factor * d[0], factor * d[1]];
        m = [
            m[0] - d[0] * gw[0],
            m[1] - d[0] * gw[1],
            m[2] - d[1] * gw[1],
        ];
        for i in 0..2 {
            let dv = x.velocity[b][i] - va[i];
            g[i] = [g[i][0] + dv * gw[0], g[i][1] + dv * gw[1]];
        }
        let w =
            kernel::value(pair.distance, pair.h) / kernel::value(pair.h / super::SMOOTHING, pair.h);
        let clump = 1.0 + CLUMPING * w * w * w * w;
        crowding = [crowding[0] + clump * gw[0], crowding[1] + clump * gw[1]];
        let ring = if rings {
            PI * (x.position[a][0] + x.position[b][0]).abs()
        } else {
            1.0
        };
        exchange -= ring * x.area[a] * factor * pair.distance * pressure_jump(x, a, b, d);
    }
    let correction = inverse(m);
    let gradient = [apply(correction, g[0]), apply(correction, g[1])];
    let hoop = if rings { va[0] / x.position[a][0] } else { 0.0 };
    Kinematics {
        correction,
        support: smaller_eigenvalue(m),
        gradient,
        divergence: gradient[0][0] + gradient[1][1] + hoop,
        exchange,
        crowding,
    }
}

/// (p_a - p_b - linear part)/(rho c), m/s; exactly antisymmetric.
#[inline]
fn pressure_jump(x: &Extended, a: usize, b: usize, d: Vec2) -> f64 {
    let slope =
        |k: usize| x.density[k] * (x.acceleration[k][0] * d[0] + x.acceleration[k][1] * d[1]);
    let jump = limited(x.pressure[a] - x.pressure[b], -0.5 * (slope(a) + slope(b)));
    jump / (0.5 * (x.density[a] * x.sound_speed[a] + x.density[b] * x.sound_speed[b]))
}
