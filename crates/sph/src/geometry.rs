//! Plane or axisymmetric motion.

use serde::{Deserialize, Serialize};

/// A point or vector of the plane of motion: (r, z) or (x, y), metres.
pub type Vec2 = [f64; 2];

/// What the two coordinates mean.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Geometry {
    /// Plane strain, per metre of thickness.
    Plane,
    /// Rotational symmetry about r = 0; masses and volumes are those of whole rings.
    Axisymmetric,
}

impl Geometry {
    /// Out-of-plane length of a particle at first coordinate `r`: 2 pi r in axisymmetry (m), 1 m in plane.
    #[must_use]
    pub fn ring(self, r: f64) -> f64 {
        match self {
            Self::Plane => 1.0,
            Self::Axisymmetric => 2.0 * std::f64::consts::PI * r,
        }
    }
}
