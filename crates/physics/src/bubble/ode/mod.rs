//! Steps in time of one bubble: an explicit method of order 8 and an implicit one for stiff walls.
//!
//! The components are radius, wall velocity and the three integrals of the ledger. The rates depend on the first two
//! only, so the integrals are quadratures and take no part in the error control.

mod dense;
mod dop853;
mod dop853_table;
mod radau;

pub use dense::DenseStep;
pub(super) use dop853::explicit_step;
pub(super) use radau::implicit_step;

/// Radius, wall velocity, viscous, radiated, driven.
pub(super) type Values = [f64; 5];

/// The rates of [`Values`].
pub(super) trait Rates {
    /// Rates at a time, radius and wall velocity. Not finite where the law has no answer.
    fn rates(&self, time: f64, radius: f64, velocity: f64) -> Values;
}

/// Where a step starts.
#[derive(Debug, Clone, Copy)]
pub(super) struct Start {
    /// Time, s.
    pub(super) time: f64,
    /// Values.
    pub(super) values: Values,
    /// Rates there.
    pub(super) rates: Values,
}

/// A step that was tried.
#[derive(Debug, Clone, Copy)]
pub(super) struct Trial {
    /// Values at its end.
    pub(super) values: Values,
    /// Error over tolerance: accepted below 1. Infinite if a stage was not finite.
    pub(super) error: f64,
    /// Factor for the next step.
    pub(super) factor: f64,
    /// |h lambda| of the stiffest motion, estimated.
    pub(super) stiffness: f64,
    /// Whether the wall velocity of a stage has the other sign than that of `direction` (1 or -1) asked for.
    pub(super) turned: bool,
    /// What dense output needs.
    pub(super) dense: DenseStep,
}

/// Tolerances of radius and velocity.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tolerance {
    /// Relative.
    pub(super) relative: f64,
    /// Velocity below which errors are measured against it, m/s.
    pub(super) velocity_floor: f64,
}

impl Tolerance {
    /// Allowed errors of radius and velocity over a step of length h.
    fn scales(&self, start: &Start, end: &Values, h: f64) -> [f64; 2] {
        let radius = start.values[0].min(end[0].abs());
        let velocity = start.values[1]
            .abs()
            .max(end[1].abs())
            .max((h * start.rates[1]).abs())
            .max(self.velocity_floor);
        [
            self.relative * radius.max(f64::MIN_POSITIVE),
            self.relative * velocity.max(f64::MIN_POSITIVE),
        ]
    }
}
