//! Geometry and kernel of eight pairs side by side.

use crate::geometry::Geometry;
use crate::kernel;
use crate::simd::Simd;
use std::f64::consts::PI;

/// Pairs are at least this far apart (m): coincident particles, and a particle with itself, get finite factors that vanish
/// with the separation.
const NEAREST: f64 = 1e-30;

/// Eight pairs.
#[derive(Clone, Copy)]
pub(crate) struct Pair<S> {
    /// x_a - x_b, m.
    pub(crate) separation: [S; 2],
    /// |x_a - x_b|, m.
    pub(crate) distance: S,
    /// 1/distance, 1/m.
    pub(crate) inverse_distance: S,
    /// Distance/h with the mean h.
    pub(crate) q: S,
    /// h/distance.
    inverse_q: S,
    /// SCALE/h^2: the unit of the kernel, 1/m2.
    unit: S,
    /// 1/h^2, 1/m2.
    inverse_square: S,
}

impl<S: Simd> Pair<S> {
    /// Pairs of particles at [x, y] with h, and 1/`divisor`: one division for all.
    #[inline(always)]
    pub(crate) fn new(a: [S; 3], b: [S; 3], divisor: S) -> (Self, S) {
        let separation = [a[0] - b[0], a[1] - b[1]];
        let h = S::splat(0.5) * (a[2] + b[2]);
        let distance = dot(separation, separation).sqrt().max(S::splat(NEAREST));
        let product = distance * h;
        let inverse = S::splat(1.0) / (product * divisor);
        let inverse_product = inverse * divisor;
        let inverse_h = inverse_product * distance;
        let inverse_square = inverse_h * inverse_h;
        let inverse_distance = inverse_product * h;
        let pair = Self {
            separation,
            distance,
            inverse_distance,
            inverse_q: h * inverse_distance,
            q: distance * inverse_h,
            unit: S::splat(kernel::SCALE) * inverse_square,
            inverse_square,
        };
        (pair, inverse * product)
    }

    /// W, 1/m2.
    #[inline(always)]
    pub(crate) fn kernel(&self) -> S {
        self.unit * kernel::shape(self.q)
    }

    /// (dW/ddistance)/distance, 1/m4: times the separation it is the gradient at a.
    #[inline(always)]
    pub(crate) fn gradient_factor(&self) -> S {
        self.unit * self.inverse_square * kernel::slope(self.q, self.inverse_q)
    }
}

/// Scalar product.
#[inline(always)]
pub(crate) fn dot<S: Simd>(a: [S; 2], b: [S; 2]) -> S {
    a[0].mul_add(b[0], a[1] * b[1])
}

/// Half-way reconstruction of a difference: what is left of `jump` after the linear part `linear`; zero when they
/// disagree in sign, never more than the jump.
#[inline(always)]
pub(crate) fn limited<S: Simd>(jump: S, linear: S) -> S {
    let rest = jump - linear;
    let zero = S::splat(0.0);
    let smaller = S::select(rest.abs().lt(jump.abs()), rest, jump);
    S::select(zero.lt(jump * rest), smaller, zero)
}

/// Mean out-of-plane length of two particles, m: |sum of first coordinates| times the first number plus the second.
pub(crate) fn mean_ring(geometry: Geometry) -> [f64; 2] {
    match geometry {
        Geometry::Plane => [0.0, 1.0],
        Geometry::Axisymmetric => [PI, 0.0],
    }
}
