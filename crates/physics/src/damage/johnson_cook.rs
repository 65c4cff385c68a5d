//! Johnson-Cook damage.
//!
//! D = sum of d eps_p/eps_f,  eps_f = (D1 + D2 exp(D3 sigma*)) (1 + D4 ln max(1, rate/rate0)) (1 + D5 T*)
//! sigma* = mean stress/von Mises stress (tension positive), T* = (T - T0)/(Tm - T0) in [0, 1]
//! (Johnson and Cook, Engineering Fracture Mechanics 21 (1985) 31.)
//!
//! Units: 1/s, K, otherwise plain numbers. D3 is negative for metals: tension makes brittle (some codes write exp(-D3 sigma*)).
//! Range: sigma* up to 1.5 in the source; beyond it spalls, which this law does not hold, and the formula is used as it
//! stands. Where eps_f is not positive (D1 < 0, high tension) any plastic strain fails.

use super::PlasticStep;
use serde::{Deserialize, Serialize};

/// Constants of Johnson-Cook damage.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct JohnsonCookDamage {
    /// D1.
    pub d1: f64,
    /// D2.
    pub d2: f64,
    /// D3, exponent of triaxiality.
    pub d3: f64,
    /// D4, rate coefficient.
    pub d4: f64,
    /// D5, temperature coefficient.
    pub d5: f64,
    /// Reference plastic strain rate, 1/s.
    pub reference_rate: f64,
    /// T0 and Tm, K; absent when D5 is not used.
    pub temperatures: Option<[f64; 2]>,
}

impl JohnsonCookDamage {
    /// Plastic strain at failure under constant conditions; may be negative (see the range).
    #[must_use]
    pub fn failure_strain(&self, step: PlasticStep) -> f64 {
        let rate = (step.rate / self.reference_rate).max(1.0);
        let heat = self.temperatures.map_or(0.0, |[t0, tm]| {
            ((step.temperature - t0) / (tm - t0)).clamp(0.0, 1.0)
        });
        (self.d1 + self.d2 * (self.d3 * step.triaxiality).exp())
            * (1.0 + self.d4 * rate.ln())
            * (1.0 + self.d5 * heat)
    }

    pub(super) fn growth(&self, step: PlasticStep) -> f64 {
        let strain = self.failure_strain(step);
        if strain > 0.0 {
            step.increment / strain
        } else {
            1.0
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::damage::Damage;

    /// OFHC copper.
    const COPPER: JohnsonCookDamage = JohnsonCookDamage {
        d1: 0.54,
        d2: 4.89,
        d3: -3.03,
        d4: 0.014,
        d5: 1.12,
        reference_rate: 1.0,
        temperatures: Some([298.0, 1356.0]),
    };

    fn step(triaxiality: f64, rate: f64, temperature: f64) -> PlasticStep {
        PlasticStep {
            increment: 0.1,
            rate,
            triaxiality,
            temperature,
        }
    }

    #[test]
    fn limits_of_each_factor() {
        let strain = |s, r, t| COPPER.failure_strain(step(s, r, t));
        assert!((strain(0.0, 1.0, 298.0) - 5.43).abs() < 1e-12);
        // A tensile bar: 0.54 + 4.89 exp(-1.01) = 2.3210.
        assert!((strain(1.0 / 3.0, 0.1, 200.0) - 2.3210).abs() < 1e-4);
        assert!((strain(0.0, std::f64::consts::E, 298.0) / 5.43 - 1.014).abs() < 1e-12);
        assert!((strain(0.0, 1.0, 1356.0) / 5.43 - 2.12).abs() < 1e-12);
        assert_eq!(strain(0.0, 1.0, 2000.0), strain(0.0, 1.0, 1356.0));
        assert!(strain(1.5, 1.0, 298.0) < strain(0.5, 1.0, 298.0));
    }

    #[test]
    fn shares_of_a_changing_path_add_up() {
        let law = Damage::JohnsonCook(COPPER);
        let (a, b) = (step(0.0, 1.0, 298.0), step(1.0, 1.0, 298.0));
        let damage = law.after(law.after(0.0, a), b);
        let expected = 0.1 / 5.43 + 0.1 / COPPER.failure_strain(b);
        assert!((damage - expected).abs() < 1e-15);
        assert_eq!(law.integrity(damage), 1.0);
    }

    #[test]
    fn no_strain_is_left_where_the_formula_turns_negative() {
        let law = JohnsonCookDamage {
            d1: -0.77,
            d2: 1.45,
            d3: -0.47,
            ..COPPER
        };
        let tension = step(3.0, 1.0, 298.0);
        assert!(law.failure_strain(tension) < 0.0);
        assert!(Damage::JohnsonCook(law).after(0.0, tension) >= 1.0);
    }
}
