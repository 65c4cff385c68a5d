//! Rayleigh-Plesset: incompressible liquid.
//!
//! R R'' + 3/2 R'^2 = (p_L - p)/rho + slip^2/4,  p_L = p_v + p_g - 2 sigma/R - 4 mu R'/R
//!
//! (Peters and el Moctar 2020, eq. 3.36, as printed.) Range: |R'| well below the sound speed.

use crate::bubble::model::WallPressure;
use crate::bubble::{Ambient, BubbleModel, Gas, Liquid, Wall};
use serde::{Deserialize, Serialize};

/// Rayleigh-Plesset.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct RayleighPlesset;

impl BubbleModel for RayleighPlesset {
    fn name(&self) -> &'static str {
        "rayleigh_plesset"
    }

    #[inline]
    fn acceleration(&self, liquid: &Liquid, gas: &Gas, wall: &Wall, ambient: &Ambient) -> f64 {
        let at_wall = WallPressure::new(liquid, gas, wall, 1.0);
        let push = at_wall.value - ambient.mean_pressure(liquid.density);
        (push / liquid.density - 1.5 * wall.velocity * wall.velocity) / wall.radius
    }
}
