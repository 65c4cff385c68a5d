//! What the particles of a cluster need of themselves in the sums, eight side by side.

use super::blocks::Block;
use super::mat2::{Mat2, scaled};
use super::reference::Reference;
use crate::simd::LANES;

/// Constants of all clusters.
#[derive(Debug, Clone, Default)]
pub(super) struct Own {
    /// L_own/A: from the sums of gradients to the deformation gradient.
    pub(super) strain: Vec<Block<4>>,
    /// R L_full: from P to the flux.
    pub(super) flux: Vec<Block<4>>,
    pub(super) force: Vec<Block<7>>,
    /// Whether open images act on one of them.
    pub(super) open: Vec<bool>,
}

/// What forces need.
pub(super) struct OfForce<T> {
    /// sum g X, less A times the imbalance (`balance.rs`): the flux of a particle itself times this is its share in the force.
    pub(super) flux: [T; 2],
    /// sum e X, the same of the deformation gradient in the hourglass force.
    pub(super) hourglass: [T; 2],
    /// From the sums to accelerations: 1/(rho0 R A), 0 for a particle that was taken out.
    pub(super) scale: T,
    /// Area, m2.
    pub(super) area: T,
    /// Mass, kg.
    pub(super) mass: T,
}

impl<T> From<[T; 7]> for OfForce<T> {
    #[inline(always)]
    fn from([a, b, c, d, scale, area, mass]: [T; 7]) -> Self {
        Self {
            flux: [a, b],
            hourglass: [c, d],
            scale,
            area,
            mass,
        }
    }
}

impl Own {
    /// Of a body whose pairs, corrections and imbalances are known.
    pub(super) fn of(reference: &Reference) -> Self {
        let clusters = 0..reference.pairs.clusters();
        let mut own = Self {
            strain: vec![Block([[0.0; LANES]; 4]); clusters.len()],
            flux: vec![Block([[0.0; LANES]; 4]); clusters.len()],
            force: vec![Block([[0.0; LANES]; 7]); clusters.len()],
            open: vec![false; clusters.len()],
        };
        clusters.for_each(|c| own.settle(reference, c));
        own
    }

    /// Brings the constants of a cluster up to the reference.
    pub(super) fn settle(&mut self, reference: &Reference, cluster: usize) {
        let last = reference.position.len() - 1;
        self.open[cluster] = false;
        for lane in 0..LANES {
            // The last cluster is filled up with the last particle, which then counts once.
            let place = cluster * LANES + lane;
            let a = place.min(last);
            let strain = scaled(&reference.own_correction[a], 1.0 / reference.area[a]);
            let flux = scaled(&reference.full_correction[a], reference.weight[a]);
            set(&mut self.strain[cluster], lane, flat(&strain));
            set(&mut self.flux[cluster], lane, flat(&flux));
            let mut force = of_force(reference, a);
            if place > last {
                force[6] = 0.0;
            }
            set(&mut self.force[cluster], lane, force);
            self.open[cluster] |= !reference.open_pairs_of(a).is_empty();
        }
    }
}

fn of_force(reference: &Reference, a: usize) -> [f64; 7] {
    let (area, mass) = (reference.area[a], reference.mass[a]);
    let ring = area * reference.weight[a];
    let imbalance = reference.imbalance[a];
    let [mut flux, mut hourglass] = [imbalance.map(|x| -area * x), [0.0; 2]];
    for p in reference.pairs_of(a) {
        for k in 0..2 {
            flux[k] += area * p.gradient * p.offset[k];
            hourglass[k] += 0.5 * ring * p.hourglass * p.offset[k];
        }
    }
    let scale = if reference.forgotten[a] {
        0.0
    } else {
        1.0 / (reference.density[a] * ring)
    };
    let ([x, y], [u, v]) = (flux, hourglass);
    [x, y, u, v, scale, area, mass]
}

fn flat(m: &Mat2) -> [f64; 4] {
    [m[0][0], m[0][1], m[1][0], m[1][1]]
}

fn set<const N: usize>(block: &mut Block<N>, lane: usize, numbers: [f64; N]) {
    for (lanes, x) in block.0.iter_mut().zip(numbers) {
        lanes[lane] = x;
    }
}
