//! Distributions of the equilibrium radii of nuclei.
//!
//! lognormal: ln(R/median) is normal with standard deviation s:  mean = median exp(s^2/2)
//! Rayleigh:  F = R/a^2 exp(-R^2/(2 a^2)), a the mode:           mean = a sqrt(pi/2)
//!
//! Samples invert the distribution function: one random number, one nucleus.

use super::invert::invert;
use super::measured;
use super::stream::Stream;
use serde::{Deserialize, Serialize};
use std::f64::consts::{PI, SQRT_2};
use thiserror::Error;

/// A distribution of radii; lengths in m.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum NucleiDistribution {
    /// All alike.
    Constant {
        /// Radius, m.
        radius: f64,
    },
    /// Measured in a cavitating jet (eq. 3.44, normalised).
    Measured,
    /// Normal in the logarithm.
    Lognormal {
        /// Median, m.
        median: f64,
        /// Standard deviation of the logarithm, dimensionless.
        deviation: f64,
    },
    /// Rayleigh's.
    Rayleigh {
        /// Most frequent radius, m.
        mode: f64,
    },
}

/// A parameter that makes no distribution.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("the {parameter} of the nuclei is {value}, but it must be positive and finite")]
pub struct NucleiError {
    /// Which parameter.
    pub parameter: &'static str,
    /// What was given.
    pub value: f64,
}

impl NucleiDistribution {
    /// The same if its parameters are positive and finite.
    ///
    /// # Errors
    /// Names the first parameter that is not.
    pub fn checked(self) -> Result<Self, NucleiError> {
        let parameters: &[(&'static str, f64)] = match self {
            Self::Constant { radius } => &[("radius", radius)],
            Self::Measured => &[],
            Self::Lognormal { median, deviation } => {
                &[("median", median), ("deviation", deviation)]
            }
            Self::Rayleigh { mode } => &[("mode", mode)],
        };
        let bad = |&&(_, value): &&(_, f64)| !(value > 0.0 && value.is_finite());
        match parameters.iter().find(bad) {
            Some(&(parameter, value)) => Err(NucleiError { parameter, value }),
            None => Ok(self),
        }
    }

    /// Density of probability, 1/m; `None` for the constant, whose probability sits in one point.
    #[must_use]
    pub fn density(&self, radius: f64) -> Option<f64> {
        if radius <= 0.0 {
            return (!matches!(self, Self::Constant { .. })).then_some(0.0);
        }
        match *self {
            Self::Constant { .. } => None,
            Self::Measured => Some(measured::density(radius)),
            Self::Lognormal { median, deviation } => {
                let z = (radius / median).ln() / deviation;
                Some((-0.5 * z * z).exp() / (radius * deviation * (2.0 * PI).sqrt()))
            }
            Self::Rayleigh { mode } => {
                let z = radius / mode;
                Some(z / mode * (-0.5 * z * z).exp())
            }
        }
    }

    /// Probability of a radius of at most `radius`.
    #[must_use]
    pub fn cumulative(&self, radius: f64) -> f64 {
        if radius <= 0.0 {
            return 0.0;
        }
        match *self {
            Self::Constant { radius: all } => f64::from(u8::from(radius >= all)),
            Self::Measured => measured::cumulative(radius),
            Self::Lognormal { median, deviation } => {
                0.5 * libm::erfc(-(radius / median).ln() / (deviation * SQRT_2))
            }
            Self::Rayleigh { mode } => -(-0.5 * (radius / mode).powi(2)).exp_m1(),
        }
    }

    /// Radius (m) that a share `probability` (between 0 and 1, both excluded) does not exceed.
    #[must_use]
    pub fn quantile(&self, probability: f64) -> f64 {
        match *self {
            Self::Constant { radius } => radius,
            Self::Measured => {
                let slope = |r: f64| measured::density(r);
                invert(measured::cumulative, slope, (0.0, 1e-4), probability)
            }
            Self::Lognormal { median, deviation } => {
                let normal = |z: f64| 0.5 * libm::erfc(-z / SQRT_2);
                let slope = |z: f64| (-0.5 * z * z).exp() / (2.0 * PI).sqrt();
                median * (deviation * invert(normal, slope, (-40.0, 40.0), probability)).exp()
            }
            Self::Rayleigh { mode } => mode * (-2.0 * (-probability).ln_1p()).sqrt(),
        }
    }

    /// The nucleus at a place of a stream, m.
    #[must_use]
    pub fn sample(&self, stream: Stream, place: u64) -> f64 {
        self.quantile(stream.uniform(place))
    }

    /// Mean radius, m.
    #[must_use]
    pub fn mean(&self) -> f64 {
        match *self {
            Self::Constant { radius } => radius,
            Self::Measured => measured::mean(),
            Self::Lognormal { median, deviation } => median * (0.5 * deviation * deviation).exp(),
            Self::Rayleigh { mode } => mode * (0.5 * PI).sqrt(),
        }
    }

    /// Standard deviation of the radius, m.
    #[must_use]
    pub fn standard_deviation(&self) -> f64 {
        match *self {
            Self::Constant { .. } => 0.0,
            Self::Measured => measured::standard_deviation(),
            Self::Lognormal { deviation, .. } => {
                self.mean() * (deviation * deviation).exp_m1().sqrt()
            }
            Self::Rayleigh { mode } => mode * (2.0 - 0.5 * PI).sqrt(),
        }
    }
}

/// The measured distribution as printed: integrates to [`super::PRINTED_INTEGRAL`], for comparison with the source only.
#[must_use]
pub fn measured_as_printed(radius: f64) -> f64 {
    measured::printed_density(radius)
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: [NucleiDistribution; 3] = [
        NucleiDistribution::Measured,
        NucleiDistribution::Lognormal {
            median: 3e-6,
            deviation: 0.5,
        },
        NucleiDistribution::Rayleigh { mode: 2e-6 },
    ];

    #[test]
    fn quantile_inverts_the_cumulative_far_into_the_tails() {
        for d in ALL {
            for p in [1e-12, 1e-6, 0.01, 0.3, 0.54, 0.9, 1.0 - 1e-9] {
                let miss = d.cumulative(d.quantile(p)) - p;
                assert!(miss.abs() < 1e-14 + 1e-9 * p, "{d:?} {p} {miss}");
            }
        }
    }

    /// Mean and variance of samples within five standard errors of the exact moments.
    #[test]
    fn samples_have_the_moments() {
        let n = 200_000;
        for d in ALL {
            let stream = Stream { seed: 42 };
            let sample: Vec<f64> = (0..n).map(|k| d.sample(stream, k)).collect();
            let count = n as f64;
            let mean = sample.iter().sum::<f64>() / count;
            let central = |k| sample.iter().map(|r| (r - mean).powi(k)).sum::<f64>() / count;
            let (variance, fourth) = (central(2), central(4));
            let s = d.standard_deviation();
            assert!((mean - d.mean()).abs() < 5.0 * s / count.sqrt(), "{d:?}");
            let error = ((fourth - variance * variance) / count).sqrt();
            assert!((variance - s * s).abs() < 5.0 * error, "{d:?}");
        }
    }

    #[test]
    fn median_of_the_measured_distribution() {
        let median = NucleiDistribution::Measured.quantile(0.5);
        assert!((median / 2.088_461e-6 - 1.0).abs() < 1e-6);
    }

    #[test]
    fn bad_parameters_are_named() {
        let bad = NucleiDistribution::Rayleigh { mode: -1e-6 };
        assert!(bad.checked().unwrap_err().to_string().contains("mode"));
        assert!(NucleiDistribution::Measured.checked().is_ok());
    }
}
