//! Images of particles beyond the faces of the block.
//!
//! A mirror image deforms with the body (axis, symmetry, clamped and driven faces); an open image beyond a traction or
//! absorbing face only carries a stress into the force. Corners have double images. In axisymmetry the radius of an
//! image at the axis is negative, so that R P runs smoothly through the axis (no correction function is needed there).
//!
//! Displacement u' of an image from its reference place, for a face that moves by U (zero where nothing is prescribed):
//! mirror and slip u'_n = 2 U_n - u_n, u'_t = u_t; bonded u' = 2 U - u. Velocities the same.

use super::block::{Block, Reflection, Side};
use super::mat2::{Mat2, mirrored, product, scaled};
use super::surface::{Surface, Wall};
use crate::geometry::Vec2;

/// One reflection: the face and how the body goes on beyond it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Step {
    pub(super) side: Side,
    pub(super) how: Reflection,
}

impl Step {
    pub(super) fn is_open(self) -> bool {
        self.how == Reflection::Open
    }
}

/// One image: its particle and the faces it is reflected in, open faces last.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Image {
    pub(super) source: u32,
    pub(super) steps: [Option<Step>; 2],
}

/// Displacement, velocity and slope of a face where a particle is reflected in it.
pub(super) fn wall_at(surfaces: &[Surface], side: Side, particle: u32) -> Wall {
    surfaces
        .iter()
        .find(|s| s.side == side)
        .map_or(Wall::default(), |s| s.wall_at(particle))
}

impl Image {
    pub(super) fn steps(&self) -> impl Iterator<Item = Step> {
        self.steps.into_iter().flatten()
    }

    pub(super) fn is_mirror(&self) -> bool {
        self.steps().all(|s| !s.is_open())
    }

    /// Whether the image lies beyond this face.
    pub(super) fn beyond(&self, side: Side) -> bool {
        self.steps().any(|s| s.side == side)
    }

    /// Reflected reference point.
    pub(super) fn place(&self, block: &Block, point: Vec2) -> Vec2 {
        self.steps().fold(point, |p, s| block.reflect(s.side, p))
    }

    /// Displacement or velocity of the image, from that of its particle; `wall` picks the same of a face.
    pub(super) fn turn(
        &self,
        mut vector: Vec2,
        surfaces: &[Surface],
        wall: impl Fn(Wall) -> Vec2,
    ) -> Vec2 {
        let mut turned = [1.0, 1.0];
        for step in self.steps() {
            let n = step.side.normal_axis();
            let moved = match step.how {
                Reflection::Mirror | Reflection::Open => [0.0; 2],
                _ => wall(wall_at(surfaces, step.side, self.source)),
            };
            vector[n] = 2.0 * turned[n] * moved[n] - vector[n];
            if step.how == Reflection::Bonded {
                let t = 1 - n;
                vector[t] = 2.0 * turned[t] * moved[t] - vector[t];
            }
            turned[n] *= -1.0;
        }
        vector
    }

    /// S M S for every reflection.
    pub(super) fn turn_matrix(&self, m: Mat2) -> Mat2 {
        self.steps().fold(m, |m, _| mirrored(&m))
    }

    /// Deformation gradient of the image.
    pub(super) fn deformation(&self, mut f: Mat2, surfaces: &[Surface]) -> Mat2 {
        let mut turned = [1.0, 1.0];
        for step in self.steps() {
            let (n, t) = (step.side.normal_axis(), 1 - step.side.normal_axis());
            if matches!(step.how, Reflection::Mirror | Reflection::Open) {
                f = mirrored(&f);
            } else {
                let slope = wall_at(surfaces, step.side, self.source).slope;
                let along = [0, 1].map(|i| 2.0 * turned[i] * turned[t] * slope[i]);
                f[n][t] = along[n] - f[n][t];
                if step.how == Reflection::Bonded {
                    f[t][t] = 2.0 + along[t] - f[t][t];
                } else {
                    f[t][n] = -f[t][n];
                }
            }
            turned[n] *= -1.0;
        }
        f
    }
}

/// All images that a particle within reach of a face may need; `reach[i]` is the largest depth that matters.
pub(super) fn all_images(block: &Block, position: &[Vec2], reach: &[f64]) -> Vec<Image> {
    let mut images = Vec::new();
    for (i, (&x, &reach)) in position.iter().zip(reach).enumerate() {
        let near = |s: &Side| block.depth(*s, x) < reach;
        let step = |side: Side| Step {
            side,
            how: block.reflection(side, x),
        };
        let (r, z): (Vec<Step>, Vec<Step>) =
            (Side::ALL.into_iter().filter(near).map(step)).partition(|s| s.side.normal_axis() == 0);
        let mut add = |mut steps: [Option<Step>; 2]| {
            let open = |s: Option<Step>| s.is_some_and(Step::is_open);
            if open(steps[0]) && steps[1].is_some() && !open(steps[1]) {
                steps.swap(0, 1);
            }
            images.push(Image {
                source: i as u32,
                steps,
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
    /// Mirror faces and faces driven along their normal: P_rz, P_zr odd. Bonded faces: P even. Open faces: the traction
    /// column of R P is odd about the given traction, (R P)' N = 2 R t - (R P) N, and so is its partner beside the
    /// diagonal; the other diagonal part of P is even. The odd partner costs the exact balance of momentum where shear
    /// varies along the face, but an even one (which keeps it) takes 8 % off the plastic strain under a Gaussian pressure
    /// ten spacings wide.
    pub(super) fn at_image(
        mut self,
        image: &Image,
        block: &Block,
        axisymmetric: bool,
        surfaces: &[Surface],
    ) -> Mat2 {
        let mut turned = [1.0, 1.0];
        for step in image.steps() {
            let side = step.side;
            let axis = side.normal_axis();
            let weight = reflected_weight(axisymmetric, side, block, self.weight);
            let ratio = weight / self.weight;
            self.correction = mirrored(&self.correction);
            match step.how {
                Reflection::Mirror | Reflection::Slip => {
                    self.flux = scaled(&mirrored(&self.flux), ratio);
                    turned[axis] *= -1.0;
                }
                Reflection::Bonded => {
                    self.flux = scaled(&self.flux, ratio);
                    turned[axis] *= -1.0;
                }
                Reflection::Open => {
                    let on_face = if axisymmetric && axis == 0 {
                        block.coordinate(side)
                    } else {
                        self.weight
                    };
                    let traction = traction_at(surfaces, side, image.source);
                    let given =
                        [0, 1].map(|i| 2.0 * on_face * side.sign() * traction[i] * turned[i]);
                    let (n, t) = (axis, 1 - axis);
                    self.flux[n][n] = given[n] - self.flux[n][n];
                    self.flux[t][n] = given[t] - self.flux[t][n];
                    self.flux[n][t] = given[t] - self.flux[n][t];
                    self.flux[t][t] *= ratio;
                }
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
