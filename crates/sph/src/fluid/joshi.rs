//! The published formulation (Joshi 2018, sections 5.3.2 and 6.2.1): what liquid particles do to each other.
//!
//! eta_a = f1_a sum_b m_b W_ab, rho = eta/(2 pi r)                                                    (5.29, 6.3, 6.4)
//! dv_r/dt = 2 pi p_a/eta_a - 2 pi sum_b m_b (p_b r_b/eta_b^2 + f1_a p_a r_a/eta_a^2) dW/dr
//!           - 2 pi r_a p_a/(eta_a f1_a) df1/dr - sum_b m_b Pi_ab dW/dr                                        (6.7)
//! dv_z/dt = the same sums with dW/dz, without the two terms outside of them                                    (6.8)
//! Pi_ab = (-alpha c mu + beta mu^2)/mean eta, mu = h v.x/(x^2 + 0.01 h^2), on approach                    (6.9, 6.10)
//!
//! Pi is divided by the mean eta, not the mean rho as printed: otherwise its dimension is wrong and it depends on r. In
//! plane motion f1 = 1, eta = rho, and the two terms outside the sums are gone.
//!
//! Choices that the source leaves open:
//! - h stays what it was at the start (it may differ between particles).
//! - Tension is clipped (p >= 0): summation is deficient at a free surface and Tait would turn that into tension.
//! - At an open side summation would see the same deficit. Particles with a far field keep a density of their own that
//!   follows the continuity equation with the corrected divergence ([`super::kinematics`]), and p - p_x takes the place
//!   of p in (6.7) and (6.8), p_x the pressure outside.
//! - A wall mirrors mass, density and pressure; radii of ghosts count as |r|.
//!
//! Known limits: particles must start on a lattice; shells and other packings start with a density off by some percent,
//! which Tait turns into more than the driving pressure. Near the axis f1 is off by 2.6 % ([`super::axis_function`]).

use crate::fluid::Fluid;
use crate::fluid::axis_function::axis_function;
use crate::fluid::extended::Extended;
use crate::fluid::ghosts::Ghosts;
use crate::fluid::momentum::Forces;
use crate::fluid::step::Sweep;
use crate::geometry::{Geometry, dot};
use crate::kernel;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// Numerical settings of the published formulation.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Settings {
    /// Linear artificial viscosity.
    pub alpha: f64,
    /// Quadratic artificial viscosity.
    pub beta: f64,
    /// Share of the neighbours' velocity in the motion (XSPH, eq. 5.12 with the mean eta); 0 is off.
    pub xsph: f64,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            alpha: 1.0,
            beta: 2.0,
            xsph: 0.0,
        }
    }
}

/// eta = 2 pi |r| rho of particles and ghosts, kg/m2 (rho in plane motion); A eta is the mass.
fn ring_density<const D: usize>(geometry: Geometry, x: &Extended<D>) -> Vec<f64> {
    (x.position.iter().zip(&x.density))
        .map(|(p, d)| geometry.ring(p[0].abs()) * d)
        .collect()
}

/// f1 and df1/dr (1/m) of a particle; 1 and 0 in plane motion.
pub(crate) fn axis_correction(geometry: Geometry, r: f64, h: f64) -> (f64, f64) {
    match geometry {
        Geometry::Plane => (1.0, 0.0),
        Geometry::Axisymmetric => {
            let f = axis_function(r / h);
            (f.value, f.slope / h)
        }
    }
}

impl<const D: usize> Fluid<D> {
    /// Density of particles with a far field by continuity; the others get theirs in [`Self::sum_density`].
    pub(crate) fn advance_far_volume(&mut self, sweep: &Sweep<D>, dt: f64) {
        for a in 0..self.len() {
            if self.far_field[a].is_some() {
                self.volume[a] *= (dt * sweep.kinematics(a).divergence).exp();
            }
        }
    }

    /// Volume from the summation density where the particles are now.
    pub(crate) fn sum_density(&mut self, ghosts: &Ghosts<D>, sweep: &Sweep<D>) {
        let x = Extended::new(self, ghosts, &self.velocity);
        let eta = ring_density(self.geometry, &x);
        let volume: Vec<f64> = (0..self.len())
            .into_par_iter()
            .map(|a| {
                if self.far_field[a].is_some() {
                    return self.volume[a];
                }
                let mut sum = self.mass[a] * kernel::value_in::<D>(0.0, self.smoothing_length[a]);
                for &b in sweep.list.of(a) {
                    let b = b as usize;
                    if let Some(pair) = x.pair(a, b) {
                        sum += x.area[b] * eta[b] * kernel::value_in::<D>(pair.distance, pair.h);
                    }
                }
                let r = self.position[a][0];
                let f1 = axis_correction(self.geometry, r, self.smoothing_length[a]).0;
                self.mass[a] * self.geometry.ring(r) / (f1 * sum)
            })
            .collect();
        self.volume = volume;
    }

    /// Velocities of XSPH on top of the particles' own, m/s.
    pub(crate) fn smoothing_velocities(
        &self,
        x: &Extended<D>,
        sweep: &Sweep<D>,
        share: f64,
    ) -> Vec<[f64; D]> {
        if share == 0.0 {
            return vec![[0.0; D]; self.len()];
        }
        let eta = ring_density(self.geometry, x);
        (0..self.len())
            .into_par_iter()
            .map(|a| {
                let mut u = [0.0; D];
                for &b in sweep.list.of(a) {
                    let b = b as usize;
                    let Some(pair) = x.pair(a, b) else { continue };
                    let w = x.area[b] * eta[b] * kernel::value_in::<D>(pair.distance, pair.h);
                    let k = 2.0 * share * w / (eta[a] + eta[b]);
                    let dv = std::array::from_fn(|i| x.velocity[b][i] - x.velocity[a][i]);
                    add(&mut u, dv, k);
                }
                u
            })
            .collect()
    }
}

/// Forces on every particle; `outside` is the far-field pressure of each, Pa.
pub(crate) fn forces<const D: usize>(
    fluid: &Fluid<D>,
    x: &Extended<D>,
    outside: &[f64],
    sweep: &Sweep<D>,
    s: &Settings,
) -> Vec<Forces<D>> {
    let eta = ring_density(fluid.geometry, x);
    (0..fluid.len())
        .into_par_iter()
        .map(|a| forces_on(a, fluid, x, &eta, outside[a], sweep, s))
        .collect()
}

fn forces_on<const D: usize>(
    a: usize,
    fluid: &Fluid<D>,
    x: &Extended<D>,
    eta: &[f64],
    outside: f64,
    sweep: &Sweep<D>,
    s: &Settings,
) -> Forces<D> {
    let r = x.position[a][0];
    let (f1, slope) = axis_correction(fluid.geometry, r, x.smoothing_length[a]);
    let own = f1 / (x.density[a] * eta[a]);
    let excess = x.pressure[a] - outside;
    let mut f = Forces {
        acceleration: [0.0; D],
        dissipation: [0.0; D],
        wall: [0.0; D],
    };
    for &b in sweep.list.of(a) {
        let b = b as usize;
        let Some(pair) = x.pair(a, b) else { continue };
        let d = pair.separation;
        let factor = -x.area[b] * pair.factor;
        let pressure = (x.pressure[b] - outside) / x.density[b] + own * eta[b] * excess;
        let viscosity = viscosity(x, a, b, d, pair.h, s) * 2.0 * eta[b] / (eta[a] + eta[b]);
        let pushes = sweep.ghosts.is_surface(fluid.len(), b);
        let all = x.pressure[b] / x.density[b] + own * eta[b] * x.pressure[a] + viscosity;
        add(&mut f.acceleration, d, (pressure + viscosity) * factor);
        add(&mut f.dissipation, d, viscosity * factor);
        if pushes {
            add(&mut f.wall, d, all * factor);
        }
    }
    if fluid.geometry == Geometry::Axisymmetric {
        f.acceleration[0] += excess / x.density[a] * (1.0 / r - slope / f1);
    }
    f
}

/// sum += k v.
#[inline]
fn add<const D: usize>(sum: &mut [f64; D], v: [f64; D], k: f64) {
    for (sum, v) in sum.iter_mut().zip(v) {
        *sum += k * v;
    }
}

/// (-alpha c mu + beta mu^2) of a pair, m2/s2.
#[inline]
fn viscosity<const D: usize>(
    x: &Extended<D>,
    a: usize,
    b: usize,
    d: [f64; D],
    h: f64,
    s: &Settings,
) -> f64 {
    let (va, vb) = (x.velocity[a], x.velocity[b]);
    let approach = dot(std::array::from_fn(|k| va[k] - vb[k]), d);
    if approach >= 0.0 {
        return 0.0;
    }
    let mu = h * approach / (dot(d, d) + 0.01 * h * h);
    let c = 0.5 * (x.sound_speed[a] + x.sound_speed[b]);
    mu * (s.beta * mu - s.alpha * c)
}

#[cfg(test)]
mod tests;
