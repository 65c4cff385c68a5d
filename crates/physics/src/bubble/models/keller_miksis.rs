//! Keller-Miksis: compressible to first order in the Mach number M = R'/c.
//!
//! (1 - M) R R'' + 3/2 R'^2 (1 - M/3) = (1 + M) (p_L - p)/rho + R/(rho c) d(p_L - p)/dt
//!
//! Source: Keller and Miksis, J. Acoust. Soc. Am. 68 (1980) 628, in the form with p_L of eq. 3.39 of Peters and
//! el Moctar 2020. dp_L/dt holds R'', which is collected on the left. Range: M < 1; good below 0.3.

use super::solved;
use crate::bubble::model::WallPressure;
use crate::bubble::{Ambient, BubbleModel, Gas, Liquid, Wall};
use serde::{Deserialize, Serialize};

/// Keller-Miksis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct KellerMiksis;

impl BubbleModel for KellerMiksis {
    fn name(&self) -> &'static str {
        "keller_miksis"
    }

    #[inline]
    fn acceleration(&self, liquid: &Liquid, gas: &Gas, wall: &Wall, ambient: &Ambient) -> f64 {
        let at_wall = WallPressure::new(liquid, gas, wall, 1.0);
        let over_rho = 1.0 / liquid.density;
        let mach = wall.velocity / liquid.sound_speed;
        let push = (at_wall.value - ambient.mean_pressure(liquid.density)) * over_rho;
        let delay = wall.radius * over_rho / liquid.sound_speed;
        let push_rate = at_wall.rate - ambient.mean_pressure_rate(liquid.density);
        let inertia = 1.5 * wall.velocity * wall.velocity * (1.0 - mach / 3.0);
        solved(
            (1.0 + mach) * push + delay * push_rate - inertia,
            (1.0 - mach) * wall.radius + delay * at_wall.inertia,
        )
    }
}
