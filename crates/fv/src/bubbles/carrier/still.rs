//! Liquid at rest under gravity: p = p0 + rho g . x, p0 at the origin.

use super::{Carrier, CarrierError, CarrierPoint};
use crate::vector::{Vector, dot};

/// Liquid at rest without bounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Still {
    /// Pressure at the origin, Pa.
    pub pressure: f64,
    /// Density, kg/m3.
    pub density: f64,
    /// Dynamic viscosity, Pa s.
    pub viscosity: f64,
    /// Gravity, m/s2.
    pub gravity: Vector,
}

impl Carrier for Still {
    fn at(&self, position: Vector, _time: f64) -> Result<CarrierPoint, CarrierError> {
        let pressure = self.pressure + self.density * dot(self.gravity, position);
        Ok(CarrierPoint::at_rest(
            pressure,
            self.density,
            self.viscosity,
        ))
    }

    fn length_scale(&self, _position: Vector) -> f64 {
        f64::INFINITY
    }
}
