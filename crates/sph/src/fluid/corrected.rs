//! The corrected formulation: divergence exact for linear velocities ([`super::kinematics`]), pressure gradient corrected
//! inside and plain at a free surface ([`super::momentum`]), Riemann dissipation, shifting that carries mass
//! ([`super::shifting`]). The order of a step: [`super::step`].

use crate::fluid::refinement::Changes;
use crate::fluid::step::Sweep;
use crate::fluid::{Fluid, ordered_sums, shifting};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::sync::atomic::{AtomicU64, Ordering};

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
    /// What refinement did.
    #[serde(default)]
    pub refinement: Changes,
}

impl<const D: usize> Fluid<D> {
    /// Volume of one step, with what else the first sweep found; exchange of volume by shifting, whose velocities stay in the
    /// memory of the sweep.
    pub(crate) fn exchange_volume(&mut self, s: &Settings, sweep: &mut Sweep<D>, dt: f64) {
        let mut shift = std::mem::take(&mut sweep.memory.shift);
        shift.resize(self.len(), [0.0; D]);
        let found = &*sweep;
        let (mass, density) = (&self.mass, self.eos.reference_density);
        let (pressure, h) = (&self.pressure, &self.smoothing_length);
        let parted = AtomicU64::new(0);
        let works = (self.volume.par_iter_mut())
            .zip(&mut self.support)
            .zip(&mut self.strain_rate)
            .zip(&mut shift)
            .enumerate()
            .map(|(a, (((volume, support), strain_rate), shift))| {
                let k = found.kinematics(a);
                *support = k.support;
                *strain_rate = shifting::norm(&k.gradient);
                *volume *= (dt * (k.divergence + k.exchange / *volume)).exp();
                let largest = swelling(k.support) * mass[a] / density;
                if *volume > largest {
                    *volume = largest;
                    parted.fetch_add(1, Ordering::Relaxed);
                }
                *shift = shifting::velocity(h[a], *strain_rate, k, s);
                [pressure[a] * k.exchange]
            });
        let [work] = ordered_sums(works);
        self.account.parted += parted.into_inner();
        self.account.dissipation += dt * work;
        shifting::exchange(self, sweep, &shift, dt);
        sweep.memory.shift = shift;
    }
}

/// Largest volume in units of that at zero pressure.
///
/// Where the liquid has parted it keeps its density at zero pressure: the void opens between the pieces, not in them.
/// Inside the liquid a deficit of density stands for bubbles too small to see and is kept up to a limit. Volume
/// taken here is at zero pressure: no energy is lost with it.
fn swelling(support: f64) -> f64 {
    if support < PARTED {
        1.0
    } else {
        LARGEST_SWELLING
    }
}
