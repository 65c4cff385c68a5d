//! A new reference configuration under large strain.
//!
//! Every so often the present configuration becomes the reference: X := x, F := 1, and neighbours are searched anew. The
//! total deformation F_0 from the first configuration (hoop part H_0) stays known, and with it A = A_0 det F_0, J = H_0 det F_0,
//! so that masses, velocities, stresses and tau = J sigma are untouched: mass, momentum, kinetic and elastic energy are
//! kept to round-off. What the hourglass penalty holds is forgotten (its work stays in the ledger).
//!
//! h = h_0 x largest principal stretch in the plane: particles that were drawn apart still see each other.
//!
//! The faces of the present configuration are curved. Only mirror faces (axis, symmetry) keep their images; free faces
//! have none: force and strain use the same corrected gradient (adjoint to each other), traction vanishes there
//! naturally. So the other faces must be free, without pressure or indenter.
//!
//! Range: where F of the total Lagrangian form still follows the particles the renewal is not needed and smooths; it pays
//! when neighbours slide past each other. It does not undo anisotropy: cost grows with the stretch (h).

use super::layers::Materials;
use super::layout::Layout;
use super::mat2::{Mat2, UNIT, largest_stretch, product, smallest_stretch};
use super::reference::Reference;
use super::{Face, Formulation, Side, Solid, SolidError, force};
use crate::geometry::Vec2;
use serde::{Deserialize, Serialize};

/// A renewed reference configuration: everything a checkpoint has to keep of it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Base {
    /// How many renewals there were.
    pub renewals: u32,
    /// Position, m.
    pub position: Vec<Vec2>,
    /// Deformation gradient in the plane from the first configuration.
    pub deformation: Vec<Mat2>,
    /// Stretch out of the plane from the first configuration.
    pub hoop_stretch: Vec<f64>,
    /// Points of the faces, m, in the order of the surfaces.
    pub surface_position: Vec<Vec<Vec2>>,
}

impl Solid {
    /// Deformation gradient in the plane from the first configuration.
    #[must_use]
    pub fn total_deformation(&self, particle: usize) -> Mat2 {
        let f = &self.state.deformation[particle];
        match &self.state.base {
            None => *f,
            Some(base) => product(f, &base.deformation[particle]),
        }
    }

    /// Number of renewals of the reference.
    #[must_use]
    pub fn renewals(&self) -> u32 {
        self.state.base.as_ref().map_or(0, |b| b.renewals)
    }

    /// Makes the present configuration the reference, see `renewal.rs`. Call it when stress and positions belong together.
    ///
    /// # Errors
    /// If a face is neither a mirror nor free, or a particle has too few neighbours.
    pub fn renew_reference(&mut self) -> Result<(), SolidError> {
        self.check_renewable()?;
        self.follow_moved_surfaces();
        let old = self.state.base.take();
        let n = self.len();
        let hoop = |a: usize| old.as_ref().map_or(1.0, |b| b.hoop_stretch[a]);
        let plane = |a: usize| old.as_ref().map_or(UNIT, |b| b.deformation[a]);
        let s = &self.state;
        let base = Base {
            renewals: old.as_ref().map_or(0, |b| b.renewals) + 1,
            position: s.position.clone(),
            deformation: (0..n)
                .map(|a| product(&s.deformation[a], &plane(a)))
                .collect(),
            hoop_stretch: (0..n).map(|a| s.hoop_stretch[a] * hoop(a)).collect(),
            surface_position: self.surfaces.iter().map(|s| s.position.clone()).collect(),
        };
        self.state.deformation.fill(UNIT);
        self.state.hoop_stretch.fill(1.0);
        self.state.base = Some(base);
        self.take_up()
    }

    /// Brings everything that is not stored in a checkpoint up to a state that was put in place.
    ///
    /// # Errors
    /// If its reference configuration cannot be built.
    pub fn take_up(&mut self) -> Result<(), SolidError> {
        if let Some(base) = &self.state.base
            && base.renewals != self.reference.renewals
        {
            let layout = Layout::renewed(base, &self.reference, &self.state.removed);
            let materials = Materials {
                own: &self.material,
                layers: &self.layers,
            };
            self.reference = Reference::new(
                self.geometry,
                &self.block,
                materials,
                &self.numerics,
                layout,
            )?;
            for (surface, position) in self.surfaces.iter_mut().zip(&base.surface_position) {
                surface.anchor.clone_from(position);
            }
            self.scratch = force::Scratch::of(&self.reference, &self.surfaces);
        }
        self.follow_surfaces();
        Ok(())
    }

    /// Renews the reference where [`super::Numerics::renewal`] asks for it.
    pub(super) fn renew_if_stretched(&mut self) -> Result<(), SolidError> {
        let Some(limit) = self.numerics.renewal else {
            return Ok(());
        };
        let s = &self.state;
        let far = |a: usize| {
            let f = &s.deformation[a];
            s.removed[a] == 0.0 && (largest_stretch(f) > limit || smallest_stretch(f) * limit < 1.0)
        };
        if (0..self.len()).any(far) {
            return self.renew_reference();
        }
        Ok(())
    }

    fn check_renewable(&self) -> Result<(), SolidError> {
        let bad = |side, why: &str| {
            Err(SolidError::NotRenewable {
                side,
                why: why.to_owned(),
            })
        };
        for side in Side::ALL {
            match self.block.face(side) {
                Face::Axis | Face::Symmetry | Face::Traction | Face::Free => {}
                face => return bad(side, &format!("it is {face:?}")),
            }
        }
        for surface in &self.surfaces {
            if surface.pressure.iter().any(|p| *p != 0.0) {
                return bad(surface.side, "pressure acts on it");
            }
        }
        if let Some(indenter) = &self.indenter {
            return bad(indenter.side, "an indenter presses on it");
        }
        if self.numerics.formulation != Formulation::TotalLagrangian {
            return bad(
                Side::Left,
                "the published form has no reference configuration",
            );
        }
        Ok(())
    }
}
