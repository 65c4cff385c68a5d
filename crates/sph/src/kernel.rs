//! Cubic spline kernel in two dimensions.
//!
//! W = 10/(7 pi h^2) (1 - 3/2 q^2 + 3/4 q^3) for q < 1, 10/(7 pi h^2) (2 - q)^3/4 for q < 2, q = distance/h.
//! (Joshi 2018, eq. 2.38, with the constant of Monaghan's cubic spline: see docs/equations.md.)

use crate::simd::Simd;
use std::f64::consts::PI;

/// Support radius in units of h.
pub const SUPPORT: f64 = 2.0;

/// W = SCALE/h^2 times [`shape`] of q.
pub const SCALE: f64 = 10.0 / (7.0 * PI);

/// Kernel value, 1/m2.
#[must_use]
pub fn value(distance: f64, h: f64) -> f64 {
    let q = distance / h;
    let s = 10.0 / (7.0 * PI * h * h);
    let t = (2.0 - q).max(0.0);
    let u = (1.0 - q).max(0.0);
    s * (0.25 * t * t * t - u * u * u)
}

/// (dW/ddistance)/distance, 1/m4: times (x_a - x_b) it is the gradient at a. Finite at distance 0.
#[must_use]
pub fn gradient_factor(distance: f64, h: f64) -> f64 {
    let q = distance / h;
    let s = 10.0 / (7.0 * PI * h * h * h * h);
    if q < 1.0 {
        s * (2.25 * q - 3.0)
    } else if q < 2.0 {
        let t = 2.0 - q;
        -0.75 * s * t * t / q
    } else {
        0.0
    }
}

/// W h^2/SCALE of eight pairs at q; exactly 0 from q = 2 on.
#[inline(always)]
pub fn shape<S: Simd>(q: S) -> S {
    let zero = S::splat(0.0);
    let t = (S::splat(2.0) - q).max(zero);
    let u = (S::splat(1.0) - q).max(zero);
    S::splat(0.25) * t * t * t - u * u * u
}

/// (dW/ddistance)/distance h^4/SCALE of eight pairs at q; finite at q = 0 (1/q must be finite there), exactly 0 from q = 2 on.
#[inline(always)]
pub fn slope<S: Simd>(q: S, inverse_q: S) -> S {
    let t = (S::splat(2.0) - q).max(S::splat(0.0));
    let inner = q.mul_add(S::splat(2.25), S::splat(-3.0));
    S::select(
        q.lt(S::splat(1.0)),
        inner,
        S::splat(-0.75) * t * t * inverse_q,
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simd::{self, LANES, Task};

    /// [`shape`] and [`slope`] at eight q.
    struct Both([f64; LANES]);

    impl Task for Both {
        type Output = [[f64; LANES]; 2];

        #[inline(always)]
        fn run<S: Simd>(self) -> Self::Output {
            let q = S::load(&self.0);
            let inverse = S::splat(1.0) / q.max(S::splat(1e-30));
            [shape(q).store(), slope(q, inverse).store()]
        }
    }

    #[test]
    fn lanes_agree_with_single_pairs() {
        let q = [0.0, 0.3, 0.999, 1.0, 1.2, 1.9, 2.0, 2.5];
        let [shape, slope] = simd::run(Both(q));
        let h: f64 = 0.7;
        for (k, q) in q.into_iter().enumerate() {
            assert!((SCALE / h.powi(2) * shape[k] - value(q * h, h)).abs() < 1e-14);
            assert!((SCALE / h.powi(4) * slope[k] - gradient_factor(q * h, h)).abs() < 1e-13);
        }
        assert_eq!([shape[6], shape[7], slope[6], slope[7]], [0.0; 4]);
    }

    #[test]
    fn integrates_to_one_and_matches_its_gradient() {
        let (h, n) = (0.7, 4000);
        let d = SUPPORT * h / f64::from(n);
        let sum: f64 = (0..n)
            .map(|i| (f64::from(i) + 0.5) * d)
            .map(|r| value(r, h) * 2.0 * PI * r * d)
            .sum();
        assert!((sum - 1.0).abs() < 1e-6);
        for r in [0.01, 0.3, 0.69, 0.71, 1.2, 1.39, 1.5] {
            let e = 1e-6;
            let slope = (value(r + e, h) - value(r - e, h)) / (2.0 * e);
            assert!((slope - r * gradient_factor(r, h)).abs() < 1e-7);
        }
    }
}
