//! Sound of one frequency in liquid at rest.
//!
//! uniform    p = p0 - a sin(w t)                                     u = 0 (a bubble much smaller than the wave length)
//! travelling p = p0 - a sin(w t - k x),   u = -a/(rho c) sin(w t - k x) e
//! standing   p = p0 - a sin(w t) cos(k x), u = a/(rho c) cos(w t) sin(k x) e
//!
//! k = w/c, x along e. Linear acoustics; grad p = -rho du/dt, and Du/Dt has its convective part. Range: a << rho c^2.

use super::{Carrier, CarrierError, CarrierPoint};
use crate::vector::{Vector, dot, scale};
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// Kinds of waves.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Wave {
    /// The same pressure everywhere.
    Uniform,
    /// Travels along a unit vector.
    Travelling(Vector),
    /// Stands along a unit vector, loudest at the origin.
    Standing(Vector),
}

/// An acoustic field without bounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Acoustic {
    /// Kind.
    pub wave: Wave,
    /// Mean pressure, Pa.
    pub mean: f64,
    /// Amplitude, Pa.
    pub amplitude: f64,
    /// Frequency, Hz.
    pub frequency: f64,
    /// Density, kg/m3.
    pub density: f64,
    /// Sound speed, m/s.
    pub sound_speed: f64,
    /// Dynamic viscosity, Pa s.
    pub viscosity: f64,
}

/// One-dimensional values: pressure change, its slope, velocity, its slope, its rate.
struct Line {
    pressure: f64,
    pressure_slope: f64,
    velocity: f64,
    velocity_slope: f64,
    velocity_rate: f64,
}

impl Acoustic {
    fn omega(&self) -> f64 {
        TAU * self.frequency
    }

    fn line(&self, x: f64, t: f64) -> Line {
        let (a, w) = (self.amplitude, self.omega());
        let k = w / self.sound_speed;
        let v = a / (self.density * self.sound_speed);
        match self.wave {
            Wave::Uniform => Line {
                pressure: -a * (w * t).sin(),
                pressure_slope: 0.0,
                velocity: 0.0,
                velocity_slope: 0.0,
                velocity_rate: 0.0,
            },
            Wave::Travelling(_) => {
                let (s, c) = (w * t - k * x).sin_cos();
                Line {
                    pressure: -a * s,
                    pressure_slope: a * k * c,
                    velocity: -v * s,
                    velocity_slope: v * k * c,
                    velocity_rate: -v * w * c,
                }
            }
            Wave::Standing(_) => {
                let ((st, ct), (sx, cx)) = ((w * t).sin_cos(), (k * x).sin_cos());
                Line {
                    pressure: -a * st * cx,
                    pressure_slope: a * k * st * sx,
                    velocity: v * ct * sx,
                    velocity_slope: v * k * ct * cx,
                    velocity_rate: -v * w * st * sx,
                }
            }
        }
    }
}

impl Carrier for Acoustic {
    fn at(&self, position: Vector, time: f64) -> Result<CarrierPoint, CarrierError> {
        let e = match self.wave {
            Wave::Uniform => [0.0; 3],
            Wave::Travelling(e) | Wave::Standing(e) => e,
        };
        let line = self.line(dot(e, position), time);
        Ok(CarrierPoint {
            velocity: scale(line.velocity, e),
            pressure_gradient: scale(line.pressure_slope, e),
            velocity_gradient: e.map(|component| scale(line.velocity_slope * component, e)),
            acceleration: scale(line.velocity_rate + line.velocity * line.velocity_slope, e),
            ..CarrierPoint::at_rest(self.mean + line.pressure, self.density, self.viscosity)
        })
    }

    fn length_scale(&self, _position: Vector) -> f64 {
        match self.wave {
            Wave::Uniform => f64::INFINITY,
            _ => self.sound_speed / self.omega(),
        }
    }

    fn time_scale(&self) -> f64 {
        1.0 / self.omega()
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::misses;
    use super::*;

    #[test]
    fn waves_are_what_they_state() {
        let e = [0.6, 0.0, 0.8];
        for wave in [Wave::Travelling(e), Wave::Standing(e)] {
            let field = Acoustic {
                wave,
                mean: 1e5,
                amplitude: 1e4,
                frequency: 2e4,
                density: 998.0,
                sound_speed: 1480.0,
                viscosity: 1e-3,
            };
            let (x, t) = ([0.011, 0.02, 0.007], 1.3e-5);
            let [gradient, pressure, acceleration] = misses(&field, x, t, 1e-5, 1e-9);
            assert!(
                gradient < 1e-6 && pressure < 1e-6 && acceleration < 1e-6,
                "{wave:?}"
            );
            // Linear momentum: rho du/dt = -grad p.
            let p = field.at(x, t).unwrap();
            let rate = (field.at(x, t + 1e-9).unwrap().velocity[0]
                - field.at(x, t - 1e-9).unwrap().velocity[0])
                / 2e-9;
            assert!((998.0 * rate / -p.pressure_gradient[0] - 1.0).abs() < 1e-6);
        }
    }
}
