//! The corrected formulation: divergence exact for linear velocities ([`super::kinematics`]), pressure gradient corrected
//! inside and plain at a free surface ([`super::momentum`]), Riemann dissipation, shifting that carries mass
//! ([`super::shifting`]). The order of a step: [`super::step`].

use crate::fluid::Fluid;
use crate::fluid::shifting;
use crate::fluid::step::Sweep;
use crate::geometry::Vec2;
use serde::{Deserialize, Serialize};

/// Numerical settings of the corrected formulation.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Settings {
    /// Strength k of the particle shifting.
    pub shifting: f64,
    /// Largest shifting velocity in units of h |grad v|.
    pub shifting_limit: f64,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            shifting: 10.0,
            shifting_limit: 2.0,
        }
    }
}

/// Energy that left or entered the liquid otherwise than through its own motion, J; and what was counted.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Account {
    /// Kinetic energy turned into nothing by the Riemann dissipation, by exchange of volume at unequal pressure and by
    /// mixing of shifted volumes.
    pub dissipation: f64,
    /// Work done by the far field.
    pub far_field_work: f64,
    /// Particles mirrored back at the axis.
    pub axis_crossings: u64,
    /// Particles mirrored back at a wall.
    pub wall_crossings: u64,
    /// Particle-steps in which tension was removed.
    pub cavitating: u64,
    /// Exchanges of volume that were cut to the largest share a particle may give.
    pub limited_exchanges: u64,
}

impl Fluid {
    /// Volume of one step; exchange of volume by shifting. Returns the shifting velocities, m/s.
    pub(crate) fn exchange_volume(&mut self, s: &Settings, sweep: &Sweep, dt: f64) -> Vec<Vec2> {
        for (a, k) in sweep.kinematics.iter().enumerate() {
            self.account.dissipation += dt * self.pressure[a] * k.exchange;
            let relative = k.divergence + k.exchange / self.volume[a];
            self.volume[a] *= (dt * relative).exp();
        }
        let shift = shifting::velocities(self, &sweep.kinematics, s);
        shifting::exchange(self, &sweep.ghosts, &sweep.list, &shift, dt);
        shift
    }
}
