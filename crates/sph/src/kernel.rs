//! Cubic spline kernel in two and three dimensions.
//!
//! W = s/h^D (1 - 3/2 q^2 + 3/4 q^3) for q < 1, s/h^D (2 - q)^3/4 for q < 2, q = distance/h; s = 10/(7 pi) in two dimensions,
//! 1/pi in three. (Joshi 2018, eq. 2.38, with the constant of Monaghan's cubic spline: see docs/equations.md.)

use crate::simd::Simd;
use std::f64::consts::PI;

/// Support radius in units of h.
pub const SUPPORT: f64 = 2.0;

/// Constant of the kernel: W = scale(D)/h^D at distance 0.
///
/// # Panics
/// In other than two or three dimensions.
#[must_use]
pub const fn scale(dimensions: usize) -> f64 {
    match dimensions {
        2 => 10.0 / (7.0 * PI),
        3 => 1.0 / PI,
        _ => panic!("the kernel has two or three dimensions"),
    }
}

/// Kernel value in the plane, 1/m2.
#[must_use]
pub fn value(distance: f64, h: f64) -> f64 {
    value_in::<2>(distance, h)
}

/// Kernel value in `D` dimensions, 1/m^D.
#[must_use]
pub fn value_in<const D: usize>(distance: f64, h: f64) -> f64 {
    let q = distance / h;
    let t = (2.0 - q).max(0.0);
    let u = (1.0 - q).max(0.0);
    (const { scale(D) }) / h.powi(D as i32) * (0.25 * t * t * t - u * u * u)
}

/// (dW/ddistance)/distance in the plane, 1/m4: times (x_a - x_b) it is the gradient at a. Finite at distance 0.
#[must_use]
pub fn gradient_factor(distance: f64, h: f64) -> f64 {
    gradient_factor_in::<2>(distance, h)
}

/// The same in `D` dimensions, 1/m^(D + 2).
#[must_use]
pub fn gradient_factor_in<const D: usize>(distance: f64, h: f64) -> f64 {
    let q = distance / h;
    let s = (const { scale(D) }) / h.powi(D as i32 + 2);
    if q < 1.0 {
        s * (2.25 * q - 3.0)
    } else if q < 2.0 {
        let t = 2.0 - q;
        -0.75 * s * t * t / q
    } else {
        0.0
    }
}

/// W R^(D + 3) and (dW/ddistance) R^(D + 3) of eight pairs with support radius R = 2h: with t = R - distance and u = R/2 - distance,
/// not below zero, these are 2^D scale (2 t^3 - 8 u^3) and 2^D scale (24 u^2 - 6 t^2). Exactly 0 from distance R on.
#[inline(always)]
pub fn times_support<S: Simd, const D: usize>(distance: S, support: S) -> [S; 2] {
    let scale = const { scale(D) * (1 << D) as f64 };
    let zero = S::splat(0.0);
    let t = (support - distance).max(zero);
    let u = support.mul_add(S::splat(0.5), -distance).max(zero);
    let (t2, u2) = (t * t, u * u);
    let value = (t2 * t).mul_add(S::splat(2.0 * scale), u2 * u * S::splat(-8.0 * scale));
    let slope = u2.mul_add(S::splat(24.0 * scale), t2 * S::splat(-6.0 * scale));
    [value, slope]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simd::{self, LANES, Task};

    /// Value and slope at eight q with h.
    struct Both<const D: usize>([f64; LANES], f64);

    impl<const D: usize> Task for Both<D> {
        type Output = [[f64; LANES]; 2];

        #[inline(always)]
        fn run<S: Simd>(self) -> Self::Output {
            let h = S::splat(self.1);
            times_support::<S, D>(S::load(&self.0) * h, h + h).map(S::store)
        }
    }

    fn lanes_agree<const D: usize>() {
        let q = [0.0, 0.3, 0.999, 1.0, 1.2, 1.9, 2.0, 2.5];
        let h: f64 = 0.75;
        let [values, slopes] = simd::run(Both::<D>(q, h));
        let power = (2.0 * h).powi(D as i32 + 3);
        for (k, q) in q.into_iter().enumerate() {
            let slope = q * h * gradient_factor_in::<D>(q * h, h);
            assert!((values[k] / power - value_in::<D>(q * h, h)).abs() < 1e-14);
            assert!((slopes[k] / power - slope).abs() < 1e-13);
        }
        assert_eq!([values[6], values[7], slopes[6], slopes[7]], [0.0; 4]);
    }

    #[test]
    fn lanes_agree_with_single_pairs() {
        lanes_agree::<2>();
        lanes_agree::<3>();
    }

    /// `shell` is the circumference or surface at a radius.
    fn integrates_to_one<const D: usize>(shell: fn(f64) -> f64) {
        let (h, n) = (0.7, 4000);
        let d = SUPPORT * h / f64::from(n);
        let sum: f64 = (0..n)
            .map(|i| (f64::from(i) + 0.5) * d)
            .map(|r| value_in::<D>(r, h) * shell(r) * d)
            .sum();
        assert!((sum - 1.0).abs() < 1e-6);
        for r in [0.01, 0.3, 0.69, 0.71, 1.2, 1.39, 1.5] {
            let e = 1e-6;
            let slope = (value_in::<D>(r + e, h) - value_in::<D>(r - e, h)) / (2.0 * e);
            assert!((slope - r * gradient_factor_in::<D>(r, h)).abs() < 1e-7);
        }
    }

    #[test]
    fn integrates_to_one_and_matches_its_gradient() {
        integrates_to_one::<2>(|r| 2.0 * PI * r);
        integrates_to_one::<3>(|r| 4.0 * PI * r * r);
    }
}
