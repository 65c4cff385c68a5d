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
pub(crate) struct Pair<S, const D: usize> {
    /// x_a - x_b, m.
    pub(crate) separation: [S; D],
    /// |x_a - x_b|, m.
    pub(crate) distance: S,
    /// 1/distance, 1/m.
    pub(crate) inverse_distance: S,
    /// W R^D.
    pub(crate) relative_kernel: S,
    /// Kernel W, 1/m^D.
    pub(crate) kernel: S,
    /// (dW/ddistance)/distance, 1/m^(D + 2): times the separation it is the gradient at a.
    pub(crate) gradient: S,
}

impl<S: Simd, const D: usize> Pair<S, D> {
    /// Pairs of particles at `x_a` and `x_b` with the sum `support` of their smoothing lengths, and 1/`divisor`: one division for all.
    #[inline(always)]
    pub(crate) fn new(x_a: &[S; D], x_b: &[S; D], support: S, divisor: S) -> (Self, S) {
        let zero = S::splat(0.0);
        let mut separation = [zero; D];
        let mut square = S::splat(NEAREST_SQUARED);
        for k in (0..D).rev() {
            separation[k] = x_a[k] - x_b[k];
            square = separation[k].mul_add(separation[k], square);
        }
        let distance = square.sqrt();
        // R = 2 (h_a + h_b)/2.
        let product = distance * support;
        let inverse = S::splat(1.0) / (product * divisor);
        let inverse_product = inverse * divisor;
        let inverse_support = inverse_product * distance;
        let inverse_square = inverse_support * inverse_support;
        let inverse_cube = inverse_square * inverse_support;
        let inverse_power = if D == 2 { inverse_square } else { inverse_cube };
        let [value, slope] = kernel::times_support::<S, D>(distance, support);
        let pair = Self {
            separation,
            distance,
            inverse_distance: inverse_product * support,
            relative_kernel: value * inverse_cube,
            kernel: value * (inverse_cube * inverse_power),
            gradient: slope * (inverse_square * inverse_power * inverse_product),
        };
        (pair, inverse * product)
    }
}

/// Scalar product.
#[inline(always)]
pub(crate) fn dot<S: Simd, const D: usize>(a: &[S; D], b: &[S; D]) -> S {
    let mut sum = a[D - 1] * b[D - 1];
    for k in (0..D - 1).rev() {
        sum = a[k].mul_add(b[k], sum);
    }
    sum
}

/// Sum of two vectors.
#[inline(always)]
pub(crate) fn plus<S: Simd, const D: usize>(a: &[S; D], b: &[S; D]) -> [S; D] {
    let mut sum = *a;
    for k in 0..D {
        sum[k] = a[k] + b[k];
    }
    sum
}

/// A vector times a number.
#[inline(always)]
pub(crate) fn scaled<S: Simd, const D: usize>(a: &[S; D], factor: S) -> [S; D] {
    let mut product = *a;
    for k in 0..D {
        product[k] = factor * a[k];
    }
    product
}

/// Adds a vector times a number to a sum.
#[inline(always)]
pub(crate) fn add_scaled<S: Simd, const D: usize>(sum: &mut [S; D], a: &[S; D], factor: S) {
    for k in 0..D {
        sum[k] = factor.mul_add(a[k], sum[k]);
    }
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
