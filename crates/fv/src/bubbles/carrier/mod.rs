//! The flow that carries bubbles, as a function of place and time.

mod acoustic;
mod average;
mod exponential_integral;
mod limits;
mod stagnation;
mod still;
mod table;
mod vortex;

pub use acoustic::{Acoustic, Wave};
pub use average::{Average, surface_average};
pub use limits::{Bounded, NearPlane};
pub use stagnation::Stagnation;
pub use still::Still;
pub use table::{Grid, Snapshot, Table, TableError};
pub use vortex::{LambOseen, VortexForm};

use crate::vector::{Vector, finite};
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// Values of the flow at a place and time, as if no bubble were there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CarrierPoint {
    /// Velocity u, m/s.
    pub velocity: Vector,
    /// Pressure with its hydrostatic part, Pa.
    pub pressure: f64,
    /// Gradient of the pressure without its hydrostatic part, Pa/m: buoyancy is a force of its own.
    pub pressure_gradient: Vector,
    /// du_i/dx_j, 1/s; row i.
    pub velocity_gradient: [Vector; 3],
    /// Material derivative Du/Dt = du/dt + (u . grad) u, following the liquid, m/s2.
    pub acceleration: Vector,
    /// Density, kg/m3.
    pub density: f64,
    /// Dynamic viscosity, Pa s.
    pub viscosity: f64,
}

impl CarrierPoint {
    /// Curl of the velocity, 1/s.
    #[must_use]
    pub fn vorticity(&self) -> Vector {
        let g = &self.velocity_gradient;
        [g[2][1] - g[1][2], g[0][2] - g[2][0], g[1][0] - g[0][1]]
    }

    /// Liquid at rest at a pressure.
    pub(crate) fn at_rest(pressure: f64, density: f64, viscosity: f64) -> Self {
        Self {
            velocity: [0.0; 3],
            pressure,
            pressure_gradient: [0.0; 3],
            velocity_gradient: [[0.0; 3]; 3],
            acceleration: [0.0; 3],
            density,
            viscosity,
        }
    }

    /// Whether all numbers are finite and density and viscosity positive or zero.
    pub(crate) fn is_sound(&self) -> bool {
        let vectors = [self.velocity, self.pressure_gradient, self.acceleration];
        let all = vectors.iter().chain(&self.velocity_gradient);
        all.into_iter().all(|v| finite(*v))
            && self.pressure.is_finite()
            && self.density > 0.0
            && self.viscosity >= 0.0
    }
}

/// The nearest point of a wall.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct WallPoint {
    /// Distance, m; negative behind the wall.
    pub distance: f64,
    /// Unit normal, from the wall into the liquid.
    pub normal: Vector,
}

/// Why the flow has no answer.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum CarrierError {
    /// The place is not in the flow.
    #[error(
        "the flow is not known at ({x:e}, {y:e}, {z:e}) m, outside its domain; enlarge the domain or end the run before bubbles leave",
        x = .position[0], y = .position[1], z = .position[2]
    )]
    Outside {
        /// Place, m.
        position: Vector,
    },
    /// The time is not in the data.
    #[error("the flow is not known at {time:e} s; its data go from {start:e} to {end:e} s")]
    OutsideTime {
        /// Time, s.
        time: f64,
        /// First time, s.
        start: f64,
        /// Last time, s.
        end: f64,
    },
    /// The flow gave a number that is not finite.
    #[error("the flow is not finite at ({x:e}, {y:e}, {z:e}) m", x = .position[0], y = .position[1], z = .position[2])]
    NotFinite {
        /// Place, m.
        position: Vector,
    },
}

/// A flow. It answers within its domain and says so outside: it never extrapolates.
pub trait Carrier: Sync {
    /// Values at a place, m, and time, s.
    ///
    /// # Errors
    /// Outside the domain or the times of the flow.
    fn at(&self, position: Vector, time: f64) -> Result<CarrierPoint, CarrierError>;

    /// The nearest wall; `None` where there is none.
    fn wall(&self, _position: Vector) -> Option<WallPoint> {
        None
    }

    /// Length (m) over which the flow changes at a place: size of a cell, of a vortex. Limits the way of a bubble in one
    /// step; infinite where nothing changes.
    fn length_scale(&self, position: Vector) -> f64;

    /// Time (s) in which the flow changes: part of a period, distance of snapshots. Limits a step; infinite in steady flow.
    fn time_scale(&self) -> f64 {
        f64::INFINITY
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// Differences of the flow against the gradients and the acceleration it states: velocity gradient, pressure gradient
    /// (against `-rho g` too), and Du/Dt. Returns the largest misses relative to the scale of each.
    pub(crate) fn misses(flow: &impl Carrier, x: Vector, t: f64, d: f64, dt: f64) -> [f64; 3] {
        let here = flow.at(x, t).unwrap();
        let moved = |j: usize, s: f64| {
            let mut y = x;
            y[j] += s * d;
            flow.at(y, t).unwrap()
        };
        let (mut gradient, mut pressure) = (0.0f64, 0.0f64);
        let mut convective = [0.0; 3];
        for j in 0..3 {
            let (a, b) = (moved(j, -1.0), moved(j, 1.0));
            for (i, sum) in convective.iter_mut().enumerate() {
                let slope = (b.velocity[i] - a.velocity[i]) / (2.0 * d);
                gradient = gradient.max((slope - here.velocity_gradient[i][j]).abs());
                *sum += here.velocity[j] * slope;
            }
            let slope = (b.pressure - a.pressure) / (2.0 * d);
            pressure = pressure.max((slope - here.pressure_gradient[j]).abs());
        }
        let (before, after) = (flow.at(x, t - dt).unwrap(), flow.at(x, t + dt).unwrap());
        let mut acceleration = 0.0f64;
        for (i, convective) in convective.into_iter().enumerate() {
            let rate = (after.velocity[i] - before.velocity[i]) / (2.0 * dt);
            acceleration = acceleration.max((rate + convective - here.acceleration[i]).abs());
        }
        let size = |v: &[f64]| v.iter().fold(1e-300f64, |m, x| m.max(x.abs()));
        [
            gradient / size(here.velocity_gradient.as_flattened()),
            pressure / size(&here.pressure_gradient),
            acceleration / size(&here.acceleration),
        ]
    }
}
