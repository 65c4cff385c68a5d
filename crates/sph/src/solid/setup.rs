//! What a solid is made from.

use super::{Block, Numerics, Side, SolidError};
use crate::geometry::{Geometry, Vec2};
use crate::kernel;
use erode_physics::material_point::Material;

/// What a solid is made from.
#[derive(Debug, Clone, PartialEq)]
pub struct Setup {
    /// Plane strain or axisymmetric.
    pub geometry: Geometry,
    /// Reference rectangle and its faces.
    pub block: Block,
    /// Material.
    pub material: Material,
    /// Numerical constants.
    pub numerics: Numerics,
    /// Reference positions inside the rectangle, m. Steps are fastest where eights of particles that follow each other lie close
    /// together, see [`crate::neighbours::compact_order`].
    pub position: Vec<Vec2>,
    /// Area of each particle in the plane of motion, m2.
    pub area: Vec<f64>,
}

impl Setup {
    pub(super) fn check(&self) -> Result<(), SolidError> {
        self.block.check(self.geometry)?;
        if self.position.len() != self.area.len() || self.position.is_empty() {
            return Err(SolidError::BadCount {
                positions: self.position.len(),
                areas: self.area.len(),
            });
        }
        let largest = self.area.iter().fold(0.0, |m: f64, &a| m.max(a));
        let support = kernel::SUPPORT * self.numerics.smoothing_ratio * largest.sqrt();
        if (0..2).any(|k| self.block.upper[k] - self.block.lower[k] < support) {
            return Err(SolidError::BadBlock {
                block: Box::new(self.block),
                why: format!("it is thinner than the kernel of its largest particle, {support} m"),
            });
        }
        for (particle, (&position, &area)) in self.position.iter().zip(&self.area).enumerate() {
            let inside = Side::ALL
                .iter()
                .all(|&s| self.block.depth(s, position) > 0.0);
            if !inside || !area.is_finite() || area <= 0.0 {
                return Err(SolidError::BadParticle {
                    particle,
                    position,
                    area,
                });
            }
        }
        Ok(())
    }
}
