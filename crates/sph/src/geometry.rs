//! Plane, axisymmetric or three-dimensional motion.

use serde::{Deserialize, Serialize};

/// A point or vector of the plane of motion: (r, z) or (x, y), metres.
pub type Vec2 = [f64; 2];

/// A point or vector of space, metres.
pub type Vec3 = [f64; 3];

/// What the coordinates mean.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Geometry {
    /// Cartesian: plane strain per metre of thickness in two dimensions, space in three.
    Plane,
    /// Rotational symmetry about r = 0 (two dimensions); masses and volumes are those of whole rings.
    Axisymmetric,
}

impl Geometry {
    /// Out-of-plane length of a particle at first coordinate `r`: 2 pi r in axisymmetry (m), 1 m in plane, 1 in space.
    #[inline]
    #[must_use]
    pub fn ring(self, r: f64) -> f64 {
        match self {
            Self::Plane => 1.0,
            Self::Axisymmetric => 2.0 * std::f64::consts::PI * r,
        }
    }
}

/// Scalar product.
#[inline]
pub(crate) fn dot<const D: usize>(a: [f64; D], b: [f64; D]) -> f64 {
    let mut sum = a[0] * b[0];
    for k in 1..D {
        sum += a[k] * b[k];
    }
    sum
}

/// Length of a vector.
#[inline]
pub(crate) fn length<const D: usize>(x: [f64; D]) -> f64 {
    dot(x, x).sqrt()
}
