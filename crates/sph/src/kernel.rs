//! Cubic spline kernel in two dimensions.
//!
//! W = 10/(7 pi h^2) (1 - 3/2 q^2 + 3/4 q^3) for q < 1, 10/(7 pi h^2) (2 - q)^3/4 for q < 2, q = distance/h.
//! (Joshi 2018, eq. 2.38, with the constant of Monaghan's cubic spline: see docs/equations.md.)

use crate::simd::Simd;
use std::f64::consts::PI;

/// Support radius in units of h.
pub const SUPPORT: f64 = 2.0;

/// Constant of the kernel: W = SCALE/h^2 at distance 0.
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

/// W R^5 and (dW/ddistance) R^5 of eight pairs with support radius R = 2h: with t = R - distance and u = R/2 - distance, not
/// below zero, these are SCALE (8 t^3 - 32 u^3) and SCALE (96 u^2 - 24 t^2). Exactly 0 from distance R on.
#[inline(always)]
pub fn times_support_to_fifth<S: Simd>(distance: S, support: S) -> [S; 2] {
    let zero = S::splat(0.0);
    let t = (support - distance).max(zero);
    let u = support.mul_add(S::splat(0.5), -distance).max(zero);
    let (t2, u2) = (t * t, u * u);
    let value = (t2 * t).mul_add(S::splat(8.0 * SCALE), u2 * u * S::splat(-32.0 * SCALE));
    let slope = u2.mul_add(S::splat(96.0 * SCALE), t2 * S::splat(-24.0 * SCALE));
    [value, slope]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simd::{self, LANES, Task};

    /// Value and slope at eight q with h.
    struct Both([f64; LANES], f64);

    impl Task for Both {
        type Output = [[f64; LANES]; 2];

        #[inline(always)]
        fn run<S: Simd>(self) -> Self::Output {
            let h = S::splat(self.1);
            times_support_to_fifth(S::load(&self.0) * h, h + h).map(S::store)
        }
    }

    #[test]
    fn lanes_agree_with_single_pairs() {
        let q = [0.0, 0.3, 0.999, 1.0, 1.2, 1.9, 2.0, 2.5];
        let h: f64 = 0.75;
        let [values, slopes] = simd::run(Both(q, h));
        let fifth = (2.0 * h).powi(5);
        for (k, q) in q.into_iter().enumerate() {
            let slope = q * h * gradient_factor(q * h, h);
            assert!((values[k] / fifth - value(q * h, h)).abs() < 1e-14);
            assert!((slopes[k] / fifth - slope).abs() < 1e-13);
        }
        assert_eq!([values[6], values[7], slopes[6], slopes[7]], [0.0; 4]);
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
