//! Images of particles beyond the faces of the block.
//!
//! A mirror image deforms with the body (axis, symmetry); an open image beyond a traction or absorbing face only
//! carries a stress into the force. Corners have double images. In axisymmetry the radius of an image at the axis is
//! negative, so that R P runs smoothly through the axis (no correction function is needed there).

use super::block::{Block, Side};
use super::mat2::{Mat2, mirrored, product, scaled};
use super::surface::Surface;
use crate::geometry::Vec2;

/// One image: its particle and the faces it is reflected in, mirror faces first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Image {
    pub(super) source: u32,
    pub(super) sides: [Option<Side>; 2],
}

impl Image {
    pub(super) fn sides(&self) -> impl Iterator<Item = Side> {
        self.sides.into_iter().flatten()
    }

    pub(super) fn is_mirror(&self, block: &Block) -> bool {
        self.sides().all(|s| block.face(s).mirrors())
    }

    /// Reflected point.
    pub(super) fn place(&self, block: &Block, point: Vec2) -> Vec2 {
        self.sides().fold(point, |p, s| block.reflect(s, p))
    }

    /// Reflected vector.
    pub(super) fn turn(&self, mut vector: Vec2) -> Vec2 {
        for s in self.sides() {
            vector[s.normal_axis()] *= -1.0;
        }
        vector
    }

    /// S M S for every reflection.
    pub(super) fn turn_matrix(&self, m: Mat2) -> Mat2 {
        self.sides().fold(m, |m, _| mirrored(&m))
    }
}

/// All images that a particle within reach of a face may need; `reach[i]` is the largest depth that matters.
pub(super) fn all_images(block: &Block, position: &[Vec2], reach: &[f64]) -> Vec<Image> {
    let mut images = Vec::new();
    for (i, (&x, &reach)) in position.iter().zip(reach).enumerate() {
        let near = |s: &Side| block.depth(*s, x) < reach;
        let (r, z): (Vec<Side>, Vec<Side>) =
            (Side::ALL.into_iter().filter(near)).partition(|s| s.normal_axis() == 0);
        let mut add = |mut sides: [Option<Side>; 2]| {
            let mirrors = |s: Option<Side>| s.is_some_and(|s| block.face(s).mirrors());
            if !mirrors(sides[0]) && mirrors(sides[1]) {
                sides.swap(0, 1);
            }
            images.push(Image {
                source: i as u32,
                sides,
            });
        };
        for &s in r.iter().chain(&z) {
            add([Some(s), None]);
        }
        for &s in &r {
            for &t in &z {
                add([Some(s), Some(t)]);
            }
        }
    }
    images
}

/// R P of a particle, with what is needed to continue it beyond a face.
#[derive(Debug, Clone, Copy)]
pub(super) struct Flux {
    /// R P.
    pub(super) flux: Mat2,
    /// Correction L of the gradient.
    pub(super) correction: Mat2,
    /// R in axisymmetry, 1 in plane strain.
    pub(super) weight: f64,
}

/// Weight of the reflection of a particle with weight `weight` in a side face at `coordinate` (axisymmetry).
pub(super) fn reflected_weight(axisymmetric: bool, side: Side, block: &Block, weight: f64) -> f64 {
    if axisymmetric && side.normal_axis() == 0 {
        2.0 * block.coordinate(side) - weight
    } else {
        weight
    }
}

impl Flux {
    /// R P L at an image of the particle.
    ///
    /// Mirror faces: P_rz, P_zr odd. Open faces: the traction column of R P is odd about the given traction,
    /// (R P)' N = 2 R t - (R P) N, and so is its partner beside the diagonal; the other diagonal part of P is even.
    /// The odd partner costs the exact balance of momentum where shear varies along the face, but an even one
    /// (which keeps it) takes 8 % off the plastic strain under a Gaussian pressure ten spacings wide.
    pub(super) fn at_image(
        mut self,
        image: &Image,
        block: &Block,
        axisymmetric: bool,
        surfaces: &[Surface],
    ) -> Mat2 {
        let mut turned = [1.0, 1.0];
        for side in image.sides() {
            let axis = side.normal_axis();
            let weight = reflected_weight(axisymmetric, side, block, self.weight);
            self.correction = mirrored(&self.correction);
            if block.face(side).mirrors() {
                let ratio = weight / self.weight;
                self.flux = scaled(&mirrored(&self.flux), ratio);
                turned[axis] *= -1.0;
            } else {
                let on_face = if axisymmetric && axis == 0 {
                    block.coordinate(side)
                } else {
                    self.weight
                };
                let traction = traction_at(surfaces, side, image.source);
                let given = [0, 1].map(|i| 2.0 * on_face * side.sign() * traction[i] * turned[i]);
                let (n, t) = (axis, 1 - axis);
                self.flux[n][n] = given[n] - self.flux[n][n];
                self.flux[t][n] = given[t] - self.flux[t][n];
                self.flux[n][t] = given[t] - self.flux[n][t];
                self.flux[t][t] *= weight / self.weight;
            }
            self.weight = weight;
        }
        product(&self.flux, &self.correction)
    }
}

fn traction_at(surfaces: &[Surface], side: Side, particle: u32) -> Vec2 {
    surfaces
        .iter()
        .find(|s| s.side == side)
        .map_or([0.0; 2], |s| s.traction_on(particle))
}
