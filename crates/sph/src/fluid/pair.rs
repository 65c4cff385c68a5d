//! Geometry and kernel of eight pairs side by side.

use crate::geometry::Geometry;
use crate::kernel;
use crate::simd::Simd;
use std::f64::consts::PI;

/// Square of the least distance of a pair, m2: coincident particles, and a particle with itself, get finite factors that vanish
/// with the separation.
const NEAREST_SQUARED: f64 = 1e-60;

/// Eight pairs, with the mean h. What a law does not use costs nothing.
#[derive(Clone, Copy)]
pub(crate) struct Pair<S> {
    /// x_a - x_b, m.
    pub(crate) separation: [S; 2],
    /// |x_a - x_b|, m.
    pub(crate) distance: S,
    /// 1/distance, 1/m.
    pub(crate) inverse_distance: S,
    /// W R^2.
    pub(crate) relative_kernel: S,
    /// Kernel W, 1/m2.
    pub(crate) kernel: S,
    /// (dW/ddistance)/distance, 1/m4: times the separation it is the gradient at a.
    pub(crate) gradient: S,
}

impl<S: Simd> Pair<S> {
    /// Pairs of particles at [x, y] with h, and 1/`divisor`: one division for all.
    #[inline(always)]
    pub(crate) fn new(a: [S; 3], b: [S; 3], divisor: S) -> (Self, S) {
        let separation = [a[0] - b[0], a[1] - b[1]];
        let [x, y] = separation;
        let square = x.mul_add(x, y.mul_add(y, S::splat(NEAREST_SQUARED)));
        let distance = square.sqrt();
        // R = 2 (h_a + h_b)/2.
        let support = a[2] + b[2];
        let product = distance * support;
        let inverse = S::splat(1.0) / (product * divisor);
        let inverse_product = inverse * divisor;
        let inverse_support = inverse_product * distance;
        let inverse_square = inverse_support * inverse_support;
        let inverse_fourth = inverse_square * inverse_square;
        let [value, slope] = kernel::times_support_to_fifth(distance, support);
        let pair = Self {
            separation,
            distance,
            inverse_distance: inverse_product * support,
            relative_kernel: value * (inverse_square * inverse_support),
            kernel: value * (inverse_fourth * inverse_support),
            gradient: slope * (inverse_fourth * inverse_product),
        };
        (pair, inverse * product)
    }
}

/// Scalar product.
#[inline(always)]
pub(crate) fn dot<S: Simd>(a: [S; 2], b: [S; 2]) -> S {
    a[0].mul_add(b[0], a[1] * b[1])
}

/// Half-way reconstruction of a difference: the `rest` that the linear part leaves of a `jump`; zero when they disagree in sign,
/// never more than the jump: the middle one of the two and zero.
#[inline(always)]
pub(crate) fn limited<S: Simd>(jump: S, rest: S) -> S {
    let zero = S::splat(0.0);
    jump.min(rest).max(jump.max(rest).min(zero))
}

/// Half of the out-of-plane length of a particle at first coordinate `x`, m: |sum| of two is their mean length.
pub(crate) fn half_ring(geometry: Geometry, x: f64) -> f64 {
    match geometry {
        Geometry::Plane => 0.5,
        Geometry::Axisymmetric => PI * x,
    }
}
