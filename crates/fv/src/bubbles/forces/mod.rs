//! Forces of the liquid on a bubble (Peters and el Moctar 2020, eqs 3.24 to 3.32, corrected).
//!
//! Du/Dt follows the liquid. Forces are in N, along the axes; `radius` in m, `volume` in m3.

mod drag;
mod lift;

pub use drag::{DragLaw, eotvos_number, reynolds_number, terminal_speed};
pub use lift::LiftLaw;

use super::carrier::CarrierPoint;
use crate::vector::{Vector, scale};
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// From which value of the flow the pressure gradient force is taken (3.24).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum PressureForce {
    /// No such force.
    Off,
    /// -V grad p, without the hydrostatic part.
    Gradient,
    /// V rho Du/Dt: equal to the gradient wherever the flow obeys the momentum equation.
    Acceleration,
}

/// Which forces act.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Forces {
    /// Pressure gradient (3.24).
    pub pressure: PressureForce,
    /// Added mass (3.25).
    pub added_mass: bool,
    /// Change of volume (3.26); belongs to the added mass.
    pub volume_change: bool,
    /// Drag (3.27 to 3.29).
    pub drag: DragLaw,
    /// Lift (3.30, 3.31).
    pub lift: LiftLaw,
    /// Gravity, m/s2; weight and buoyancy (3.32). Zero: none.
    pub gravity: Vector,
}

impl Forces {
    /// All forces of a flow, without gravity: drag of Haberman and Morton, inviscid lift.
    pub const IN_FLOW: Self = Self {
        pressure: PressureForce::Acceleration,
        added_mass: true,
        volume_change: true,
        drag: DragLaw::HabermanMorton,
        lift: LiftLaw::Inviscid,
        gravity: [0.0; 3],
    };
}

/// Volume of a sphere, m3.
#[must_use]
pub fn volume(radius: f64) -> f64 {
    4.0 / 3.0 * PI * radius.powi(3)
}

/// Added mass of a sphere, rho V/2, kg (3.25).
#[must_use]
pub fn added_mass(radius: f64, density: f64) -> f64 {
    0.5 * density * volume(radius)
}

/// Pressure gradient force (3.24).
#[must_use]
pub fn pressure_gradient(form: PressureForce, volume: f64, flow: &CarrierPoint) -> Vector {
    match form {
        PressureForce::Off => [0.0; 3],
        PressureForce::Gradient => scale(-volume, flow.pressure_gradient),
        PressureForce::Acceleration => scale(volume * flow.density, flow.acceleration),
    }
}

/// The part of the added mass force that the acceleration of the liquid makes: rho V/2 Du/Dt (3.25). The part of the
/// bubble's own acceleration is on the left-hand side (3.33).
#[must_use]
pub fn added_mass_of_flow(volume: f64, flow: &CarrierPoint) -> Vector {
    scale(0.5 * flow.density * volume, flow.acceleration)
}

/// Force of the change of volume over the slip u_c - u_b: rho/2 dV/dt = 3/2 rho V R'/R, kg/s (3.26).
#[must_use]
pub fn volume_change(radius: f64, wall_velocity: f64, density: f64) -> f64 {
    2.0 * PI * density * radius * radius * wall_velocity
}

/// Weight less buoyancy: (m_b - rho V) g (3.32).
#[must_use]
pub fn buoyancy(mass: f64, volume: f64, density: f64, gravity: Vector) -> Vector {
    scale(mass - density * volume, gravity)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 3/2 rho V R'/R is rho/2 dV/dt.
    #[test]
    fn volume_force_is_the_rate_of_the_added_mass() {
        let (r, v, rho) = (1.3e-4, 7.0, 998.0);
        let printed = 1.5 * rho * volume(r) * v / r;
        assert!((volume_change(r, v, rho) / printed - 1.0).abs() < 1e-14);
        let h = 1e-10;
        let slope = (added_mass(r + v * h, rho) - added_mass(r - v * h, rho)) / (2.0 * h);
        assert!((slope / printed - 1.0).abs() < 1e-6);
    }
}
