//! Johnson-Cook yield stress.
//!
//! sigma_y = (A + B eps_p^n) (1 + C ln max(1, rate/rate0)) (1 - T*^m)     (Joshi 2018, eqs 2.27, 6.15)

use serde::{Deserialize, Serialize};

/// Constants of the Johnson-Cook law.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct JohnsonCook {
    /// A, yield stress at zero plastic strain, Pa.
    pub a: f64,
    /// B, hardening, Pa.
    pub b: f64,
    /// n, hardening exponent.
    pub n: f64,
    /// C, rate coefficient.
    pub c: f64,
    /// Reference plastic strain rate, 1/s.
    pub reference_rate: f64,
    /// Thermal softening, off when absent.
    pub thermal: Option<Thermal>,
}

/// Thermal softening 1 - ((T - T0)/(Tm - T0))^m and heating by plastic work.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Thermal {
    /// m, softening exponent.
    pub m: f64,
    /// T0, reference temperature, K.
    pub reference_temperature: f64,
    /// Tm, melting temperature, K.
    pub melting_temperature: f64,
    /// Specific heat capacity, J/(kg K).
    pub heat_capacity: f64,
    /// Taylor-Quinney factor: share of plastic work that heats.
    pub taylor_quinney: f64,
}
