//! The 2x2 moment matrix of kernel gradients and its inverse.

use crate::geometry::Vec2;

/// Symmetric 2x2 matrix [xx, xy, yy].
pub(crate) type Sym2 = [f64; 3];

/// Inverse of M = -sum A_b (x_a - x_b) (x) grad W; eigenvalues below `FLOOR` are lifted, so that a particle with too few
/// neighbours falls back to the uncorrected gradient instead of an arbitrary one.
pub(crate) fn inverse(m: Sym2) -> Sym2 {
    let smallest = smaller_eigenvalue(m);
    let lift = (FLOOR - smallest).max(0.0);
    let (a, b, c) = (m[0] + lift, m[1], m[2] + lift);
    let det = a * c - b * b;
    [c / det, -b / det, a / det]
}

/// Below this eigenvalue the moment matrix is regularised.
const FLOOR: f64 = 0.2;

/// Smaller eigenvalue of a symmetric 2x2 matrix.
pub(crate) fn smaller_eigenvalue(m: Sym2) -> f64 {
    0.5 * (m[0] + m[2]) - (0.25 * (m[0] - m[2]).powi(2) + m[1] * m[1]).sqrt()
}

/// Matrix times vector.
pub(crate) fn apply(m: Sym2, x: Vec2) -> Vec2 {
    [m[0] * x[0] + m[1] * x[1], m[1] * x[0] + m[2] * x[1]]
}
