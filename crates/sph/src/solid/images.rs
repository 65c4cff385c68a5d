//! Images of particles beyond the faces of the block.
//!
//! A mirror image deforms with the body (axis, symmetry, clamped and driven faces); an open image beyond a traction or
//! absorbing face only carries a stress into the force. Corners have double images. In axisymmetry the radius of an
//! image at the axis is negative, so that R P runs smoothly through the axis (no correction function is needed there).
//!
//! Place x' of an image for a face that moves by U(X_t) (zero where nothing is prescribed), with slope s = dU_n/dX_t:
//! mirror: u'_n = -u_n, u'_t = u_t; bonded: u' = 2 U - u, velocities the same;
//! slip: the particle is mirrored in the tangent of the moved face, x' = x + 2 g n/(1 + s^2), with n = 1 along the normal axis
//! and -s along the face and g = (x_foot - x).n = d (1 + s^2) + U_n - u_n for the foot of a normal of length d that turned
//! with the face. So normals stay normal, no shear arises from the slope, and a body that turns with its face is at rest.

use super::block::{Block, Reflection, Side};
use super::mat2::{Mat2, mirrored, product, scaled};
use super::motion::Wall;
use super::surface::Surface;
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

impl Wall {
    /// The same as seen after reflections; n is the normal axis of the face.
    fn turned(mut self, turned: [f64; 2], n: usize) -> Self {
        let t = 1 - n;
        for i in 0..2 {
            self.displacement[i] *= turned[i];
            self.velocity[i] *= turned[i];
            self.slope[i] *= turned[i] * turned[t];
        }
        self.curvature *= turned[n];
        self
    }

    /// Slope s of the normal displacement and 1/(1 + s^2).
    fn tilt(&self, n: usize) -> (f64, f64) {
        let s = self.slope[n];
        (s, 1.0 / (1.0 + s * s))
    }
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

    /// Displacement of the image from its reference place, from that of its particle, which was at `start`.
    pub(super) fn displacement(
        &self,
        block: &Block,
        surfaces: &[Surface],
        start: Vec2,
        mut u: Vec2,
    ) -> Vec2 {
        let mut turned = [1.0, 1.0];
        for step in self.steps() {
            let (n, t) = (step.side.normal_axis(), 1 - step.side.normal_axis());
            match step.how {
                Reflection::Mirror | Reflection::Open => u[n] = -u[n],
                Reflection::Slip => {
                    let wall = wall_at(surfaces, step.side, self.source).turned(turned, n);
                    let distance = block.coordinate(step.side) - start[n];
                    let (s, k) = wall.tilt(n);
                    let gap = distance * (1.0 + s * s) + wall.displacement[n] - u[n];
                    u[n] += 2.0 * (gap * k - distance);
                    u[t] -= 2.0 * gap * k * s;
                }
                Reflection::Bonded => {
                    let wall = wall_at(surfaces, step.side, self.source).turned(turned, n);
                    u = [0, 1].map(|i| 2.0 * wall.displacement[i] - u[i]);
                }
            }
            turned[n] *= -1.0;
        }
        u
    }

    /// Velocity of the image, from that of its particle (the turning of a tilted face left out).
    pub(super) fn velocity(&self, surfaces: &[Surface], mut v: Vec2) -> Vec2 {
        let mut turned = [1.0, 1.0];
        for step in self.steps() {
            let (n, t) = (step.side.normal_axis(), 1 - step.side.normal_axis());
            match step.how {
                Reflection::Mirror | Reflection::Open => v[n] = -v[n],
                Reflection::Slip => {
                    let wall = wall_at(surfaces, step.side, self.source).turned(turned, n);
                    let (s, k) = wall.tilt(n);
                    let approach = 2.0 * k * (wall.velocity[n] - v[n]);
                    v[n] += approach;
                    v[t] -= approach * s;
                }
                Reflection::Bonded => {
                    let wall = wall_at(surfaces, step.side, self.source).turned(turned, n);
                    v = [0, 1].map(|i| 2.0 * wall.velocity[i] - v[i]);
                }
            }
            turned[n] *= -1.0;
        }
        v
    }

    /// S M S for every reflection.
    pub(super) fn turn_matrix(&self, m: Mat2) -> Mat2 {
        self.steps().fold(m, |m, _| mirrored(&m))
    }

    /// Deformation gradient of the image: the derivative of its place by its reference place; its particle was at `start` and
    /// has moved by u.
    pub(super) fn deformation(
        &self,
        block: &Block,
        surfaces: &[Surface],
        start: Vec2,
        u: Vec2,
        mut f: Mat2,
    ) -> Mat2 {
        let mut turned = [1.0, 1.0];
        for step in self.steps() {
            let (n, t) = (step.side.normal_axis(), 1 - step.side.normal_axis());
            match step.how {
                Reflection::Mirror | Reflection::Open => f = mirrored(&f),
                Reflection::Slip => {
                    let wall = wall_at(surfaces, step.side, self.source).turned(turned, n);
                    let (s, k) = wall.tilt(n);
                    let distance = block.coordinate(step.side) - start[n];
                    let gap = distance * (1.0 + s * s) + wall.displacement[n] - u[n];
                    let change = -2.0 * s * wall.curvature * k * k;
                    let rise = s - f[n][t] + 2.0 * s * wall.curvature * distance;
                    let deep = 2.0 * k * (f[n][n] + s * s);
                    f[t][t] -= 2.0 * (s * k * rise + gap * (k * wall.curvature + change * s));
                    f[t][n] = -f[t][n] - s * deep;
                    f[n][t] += 2.0 * (k * rise + gap * change);
                    f[n][n] = deep - f[n][n];
                }
                Reflection::Bonded => {
                    let wall = wall_at(surfaces, step.side, self.source).turned(turned, n);
                    f[n][t] = 2.0 * wall.slope[n] - f[n][t];
                    f[t][t] = 2.0 + 2.0 * wall.slope[t] - f[t][t];
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
        let step = |side: Side| block.reflection(side, x).map(|how| Step { side, how });
        let (r, z): (Vec<Step>, Vec<Step>) = (Side::ALL.into_iter().filter(near).filter_map(step))
            .partition(|s| s.side.normal_axis() == 0);
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
    /// Mirror faces: P_rz, P_zr odd. Faces driven along their normal: P_rz odd, P_zr odd about s (P_rr + P_zz), which it is on
    /// a tilted face without shear. Bonded faces: P even. Open faces: the traction
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
                Reflection::Mirror => {
                    self.flux = scaled(&mirrored(&self.flux), ratio);
                    turned[axis] *= -1.0;
                }
                Reflection::Slip => {
                    let wall = wall_at(surfaces, side, image.source).turned(turned, axis);
                    let normal = self.flux[0][0] + self.flux[1][1];
                    self.flux = scaled(&mirrored(&self.flux), ratio);
                    self.flux[axis][1 - axis] += 2.0 * ratio * wall.slope[axis] * normal;
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
