//! Lift in a shear flow (Peters and el Moctar 2020, eqs 3.30, 3.31).
//!
//! F = 3/8 c_L rho V (u_c - u_b)/alpha x omega,  alpha = |omega| R/|u_c - u_b|
//!
//! The source gives no c_L. The inviscid value c_L = 4/3 alpha makes F = 1/2 rho V (u_c - u_b) x omega; alpha cancels, so
//! that nothing is divided by a slip or vorticity of zero. Units: 1/s for omega = curl u_c. Range: weak shear, large Re.

use super::super::carrier::CarrierPoint;
use crate::vector::{Vector, cross, scale};
use serde::{Deserialize, Serialize};

/// Laws of lift.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum LiftLaw {
    /// None.
    Off,
    /// Sphere in weak inviscid shear (Auton 1987): coefficient 1/2.
    Inviscid,
    /// A coefficient of one's own: F = C rho V (u_c - u_b) x omega.
    Coefficient(f64),
}

impl LiftLaw {
    /// Force (N) on a bubble of a volume (m3) that moves with `slip` = u_c - u_b (m/s).
    #[must_use]
    pub fn force(&self, volume: f64, slip: Vector, flow: &CarrierPoint) -> Vector {
        let coefficient = match *self {
            Self::Off => return [0.0; 3],
            Self::Inviscid => 0.5,
            Self::Coefficient(c) => c,
        };
        let size = coefficient * flow.density * volume;
        scale(size, cross(slip, flow.vorticity()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// u_c = (s y, 0, 0), the bubble lags: lift towards the faster liquid, +y, of rho V/2 |slip| s. This is figure 4 of the
    /// source.
    #[test]
    fn inviscid_value_and_direction() {
        let flow = CarrierPoint {
            velocity_gradient: [[0.0, 3.0, 0.0], [0.0; 3], [0.0; 3]],
            ..CarrierPoint::at_rest(0.0, 1000.0, 1e-3)
        };
        assert_eq!(flow.vorticity(), [0.0, 0.0, -3.0]);
        let force = LiftLaw::Inviscid.force(1e-9, [0.2, 0.0, 0.0], &flow);
        assert!((force[1] / (0.5 * 1000.0 * 1e-9 * 0.2 * 3.0) - 1.0).abs() < 1e-14);
        assert_eq!((force[0], force[2]), (0.0, 0.0));
        assert_eq!(LiftLaw::Inviscid.force(1e-9, [0.0; 3], &flow), [0.0; 3]);
    }
}
