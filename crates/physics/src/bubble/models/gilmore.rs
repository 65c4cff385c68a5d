//! Gilmore: compressible, with enthalpy and sound speed of the liquid at the wall.
//!
//! (1 - M) R R'' + 3/2 R'^2 (1 - M/3) = H (1 + M) + R/C (1 - M) H',  M = R'/C
//! H = integral of dp/rho from p to p_L,  C sound speed at p_L,  H' = p_L'/rho(p_L) - p'/rho(p)
//! Tait: (p + B)/(p0 + B) = (rho/rho0)^n,  B = rho0 c0^2/n - p0
//!
//! Source: Gilmore 1952 (Caltech report 26-4). H' holds R'', which is collected on the left. Range: M < 1 and
//! p, p_L > -B (not a number outside).

use super::solved;
use crate::bubble::model::WallPressure;
use crate::bubble::{Ambient, BubbleModel, Gas, Liquid, Wall};
use serde::{Deserialize, Serialize};

/// Gilmore with Tait's equation of state through density and sound speed of [`Liquid`] at the reference pressure.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Gilmore {
    /// n, dimensionless; above 1.
    pub tait_exponent: f64,
    /// Pressure p0 at which the liquid has its density and sound speed, Pa.
    pub reference_pressure: f64,
}

impl Default for Gilmore {
    /// Water.
    fn default() -> Self {
        Self {
            tait_exponent: 7.0,
            reference_pressure: 1e5,
        }
    }
}

impl BubbleModel for Gilmore {
    fn name(&self) -> &'static str {
        "gilmore"
    }

    #[inline]
    fn acceleration(&self, liquid: &Liquid, gas: &Gas, wall: &Wall, ambient: &Ambient) -> f64 {
        let at_wall = WallPressure::new(liquid, gas, wall, 1.0);
        let n = self.tait_exponent;
        let stiffness = liquid.density * liquid.sound_speed * liquid.sound_speed / n; // p0 + B
        let far = self.compressed(stiffness, ambient.mean_pressure(liquid.density));
        let near = self.compressed(stiffness, at_wall.value);
        let rho_near = liquid.density * near.density;
        let rho_far = liquid.density * far.density;
        let unit = n / (n - 1.0) * stiffness / liquid.density;
        let enthalpy = unit * (near.enthalpy - far.enthalpy);
        let sound = liquid.sound_speed * (1.0 + near.enthalpy).sqrt();
        let mach = wall.velocity / sound;
        let delay = wall.radius / sound * (1.0 - mach);
        let enthalpy_rate =
            at_wall.rate / rho_near - ambient.mean_pressure_rate(liquid.density) / rho_far;
        let inertia = 1.5 * wall.velocity * wall.velocity * (1.0 - mach / 3.0);
        solved(
            (1.0 + mach) * enthalpy + delay * enthalpy_rate - inertia,
            (1.0 - mach) * wall.radius + delay * at_wall.inertia / rho_near,
        )
    }
}

/// Liquid at a pressure relative to the liquid at the reference pressure.
struct Compressed {
    /// rho/rho0.
    density: f64,
    /// Enthalpy above that at p0 over n/(n - 1) (p0 + B)/rho0; one more is (C/c0)^2.
    enthalpy: f64,
}

impl Gilmore {
    /// With x = (p - p0)/(p0 + B): the enthalpy is (1 + x)^((n - 1)/n) - 1, free of cancellation for small x.
    #[inline]
    fn compressed(&self, stiffness: f64, pressure: f64) -> Compressed {
        let x = (pressure - self.reference_pressure) / stiffness;
        let exponent = 1.0 - 1.0 / self.tait_exponent;
        let enthalpy = (exponent * x.ln_1p()).exp_m1();
        Compressed {
            density: (1.0 + x) / (1.0 + enthalpy),
            enthalpy,
        }
    }
}
