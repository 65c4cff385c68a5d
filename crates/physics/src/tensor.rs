//! Small tensors of continuum mechanics.
//!
//! Index order is (r, z, theta) in axisymmetry, (x, y, z) otherwise: the first two directions span the plane of
//! motion, the third is the hoop (axisymmetric) or out-of-plane (plane strain) direction.

use serde::{Deserialize, Serialize};

/// Symmetric 3x3 tensor, six components.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Sym3 {
    /// Component 11 (rr or xx).
    pub xx: f64,
    /// Component 22 (zz in axisymmetry, or yy).
    pub yy: f64,
    /// Component 33 (hoop, or out of plane).
    pub zz: f64,
    /// Component 12.
    pub xy: f64,
    /// Component 13.
    pub xz: f64,
    /// Component 23.
    pub yz: f64,
}
