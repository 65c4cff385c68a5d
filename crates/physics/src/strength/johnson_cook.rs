//! Johnson-Cook yield stress.
//!
//! sigma_y = (A + B eps_p^n) (1 + C ln max(1, rate/rate0)) (1 - T*^m)     (Joshi 2018, eqs 2.27, 6.15)
//! T* = (T - T0)/(Tm - T0), taken as 0 below T0 and 1 above Tm (no strength in the melt).
//!
//! Units: Pa, 1/s, K. Range: eps_p >= 0; a rate below the reference leaves the quasi-static curve (factor 1), the
//! logarithm is not extended to softening.

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

impl JohnsonCook {
    /// Yield stress, Pa, at a plastic strain, plastic strain rate (1/s) and temperature (K).
    #[must_use]
    pub fn yield_stress(&self, plastic_strain: f64, rate: f64, temperature: f64) -> f64 {
        (self.a + self.b * plastic_strain.powf(self.n))
            * self.rate_factor(rate)
            * self.thermal_factor(temperature)
    }

    /// Derivatives of the yield stress with plastic strain (Pa) and with plastic strain rate (Pa s).
    ///
    /// The first is infinite at zero plastic strain for n < 1. The second is zero below the reference rate.
    #[must_use]
    pub fn yield_slopes(&self, plastic_strain: f64, rate: f64, temperature: f64) -> (f64, f64) {
        let thermal = self.thermal_factor(temperature);
        if thermal == 0.0 {
            return (0.0, 0.0);
        }
        let hardening = if self.b == 0.0 {
            0.0
        } else {
            self.b * self.n * plastic_strain.powf(self.n - 1.0)
        };
        let by_rate = if rate > self.reference_rate {
            (self.a + self.b * plastic_strain.powf(self.n)) * self.c / rate
        } else {
            0.0
        };
        (
            hardening * self.rate_factor(rate) * thermal,
            by_rate * thermal,
        )
    }

    fn rate_factor(&self, rate: f64) -> f64 {
        if rate > self.reference_rate {
            1.0 + self.c * (rate / self.reference_rate).ln()
        } else {
            1.0
        }
    }

    fn thermal_factor(&self, temperature: f64) -> f64 {
        self.thermal.map_or(1.0, |t| t.factor(temperature))
    }
}

impl Thermal {
    /// 1 - T*^m, between 1 (at and below T0) and 0 (at and above Tm).
    #[must_use]
    pub fn factor(&self, temperature: f64) -> f64 {
        let t = (temperature - self.reference_temperature)
            / (self.melting_temperature - self.reference_temperature);
        1.0 - t.clamp(0.0, 1.0).powf(self.m)
    }

    /// Temperature rise (K) by plastic work per volume (J/m3) at a density (kg/m3).
    #[must_use]
    pub fn heating(&self, plastic_work: f64, density: f64) -> f64 {
        self.taylor_quinney * plastic_work / (density * self.heat_capacity)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAW: JohnsonCook = JohnsonCook {
        a: 508e6,
        b: 832e6,
        n: 0.29,
        c: 0.031,
        reference_rate: 4e-4,
        thermal: Some(Thermal {
            m: 1.03,
            reference_temperature: 293.0,
            melting_temperature: 1800.0,
            heat_capacity: 480.0,
            taylor_quinney: 0.9,
        }),
    };

    #[test]
    fn limits_of_each_factor() {
        let y = |e, rate, t| LAW.yield_stress(e, rate, t);
        assert_eq!(y(0.0, 0.0, 293.0), 508e6);
        assert!((y(1.0, 4e-4, 293.0) - 1340e6).abs() < 1e-3);
        assert_eq!(y(0.1, 1e-9, 293.0), y(0.1, 4e-4, 293.0));
        let e_fold = 4e-4 * std::f64::consts::E;
        assert!((y(0.0, e_fold, 293.0) / 508e6 - 1.031).abs() < 1e-12);
        assert_eq!(y(0.1, 1e3, 1800.0), 0.0);
        assert_eq!(y(0.1, 1e3, 2500.0), 0.0);
        assert_eq!(y(0.1, 1e3, 100.0), y(0.1, 1e3, 293.0));
    }

    #[test]
    fn slopes_are_the_derivatives() {
        for (e, rate, t) in [(0.01, 1e4, 300.0), (0.3, 5.0, 900.0), (0.002, 1e-5, 293.0)] {
            let (by_strain, by_rate) = LAW.yield_slopes(e, rate, t);
            let (d, r) = (1e-6 * e, 1e-6 * rate);
            let y = |e, rate| LAW.yield_stress(e, rate, t);
            let strain = (y(e + d, rate) - y(e - d, rate)) / (2.0 * d);
            let rates = (y(e, rate + r) - y(e, rate - r)) / (2.0 * r);
            assert!((by_strain / strain - 1.0).abs() < 1e-7);
            assert!((by_rate - rates).abs() <= 1e-6 * by_rate.abs());
        }
    }
}
