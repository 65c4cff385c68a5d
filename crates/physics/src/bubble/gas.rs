//! The permanent gas in a bubble.
//!
//! p_g = p_g0 (R0/R)^(3 k)      (Peters and el Moctar 2020, text after eq. 3.36; k polytropic exponent: 1 isothermal,
//! 4/3 or 1.4 adiabatic)
//!
//! Energy given by the gas as it expands from R0: p_g0 V0 - p_g V over k - 1, or p_g0 V0 ln(V/V0) for k = 1.
//! Units: Pa, m. Range: R > 0; no van der Waals core.

use super::error::{BubbleError, positive};
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// Permanent gas: its pressure at a reference radius.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Gas {
    /// Pressure at the reference radius, Pa; zero for a bubble of vapour alone.
    pub pressure: f64,
    /// Reference radius R0, m.
    pub radius: f64,
    /// Polytropic exponent k, dimensionless.
    pub polytropic_exponent: f64,
}

impl Gas {
    /// Checks the ranges.
    ///
    /// # Errors
    /// [`BubbleError::OutOfRange`] naming the quantity.
    pub fn check(&self) -> Result<(), BubbleError> {
        positive("gas_pressure", "Pa", self.pressure, true)?;
        positive("radius", "m", self.radius, false)?;
        if self.polytropic_exponent >= 1.0 && self.polytropic_exponent <= 5.0 / 3.0 {
            return Ok(());
        }
        Err(BubbleError::OutOfRange {
            quantity: "polytropic_exponent",
            value: self.polytropic_exponent,
            unit: "-",
            allowed: "between 1 (isothermal) and 5/3",
        })
    }

    /// Pressure of the gas, Pa, at a radius, m.
    #[must_use]
    #[inline]
    pub fn pressure_at(&self, radius: f64) -> f64 {
        let x = self.radius / radius;
        let exponent = 3.0 * self.polytropic_exponent;
        if exponent == 4.0 {
            let x2 = x * x;
            return self.pressure * (x2 * x2); // the common case, without a power function
        }
        self.pressure * x.powf(exponent)
    }

    /// dp_g/dR, Pa/m, from the pressure at that radius.
    #[must_use]
    #[inline]
    pub fn slope(&self, radius: f64, pressure: f64) -> f64 {
        -3.0 * self.polytropic_exponent * pressure / radius
    }

    /// Energy stored in the gas, J, relative to the reference radius: minus the work it gave by growing from there.
    #[must_use]
    pub fn energy(&self, radius: f64) -> f64 {
        let volume = 4.0 / 3.0 * PI * self.radius.powi(3);
        let k = self.polytropic_exponent;
        let x = self.radius / radius;
        if k == 1.0 {
            return 3.0 * self.pressure * volume * x.ln();
        }
        self.pressure * volume * (3.0 * (k - 1.0) * x.ln()).exp_m1() / (k - 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_energy_falls_by_the_work_of_the_gas() {
        for k in [1.0, 4.0 / 3.0, 1.4] {
            let gas = Gas {
                pressure: 1e5,
                radius: 1e-5,
                polytropic_exponent: k,
            };
            for radius in [2e-6, 1e-5, 4e-5] {
                let d = 1e-5 * radius;
                let slope = (gas.energy(radius + d) - gas.energy(radius - d)) / (2.0 * d);
                let work = -gas.pressure_at(radius) * 4.0 * PI * radius * radius;
                assert!((slope / work - 1.0).abs() < 1e-7, "k {k} at {radius}");
                let p = gas.pressure_at(radius);
                let dp = (gas.pressure_at(radius + d) - gas.pressure_at(radius - d)) / (2.0 * d);
                assert!((gas.slope(radius, p) / dp - 1.0).abs() < 1e-7);
            }
        }
    }

    #[test]
    fn bad_gas_is_refused() {
        let good = Gas {
            pressure: 0.0,
            radius: 1e-6,
            polytropic_exponent: 1.4,
        };
        assert!(good.check().is_ok());
        for bad in [
            Gas {
                pressure: -1.0,
                ..good
            },
            Gas {
                radius: 0.0,
                ..good
            },
            Gas {
                polytropic_exponent: 0.9,
                ..good
            },
            Gas {
                polytropic_exponent: f64::NAN,
                ..good
            },
        ] {
            assert!(matches!(bad.check(), Err(BubbleError::OutOfRange { .. })));
        }
    }
}
