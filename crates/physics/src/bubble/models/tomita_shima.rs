//! Tomita-Shima with a wall that the liquid follows with e R'.
//!
//! (p_L - p)/(e rho) + R d(p_L - p)/dt/(e rho c)
//!     = R R'' (1 - (1 + e) M) + 3/2 R'^2 ((4 - e)/3 - 4 M/3),  M = R'/c
//! p_L = p_v + p_g - 2 sigma/R - 4 e mu R'/R
//!
//! Source: Tomita and Shima 1977, Mathew, Keith and Nikolaidis 2006; Peters and el Moctar 2020, eqs 3.37 to 3.40.
//! Corrected: p_v added in 3.39; in varying pressure the rate is that of p_L - p, not of p_L alone. R'' in dp_L/dt is
//! collected on the left. Range: (1 + e) M < 1; good below 0.3. e = 1 is Herring-Trilling.

use super::solved;
use crate::bubble::model::WallPressure;
use crate::bubble::{Ambient, BubbleModel, Gas, Liquid, Wall};
use serde::{Deserialize, Serialize};

/// Tomita-Shima.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct TomitaShima {
    /// e = 1 - rho_b/rho_c (eq. 3.38), dimensionless.
    pub density_factor: f64,
}

impl Default for TomitaShima {
    /// The value of eq. 3.38.
    fn default() -> Self {
        Self {
            density_factor: 0.99881,
        }
    }
}

impl BubbleModel for TomitaShima {
    fn name(&self) -> &'static str {
        "tomita_shima"
    }

    #[inline]
    fn acceleration(&self, liquid: &Liquid, gas: &Gas, wall: &Wall, ambient: &Ambient) -> f64 {
        let e = self.density_factor;
        let at_wall = WallPressure::new(liquid, gas, wall, e);
        let over = 1.0 / (e * liquid.density);
        let mach = wall.velocity / liquid.sound_speed;
        let push = (at_wall.value - ambient.mean_pressure(liquid.density)) * over;
        let delay = wall.radius * over / liquid.sound_speed;
        let push_rate = at_wall.rate - ambient.mean_pressure_rate(liquid.density);
        let inertia = 0.5 * wall.velocity * wall.velocity * (4.0 - e - 4.0 * mach);
        solved(
            push + delay * push_rate - inertia,
            wall.radius * (1.0 - (1.0 + e) * mach) + delay * at_wall.inertia,
        )
    }
}
