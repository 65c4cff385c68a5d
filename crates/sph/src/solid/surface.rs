//! The points of a traction or absorbing face: where pressure enters, where the liquid sees the body.
//!
//! A point stands for a strip of the reference face; its traction acts through the open images of the particles
//! beneath it (nearest along the face). Those particles' share of the face, w_b = sum_a 2 A_a A_b n.L grad_a W, is 1 per
//! column on a lattice; elsewhere the traction is scaled so that each point transmits pressure x area exactly. (In
//! axisymmetry the signed radius moves a share of order (h/r)^2 of the load across the axis: the force of a load
//! within a few spacings of the axis is low by that share while accelerations stay right.)

use super::SolidError;
use super::block::{Block, Face, Side};
use super::mat2::{Mat2, apply};
use super::reference::{FIRST_ROW, Reference};
use super::state::State;
use crate::geometry::{Geometry, Vec2};

/// The points of one face, in order along it.
#[derive(Debug, Clone)]
pub struct Surface {
    /// Which face.
    pub side: Side,
    /// Traction or absorbing.
    pub face: Face,
    /// Particle behind each point.
    pub particle: Vec<usize>,
    /// Middle of the strip on the reference face, m.
    pub reference_position: Vec<Vec2>,
    /// Width of the strip in the reference, m.
    pub width: Vec<f64>,
    /// Area of the strip in the reference: of the ring in axisymmetry, per metre in plane strain, m2.
    pub area: Vec<f64>,
    /// Position of the deformed face point, m.
    pub position: Vec<Vec2>,
    /// Velocity of the deformed face point, m/s.
    pub velocity: Vec<Vec2>,
    /// Pressure on a traction face along its reference normal per reference area, Pa: set by the caller.
    pub pressure: Vec<f64>,
    /// Traction that acted in the last evaluation of forces, Pa.
    pub traction: Vec<Vec2>,
    scale: Vec<f64>,
    point_of_particle: Vec<u32>,
}

const NO_POINT: u32 = u32::MAX;

impl Surface {
    pub(super) fn new(
        geometry: Geometry,
        block: &Block,
        side: Side,
        reference: &Reference,
    ) -> Result<Self, SolidError> {
        let along = 1 - side.normal_axis();
        let mut particle: Vec<usize> = (0..reference.position.len())
            .filter(|&i| {
                block.depth(side, reference.position[i]) < FIRST_ROW * reference.area[i].sqrt()
            })
            .collect();
        particle.sort_by(|&a, &b| {
            reference.position[a][along].total_cmp(&reference.position[b][along])
        });
        let n = particle.len();
        let mut surface = Self {
            side,
            face: block.face(side),
            reference_position: vec![[block.coordinate(side); 2]; n],
            width: vec![0.0; n],
            area: vec![0.0; n],
            position: vec![[0.0; 2]; n],
            velocity: vec![[0.0; 2]; n],
            pressure: vec![0.0; n],
            traction: vec![[0.0; 2]; n],
            scale: vec![1.0; n],
            point_of_particle: vec![NO_POINT; reference.position.len()],
            particle,
        };
        surface.place_strips(geometry, block, reference);
        surface.share_out(geometry, block, reference)?;
        Ok(surface)
    }

    /// Strips end halfway between neighbouring points.
    fn place_strips(&mut self, geometry: Geometry, block: &Block, reference: &Reference) {
        let along = 1 - self.side.normal_axis();
        let at = |j: usize| reference.position[self.particle[j]][along];
        let n = self.particle.len();
        for j in 0..n {
            let from = if j == 0 {
                block.lower[along]
            } else {
                0.5 * (at(j - 1) + at(j))
            };
            let to = if j + 1 == n {
                block.upper[along]
            } else {
                0.5 * (at(j) + at(j + 1))
            };
            self.reference_position[j][along] = 0.5 * (from + to);
            self.width[j] = to - from;
            self.area[j] = self.width[j] * geometry.ring(self.reference_position[j][0]);
        }
    }

    /// Assigns the sources of open images to points and sets the scales.
    fn share_out(
        &mut self,
        geometry: Geometry,
        block: &Block,
        reference: &Reference,
    ) -> Result<(), SolidError> {
        let (axis, along) = (self.side.normal_axis(), 1 - self.side.normal_axis());
        let mut share = vec![0.0; self.particle.len()];
        let acts = |i: u32| {
            reference.open_images[i as usize]
                .sides()
                .any(|s| s == self.side)
        };
        for image in &reference.open_images {
            if image.sides().any(|s| s == self.side) {
                let b = image.source as usize;
                self.point_of_particle[b] =
                    self.nearest(reference.position[b][along], along, &reference.position)?;
            }
        }
        for a in 0..reference.position.len() {
            for p in reference.open_pairs_of(a).iter().filter(|p| acts(p.image)) {
                let image = reference.open_images[p.image as usize];
                let b = image.source as usize;
                let l = image.turn_matrix(reference.full_correction[b]);
                let normal = apply(&l, p.offset)[axis] * p.gradient * self.side.sign();
                let radius = if axis == 0 {
                    block.coordinate(self.side)
                } else {
                    reference.position[b][0]
                };
                let ring = geometry.ring(radius);
                share[self.point_of_particle[b] as usize] +=
                    2.0 * reference.area[a] * normal * ring;
            }
        }
        for (j, share) in share.into_iter().enumerate() {
            let scale = self.area[j] / share;
            if !(0.2..5.0).contains(&scale) {
                return Err(SolidError::UnevenFace {
                    side: self.side,
                    position: self.reference_position[j],
                    share: 1.0 / scale,
                });
            }
            self.scale[j] = scale;
        }
        Ok(())
    }

    /// Point nearest to coordinate `x` along the face; `position` are the reference positions of the particles.
    pub(super) fn nearest(
        &self,
        x: f64,
        along: usize,
        position: &[Vec2],
    ) -> Result<u32, SolidError> {
        let at = |j: usize| position[self.particle[j]][along];
        let n = self.particle.len();
        if n == 0 {
            return Err(SolidError::NoSurface { side: self.side });
        }
        let after = self.particle.partition_point(|&i| position[i][along] < x);
        let j = if after == 0 {
            0
        } else if after == n || x - at(after - 1) <= at(after) - x {
            after - 1
        } else {
            after
        };
        Ok(j as u32)
    }

    /// Scale of the traction that the images of a particle carry.
    pub(super) fn scale_on(&self, particle: u32) -> f64 {
        self.scale[self.point_of_particle[particle as usize] as usize]
    }

    /// Scaled traction that the images of a particle carry, Pa.
    pub(super) fn traction_on(&self, particle: u32) -> Vec2 {
        let j = self.point_of_particle[particle as usize] as usize;
        self.traction[j].map(|t| t * self.scale[j])
    }

    /// Extrapolates position from the particles to the face points by the deformation gradient.
    pub(super) fn follow_position(&mut self, reference: &Reference, state: &State) {
        for (j, &a) in self.particle.iter().enumerate() {
            let x = apply(&state.deformation[a], self.offset(j, reference));
            self.position[j] = [0, 1].map(|k| state.position[a][k] + x[k]);
        }
    }

    /// Extrapolates velocity from the particles to the face points by its gradient dv/dX.
    pub(super) fn follow_velocity(
        &mut self,
        reference: &Reference,
        state: &State,
        velocity_gradient: impl Fn(usize) -> Mat2,
    ) {
        for (j, &a) in self.particle.iter().enumerate() {
            let v = apply(&velocity_gradient(a), self.offset(j, reference));
            self.velocity[j] = [0, 1].map(|k| state.velocity[a][k] + v[k]);
        }
    }

    /// Reference vector from the particle to the point, m.
    fn offset(&self, j: usize, reference: &Reference) -> Vec2 {
        let x = reference.position[self.particle[j]];
        [0, 1].map(|k| self.reference_position[j][k] - x[k])
    }

    /// Power of the traction that acted, W.
    #[must_use]
    pub fn power(&self) -> f64 {
        (0..self.area.len())
            .map(|j| {
                let (t, v) = (self.traction[j], self.velocity[j]);
                self.area[j] * (t[0] * v[0] + t[1] * v[1])
            })
            .sum()
    }
}
