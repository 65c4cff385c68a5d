//! Layers at the top of a body, each of its own material: coatings.
//!
//! A particle has the material of the layer in which its centre lies in the reference configuration. Layers are bonded to each
//! other and to the body: velocities and displacements are continuous, stresses along the interface are not. Mass, wave speed,
//! impedance and yield law are those of each particle's own material; what stabilises a pair is that of the softer one.
//!
//! The gradients of a particle next to an interface reach across it, so that strain jumps over two kernel supports instead of
//! at a point; waves are reflected and transmitted as the impedances say.

use super::{Block, Formulation, Numerics, SolidError};
use crate::geometry::Vec2;
use erode_physics::damage::Damage;
use erode_physics::material_point::Material;

/// A layer of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Layer {
    /// Thickness, m.
    pub thickness: f64,
    /// Material.
    pub material: Material,
    /// When it fails.
    pub damage: Damage,
}

/// The layers of a body, and which one each particle belongs to.
#[derive(Debug, Clone, Default)]
pub struct Layers {
    layers: Vec<Layer>,
    /// 0 below the layers, then their number from the top; empty without layers.
    index: Vec<u8>,
}

impl Layers {
    /// Assigns the particles of a body, given by their reference positions and areas; the first layer lies at the top.
    pub(super) fn new(
        layers: Vec<Layer>,
        block: &Block,
        numerics: &Numerics,
        position: &[Vec2],
        area: &[f64],
    ) -> Result<Self, SolidError> {
        if layers.is_empty() {
            return Ok(Self::default());
        }
        check(&layers, block, numerics)?;
        let of = |x: &Vec2| {
            let mut bottom = block.upper[1];
            let found = layers.iter().position(|layer| {
                bottom -= layer.thickness;
                x[1] > bottom
            });
            found.map_or(0, |k| k as u8 + 1)
        };
        let index: Vec<u8> = position.iter().map(of).collect();
        for (k, layer) in layers.iter().enumerate() {
            let inside = index.iter().zip(area);
            let inside = inside.filter(|(i, _)| usize::from(**i) == k + 1);
            let finest = inside.map(|(_, a)| a.sqrt()).fold(f64::INFINITY, f64::min);
            if layer.thickness * (1.0 + 1e-9) < finest {
                let why = format!(
                    "layer {} is {} m thick, less than the spacing of the particles there; use a finer spacing or a thicker layer",
                    k + 1,
                    layer.thickness
                );
                return Err(SolidError::BadLayers { why });
            }
        }
        Ok(Self { layers, index })
    }

    /// The layers, from the top.
    #[must_use]
    pub fn list(&self) -> &[Layer] {
        &self.layers
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.layers.is_empty()
    }

    /// Number of the layer of a particle from the top, beginning with 1; 0 below the layers.
    #[must_use]
    pub fn index(&self, particle: usize) -> usize {
        self.index.get(particle).map_or(0, |i| usize::from(*i))
    }
}

fn check(layers: &[Layer], block: &Block, numerics: &Numerics) -> Result<(), SolidError> {
    let bad = |why: String| Err(SolidError::BadLayers { why });
    if layers.len() > usize::from(u8::MAX) {
        return bad(format!(
            "there are {} layers; {} are the most",
            layers.len(),
            u8::MAX
        ));
    }
    if let Some(layer) = (layers.iter()).find(|l| !l.thickness.is_finite() || l.thickness <= 0.0) {
        return bad(format!(
            "a layer is {} m thick; every layer needs a thickness above zero",
            layer.thickness
        ));
    }
    let all: f64 = layers.iter().map(|l| l.thickness).sum();
    let height = block.upper[1] - block.lower[1];
    if all >= height {
        return bad(format!(
            "the layers are {all} m thick together, the body is {height} m high; the rest of the body lies below them"
        ));
    }
    if numerics.formulation != Formulation::TotalLagrangian {
        return bad(
            "the published form has one material; use the total Lagrangian form".to_owned(),
        );
    }
    Ok(())
}

/// Materials of all particles.
#[derive(Clone, Copy)]
pub(super) struct Materials<'a> {
    pub(super) own: &'a Material,
    pub(super) layers: &'a Layers,
}

impl<'a> Materials<'a> {
    /// Material of a particle.
    pub(super) fn of(self, particle: usize) -> &'a Material {
        match self.layers.index(particle) {
            0 => self.own,
            k => &self.layers.layers[k - 1].material,
        }
    }
}
