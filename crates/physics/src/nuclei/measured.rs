//! The measured distribution of nuclei of a cavitating jet (Peters and el Moctar 2020, eqs 3.43 and 3.44, after Reuter 2018).
//!
//! F = (exp(-R/x1) + x3/sqrt(2 pi x2^2) exp(-R^2/(2 x2^2)))/x4     R > 2.2 um
//! F = (a1 R^2 + a2 R)/a3                                          R <= 2.2 um
//!
//! R in um, F in 1/um. As printed it integrates to 0.375789; here it is divided by that. The upper part is measured, the
//! lower part a guess of the source. Range: R > 0; the tail is exponential and has no upper limit.

use std::f64::consts::{FRAC_1_SQRT_2, PI};

const X1: f64 = 1.28;
const X2: f64 = 0.54;
const X3: f64 = 0.0838;
const X4: f64 = 1.328_005_544;
const A1: f64 = -0.008_835_77;
const A2: f64 = 0.037_110_25;
const A3: f64 = 0.287_940_7;
/// Radius at which both parts meet, um.
const JOINT: f64 = 2.2;

/// Integral of the distribution with its printed constants.
pub const PRINTED_INTEGRAL: f64 = 0.375_788_784_751_7;

const MICRO: f64 = 1e-6;

/// Tail integrals of R^k F from R to infinity for k = 0, 1, 2 (R in um, above the joint).
fn tail(r: f64) -> [f64; 3] {
    let decay = (-r / X1).exp();
    let bell = X3 / (2.0 * PI * X2 * X2).sqrt() * (-0.5 * (r / X2).powi(2)).exp();
    let half = 0.5 * X3 * libm::erfc(r / X2 * FRAC_1_SQRT_2);
    let square = X2 * X2;
    [
        (X1 * decay + half) / X4,
        (X1 * (r + X1) * decay + square * bell) / X4,
        (X1 * (r * r + 2.0 * X1 * r + 2.0 * X1 * X1) * decay + square * (r * bell + half)) / X4,
    ]
}

/// Integrals of R^k F from 0 to R for k = 0, 1, 2 (R in um, below the joint).
fn head(r: f64) -> [f64; 3] {
    let integral = |k: i32| {
        let term = |a: f64, power: i32| a * r.powi(power + 1) / f64::from(power + 1);
        (term(A1, 2 + k) + term(A2, 1 + k)) / A3
    };
    [integral(0), integral(1), integral(2)]
}

fn moment(k: usize) -> f64 {
    (head(JOINT)[k] + tail(JOINT)[k]) / (head(JOINT)[0] + tail(JOINT)[0])
}

/// Density of probability, 1/m, with the printed constants (does not integrate to one).
pub(super) fn printed_density(radius: f64) -> f64 {
    let r = radius / MICRO;
    let value = if r <= 0.0 {
        0.0
    } else if radius <= JOINT * MICRO {
        (A1 * r * r + A2 * r) / A3
    } else {
        let bell = X3 / (2.0 * PI * X2 * X2).sqrt() * (-0.5 * (r / X2).powi(2)).exp();
        ((-r / X1).exp() + bell) / X4
    };
    value / MICRO
}

/// Density of probability, 1/m.
pub(super) fn density(radius: f64) -> f64 {
    printed_density(radius) / PRINTED_INTEGRAL
}

/// Probability of a smaller radius.
pub(super) fn cumulative(radius: f64) -> f64 {
    let r = radius / MICRO;
    if r <= 0.0 {
        0.0
    } else if radius <= JOINT * MICRO {
        head(r)[0] / PRINTED_INTEGRAL
    } else {
        1.0 - tail(r)[0] / PRINTED_INTEGRAL
    }
}

/// Mean radius, m.
pub(super) fn mean() -> f64 {
    moment(1) * MICRO
}

/// Standard deviation, m.
pub(super) fn standard_deviation() -> f64 {
    (moment(2) - moment(1).powi(2)).sqrt() * MICRO
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn constant_of_normalisation_is_the_integral() {
        let integral = head(JOINT)[0] + tail(JOINT)[0];
        assert!((integral / PRINTED_INTEGRAL - 1.0).abs() < 1e-12);
        assert!((head(JOINT)[0] - 0.202_978).abs() < 1e-6);
    }

    /// Values found by quadrature elsewhere: 2.339379, 1.420093 um, and 0.540139 below 2.2 um.
    #[test]
    fn moments() {
        assert!((mean() / 2.339_379e-6 - 1.0).abs() < 1e-6);
        assert!((standard_deviation() / 1.420_093e-6 - 1.0).abs() < 1e-6);
        assert!((cumulative(2.2e-6) - 0.540_139).abs() < 1e-6);
    }

    #[test]
    fn density_is_the_slope_of_the_cumulative() {
        for r in [0.3e-6, 1.7e-6, 2.5e-6, 6e-6] {
            let d = 1e-10;
            let slope = (cumulative(r + d) - cumulative(r - d)) / (2.0 * d);
            assert!((slope / density(r) - 1.0).abs() < 1e-6, "{r}");
        }
    }
}
