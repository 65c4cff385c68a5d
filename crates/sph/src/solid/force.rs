//! Accelerations of a total Lagrangian solid.
//!
//! rho0 R_a a_a = sum_b A_b (R_a P_a L_a + R_b P_b L_b) grad_a W_ab - P_tt e_r,  P = J sigma F^-T, P_tt = J s_tt/F_tt
//!
//! less what a uniform stress would leave of it on a packing that is no lattice (`balance.rs`).
//!
//! Added in the same sum over real particles and mirror images, both weighted with the mean of |R_a| and |R_b|, with
//! the smaller rho0 c_l and E where two materials meet:
//! viscosity alpha rho0 c_l h (v_ab.x_ab)/|X|^2 (dW/dX)/X x_ab on approach (Joshi 2018, eq. 5.22 with beta = 0, the
//! reference distance in place of the present one), for pairs of the first row of an open face also on separation; and
//! the hourglass penalty zeta E W/|X|^2 [(F_a + F_b)/2 X_ab - x_ab], zero for every linear field.
//!
//! Why the first row has its own viscosity: at an open face the force (with images) is not the adjoint of the strain
//! (without), and the row gains energy if nothing takes it out. alpha = 1 everywhere does, but costs a wave 11 % of its
//! height in 120 spacings (25 wide); alpha = 0.2 with 1 in the first row is as stable and costs 4 %.
//!
//! R is the signed radius in axisymmetry and 1 in plane strain. Units: SI.

use super::driven::DrivenPair;
use super::flux::Images;
use super::layers::Materials;
use super::mat2::Mat2;
use super::own::OfForce;
use super::points::TASK;
use super::reference::Reference;
use super::sums::{self, Moving, eight, lanes, matrices, vectors};
use super::surface::Surface;
use super::{Face, Formulation, Solid, absorbing};
use crate::geometry::{Geometry, Vec2};
use crate::simd::{self, LANES, Simd, Task};
use rayon::prelude::*;

/// What the sums over pairs read and write, and what is found on the way.
#[derive(Debug, Clone, Default)]
pub(super) struct Scratch {
    /// Positions of mirror images, m.
    pub(super) image_position: Vec<Vec2>,
    /// Their velocities, m/s.
    pub(super) image_velocity: Vec<Vec2>,
    pub(super) images: Images,
    /// Q of the particles.
    pub(super) flux: Vec<Mat2>,
    /// Clusters with particles behind the points of faces, ascending.
    pub(super) face_clusters: Vec<u32>,
    /// Pairs with images beyond driven faces.
    pub(super) driven: Vec<DrivenPair>,
    /// Particles laid bare by failure that an indenter pushes, with the forces, N.
    pub(super) bared: Vec<(u32, Vec2)>,
    pub(super) powers: Powers,
}

/// Power of the viscous and hourglass forces at the velocities, W, and that at velocities equal to the accelerations, W/s.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Powers {
    pub(super) viscous: [f64; 2],
    pub(super) hourglass: [f64; 2],
}

impl Powers {
    fn plus(self, other: Self) -> Self {
        let add = |a: [f64; 2], b: [f64; 2]| [a[0] + b[0], a[1] + b[1]];
        Self {
            viscous: add(self.viscous, other.viscous),
            hourglass: add(self.hourglass, other.hourglass),
        }
    }
}

impl Scratch {
    /// Of a body whose reference is known.
    pub(super) fn of(reference: &Reference, surfaces: &[Surface]) -> Self {
        Self {
            driven: DrivenPair::all(reference, surfaces),
            face_clusters: Solid::clusters_at_faces(surfaces),
            ..Self::default()
        }
    }
}

/// Accelerations of the particles of one task.
struct Accelerate<'a> {
    solid: &'a Solid,
    task: usize,
    acceleration: &'a mut [Vec2],
}

impl Task for Accelerate<'_> {
    type Output = Powers;

    #[inline(always)]
    fn run<S: Simd>(self) -> Powers {
        let mut powers = [S::splat(0.0); 4];
        for (k, acceleration) in self.acceleration.chunks_mut(LANES).enumerate() {
            let cluster = self.task * TASK / LANES + k;
            let [x, y] = self.solid.accelerate::<S>(cluster, &mut powers);
            let (x, y) = (x.store(), y.store());
            for (l, a) in acceleration.iter_mut().enumerate() {
                *a = [x[l], y[l]];
            }
        }
        let mut sums = [0.0; 4];
        for (sum, power) in sums.iter_mut().zip(powers) {
            *sum = power.store().iter().sum();
        }
        Powers {
            viscous: [sums[0], sums[1]],
            hourglass: [sums[2], sums[3]],
        }
    }
}

#[inline(always)]
fn dot<S: Simd>(a: [S; 2], b: [S; 2]) -> S {
    a[0].mul_add(b[0], a[1] * b[1])
}

impl Solid {
    /// Accelerations of a cluster; adds to the powers of viscous and hourglass forces.
    #[inline(always)]
    fn accelerate<S: Simd>(&self, cluster: usize, powers: &mut [S; 4]) -> [S; 2] {
        let (state, reference, scratch) = (&self.state, &self.reference, &self.scratch);
        let particles = Moving {
            position: &state.position,
            velocity: &state.velocity,
            deformation: &state.deformation,
            flux: &scratch.flux,
        };
        let images = Moving {
            position: &scratch.image_position,
            velocity: &scratch.image_velocity,
            deformation: &scratch.images.deformation,
            flux: &scratch.images.flux,
        };
        let sums = sums::forces::<S>(&reference.pairs, &particles, &images, cluster);
        let own = OfForce::from(reference.own.force[cluster].load::<S>());
        let q = matrices::<S>(&scratch.flux, cluster);
        let f = matrices::<S>(&state.deformation, cluster);
        let (mut force, mut hourglass) = (sums.stress, sums.hourglass);
        for i in 0..2 {
            force[i] = force[i] + dot([q[2 * i], q[2 * i + 1]], own.flux);
            hourglass[i] = hourglass[i] + dot([f[2 * i], f[2 * i + 1]], own.hourglass);
        }
        if reference.own.open[cluster] {
            let open = self.open_force(cluster);
            for i in 0..2 {
                force[i] = force[i] + S::load(&open[i]);
            }
        }
        if self.geometry == Geometry::Axisymmetric {
            let (stress, count) = eight(&state.stress, cluster);
            let determinant = f[0].mul_add(f[3], -(f[1] * f[2]));
            let hoop = determinant * lanes(0, count, |l| stress[l].zz);
            force[0] = force[0] - hoop * own.area;
        }
        let mut total = force;
        for i in 0..2 {
            total[i] = (force[i] + (sums.viscous[i] + hourglass[i])) * own.scale;
        }
        if !scratch.bared.is_empty() {
            self.push_bared(cluster, &mut total);
        }
        let v = vectors(&state.velocity, cluster);
        let weight = own.mass * own.scale;
        powers[0] = weight.mul_add(dot(sums.viscous, v), powers[0]);
        powers[1] = weight.mul_add(dot(sums.viscous, total), powers[1]);
        powers[2] = weight.mul_add(dot(hourglass, v), powers[2]);
        powers[3] = weight.mul_add(dot(hourglass, total), powers[3]);
        total
    }

    /// Force of the open images on the particles of a cluster, in the unit of the sums.
    fn open_force(&self, cluster: usize) -> [[f64; LANES]; 2] {
        let (reference, scratch) = (&self.reference, &self.scratch);
        let (own, _) = eight(&scratch.flux, cluster);
        let mut force = [[0.0; LANES]; 2];
        for (l, q) in own.iter().enumerate() {
            let a = cluster * LANES + l;
            for p in reference.open_pairs_of(a) {
                let qb = &scratch.images.open_flux[p.image as usize];
                let g = p.offset.map(|x| x * (p.gradient * reference.area[a]));
                for i in 0..2 {
                    force[i][l] += (q[i][0] + qb[i][0]) * g[0] + (q[i][1] + qb[i][1]) * g[1];
                }
            }
        }
        force
    }

    /// Adds the push of an indenter on particles laid bare to the accelerations of a cluster.
    #[cold]
    fn push_bared<S: Simd>(&self, cluster: usize, total: &mut [S; 2]) {
        let bared = &self.scratch.bared;
        let first = bared.partition_point(|(a, _)| (*a as usize) < cluster * LANES);
        let here = bared[first..].iter();
        let here = here.take_while(|(a, _)| (*a as usize) < (cluster + 1) * LANES);
        for (a, force) in here {
            let mass = self.reference.mass[*a as usize];
            for (total, force) in total.iter_mut().zip(force) {
                let mut push = [0.0; LANES];
                push[*a as usize % LANES] = force / mass;
                *total = *total + S::load(&push);
            }
        }
    }

    /// Evaluates all accelerations at the present positions, stresses, velocities and pressures.
    ///
    /// In a kick-drift-kick step call it after [`Self::update_stress`]: the velocities are then those of the half step.
    pub fn accelerations(&mut self) {
        match self.numerics.formulation {
            Formulation::Joshi(settings) => self.present_accelerations(&settings),
            Formulation::TotalLagrangian => self.reference_accelerations(),
        }
    }

    fn reference_accelerations(&mut self) {
        self.place_images();
        self.move_images();
        self.press();
        self.press_bared();
        self.set_tractions();
        self.fluxes();
        let mut acceleration = std::mem::take(&mut self.state.acceleration);
        let solid = &*self;
        let powers: Vec<Powers> = (acceleration.par_chunks_mut(TASK).enumerate())
            .map(|(task, acceleration)| {
                simd::run(Accelerate {
                    solid,
                    task,
                    acceleration,
                })
            })
            .collect();
        self.state.acceleration = acceleration;
        self.scratch.powers = powers.into_iter().fold(Powers::default(), Powers::plus);
        self.driven_tractions();
    }

    fn set_tractions(&mut self) {
        let materials = Materials {
            own: &self.material,
            layers: &self.layers,
        };
        for surface in &mut self.surfaces {
            for j in 0..surface.particle.len() {
                if surface.driven[j] {
                    continue;
                }
                let a = surface.particle[j];
                surface.traction[j] = if !surface.holds[j] {
                    [0.0; 2]
                } else if surface.face == Face::Absorbing {
                    let (stress, velocity) = (self.state.stress[a], self.state.velocity[a]);
                    absorbing::traction(materials.of(a), surface, stress, velocity)
                } else {
                    let mut t = surface.contact[j];
                    t[surface.side.normal_axis()] -= surface.pressure[j] * surface.side.sign();
                    t
                };
            }
        }
    }
}
