//! Mean of the flow over the surface of a bubble (Peters and el Moctar 2020, section 3.3, after Hsiao et al. 2000).
//!
//! Six points: centre +- R along each axis, equal weights. The mean over a sphere is met exactly for fields up to cubic.
//! Points outside the flow (behind a wall, beyond the domain) are left out and counted; the centre must be inside.

use super::{Carrier, CarrierError, CarrierPoint};
use crate::vector::{Vector, add, scale};

/// A mean and how many of its six points are missing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Average {
    /// Mean values.
    pub point: CarrierPoint,
    /// Points outside the flow.
    pub left_out: u32,
}

/// Mean over the sphere of a radius (m) around a place.
///
/// # Errors
/// If the centre, or all six points, are outside the flow.
pub fn surface_average(
    flow: &impl Carrier,
    centre: Vector,
    radius: f64,
    time: f64,
) -> Result<Average, CarrierError> {
    let middle = flow.at(centre, time)?;
    let (mut sum, mut count, mut left_out) = (None, 0u32, 0);
    for axis in 0..3 {
        for side in [-radius, radius] {
            let mut place = centre;
            place[axis] += side;
            match flow.at(place, time) {
                Ok(point) => {
                    count += 1;
                    sum = Some(sum.map_or(point, |s| plus(&s, &point)));
                }
                Err(CarrierError::Outside { .. }) => left_out += 1,
                Err(other) => return Err(other),
            }
        }
    }
    let sum = sum.ok_or(CarrierError::Outside { position: centre })?;
    let point = CarrierPoint {
        // Density and viscosity are those at the centre.
        density: middle.density,
        viscosity: middle.viscosity,
        ..times(1.0 / f64::from(count), &sum)
    };
    Ok(Average { point, left_out })
}

fn plus(a: &CarrierPoint, b: &CarrierPoint) -> CarrierPoint {
    let rows = [0, 1, 2].map(|i| add(a.velocity_gradient[i], b.velocity_gradient[i]));
    CarrierPoint {
        velocity: add(a.velocity, b.velocity),
        pressure: a.pressure + b.pressure,
        pressure_gradient: add(a.pressure_gradient, b.pressure_gradient),
        velocity_gradient: rows,
        acceleration: add(a.acceleration, b.acceleration),
        ..*a
    }
}

fn times(s: f64, a: &CarrierPoint) -> CarrierPoint {
    CarrierPoint {
        velocity: scale(s, a.velocity),
        pressure: s * a.pressure,
        pressure_gradient: scale(s, a.pressure_gradient),
        velocity_gradient: a.velocity_gradient.map(|row| scale(s, row)),
        acceleration: scale(s, a.acceleration),
        ..*a
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Stagnation, Still};
    use super::*;

    /// Mean of |u|^2 over the sphere: that at the centre plus a^2 R^2 (1 + 1 + 4)/3.
    #[test]
    fn quadratic_pressure_has_its_exact_mean() {
        let flow = Stagnation {
            strain_rate: 10.0,
            pressure: 0.0,
            density: 2.0,
            viscosity: 0.0,
        };
        let (x, radius) = ([0.3, 0.1, 0.5], 0.2);
        let mean = surface_average(&flow, x, radius, 0.0).unwrap();
        let middle = flow.at(x, 0.0).unwrap();
        let expected = middle.pressure - 100.0 * radius * radius * 2.0;
        assert!((mean.point.pressure / expected - 1.0).abs() < 1e-12);
        assert_eq!(mean.left_out, 0);
        for k in 0..3 {
            assert!((mean.point.velocity[k] - middle.velocity[k]).abs() < 1e-12);
        }
    }

    #[test]
    fn points_behind_the_wall_are_counted() {
        let flow = super::super::NearPlane {
            flow: Still {
                pressure: 1e5,
                density: 1e3,
                viscosity: 1e-3,
                gravity: [0.0, 0.0, -9.81],
            },
            point: [0.0; 3],
            normal: [0.0, 0.0, 1.0],
        };
        let mean = surface_average(&flow, [0.0, 0.0, 0.1], 0.2, 0.0).unwrap();
        assert_eq!(mean.left_out, 1);
        assert!(surface_average(&flow, [0.0, 0.0, -0.1], 0.2, 0.0).is_err());
    }
}
