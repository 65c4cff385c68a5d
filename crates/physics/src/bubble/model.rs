//! The law of a bubble's wall.

use super::{Ambient, Gas, Liquid};
use serde::{Deserialize, Serialize};

/// Which way the wall moves. A model that switches laws reads it; it changes only at an extreme radius.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Phase {
    /// Towards larger radii.
    #[default]
    Growth,
    /// Towards smaller radii.
    Collapse,
}

/// State of the wall.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wall {
    /// Radius R, m.
    pub radius: f64,
    /// dR/dt, m/s.
    pub velocity: f64,
    /// The law in force, for models that switch.
    pub phase: Phase,
}

/// A law of the radius of a spherical bubble.
pub trait BubbleModel: Send + Sync {
    /// Name as in case files and reports.
    fn name(&self) -> &'static str;

    /// d2R/dt2, m/s2. Not finite where the model has no answer (a wall faster than the sound); never panics.
    fn acceleration(&self, liquid: &Liquid, gas: &Gas, wall: &Wall, ambient: &Ambient) -> f64;

    /// Whether the law depends on [`Wall::phase`], so that its acceleration jumps where the wall rests.
    fn switches(&self) -> bool {
        false
    }
}

/// Pressure of vapour and gas in the bubble, Pa: p_b = p_v + p_g.
#[must_use]
#[inline]
pub fn bubble_pressure(liquid: &Liquid, gas: &Gas, radius: f64) -> f64 {
    liquid.vapour_pressure + gas.pressure_at(radius)
}

/// Pressure in the liquid at the wall and the parts of its rate.
///
/// p_L = p_v + p_g - 2 sigma/R - 4 e mu R'/R      (eq. 3.39 with the missing p_v; e = 1 but for Tomita-Shima)
///
/// dp_L/dt = `rate` - `inertia` R''      (eq. 3.40)
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct WallPressure {
    /// p_L, Pa.
    pub(super) value: f64,
    /// Part of its rate that does not hold R'', Pa/s.
    pub(super) rate: f64,
    /// Minus the factor of R'' in its rate: 4 e mu/R, Pa s2/m.
    pub(super) inertia: f64,
}

impl WallPressure {
    #[inline]
    pub(super) fn new(liquid: &Liquid, gas: &Gas, wall: &Wall, slowing: f64) -> Self {
        let gas_pressure = gas.pressure_at(wall.radius);
        let over = 1.0 / wall.radius;
        let capillary = 2.0 * liquid.surface_tension * over;
        let inertia = 4.0 * slowing * liquid.viscosity * over;
        let stretch = wall.velocity * over;
        Self {
            value: liquid.vapour_pressure + gas_pressure - capillary - inertia * wall.velocity,
            rate: stretch
                * (capillary + inertia * wall.velocity
                    - 3.0 * gas.polytropic_exponent * gas_pressure),
            inertia,
        }
    }
}
