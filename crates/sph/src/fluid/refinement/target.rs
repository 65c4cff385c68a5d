//! The spacing that is wanted at a particle.

use super::Refinement;
use crate::cavity::Front;
use crate::fluid::{Fluid, PARTICLES_PER_TASK};
use crate::geometry::Vec2;
use rayon::prelude::*;

/// A cavity with a box around it.
struct Cavity<'a> {
    front: &'a Front,
    extent: [Vec2; 2],
}

impl Cavity<'_> {
    /// Distance from the box, m: no more than that from the surface where it is outside.
    fn least_distance(&self, x: Vec2) -> f64 {
        let [lower, upper] = self.extent;
        let [dx, dy] = [0, 1].map(|k| (lower[k] - x[k]).max(x[k] - upper[k]).max(0.0));
        dx.hypot(dy)
    }
}

/// For every particle, m; infinite without a cavity. Where a particle of the start is fine enough for a lower bound, the
/// bound is given.
pub(super) fn spacings(fluid: &Fluid, refinement: &Refinement, fronts: &[Front]) -> Vec<f64> {
    let followed = fronts.iter().filter(|f| f.radius >= refinement.smallest);
    let cavities: Vec<Cavity> = followed
        .map(|front| Cavity {
            front,
            extent: front.extent(),
        })
        .collect();
    let least = |distance: &dyn Fn(&Cavity) -> f64| {
        let near =
            |c: &Cavity| c.front.radius / refinement.per_radius + refinement.growth * distance(c);
        cavities.iter().map(near).fold(f64::INFINITY, f64::min)
    };
    (0..fluid.len())
        .into_par_iter()
        .with_min_len(PARTICLES_PER_TASK)
        .map(|a| {
            let x = fluid.position[a];
            let bound = least(&|c| c.least_distance(x));
            if fluid.origin[a].level == 0 && fluid.area(a) <= bound * bound {
                bound
            } else {
                least(&|c| c.front.distance(x))
            }
        })
        .collect()
}
