//! Yield strength of metals.

use serde::{Deserialize, Serialize};

mod johnson_cook;
pub use johnson_cook::{JohnsonCook, Thermal};

/// The strength law of a solid, as data (closed set chosen by the case file).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Strength {
    /// Never yields.
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
