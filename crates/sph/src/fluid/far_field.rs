//! Far field: a side of the liquid through which waves leave and a pressure step may enter.
//!
//! Along the characteristic that enters the liquid the Riemann invariant u - F(p) keeps the value of the far field,
//! F(p) = integral of dp/(rho c) (u outward normal velocity), so at the side F(p) = u + 2 F(p_s) - F(p_inf), with p_inf the
//! pressure at rest and p_s behind the entering step. A wave that leaves meets no resistance but its own impedance.
//! Exact for simple waves of one space dimension.

use crate::geometry::Vec2;
use erode_physics::eos::Tait;

/// What lies outside a particle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FarField {
    /// Outward unit normal; zero for particles without a far field.
    pub normal: Vec2,
    /// Pressure of the undisturbed far field, Pa.
    pub pressure: f64,
    /// Pressure behind the entering step, Pa; equal to `pressure` when there is none.
    pub step_pressure: f64,
    /// Time at which the step enters, s.
    pub start: f64,
}

impl FarField {
    /// No far field.
    pub const NONE: Self = Self { normal: [0.0; 2], pressure: 0.0, step_pressure: 0.0, start: 0.0 };

    /// Whether there is one.
    #[must_use]
    pub fn is_some(&self) -> bool {
        self.normal != [0.0; 2]
    }

    /// Pressure (Pa) on the outside of a particle that moves with `velocity` at `time`.
    #[must_use]
    pub fn pressure_outside(&self, eos: &Tait, velocity: Vec2, time: f64) -> f64 {
        let integral = |p: f64| eos.riemann_integral(eos.density(p));
        let step = if time >= self.start { self.step_pressure } else { self.pressure };
        let u = velocity[0] * self.normal[0] + velocity[1] * self.normal[1];
        let f = u + 2.0 * integral(step) - integral(self.pressure);
        eos.pressure_of_riemann_integral(f).max(0.0)
    }
}
