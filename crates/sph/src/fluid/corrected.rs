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

/// Below this eigenvalue of the moment matrix a particle lies at a free surface or is a fragment.
const PARTED: f64 = 0.6;

/// Cavitating liquid inside the body swells to this multiple of its volume at zero pressure; beyond, gaps open.
const LARGEST_SWELLING: f64 = 1.5;

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
    /// Particle-steps in which a fragment was kept at its density at zero pressure.
    pub parted: u64,
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
            self.keep_fragments_whole(a);
        }
        let shift = shifting::velocities(self, &sweep.kinematics, s);
        shifting::exchange(self, &sweep.ghosts, &sweep.list, &shift, dt);
        shift
    }

    /// Where the liquid has parted it keeps its density at zero pressure: the void opens between the pieces, not in them.
    /// Inside the liquid a deficit of density stands for bubbles too small to see and is kept up to a limit. Volume
    /// taken here is at zero pressure: no energy is lost with it.
    fn keep_fragments_whole(&mut self, a: usize) {
        let swelling = if self.support[a] < PARTED {
            1.0
        } else {
            LARGEST_SWELLING
        };
        let largest = swelling * self.mass[a] / self.eos.reference_density;
        if self.volume[a] > largest {
            self.volume[a] = largest;
            self.account.parted += 1;
        }
    }
}
