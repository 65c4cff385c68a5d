//! Refinement that follows a collapse: particles are halved where they are too large for the cavity next to them, and
//! merged again where they no longer need to be small.
//!
//! Wanted spacing at x: R/`per_radius` + `growth` d, the least over all cavities; R is the radius of the ball with the volume
//! of the cavity, d the distance from its surface ([`target`]). A particle whose root of area exceeds it by a fifth is halved
//! ([`split`]); two halves that are small for it become one again ([`merge`]). Mass and axial (in plane: all) momentum are kept
//! to rounding; the change of energy is booked as dissipation.
//!
//! Why: liquid that converges on a point is stretched along the radius; the area V/(2 pi r) of its particles grows as
//! (R0/R) while the cavity shrinks, and n particles over R0 are n (R/R0)^(3/2) over R.

mod merge;
mod particles;
mod split;
mod target;

use crate::cavity::Front;
use crate::fluid::{Clustering, Fluid, Formulation};
use serde::{Deserialize, Serialize};

/// What is asked of the spacing near cavities.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Refinement {
    /// Particles per radius of the cavity at its surface.
    pub per_radius: f64,
    /// Growth of the spacing per distance from the surface.
    pub growth: f64,
    /// Cavities with a smaller radius are not followed, m: they would ask for ever smaller particles.
    pub smallest: f64,
}

/// Steps from one refinement to the next: the surface moves by less than a spacing in between.
const EVERY: u64 = 2;

/// Steps from one merging to the next: sound crosses some spacings, so that a wave that leaves a collapse widens with them.
const MERGE_EVERY: u64 = 32;

/// What refinement did since the start.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Changes {
    /// Particles halved.
    pub splits: u64,
    /// Pairs merged.
    pub merges: u64,
    /// Kinetic and compression energy that this took out, J; part of the dissipation.
    pub energy: f64,
}

/// Where a particle comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Origin {
    /// Number of its own for good; those of the start have the first ones. Of two that merge the lower place keeps its own.
    pub id: u32,
    /// Times it was halved.
    pub level: u32,
}

impl Refinement {
    /// Whether something is done after step number `step`: cavities need not be looked for otherwise.
    #[must_use]
    pub fn is_due(step: u64) -> bool {
        step.is_multiple_of(EVERY)
    }
}

impl Fluid {
    /// Halves and merges after step number `step`, once. Particles with a far field stay as they are. Those that stay keep
    /// their order, new ones follow: the same bits for any number of threads and after a restart.
    ///
    /// The published formulation is left alone: its sum of densities knows particles of one size only.
    pub fn refine(&mut self, refinement: &Refinement, fronts: &[Front], step: u64) {
        if !Refinement::is_due(step) || matches!(self.formulation, Formulation::Joshi(_)) {
            return;
        }
        let mut wanted = target::wanted(self, refinement, fronts);
        let before = self.kinetic_energy() + self.compression_energy();
        let merges = if step.is_multiple_of(MERGE_EVERY) {
            self.merge(&mut wanted)
        } else {
            0
        };
        let splits = self.split(&wanted);
        if merges + splits == 0 {
            return;
        }
        self.clustering = Clustering::default();
        let loss = before - self.kinetic_energy() - self.compression_energy();
        self.account.dissipation += loss;
        let changes = &mut self.account.refinement;
        changes.splits += splits;
        changes.merges += merges;
        changes.energy += loss;
    }
}

#[cfg(test)]
mod tests;
