//! Refinement that follows a collapse: particles are split where the spacing is too large for the cavity next to them,
//! and merged again where it no longer needs to be small.
//!
//! Wanted spacing at x: the smallest of R/`per_radius` + `growth` times distance, over all cavities; R is the radius of the
//! ball with the volume of the cavity, the distance that from its surface. A particle with sqrt(A) above the wanted spacing
//! is halved ([`split`]); two halves that are small for it become one again ([`merge`]). Mass and momentum are kept to
//! rounding; the change of energy is booked.

mod merge;
mod particles;
mod split;
mod target;

use crate::cavity::Front;
use crate::fluid::{Clustering, Fluid, Formulation};
use serde::{Deserialize, Serialize};
use target::Target;

/// What is asked of the spacing near cavities.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Refinement {
    /// Particles per radius of the cavity at its surface.
    pub per_radius: f64,
    /// Growth of the spacing per distance from the surface.
    pub growth: f64,
    /// Largest number of times that a particle of the start is halved.
    pub levels: u32,
}

/// Steps from one refinement to the next: the surface moves by less than a spacing in between.
pub const EVERY: u64 = 4;

/// What refinement did since the start.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Changes {
    /// Particles halved.
    pub splits: u64,
    /// Pairs merged.
    pub merges: u64,
    /// Energy that halving and merging took out, J; part of the dissipation.
    pub energy: f64,
}

/// Where a particle comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Origin {
    /// Number of its own; those of the start have the first ones.
    pub id: u32,
    /// Times it was halved.
    pub level: u32,
}

impl Fluid {
    /// Splits and merges once. Particles with a far field stay as they are. Order: those that stay keep theirs, new ones
    /// follow; the same bits for any number of threads.
    ///
    /// The published formulation is left alone: its density is a sum that knows no particles of different size.
    pub fn refine(&mut self, refinement: &Refinement, fronts: &[Front]) {
        if let Formulation::Joshi(_) = self.formulation {
            return;
        }
        let target = Target::new(refinement, fronts);
        let mut wanted = target.spacings(self);
        let before = self.kinetic_energy() + self.compression_energy();
        let merged = self.merge(&mut wanted);
        let split = self.split(&wanted, refinement.levels);
        if merged + split == 0 {
            return;
        }
        self.clustering = Clustering::of(self.len());
        let after = self.kinetic_energy() + self.compression_energy();
        self.account.dissipation += before - after;
        let changes = &mut self.account.refinement;
        changes.splits += split;
        changes.merges += merged;
        changes.energy += before - after;
    }
}

/// Scratch.
pub(crate) fn tune(n: &str, d: f64) -> f64 {
    std::env::var(n).ok().and_then(|v| v.parse().ok()).unwrap_or(d)
}
