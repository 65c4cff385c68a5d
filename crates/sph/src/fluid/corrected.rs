//! The corrected formulation: divergence exact for linear velocities ([`super::kinematics`]), pressure gradient corrected
//! inside and plain at a free surface ([`super::momentum`]), Riemann dissipation, shifting that carries mass
//! ([`super::shifting`]). The order of a step: [`super::step`].

use crate::fluid::refinement::Changes;
use crate::fluid::step::Sweep;
use crate::fluid::{Fluid, PARTICLES_PER_TASK, shifting, sum_of_blocks};
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
        let mut memory = std::mem::take(&mut sweep.memory);
        let records = sweep.places.records(&mut memory.shifting);
        memory.shift.resize(self.len(), [0.0; D]);
        let mut volume = std::mem::take(&mut self.volume);
        let mut support = std::mem::take(&mut self.support);
        let mut strain_rate = std::mem::take(&mut self.strain_rate);
        let fluid = &*self;
        let parted = AtomicU64::new(0);
        let works = (memory.kinematics.results.par_chunks(PARTICLES_PER_TASK))
            .zip(volume.par_chunks_mut(PARTICLES_PER_TASK))
            .zip(support.par_chunks_mut(PARTICLES_PER_TASK))
            .zip(strain_rate.par_chunks_mut(PARTICLES_PER_TASK))
            .zip(memory.shift.par_chunks_mut(PARTICLES_PER_TASK))
            .zip(records.par_chunks_mut(PARTICLES_PER_TASK))
            .enumerate()
            .map(
                |(block, (((((results, volume), support), strain_rate), shift), records))| {
                    let (mut work, mut held) = (0.0, 0);
                    for (i, record) in records.iter_mut().enumerate() {
                        let (a, k) = (block * PARTICLES_PER_TASK + i, &results[i]);
                        support[i] = k.support;
                        strain_rate[i] = shifting::norm(&k.gradient);
                        let largest = fluid.largest_volume(a, k.support);
                        let free = volume[i] * (dt * (k.divergence + k.exchange / volume[i])).exp();
                        held += u64::from(free > largest);
                        volume[i] = if free > largest { largest } else { free };
                        let h = fluid.smoothing_length[a];
                        shift[i] = shifting::velocity(h, strain_rate[i], k, s);
                        *record =
                            shifting::Particle::new(fluid, a, volume[i], strain_rate[i], shift[i]);
                        work += fluid.pressure[a] * k.exchange;
                    }
                    parted.fetch_add(held, Ordering::Relaxed);
                    [work]
                },
            );
        let [work] = sum_of_blocks(works);
        (self.volume, self.support, self.strain_rate) = (volume, support, strain_rate);
        sweep.memory = memory;
        self.account.parted += parted.into_inner();
        self.account.dissipation += dt * work;
        shifting::exchange(self, sweep, dt);
    }

    /// Volume (m3) to which particle `a` may swell.
    fn largest_volume(&self, a: usize, support: f64) -> f64 {
        swelling(support) * self.mass[a] / self.eos.reference_density
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
