//! The liquid around a bubble, as constants.

use super::error::{BubbleError, positive};
use serde::{Deserialize, Serialize};

/// Constants of the liquid, SI.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Liquid {
    /// Density, kg/m3.
    pub density: f64,
    /// Sound speed, m/s.
    pub sound_speed: f64,
    /// Dynamic viscosity, Pa s; may be zero.
    pub viscosity: f64,
    /// Surface tension, N/m; may be zero.
    pub surface_tension: f64,
    /// Vapour pressure, Pa; may be zero.
    pub vapour_pressure: f64,
}

impl Liquid {
    /// Water at 20 C with the surface tension of Peters and el Moctar 2020, section 4.1 (density and vapour pressure are
    /// not given there).
    pub const WATER: Self = Self {
        density: 998.2,
        sound_speed: 1482.0,
        viscosity: 1e-3,
        surface_tension: 0.0725,
        vapour_pressure: 2337.0,
    };

    /// Checks the ranges.
    ///
    /// # Errors
    /// [`BubbleError::OutOfRange`] naming the quantity.
    pub fn check(&self) -> Result<(), BubbleError> {
        positive("density", "kg/m3", self.density, false)?;
        positive("sound_speed", "m/s", self.sound_speed, false)?;
        positive("viscosity", "Pa s", self.viscosity, true)?;
        positive("surface_tension", "N/m", self.surface_tension, true)?;
        positive("vapour_pressure", "Pa", self.vapour_pressure, true)
    }
}
