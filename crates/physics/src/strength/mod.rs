//! Yield strength of metals.

use serde::{Deserialize, Serialize};

mod johnson_cook;
pub use johnson_cook::{JohnsonCook, Thermal};

/// The strength law of a solid, as data (closed set chosen by the case file).
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Strength {
    /// Never yields.
    #[default]
    Elastic,
    /// Constant yield stress, Pa.
    PerfectlyPlastic {
        /// Yield stress, Pa.
        yield_stress: f64,
    },
    /// Yield stress growing linearly with plastic strain.
    LinearHardening {
        /// Yield stress at zero plastic strain, Pa.
        yield_stress: f64,
        /// d(yield stress)/d(plastic strain), Pa.
        hardening_modulus: f64,
    },
    /// Johnson-Cook.
    JohnsonCook(JohnsonCook),
}

impl Strength {
    /// Yield stress, Pa (infinite for [`Strength::Elastic`]), at a plastic strain, plastic strain rate (1/s) and
    /// temperature (K).
    #[must_use]
    pub fn yield_stress(&self, plastic_strain: f64, rate: f64, temperature: f64) -> f64 {
        match *self {
            Self::Elastic => f64::INFINITY,
            Self::PerfectlyPlastic { yield_stress } => yield_stress,
            Self::LinearHardening {
                yield_stress,
                hardening_modulus,
            } => yield_stress + hardening_modulus * plastic_strain,
            Self::JohnsonCook(law) => law.yield_stress(plastic_strain, rate, temperature),
        }
    }

    /// Derivatives of the yield stress with plastic strain (Pa) and with plastic strain rate (Pa s).
    #[must_use]
    pub fn yield_slopes(&self, plastic_strain: f64, rate: f64, temperature: f64) -> (f64, f64) {
        match *self {
            Self::Elastic | Self::PerfectlyPlastic { .. } => (0.0, 0.0),
            Self::LinearHardening {
                hardening_modulus, ..
            } => (hardening_modulus, 0.0),
            Self::JohnsonCook(law) => law.yield_slopes(plastic_strain, rate, temperature),
        }
    }

    /// Thermal softening and heating, where the law has them.
    #[must_use]
    pub fn thermal(&self) -> Option<Thermal> {
        match self {
            Self::JohnsonCook(law) => law.thermal,
            _ => None,
        }
    }
}
