//! Flow against a wall: u = a (x, y, -2 z), p = p0 - rho/2 |u|^2, z >= 0, wall at z = 0.
//!
//! Exact for the inviscid liquid; the wall is frictionless. Units: a 1/s, p0 Pa (at the stagnation point).

use super::{Carrier, CarrierError, CarrierPoint, WallPoint};
use crate::vector::{Vector, dot, scale};

/// Axisymmetric stagnation flow on the wall z = 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stagnation {
    /// Strain rate a, 1/s.
    pub strain_rate: f64,
    /// Pressure at the stagnation point, Pa.
    pub pressure: f64,
    /// Density, kg/m3.
    pub density: f64,
    /// Dynamic viscosity, Pa s.
    pub viscosity: f64,
}

impl Carrier for Stagnation {
    fn at(&self, position: Vector, _time: f64) -> Result<CarrierPoint, CarrierError> {
        if position[2] < 0.0 {
            return Err(CarrierError::Outside { position });
        }
        let a = self.strain_rate;
        let [x, y, z] = position;
        let velocity = [a * x, a * y, -2.0 * a * z];
        let acceleration = scale(a * a, [x, y, 4.0 * z]);
        let pressure = self.pressure - 0.5 * self.density * dot(velocity, velocity);
        Ok(CarrierPoint {
            velocity,
            pressure_gradient: scale(-self.density, acceleration),
            velocity_gradient: [[a, 0.0, 0.0], [0.0, a, 0.0], [0.0, 0.0, -2.0 * a]],
            acceleration,
            ..CarrierPoint::at_rest(pressure, self.density, self.viscosity)
        })
    }

    fn wall(&self, position: Vector) -> Option<WallPoint> {
        Some(WallPoint {
            distance: position[2],
            normal: [0.0, 0.0, 1.0],
        })
    }

    /// The velocity changes by a share in a length of the distance from the origin; the step is limited by 1/a instead.
    fn length_scale(&self, _position: Vector) -> f64 {
        f64::INFINITY
    }

    fn time_scale(&self) -> f64 {
        0.5 / self.strain_rate.abs()
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::misses;
    use super::*;

    #[test]
    fn it_is_what_it_states_and_ends_at_the_wall() {
        let flow = Stagnation {
            strain_rate: 30.0,
            pressure: 1e5,
            density: 1e3,
            viscosity: 1e-3,
        };
        let missed = misses(&flow, [0.1, -0.2, 0.3], 0.0, 1e-4, 1e-3);
        assert!(missed.iter().all(|m| *m < 1e-8), "{missed:?}");
        assert!(flow.at([0.0, 0.0, -1e-9], 0.0).is_err());
    }
}
