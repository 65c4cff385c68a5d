//! Elastic-plastic solid, plane strain or axisymmetric: total Lagrangian, or in the published form ([`updated`]).
//!
//! The body is a rectangle in its reference configuration, of any (also graded) spacing; in the total Lagrangian form
//! neighbours and gradients are those of the reference, stored once. Sums are gathers over fixed lists with one writer per
//! output, so results are the same bits for any number of threads. Eight particles that follow each other stand side by side in the lanes
//! of all passes (`pairs.rs`). The formulas stand on top of `stress.rs` (strain and stress), `force.rs`, `images.rs` (faces), `balance.rs`, `surface.rs` and `energy.rs`.

mod absorbing;
mod balance;
mod block;
mod blocks;
mod corrections;
mod driven;
mod energy;
mod error;
mod failure;
mod flow;
mod flux;
mod follow;
mod force;
mod images;
mod increment;
mod indenter;
mod layers;
mod layout;
mod mat2;
mod motion;
mod own;
mod pairs;
mod points;
mod quasi_static;
mod reference;
mod renewal;
mod resolution;
mod rest;
mod return_in_lanes;
mod search;
mod setup;
mod shares;
pub mod space;
mod state;
mod step;
mod stress;
mod sums;
mod surface;
pub mod updated;

pub use block::{Block, Driven, Face, Side, Tangential};
pub use energy::Energy;
pub use error::SolidError;
pub use indenter::Indenter;
pub use layers::{Layer, Layers};
pub use mat2::Mat2;
pub use quasi_static::{QuasiStatic, Share, smoothstep};
pub use reference::Reference;
pub use renewal::Base;
pub use resolution::LoadResolution;
pub use setup::Setup;
pub use state::{FAILED, Field, LOOSE, Lost, State, Work};
pub use step::StepLimit;
pub use surface::Surface;

use crate::geometry::Geometry;
use erode_physics::damage::Damage;
use erode_physics::material_point::Material;
use layers::Materials;
use layout::Layout;
use serde::{Deserialize, Serialize};

/// Numerical constants of the formulation; the defaults are the ones that were measured as best.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Numerics {
    /// Smoothing length in units of the square root of the particle's area.
    pub smoothing_ratio: f64,
    /// Linear artificial viscosity alpha.
    pub viscosity: f64,
    /// Linear artificial viscosity of pairs with a particle of the first row of an open face, on approach and
    /// separation; must be about 1 for stability (see `force.rs`).
    pub edge_viscosity: f64,
    /// Hourglass stiffness zeta.
    pub hourglass: f64,
    /// Stable step in units of spacing / longitudinal wave speed.
    pub courant: f64,
    /// Discrete form.
    pub formulation: Formulation,
    /// The present configuration becomes the reference when a particle is stretched or compressed by this factor in the
    /// plane since the last time (total Lagrangian form, see `renewal.rs`); never when absent.
    #[serde(default)]
    pub renewal: Option<f64>,
}

/// Discrete form of the solid.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Formulation {
    /// Neighbours and gradients of the reference configuration; the viscosity and hourglass stiffness of [`Numerics`].
    #[default]
    TotalLagrangian,
    /// As published: neighbours and gradients of the present configuration, an artificial viscosity of its own.
    Joshi(updated::Settings),
}

impl Default for Numerics {
    fn default() -> Self {
        Self {
            smoothing_ratio: 1.3,
            viscosity: 0.2,
            edge_viscosity: 1.0,
            hourglass: 0.1,
            courant: 0.4,
            formulation: Formulation::default(),
            renewal: None,
        }
    }
}

/// A solid body.
#[derive(Debug, Clone)]
pub struct Solid {
    /// Plane strain or axisymmetric.
    pub geometry: Geometry,
    /// Reference rectangle and its faces.
    pub block: Block,
    /// Material below the layers.
    pub material: Material,
    /// When that material fails; never unless set.
    pub damage: Damage,
    /// Layers of other materials at the top.
    pub layers: Layers,
    /// Numerical constants.
    pub numerics: Numerics,
    /// Reference configuration.
    pub reference: Reference,
    /// What changes with time; replace it by a checkpoint's to resume (then call [`Self::take_up`]).
    pub state: State,
    /// Traction, absorbing and driven faces.
    pub surfaces: Vec<Surface>,
    /// A rigid body that presses on a traction face; its motion is set by the caller.
    pub indenter: Option<Indenter>,
    scratch: force::Scratch,
    /// Used by the published form alone.
    present: updated::Present,
}

impl Solid {
    /// Builds the body at rest and free of stress.
    ///
    /// # Errors
    /// If the block is wrong, a particle lies outside of it or has no positive area, or a particle has too few
    /// neighbours for a gradient.
    pub fn new(setup: Setup) -> Result<Self, SolidError> {
        Self::layered(setup, Vec::new())
    }

    /// The same with layers of other materials, the first one at the top.
    ///
    /// # Errors
    /// As [`Self::new`], or if the layers are no thicker than the particles or do not fit into the body.
    pub fn layered(setup: Setup, layers: Vec<Layer>) -> Result<Self, SolidError> {
        setup.check()?;
        let Setup {
            geometry,
            block,
            material,
            numerics,
            position,
            area,
        } = setup;
        let layers = Layers::new(layers, &block, &numerics, &position, &area)?;
        let materials = Materials {
            own: &material,
            layers: &layers,
        };
        let layout = Layout::first(geometry, materials, &numerics, position, area);
        let mut reference = Reference::new(geometry, &block, materials, &numerics, layout)?;
        let surfaces = Side::ALL
            .into_iter()
            .filter(|&side| !block.face(side).mirrors())
            .map(|side| Surface::new(geometry, &block, side, &reference))
            .collect::<Result<Vec<_>, _>>()?;
        let present = match numerics.formulation {
            Formulation::TotalLagrangian => updated::Present::default(),
            Formulation::Joshi(_) => updated::Present::new(
                &block,
                &reference.position,
                &reference.smoothing_length,
                &surfaces,
            )?,
        };
        let axisymmetric = geometry == Geometry::Axisymmetric;
        let imbalance = balance::imbalance(&reference, &block, axisymmetric, &surfaces);
        reference.balance(imbalance);
        let mut solid = Self {
            state: State::at_rest(reference.position.clone(), material.temperature),
            geometry,
            block,
            material,
            damage: Damage::None,
            layers,
            numerics,
            scratch: force::Scratch::of(&reference, &surfaces),
            reference,
            surfaces,
            indenter: None,
            present,
        };
        solid.follow_surfaces();
        Ok(solid)
    }

    /// Number of particles.
    #[must_use]
    pub fn len(&self) -> usize {
        self.state.position.len()
    }

    /// Whether there are no particles.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    fn materials(&self) -> Materials<'_> {
        Materials {
            own: &self.material,
            layers: &self.layers,
        }
    }

    /// Material of a particle.
    #[must_use]
    pub fn material_of(&self, particle: usize) -> &Material {
        self.materials().of(particle)
    }

    /// When a particle fails.
    #[must_use]
    pub fn damage_of(&self, particle: usize) -> &Damage {
        match self.layers.index(particle) {
            0 => &self.damage,
            k => &self.layers.list()[k - 1].damage,
        }
    }

    /// Longitudinal wave speed of each material: of the body, then of its layers, m/s.
    pub(super) fn wave_speeds(&self) -> impl Iterator<Item = f64> + '_ {
        let layers = self.layers.list().iter().map(|l| &l.material);
        let all = std::iter::once(&self.material).chain(layers);
        all.map(|m| m.elastic.longitudinal_speed(m.density))
    }

    /// Longitudinal wave speed of the fastest of its materials, m/s.
    #[must_use]
    pub fn wave_speed(&self) -> f64 {
        self.wave_speeds().fold(0.0, f64::max)
    }

    /// J = present volume / volume in the first configuration of a particle.
    #[must_use]
    pub fn volume_ratio(&self, particle: usize) -> f64 {
        let f = &self.state.deformation[particle];
        self.reference.volume_ratio[particle]
            * mat2::determinant(f)
            * self.state.hoop_stretch[particle]
    }

    /// Density of a particle, kg/m3.
    #[must_use]
    pub fn density(&self, particle: usize) -> f64 {
        self.material_of(particle).density / self.volume_ratio(particle)
    }

    /// The surface on a side; none where the body is mirrored (axis, symmetry, clamped). On a free face it only follows the body.
    #[must_use]
    pub fn surface(&self, side: Side) -> Option<&Surface> {
        self.surfaces.iter().find(|s| s.side == side)
    }

    /// The same, to set its pressure.
    #[must_use]
    pub fn surface_mut(&mut self, side: Side) -> Option<&mut Surface> {
        self.surfaces.iter_mut().find(|s| s.side == side)
    }

    fn check_free_faces(&self) -> Result<(), SolidError> {
        for surface in self.surfaces.iter().filter(|s| s.face == Face::Free) {
            if let Some(&pressure) = surface.pressure.iter().find(|p| **p != 0.0) {
                return Err(SolidError::PressureOnFreeFace {
                    side: surface.side,
                    pressure,
                });
            }
        }
        Ok(())
    }
}
