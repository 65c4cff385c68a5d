//! The spacing that is wanted at a particle, and how the liquid moves there.

use super::Refinement;
use crate::cavity::Front;
use crate::fluid::{Fluid, PARTICLES_PER_TASK};
use crate::geometry::Vec2;
use rayon::prelude::*;

/// Below this eigenvalue of the moment matrix a particle is a fragment, and its velocity gradient is worth nothing: both
/// halves move as the whole.
const FRAGMENT: f64 = 0.35;

/// What halving and merging know of a particle.
pub(super) struct Wanted {
    /// Spacing, m; infinite without a cavity.
    pub(super) spacing: f64,
    /// Velocity gradient of the last step, 1/s; zero for fragments and before the first step.
    pub(super) gradient: [Vec2; 2],
}

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

/// For every particle. Where a particle of the start is fine enough for a lower bound of the spacing, the bound is given.
pub(super) fn wanted(fluid: &Fluid, refinement: &Refinement, fronts: &[Front]) -> Vec<Wanted> {
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
            let fine = fluid.origin[a].level == 0 && fluid.area(a) <= bound * bound;
            let spacing = if fine {
                bound
            } else {
                least(&|c| c.front.distance(x))
            };
            let gradient = gradient(fluid, a);
            Wanted { spacing, gradient }
        })
        .collect()
}

fn gradient(fluid: &Fluid, a: usize) -> [Vec2; 2] {
    let sweep = &fluid.sweep;
    // The places are those of the last step unless particles came or went since.
    if sweep.places.len() != fluid.len() || fluid.support[a] <= FRAGMENT {
        return [[0.0; 2]; 2];
    }
    sweep.kinematics(a).gradient
}
