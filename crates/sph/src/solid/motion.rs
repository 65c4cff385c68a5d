//! Motion of the points of a face: prescribed where the face is driven, elsewhere that of the body.

use super::block::{Face, Tangential};
use super::mat2::{Mat2, apply};
use super::reference::Reference;
use super::state::State;
use super::surface::Surface;
use crate::geometry::Vec2;

/// Prescribed motion at a point of a face.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Wall {
    /// Displacement, m.
    pub(super) displacement: Vec2,
    /// Velocity, m/s.
    pub(super) velocity: Vec2,
    /// Derivative of the displacement along the face.
    pub(super) slope: Vec2,
    /// Second derivative of the normal displacement along the face, 1/m.
    pub(super) curvature: f64,
}

impl Surface {
    /// Prescribes the motion of the driven points: `motion` gives displacement (m) and velocity (m/s) at a point of the
    /// reference face. Along a face without tangential motion only the normal components count.
    pub fn drive(&mut self, motion: impl Fn(Vec2) -> [Vec2; 2]) {
        for j in (0..self.wall.len()).filter(|&j| self.driven[j]) {
            let [displacement, velocity] = motion(self.reference_position[j]);
            self.wall[j] = Wall {
                displacement,
                velocity,
                slope: [0.0; 2],
                curvature: 0.0,
            };
        }
        for j in 0..self.wall.len() {
            (self.wall[j].slope, self.wall[j].curvature) = self.slope(j);
        }
    }

    /// First derivatives of the prescribed displacement along the face and second one of its normal component.
    fn slope(&self, j: usize) -> (Vec2, f64) {
        let (n, along) = (self.wall.len(), 1 - self.side.normal_axis());
        let at = |i: usize| (self.reference_position[i][along], self.wall[i].displacement);
        let driven = |i: usize| i < n && self.driven[i];
        let beyond = |sign: f64| {
            let (x, mut u) = at(j);
            u[along] = -u[along];
            (x + sign * self.width[j], u)
        };
        let here = at(j);
        let before = match j.checked_sub(1) {
            Some(i) if driven(i) => at(i),
            None if self.mirrored_ends[0] => beyond(-1.0),
            _ => here,
        };
        let after = if driven(j + 1) {
            at(j + 1)
        } else if j + 1 == n && self.mirrored_ends[1] {
            beyond(1.0)
        } else {
            here
        };
        let length = after.0 - before.0;
        if !self.driven[j] || length == 0.0 {
            return ([0.0; 2], 0.0);
        }
        let normal = self.side.normal_axis();
        let rise = |a: (f64, Vec2), b: (f64, Vec2)| {
            if a.0 == b.0 {
                None
            } else {
                Some((b.1[normal] - a.1[normal]) / (b.0 - a.0))
            }
        };
        let curvature = match (rise(before, here), rise(here, after)) {
            (Some(first), Some(second)) => 2.0 * (second - first) / length,
            _ => 0.0,
        };
        let slope = [0, 1].map(|k| (after.1[k] - before.1[k]) / length);
        (slope, curvature)
    }

    /// Prescribed motion where a particle is reflected.
    pub(super) fn wall_at(&self, particle: u32) -> Wall {
        let b = particle as usize;
        let (j, share) = (self.point_of_particle[b] as usize, self.share_of_next[b]);
        if share == 0.0 {
            return self.wall[j];
        }
        let (one, two) = (self.wall[j], self.wall[j + 1]);
        let mean = |a: Vec2, b: Vec2| [0, 1].map(|k| a[k] + share * (b[k] - a[k]));
        Wall {
            displacement: mean(one.displacement, two.displacement),
            velocity: mean(one.velocity, two.velocity),
            slope: mean(one.slope, two.slope),
            curvature: one.curvature + share * (two.curvature - one.curvature),
        }
    }

    /// Which components of a point's motion are prescribed.
    fn prescribed(&self, j: usize) -> [bool; 2] {
        let bonded = matches!(self.face, Face::Driven(d) if d.tangential == Tangential::Bonded);
        [0, 1].map(|k| self.driven[j] && (bonded || k == self.side.normal_axis()))
    }

    /// Extrapolates position from the particles to the face points by the deformation gradient.
    pub(super) fn follow_position(&mut self, reference: &Reference, state: &State) {
        for (j, &a) in self.particle.iter().enumerate() {
            let x = apply(&state.deformation[a], self.offset(j, reference));
            let (held, wall) = (self.prescribed(j), self.wall[j].displacement);
            self.position[j] = [0, 1].map(|k| {
                if held[k] {
                    self.reference_position[j][k] + wall[k]
                } else {
                    state.position[a][k] + x[k]
                }
            });
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
            let (held, wall) = (self.prescribed(j), self.wall[j].velocity);
            self.velocity[j] = [0, 1].map(|k| {
                if held[k] {
                    wall[k]
                } else {
                    state.velocity[a][k] + v[k]
                }
            });
        }
    }

    /// Reference vector from the particle to the point, m.
    fn offset(&self, j: usize, reference: &Reference) -> Vec2 {
        let x = reference.position[self.particle[j]];
        [0, 1].map(|k| self.anchor[j][k] - x[k])
    }
}
