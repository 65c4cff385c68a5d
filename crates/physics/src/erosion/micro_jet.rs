//! Eulerian erosion model: micro-jets of vapour near a wall (Peters and el Moctar 2020, eqs 3.45 to 3.49).
//!
//! p'     = rho c dv                                                         water hammer                (3.45)
//! v_jet  = c_gamma sqrt((p - p_v)/rho)                                      speed of the jet            (3.46)
//! v_crit = sqrt(sigma_y/rho (1 - (1 + sigma_y/B)^(-1/n)))                   speed that makes it yield   (3.47, Lush 1983)
//! c_jet  = v_jet/v_crit                                                     intensity                   (3.48)
//!
//! Units SI. Range: p > p_v, else there is no jet; sigma_y > 0. The source does not define c_gamma, so it has no default.
//! (3.47) is the speed behind a shock of pressure sigma_y in a Tait liquid: p = rho U v, rho U = rho' (U - v).

use serde::{Deserialize, Serialize};

/// Parameters of the micro-jet model.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct MicroJetModel {
    /// c_gamma of (3.46), dimensionless.
    pub jet_coefficient: f64,
    /// Density of the liquid, kg/m3.
    pub density: f64,
    /// Vapour pressure, Pa.
    pub vapour_pressure: f64,
    /// Yield strength of the wall, Pa.
    pub yield_strength: f64,
    /// B of the Tait equation, Pa; 300 MPa in the source.
    pub tait_modulus: f64,
    /// n of the Tait equation; 7 in the source.
    pub tait_exponent: f64,
    /// Volume fraction of vapour near the wall from which a face is considered; 0.01 in the source.
    pub least_vapour: f64,
}

/// What a face sees in one time step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum JetImpact {
    /// Too little vapour near the face.
    NoVapour,
    /// The pressure does not exceed the vapour pressure: nothing drives a collapse.
    NoCollapse,
    /// A jet slower than the critical speed; its intensity below one.
    Harmless(f64),
    /// A jet that damages; intensity c_jet, at least one.
    Damaging(f64),
}

/// Pressure rise (Pa) when a liquid with density (kg/m3) and sound speed (m/s) is stopped from a speed (m/s).
#[must_use]
pub fn water_hammer(density: f64, sound_speed: f64, speed: f64) -> f64 {
    density * sound_speed * speed
}

/// Speed of the micro-jet, m/s; `None` where the pressure does not exceed the vapour pressure.
#[must_use]
pub fn micro_jet_speed(
    jet_coefficient: f64,
    pressure: f64,
    vapour_pressure: f64,
    density: f64,
) -> Option<f64> {
    let driving = pressure - vapour_pressure;
    (driving > 0.0).then(|| jet_coefficient * (driving / density).sqrt())
}

/// Speed (m/s) from which a jet makes the wall yield: yield strength and Tait modulus in Pa, density in kg/m3.
#[must_use]
pub fn critical_speed(
    yield_strength: f64,
    density: f64,
    tait_modulus: f64,
    tait_exponent: f64,
) -> f64 {
    // 1 - (1 + x)^(-1/n) without cancellation for small x.
    let compression = -((-(yield_strength / tait_modulus).ln_1p() / tait_exponent).exp_m1());
    (yield_strength / density * compression).sqrt()
}

impl MicroJetModel {
    /// Critical speed of the wall, m/s.
    #[must_use]
    pub fn critical_speed(&self) -> f64 {
        critical_speed(
            self.yield_strength,
            self.density,
            self.tait_modulus,
            self.tait_exponent,
        )
    }

    /// What a face sees where the pressure (Pa) and the volume fraction of vapour near it are these. Only damaging impacts
    /// enter the sums of (3.49).
    #[must_use]
    pub fn impact(&self, pressure: f64, vapour: f64) -> JetImpact {
        if vapour < self.least_vapour {
            return JetImpact::NoVapour;
        }
        let speed = micro_jet_speed(
            self.jet_coefficient,
            pressure,
            self.vapour_pressure,
            self.density,
        );
        match speed.map(|v| v / self.critical_speed()) {
            None => JetImpact::NoCollapse,
            Some(c) if c < 1.0 => JetImpact::Harmless(c),
            Some(c) => JetImpact::Damaging(c),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MODEL: MicroJetModel = MicroJetModel {
        jet_coefficient: 20.0,
        density: 1000.0,
        vapour_pressure: 2340.0,
        yield_strength: 4e8,
        tait_modulus: 3e8,
        tait_exponent: 7.0,
        least_vapour: 0.01,
    };

    /// The shock that (3.47) stands for: mass and momentum across it, density from Tait.
    #[test]
    fn critical_speed_is_a_tait_shock() {
        let v = MODEL.critical_speed();
        assert!((v - 213.545_069_402).abs() < 1e-8, "{v}");
        let compressed = 1000.0 * (1.0f64 + 4.0 / 3.0).powf(1.0 / 7.0);
        let shock = 4e8 / (1000.0 * v);
        assert!((compressed * (shock - v) / (1000.0 * shock) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn faces_are_told_apart() {
        assert_eq!(MODEL.impact(1e6, 0.0), JetImpact::NoVapour);
        assert_eq!(MODEL.impact(2000.0, 0.5), JetImpact::NoCollapse);
        assert!(matches!(MODEL.impact(1e4, 0.5), JetImpact::Harmless(c) if c < 1.0));
        assert!(matches!(MODEL.impact(1e6, 0.5), JetImpact::Damaging(c) if c > 1.0));
    }
}
