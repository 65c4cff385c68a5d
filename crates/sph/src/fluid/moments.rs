//! The 2x2 moment matrix of kernel gradients and its inverse.

use crate::geometry::Vec2;
use crate::simd::Simd;

/// Symmetric 2x2 matrix [xx, xy, yy].
pub(crate) type Sym2<T = f64> = [T; 3];

/// Inverse of M = -sum A_b (x_a - x_b) (x) grad W; eigenvalues below `FLOOR` are lifted, so that a particle with too few
/// neighbours falls back to the uncorrected gradient instead of an arbitrary one.
#[inline(always)]
pub(crate) fn inverse<S: Simd>(m: Sym2<S>) -> Sym2<S> {
    let lift = (S::splat(FLOOR) - smaller_eigenvalue(m)).max(S::splat(0.0));
    let (a, b, c) = (m[0] + lift, m[1], m[2] + lift);
    let inverse = S::splat(1.0) / (a * c - b * b);
    [c * inverse, -b * inverse, a * inverse]
}

/// Below this eigenvalue the moment matrix is regularised.
const FLOOR: f64 = 0.2;

/// Smaller eigenvalue of a symmetric 2x2 matrix.
#[inline(always)]
pub(crate) fn smaller_eigenvalue<S: Simd>(m: Sym2<S>) -> S {
    let half = S::splat(0.5);
    let difference = half * (m[0] - m[2]);
    half * (m[0] + m[2]) - difference.mul_add(difference, m[1] * m[1]).sqrt()
}

/// Matrix times vector, for eight particles.
#[inline(always)]
pub(crate) fn apply_lanes<S: Simd>(m: Sym2<S>, x: [S; 2]) -> [S; 2] {
    [
        m[0].mul_add(x[0], m[1] * x[1]),
        m[1].mul_add(x[0], m[2] * x[1]),
    ]
}

/// Matrix times vector.
pub(crate) fn apply(m: Sym2, x: Vec2) -> Vec2 {
    [m[0] * x[0] + m[1] * x[1], m[1] * x[0] + m[2] * x[1]]
}
