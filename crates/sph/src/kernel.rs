//! Cubic spline kernel in two dimensions.
//!
//! W = 10/(7 pi h^2) (1 - 3/2 q^2 + 3/4 q^3) for q < 1, 10/(7 pi h^2) (2 - q)^3/4 for q < 2, q = distance/h.
//! (Joshi 2018, eq. 2.38, with the constant of Monaghan's cubic spline: see docs/equations.md.)

use std::f64::consts::PI;

/// Support radius in units of h.
pub const SUPPORT: f64 = 2.0;

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

#[cfg(test)]
mod tests {
    use super::*;

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
