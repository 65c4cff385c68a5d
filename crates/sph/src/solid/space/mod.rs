//! Elastic-plastic solid in three dimensions, total Lagrangian.
//!
//! The body is what its particles say: reference positions and volumes, of any (also graded) spacing. All its faces are free, as
//! `Face::Free` in the plane: no images, the force is the adjoint of the strain, energy is kept without viscosity. Components of
//! the velocity of particles can be held: symmetry planes, clamped and driven parts.
//!
//! Particles stand in clusters of eight, and so do all numbers about them (`blocks.rs`); neighbours are found once (`list.rs`), their
//! weights are computed anew in every sum (`weight.rs`), which needs no memory and neither root nor quotient. The formulas stand
//! on top of `sums.rs` and `points.rs`. Sums have one writer and a fixed order: results are the same bits for any number of
//! threads and any width of the lanes.

mod energy;
mod error;
mod lanes;
mod list;
mod patches;
mod points;
mod reference;
mod setup;
mod step;
mod stretch;
mod sums;
mod weight;

pub use super::blocks::Blocks;
pub use energy::Work;
pub use error::SpaceError;
pub use setup::{Numerics, Setup};

use super::blocks;
use crate::simd::LANES;
use erode_physics::Sym3;
use erode_physics::material_point::Material;
use reference::Reference;
use serde::{Deserialize, Serialize};

/// Clusters per task: large enough to hide the cost of a task. The ledger adds task by task.
const TASK: usize = 32;

/// A solid body in three dimensions; its particles stand in an order of their own ([`Self::order`]).
#[derive(Debug, Clone)]
pub struct SpaceSolid {
    /// Material.
    pub material: Material,
    /// Numerical constants.
    pub numerics: Numerics,
    /// Which of the particles of the setup each particle was.
    pub order: Vec<u32>,
    /// What changes with time; see [`Self::resume`].
    pub state: State,
    reference: Reference,
    stabilisers: Stabilisers,
    /// 1 where a component of the velocity is free, 0 where it is held; none when all are free.
    free: Option<Blocks<3>>,
}

/// What changes with time: everything a checkpoint has to keep.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// Position, m.
    pub position: Blocks<3>,
    /// Velocity, m/s.
    pub velocity: Blocks<3>,
    /// Acceleration, m/s2.
    pub acceleration: Blocks<3>,
    /// Deformation gradient dx/dX, rows first.
    pub deformation: Blocks<9>,
    /// J sigma F^-T M^-1 with the moment matrix M of the reference, Pa: the stress as forces need it; see [`SpaceSolid::stress`].
    pub flux: Blocks<9>,
    /// Equivalent plastic strain.
    pub plastic_strain: Blocks<1>,
    /// Its rate in the last step, 1/s.
    pub plastic_strain_rate: Blocks<1>,
    /// Plastic work per reference volume, J/m3.
    pub plastic_work: Blocks<1>,
    /// Work done so far.
    pub work: Work,
}

impl State {
    /// Entries of each field.
    fn lengths(&self) -> [usize; 8] {
        [
            self.position.len(),
            self.velocity.len(),
            self.acceleration.len(),
            self.deformation.len(),
            self.flux.len(),
            self.plastic_strain.len(),
            self.plastic_strain_rate.len(),
            self.plastic_work.len(),
        ]
    }
}

/// Factors of the sums of viscous and hourglass accelerations.
#[derive(Debug, Clone, Copy)]
struct Stabilisers {
    viscous: f64,
    hourglass: f64,
}

impl SpaceSolid {
    /// Builds the body at rest and free of stress.
    ///
    /// # Errors
    /// If a position is not finite, a volume not positive, or a particle has too few neighbours for a gradient.
    pub fn new(setup: &Setup) -> Result<Self, SpaceError> {
        setup.check()?;
        let order = patches::order(&setup.position);
        let (material, numerics) = (setup.material, setup.numerics);
        let reference = Reference::new(setup, &order)?;
        let n = order.len();
        let [hourglass, viscous] = weight::stabiliser_factors(numerics.smoothing_ratio);
        let speed = material.elastic.longitudinal_speed(material.density);
        let stiffness = material.elastic.young_modulus / material.density;
        Ok(Self {
            material,
            numerics,
            state: State {
                position: Blocks::collect(n, |a| setup.position[order[a] as usize]),
                velocity: Blocks::splat(n, [0.0; 3]),
                acceleration: Blocks::splat(n, [0.0; 3]),
                deformation: Blocks::splat(n, [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]),
                flux: Blocks::splat(n, [0.0; 9]),
                plastic_strain: Blocks::splat(n, [0.0]),
                plastic_strain_rate: Blocks::splat(n, [0.0]),
                plastic_work: Blocks::splat(n, [0.0]),
                work: Work::default(),
            },
            stabilisers: Stabilisers {
                viscous: numerics.viscosity * speed * viscous,
                hourglass: numerics.hourglass * stiffness * hourglass,
            },
            reference,
            free: None,
            order,
        })
    }

    /// Number of particles.
    #[must_use]
    pub fn len(&self) -> usize {
        self.order.len()
    }

    /// Whether there are no particles.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.order.is_empty()
    }

    /// Takes up a state that was saved.
    ///
    /// # Errors
    /// If it has another number of particles.
    pub fn resume(&mut self, state: State) -> Result<(), SpaceError> {
        let n = self.len();
        if let Some(state) = state.lengths().into_iter().find(|len| *len != n) {
            return Err(SpaceError::OtherState { state, solid: n });
        }
        self.state = state;
        Ok(())
    }

    /// Holds components of the velocity of a particle at what they are from now on; set the velocity itself in the state.
    pub fn hold(&mut self, particle: usize, components: [bool; 3]) {
        let n = self.len();
        let free = self.free.get_or_insert_with(|| Blocks::splat(n, [1.0; 3]));
        free.set(particle, components.map(|held| f64::from(u8::from(!held))));
    }

    /// Directed pairs of particles within the support.
    #[must_use]
    pub fn pairs(&self) -> usize {
        self.reference.list.pairs
    }

    /// Places in the lists of all clusters: eight pairs are computed for each.
    #[must_use]
    pub fn list_length(&self) -> usize {
        let clusters = 0..self.reference.place.blocks.len();
        clusters.map(|c| self.reference.list.neighbours(c)).sum()
    }

    /// Bytes that the body takes: state, reference and lists.
    #[must_use]
    pub fn memory(&self) -> usize {
        let (r, s) = (&self.reference, &self.state);
        let vectors = s.position.memory() + s.velocity.memory() + s.acceleration.memory();
        let matrices = s.deformation.memory() + s.flux.memory();
        let scalars = s.plastic_strain.memory() + s.plastic_strain_rate.memory();
        let reference = r.place.memory() + r.moment.memory() + r.list.memory();
        let held = self.free.as_ref().map_or(0, Blocks::memory);
        let order = self.order.len() * size_of::<u32>();
        vectors + matrices + scalars + s.plastic_work.memory() + reference + held + order
    }

    /// Reference position of a particle, m.
    #[must_use]
    pub fn reference_position(&self, particle: usize) -> [f64; 3] {
        let [x, y, z, _, _] = self.reference.place.get(particle);
        [x, y, z]
    }

    /// Reference volume of a particle, m3.
    #[must_use]
    pub fn volume(&self, particle: usize) -> f64 {
        self.spacing(particle).powi(3)
    }

    /// Cubic root of the reference volume, m.
    fn spacing(&self, particle: usize) -> f64 {
        self.reference.place.get(particle)[3] / self.numerics.smoothing_ratio
    }

    /// J = present / reference volume of a particle.
    #[must_use]
    pub fn volume_ratio(&self, particle: usize) -> f64 {
        let f = self.state.deformation.get(particle);
        let minor = |i: usize, j: usize| f[3 + i] * f[6 + j] - f[3 + j] * f[6 + i];
        f[0] * minor(1, 2) + f[1] * minor(2, 0) + f[2] * minor(0, 1)
    }

    /// Kirchhoff stress tau = J sigma = Q M F^T of a particle, Pa.
    #[must_use]
    pub fn kirchhoff_stress(&self, particle: usize) -> Sym3 {
        let q = self.state.flux.get(particle);
        let m = self.reference.moment.get(particle);
        let f = self.state.deformation.get(particle);
        let nominal =
            |i: usize, k: usize| -> f64 { (0..3).map(|l| q[3 * i + l] * m[lanes::AT[l][k]]).sum() };
        let tau =
            |i: usize, j: usize| -> f64 { (0..3).map(|k| nominal(i, k) * f[3 * j + k]).sum() };
        Sym3 {
            xx: tau(0, 0),
            yy: tau(1, 1),
            zz: tau(2, 2),
            xy: tau(0, 1),
            xz: tau(0, 2),
            yz: tau(1, 2),
        }
    }

    /// Cauchy stress of a particle, Pa.
    #[must_use]
    pub fn stress(&self, particle: usize) -> Sym3 {
        self.kirchhoff_stress(particle) * (1.0 / self.volume_ratio(particle))
    }

    /// Temperature of a particle, K: plastic work heats it, nothing is conducted.
    #[must_use]
    pub fn temperature(&self, particle: usize) -> f64 {
        let [work] = self.state.plastic_work.get(particle);
        let m = &self.material;
        let thermal = m.strength.thermal();
        m.temperature + thermal.map_or(0.0, |t| t.heating(work, m.density))
    }

    /// Masses of the particles of a cluster, kg; 0 for what fills up the last one.
    #[inline(always)]
    fn masses(&self, cluster: usize) -> [f64; LANES] {
        let h = &self.reference.place.blocks[cluster].0[3];
        let count = LANES.min(self.len() - cluster * LANES);
        let mut masses = [0.0; LANES];
        for l in 0..count {
            let spacing = h[l] / self.numerics.smoothing_ratio;
            masses[l] = self.material.density * (spacing * spacing * spacing);
        }
        masses
    }
}
