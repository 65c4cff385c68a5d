//! Contact with a rigid indenter without friction: a cylinder in plane strain, a sphere on the axis.
//!
//! At every point of the traction face, per reference area:
//! t = max(0, k E g/dx + c rho c_l dg/dt) e,  g = R - |x - x_c|,  e = (x - x_c)/|x - x_c|
//!
//! Penalty with a dashpot. g is the depth of the deformed face point in the indenter, dx the width of its strip: with k = 4
//! a pressure of 2 GPa on steel needs 0.3 % of a spacing, and the pressure under a Hertz contact ten spacings wide is right
//! to 1 % (k = 1: 4 % low). The dashpot (c = 0.5) takes the energy of points that arrive; the contact never pulls.
//! Stability: the penalty's frequency times the step is 0.35 sqrt(k) at Courant number 0.4, and must stay below 2.
//! Where the material behind a face point has failed the point is gone; the indenter then acts on the particles that it
//! meets beneath, as on a strip half a spacing above their centres.
//! Units: SI. Range: the circle is large beside the spacing; no friction, no rotation.

use super::layers::Materials;
use super::surface::Surface;
use super::{Face, Side, Solid, SolidError};
use crate::geometry::{Geometry, Vec2};
use erode_physics::material_point::Material;
use serde::{Deserialize, Serialize};

/// A rigid circle that moves as the caller says.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Indenter {
    /// The face it presses on.
    pub side: Side,
    /// Radius, m.
    pub radius: f64,
    /// Centre now, m; on the axis in axisymmetry.
    pub centre: Vec2,
    /// Velocity of the centre, m/s.
    pub velocity: Vec2,
    /// Penalty stiffness k in units of Young's modulus over the spacing.
    pub stiffness: f64,
    /// Dashpot c in units of the impedance of longitudinal waves.
    pub damping: f64,
}

impl Indenter {
    /// An indenter at rest with the usual stiffness and damping.
    #[must_use]
    pub fn new(side: Side, radius: f64, centre: Vec2) -> Self {
        Self {
            side,
            radius,
            centre,
            velocity: [0.0; 2],
            stiffness: 4.0,
            damping: 0.5,
        }
    }

    /// Traction (Pa) on a face point at `x` with velocity `v`.
    fn traction(&self, material: &Material, width: f64, x: Vec2, v: Vec2) -> Vec2 {
        let d = [0, 1].map(|i| x[i] - self.centre[i]);
        let distance = d[0].hypot(d[1]);
        let depth = self.radius - distance;
        if depth <= 0.0 || distance == 0.0 {
            return [0.0; 2];
        }
        let e = d.map(|d| d / distance);
        let deepening = -(0..2)
            .map(|i| (v[i] - self.velocity[i]) * e[i])
            .sum::<f64>();
        let (elastic, density) = (material.elastic, material.density);
        let impedance = density * elastic.longitudinal_speed(density);
        let pressure = self.stiffness * elastic.young_modulus * depth / width
            + self.damping * impedance * deepening;
        e.map(|e| pressure.max(0.0) * e)
    }

    /// Checks that it can press on this body.
    fn check(&self, solid: &Solid) -> Result<(), SolidError> {
        let bad = |why: String| Err(SolidError::BadIndenter { why });
        let numbers = [
            self.radius,
            self.centre[0],
            self.centre[1],
            self.stiffness,
            self.damping,
        ];
        if !numbers.iter().all(|x| x.is_finite()) || self.radius <= 0.0 || self.stiffness <= 0.0 {
            return bad(format!(
                "its radius {} m and stiffness {} must be positive and all its numbers finite",
                self.radius, self.stiffness
            ));
        }
        let face = solid.block.face(self.side);
        if !matches!(face, Face::Traction | Face::Driven(_)) {
            return bad(format!(
                "the {:?} face is {face:?}; an indenter needs a face with given pressure",
                self.side
            ));
        }
        if solid.geometry == Geometry::Axisymmetric
            && (self.centre[0] != 0.0 || self.side.normal_axis() == 0)
        {
            return bad(format!(
                "its centre is at r = {} m on the {:?} face; in axisymmetry only a sphere on the axis, pressing on the top \
                 or bottom face, is rotationally symmetric",
                self.centre[0], self.side
            ));
        }
        let along = 1 - self.side.normal_axis();
        let (first, last) = (solid.block.lower[along], solid.block.upper[along]);
        if !(first..=last).contains(&self.centre[along]) {
            return bad(format!(
                "its centre at {} m along the {:?} face lies outside the body, which goes from {first} m to {last} m",
                self.centre[along], self.side
            ));
        }
        Ok(())
    }
}

impl Surface {
    /// Sets the tractions of contact from the positions and velocities of the points.
    fn press(&mut self, materials: Materials, indenter: &Indenter) {
        for j in (0..self.width.len()).filter(|&j| !self.driven[j]) {
            let (x, v) = (self.position[j], self.velocity[j]);
            self.contact[j] = if self.holds[j] {
                let material = materials.of(self.particle[j]);
                indenter.traction(material, self.width[j], x, v)
            } else {
                [0.0; 2]
            };
        }
    }
}

impl Solid {
    /// Puts an indenter on a traction face; move it by the `centre` and `velocity` of [`Solid::indenter`].
    ///
    /// # Errors
    /// If its numbers make no sense, its face cannot be pressed on, or it is not above the body.
    pub fn indent(&mut self, indenter: Indenter) -> Result<(), SolidError> {
        indenter.check(self)?;
        self.indenter = Some(indenter);
        Ok(())
    }

    /// Tractions of the indenter at the present positions and velocities, with the images where they are.
    pub(super) fn press(&mut self) {
        if self.indenter.is_some() {
            self.follow_moved_surfaces();
            self.press_points();
        }
    }

    /// Finds the particles laid bare by failure that the indenter pushes, ascending.
    pub(super) fn press_bared(&mut self) {
        self.scratch.bared.clear();
        let Some(indenter) = self.indenter else {
            return;
        };
        if self.state.work.lost.failed == 0 {
            return;
        }
        let Some(surface) = self.surfaces.iter().find(|s| s.side == indenter.side) else {
            return;
        };
        let mut covered = vec![false; self.len()];
        for (&a, &holds) in surface.particle.iter().zip(&surface.holds) {
            covered[a] = holds;
        }
        for (a, covered) in covered.into_iter().enumerate() {
            if covered || self.is_removed(a) {
                continue;
            }
            let width = self.reference.area[a].sqrt();
            let (x, v) = (self.state.position[a], self.state.velocity[a]);
            let away = [0, 1].map(|i| indenter.centre[i] - x[i]);
            let distance = away[0].hypot(away[1]);
            // The place of the particle nearest to the indenter.
            let edge = [0, 1].map(|i| x[i] + 0.5 * width * away[i] / distance.max(width));
            let traction = indenter.traction(self.material_of(a), width, edge, v);
            if traction != [0.0; 2] {
                let area = width * self.geometry.ring(self.reference.position[a][0]);
                let force = traction.map(|t| t * area);
                self.scratch.bared.push((a as u32, force));
            }
        }
    }

    /// Force of the indenter on the body in the last evaluation of forces, N.
    #[must_use]
    pub fn indenter_force(&self) -> Vec2 {
        let face = (self.indenter.as_ref())
            .and_then(|i| self.surface(i.side))
            .map_or([0.0; 2], Surface::contact_force);
        let add = |sum: Vec2, f: &Vec2| [sum[0] + f[0], sum[1] + f[1]];
        self.scratch.bared.iter().map(|(_, f)| f).fold(face, add)
    }

    /// The same with the face points where they are.
    pub(super) fn press_points(&mut self) {
        let materials = Materials {
            own: &self.material,
            layers: &self.layers,
        };
        if let Some(indenter) = &self.indenter
            && let Some(surface) = self.surfaces.iter_mut().find(|s| s.side == indenter.side)
        {
            surface.press(materials, indenter);
        }
    }
}
