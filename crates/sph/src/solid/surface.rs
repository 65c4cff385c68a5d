//! The points of a traction, absorbing or driven face: where pressure enters, where the liquid sees the body, where motion
//! is prescribed.
//!
//! A point stands for a strip of the reference face; its traction acts through the open images of the particles
//! beneath it (nearest along the face). Those particles' share of the face, w_b = sum_a 2 A_a A_b n.L grad_a W, is 1 per
//! column on a lattice; elsewhere the traction is scaled so that each point transmits pressure x area exactly. (In
//! axisymmetry the signed radius moves a share of order (h/r)^2 of the load across the axis: the force of a load
//! within a few spacings of the axis is low by that share while accelerations stay right.)
//!
//! A driven point moves as the caller says ([`Surface::drive`]); its traction is the force that the images beyond it put on
//! the body, per reference area.

use super::SolidError;
use super::block::{Block, Face, Side};
use super::motion::Wall;
use super::reference::{FIRST_ROW, Reference};
use super::shares::drives;
use crate::geometry::{Geometry, Vec2};

/// The points of one face, in order along it.
#[derive(Debug, Clone)]
pub struct Surface {
    /// Which face.
    pub side: Side,
    /// Traction, absorbing or driven.
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
    /// Traction of a rigid indenter per reference area in the last evaluation of forces, Pa.
    pub contact: Vec<Vec2>,
    /// Whether the motion of a point is prescribed.
    pub(super) driven: Vec<bool>,
    pub(super) wall: Vec<Wall>,
    pub(super) scale: Vec<f64>,
    /// Whether there is still material beneath a point to act on.
    pub(super) holds: Vec<bool>,
    pub(super) point_of_particle: Vec<u32>,
    /// Place of the points in the reference configuration of the particles, m.
    pub(super) anchor: Vec<Vec2>,
    /// Share of the next point in the motion at a particle reflected in a driven part.
    pub(super) share_of_next: Vec<f64>,
    /// Whether the body is mirrored at the first and the last point.
    pub(super) mirrored_ends: [bool; 2],
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
        let driven = (particle.iter())
            .map(|&i| drives(block.reflection(side, reference.position[i])))
            .collect();
        let ends = if along == 0 {
            [Side::Left, Side::Right]
        } else {
            [Side::Bottom, Side::Top]
        };
        let mut surface = Self {
            side,
            driven,
            wall: vec![Wall::default(); n],
            contact: vec![[0.0; 2]; n],
            share_of_next: vec![0.0; reference.position.len()],
            mirrored_ends: ends.map(|s| matches!(block.face(s), Face::Axis | Face::Symmetry)),
            face: block.face(side),
            reference_position: vec![[block.coordinate(side); 2]; n],
            width: vec![0.0; n],
            area: vec![0.0; n],
            position: vec![[0.0; 2]; n],
            velocity: vec![[0.0; 2]; n],
            pressure: vec![0.0; n],
            traction: vec![[0.0; 2]; n],
            anchor: Vec::new(),
            scale: vec![1.0; n],
            holds: vec![true; n],
            point_of_particle: vec![NO_POINT; reference.position.len()],
            particle,
        };
        surface.place_strips(geometry, block, reference);
        surface.anchor.clone_from(&surface.reference_position);
        if surface.face == Face::Free {
            surface.holds.fill(false);
        } else {
            surface.find_feet(block, reference)?;
            surface.share_out(geometry, block, reference)?;
        }
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

    /// Sets the pressure (Pa) from the place of each point on the reference face.
    pub fn push(&mut self, pressure: impl Fn(Vec2) -> f64) {
        for (p, x) in self.pressure.iter_mut().zip(&self.reference_position) {
            *p = pressure(*x);
        }
    }

    /// Number of driven points.
    #[must_use]
    pub fn driven_points(&self) -> usize {
        self.driven.iter().filter(|d| **d).count()
    }

    /// Point that takes the reaction of a particle reflected in a driven part.
    pub(super) fn foot(&self, particle: u32) -> usize {
        let b = particle as usize;
        self.point_of_particle[b] as usize + usize::from(self.share_of_next[b] > 0.5)
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

    /// Power of the traction that acted, W: at driven points (`true`) or at the others.
    #[must_use]
    pub fn power(&self, driven: bool) -> f64 {
        (0..self.area.len())
            .filter(|&j| self.driven[j] == driven)
            .map(|j| {
                let (t, v) = (self.traction[j], self.velocity[j]);
                self.area[j] * (t[0] * v[0] + t[1] * v[1])
            })
            .sum()
    }

    /// Force of the traction that acted, N (of the whole ring in axisymmetry, per metre in plane strain).
    #[must_use]
    pub fn force(&self) -> Vec2 {
        let sum = |k: usize| {
            (self.traction.iter().zip(&self.area))
                .map(|(t, a)| t[k] * a)
                .sum()
        };
        [0, 1].map(sum)
    }

    /// Force of the indenter alone, N.
    #[must_use]
    pub fn contact_force(&self) -> Vec2 {
        let sum = |k: usize| {
            (self.contact.iter().zip(&self.area))
                .map(|(t, a)| t[k] * a)
                .sum()
        };
        [0, 1].map(sum)
    }
}
