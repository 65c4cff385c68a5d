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

use super::images::{Flux, Image};
use super::layers::Materials;
use super::mat2::{Mat2, apply, combine, determinant, product, scaled};
use super::pairs::Pair;
use super::reference::Reference;
use super::state::State;
use super::stress::TASK;
use super::sums::{self, Forces, Matrices, Moving};
use super::surface::Surface;
use super::{Face, Formulation, Solid, absorbing};
use crate::geometry::{Geometry, Vec2};
use rayon::prelude::*;

/// What the sums over pairs read and write, and what is found on the way.
#[derive(Debug, Clone, Default)]
pub(super) struct Scratch {
    /// Positions of particles, then of mirror images, m.
    pub(super) position: Vec<Vec2>,
    /// Velocities of the same, m/s.
    pub(super) velocity: Vec<Vec2>,
    /// Sums of the deformation gradient, by clusters.
    pub(super) gradients: Vec<Matrices>,
    moving: Vec<Moving>,
    forces: Vec<Forces>,
    open_flux: Vec<Mat2>,
    /// P_tt, zero in plane strain.
    hoop: Vec<f64>,
    /// Pairs with images beyond driven faces.
    driven: Vec<DrivenPair>,
    /// Particles laid bare by failure that an indenter pushes, with the forces, N.
    pub(super) bared: Vec<(u32, Vec2)>,
    pub(super) viscous: Vec<Vec2>,
    pub(super) hourglass: Vec<Vec2>,
}

/// A pair through which a driven face acts.
#[derive(Debug, Clone, Copy)]
struct DrivenPair {
    particle: u32,
    /// Where it stands in the lists of `pairs.rs`.
    place: u32,
    surface: u32,
    point: u32,
}

/// The three parts of an acceleration.
#[derive(Default)]
struct Parts {
    total: Vec2,
    viscous: Vec2,
    hourglass: Vec2,
}

impl Scratch {
    /// Finds the pairs through which driven faces act.
    pub(super) fn of(reference: &Reference, surfaces: &[Surface]) -> Self {
        let n = reference.position.len();
        let mut driven = Vec::new();
        for (surface, face) in surfaces.iter().enumerate() {
            for particle in 0..n {
                for place in reference.pairs.places_of(particle) {
                    let neighbour = reference.pairs.neighbour(place);
                    let Some(image) = neighbour.checked_sub(n) else {
                        continue;
                    };
                    let image = reference.mirror_images[image];
                    if image.beyond(face.side) {
                        driven.push(DrivenPair {
                            particle: particle as u32,
                            place: place as u32,
                            surface: surface as u32,
                            point: face.foot(image.source) as u32,
                        });
                    }
                }
            }
        }
        Self {
            driven,
            ..Self::default()
        }
    }

    /// Acceleration of a particle by one of its real or mirrored neighbours.
    fn by(&self, reference: &Reference, a: usize, p: &Pair) -> Vec2 {
        let b = p.neighbour as usize;
        let g = [p.offset[0] * p.gradient, p.offset[1] * p.gradient];
        let (own, other) = (&self.moving[a], &self.moving[b]);
        let d = [0, 1].map(|i| own.position[i] - other.position[i]);
        let v = [0, 1].map(|i| own.velocity[i] - other.velocity[i]);
        let along = v[0] * d[0] + v[1] * d[1];
        let per_density = 1.0 / reference.density[a];
        let approach = per_density * along * if along < 0.0 { p.viscous } else { p.separating };
        let stiffness = per_density * p.hourglass;
        let (q, f) = (
            combine(&own.flux, 1.0, &other.flux, 1.0),
            combine(&own.half_deformation, 1.0, &other.half_deformation, 1.0),
        );
        let (force, linear) = (apply(&q, g), apply(&f, p.offset));
        let scale = 1.0 / (reference.density[a] * reference.weight[a]);
        [0, 1].map(|i| force[i] * scale + approach * d[i] + stiffness * (linear[i] - d[i]))
    }

    /// Acceleration from the sums over pairs, the open images and the hoop stress.
    fn acceleration(&self, reference: &Reference, a: usize) -> Parts {
        if reference.forgotten[a] {
            return Parts::default();
        }
        let (cluster, lane) = reference.pairs.slot(a);
        let sum = self.forces[cluster].map(|s| s[lane]);
        let q = &self.moving[a].flux;
        let mut force = [sum[0], sum[1]];
        for p in reference.open_pairs_of(a) {
            let qb = &self.open_flux[p.image as usize];
            let g = [p.offset[0] * p.gradient, p.offset[1] * p.gradient];
            for i in 0..2 {
                force[i] += (q[i][0] + qb[i][0]) * g[0] + (q[i][1] + qb[i][1]) * g[1];
            }
        }
        let imbalance = apply(q, reference.imbalance[a]);
        force[0] -= imbalance[0] + self.hoop[a];
        force[1] -= imbalance[1];
        let scale = 1.0 / (reference.density[a] * reference.weight[a]);
        let half = 0.5 / reference.density[a];
        let viscous = [sum[2], sum[3]].map(|x| half * x);
        let hourglass = [sum[4], sum[5]].map(|x| half * x);
        Parts {
            total: [0, 1].map(|i| force[i] * scale + viscous[i] + hourglass[i]),
            viscous,
            hourglass,
        }
    }
}

impl Solid {
    /// Positions of particles and mirror images for the gather loops.
    pub(super) fn place_images(&mut self) {
        let (reference, surfaces, block) = (&self.reference, &self.surfaces, &self.block);
        let position = &mut self.scratch.position;
        position.clear();
        position.extend_from_slice(&self.state.position);
        for (image, place) in (reference.mirror_images.iter()).zip(&reference.image_position) {
            let b = image.source as usize;
            let (x, start) = (self.state.position[b], reference.position[b]);
            let u = [x[0] - start[0], x[1] - start[1]];
            let u = image.displacement(block, surfaces, start, u);
            position.push([place[0] + u[0], place[1] + u[1]]);
        }
    }

    pub(super) fn move_images(&mut self) {
        let velocity = &mut self.scratch.velocity;
        velocity.clear();
        velocity.extend_from_slice(&self.state.velocity);
        for image in &self.reference.mirror_images {
            let v = self.state.velocity[image.source as usize];
            velocity.push(image.velocity(&self.surfaces, v));
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
        self.press_bared();
    }

    fn reference_accelerations(&mut self) {
        self.place_images();
        self.move_images();
        self.press();
        self.set_tractions();
        self.fluxes();
        sums::forces(
            &self.reference.pairs,
            &self.scratch.moving,
            &mut self.scratch.forces,
        );
        let mut viscous = std::mem::take(&mut self.scratch.viscous);
        let mut hourglass = std::mem::take(&mut self.scratch.hourglass);
        viscous.resize(self.len(), [0.0; 2]);
        hourglass.resize(self.len(), [0.0; 2]);
        let (scratch, reference) = (&self.scratch, &self.reference);
        (&mut self.state.acceleration, &mut viscous, &mut hourglass)
            .into_par_iter()
            .enumerate()
            .with_min_len(TASK)
            .for_each(|(a, (total, viscous, hourglass))| {
                let parts = scratch.acceleration(reference, a);
                (*total, *viscous, *hourglass) = (parts.total, parts.viscous, parts.hourglass);
            });
        (self.scratch.viscous, self.scratch.hourglass) = (viscous, hourglass);
        self.driven_tractions();
    }

    /// Tractions of the driven points: the forces of the images beyond them per reference area.
    fn driven_tractions(&mut self) {
        for surface in &mut self.surfaces {
            for j in (0..surface.area.len()).filter(|&j| surface.driven[j]) {
                surface.traction[j] = [0.0; 2];
            }
        }
        let (scratch, reference) = (&self.scratch, &self.reference);
        for d in &scratch.driven {
            let (a, j) = (d.particle as usize, d.point as usize);
            let pair = reference.pairs.pair(a, d.place as usize);
            let acceleration = scratch.by(reference, a, &pair);
            let surface = &mut self.surfaces[d.surface as usize];
            let share = reference.mass[a] / surface.area[j];
            for (t, acceleration) in surface.traction[j].iter_mut().zip(acceleration) {
                *t += share * acceleration;
            }
        }
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

    fn fluxes(&mut self) {
        let (state, reference) = (&self.state, &self.reference);
        let axisymmetric = self.geometry == Geometry::Axisymmetric;
        let scratch = &mut self.scratch;
        let images = scratch.position.len();
        scratch.moving.resize(images, Moving::default());
        scratch.hoop.resize(state.position.len(), 0.0);
        let (moving, _) = scratch.moving.split_at_mut(state.position.len());
        (moving, &mut scratch.hoop)
            .into_par_iter()
            .enumerate()
            .with_min_len(TASK)
            .for_each(|(a, (moving, hoop))| {
                let f = &state.deformation[a];
                let nominal = weighted_nominal(state, reference, a);
                *moving = Moving {
                    position: state.position[a],
                    velocity: state.velocity[a],
                    half_deformation: scaled(f, 0.5),
                    flux: product(&nominal, &reference.full_correction[a]),
                };
                *hoop = if axisymmetric {
                    determinant(f) * state.stress[a].zz
                } else {
                    0.0
                };
            });
        self.image_fluxes(axisymmetric);
    }

    fn image_fluxes(&mut self, axisymmetric: bool) {
        let (state, reference) = (&self.state, &self.reference);
        let (block, surfaces) = (&self.block, &self.surfaces);
        let at = |image: &Image| {
            let b = image.source as usize;
            let source = Flux {
                flux: weighted_nominal(state, reference, b),
                correction: reference.full_correction[b],
                weight: reference.weight[b],
            };
            source.at_image(image, block, axisymmetric, surfaces)
        };
        let scratch = &mut self.scratch;
        let n = state.position.len();
        for (k, image) in reference.mirror_images.iter().enumerate() {
            let b = image.source as usize;
            let (x, start) = (state.position[b], reference.position[b]);
            let u = [x[0] - start[0], x[1] - start[1]];
            let f = image.deformation(block, surfaces, start, u, state.deformation[b]);
            scratch.moving[n + k] = Moving {
                position: scratch.position[n + k],
                velocity: scratch.velocity[n + k],
                half_deformation: scaled(&f, 0.5),
                flux: at(image),
            };
        }
        scratch.open_flux.clear();
        scratch
            .open_flux
            .extend(reference.open_images.iter().map(at));
    }
}

/// R P in the plane of motion, P = J sigma F^-T.
fn weighted_nominal(state: &State, reference: &Reference, a: usize) -> Mat2 {
    let (f, s) = (&state.deformation[a], state.stress[a]);
    // J F^-T = F_tt cof F, without a quotient.
    let cofactor = [[f[1][1], -f[1][0]], [-f[0][1], f[0][0]]];
    let nominal = product(&[[s.xx, s.xy], [s.xy, s.yy]], &cofactor);
    scaled(&nominal, reference.weight[a] * state.hoop_stretch[a])
}
