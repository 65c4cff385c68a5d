//! The spacing that is wanted at a place.

use super::Refinement;
use crate::cavity::Front;
use crate::fluid::{Fluid, PARTICLES_PER_TASK};
use crate::geometry::Vec2;
use rayon::prelude::*;

/// Wanted spacing near some cavities.
pub(super) struct Target<'a> {
    refinement: &'a Refinement,
    fronts: &'a [Front],
}

impl<'a> Target<'a> {
    pub(super) fn new(refinement: &'a Refinement, fronts: &'a [Front]) -> Self {
        Self { refinement, fronts }
    }

    /// m; infinite without a cavity.
    fn spacing(&self, x: Vec2) -> f64 {
        let near = |f: &Front| {
            f.radius / self.refinement.per_radius + self.refinement.growth * f.distance(x)
        };
        self.fronts.iter().map(near).fold(f64::INFINITY, f64::min)
    }

    /// For every particle, m.
    pub(super) fn spacings(&self, fluid: &Fluid) -> Vec<f64> {
        (fluid.position.par_iter())
            .with_min_len(PARTICLES_PER_TASK)
            .map(|x| self.spacing(*x))
            .collect()
    }
}
