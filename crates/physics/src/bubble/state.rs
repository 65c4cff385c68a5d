//! State of a bubble in time: all that the next step depends on, and what has happened.

use super::error::{BubbleError, positive};
use super::{Ambient, Gas, Liquid, Phase};
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// A bubble at an instant. Written and read back it continues with the same bits.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct BubbleState {
    /// Time, s.
    pub time: f64,
    /// What the last digit of the time has lost, s: steps can be far shorter than it.
    pub time_rest: f64,
    /// Radius, m.
    pub radius: f64,
    /// dR/dt, m/s.
    pub wall_velocity: f64,
    /// Way the wall moves; `None` until the first step has found out.
    pub phase: Option<Phase>,
    /// Law in force for models that switch; that of `phase` but for a bubble held between both laws.
    pub law: Phase,
    /// Size of the next step, s; zero: to be chosen.
    pub next_step: f64,
    /// Steps in a row that looked stiff.
    pub stiff_steps: u32,
    /// Whether the implicit method is in use.
    pub stiff: bool,
    /// Energy that has left or entered.
    pub ledger: Ledger,
    /// The last largest radius, where the collapse in progress began.
    pub largest: Option<Largest>,
    /// What has been done.
    pub counters: Counters,
}

/// A largest radius.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Largest {
    /// Time, s.
    pub time: f64,
    /// Radius, m.
    pub radius: f64,
    /// Pressure of the liquid, Pa.
    pub ambient_pressure: f64,
}

/// Integrals over time of powers, J. See [`super::Energy`] for what they balance.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Ledger {
    /// Dissipated by viscosity: integral of 16 pi mu R R'^2.
    pub viscous: f64,
    /// Handed to the compressible liquid: work of the wall that the incompressible balance does not explain.
    pub radiated: f64,
    /// Put in by the changing pressure of the liquid: integral of V dp.
    pub driven: f64,
}

/// Counts since the start.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Counters {
    /// Steps accepted.
    pub steps: u64,
    /// Steps rejected by the error control.
    pub rejected: u64,
    /// Of the accepted steps, those by the implicit method.
    pub implicit_steps: u64,
    /// Smallest radii passed.
    pub collapses: u64,
    /// Extreme radii at which a switching model kept its law because the other one pushed back.
    pub held: u64,
}

/// What an [`Event`] is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum EventKind {
    /// Largest radius: growth or rebound ends, a collapse begins (R' turns from positive to negative).
    CollapseBegins,
    /// Smallest radius: the collapse ends, a rebound begins (R' turns from negative to positive).
    SmallestRadius,
    /// The radius fell to [`super::Controls::closure`] of the reference radius: the bubble has closed.
    Closed,
}

/// Something that happened to a bubble. The sign changes in the text after eq. 3.59 of Peters and el Moctar 2020 are
/// exchanged; these are the right ones.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Event {
    /// What.
    pub kind: EventKind,
    /// When, s.
    pub time: f64,
    /// Radius, m.
    pub radius: f64,
    /// Pressure of vapour and gas, Pa.
    pub bubble_pressure: f64,
    /// Pressure of the liquid, Pa.
    pub ambient_pressure: f64,
    /// The collapse that ended, at a smallest radius whose collapse was seen from its beginning.
    pub collapse: Option<Collapse>,
}

/// A collapse from its largest to its smallest radius.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Collapse {
    /// Where it began.
    pub begin: Largest,
    /// Time of the smallest radius, s.
    pub end_time: f64,
    /// Smallest radius, m.
    pub smallest_radius: f64,
    /// Pressure of vapour and gas at the smallest radius, Pa.
    pub peak_pressure: f64,
}

impl BubbleState {
    /// A bubble at rest with a radius, m, at a time, s.
    ///
    /// # Errors
    /// [`BubbleError::OutOfRange`] if the radius is not positive.
    pub fn at_rest(radius: f64, time: f64) -> Result<Self, BubbleError> {
        Self::moving(radius, 0.0, time)
    }

    /// A bubble with a radius, m, and a wall velocity, m/s, at a time, s.
    ///
    /// # Errors
    /// [`BubbleError::OutOfRange`] if the radius is not positive or a number is not finite.
    pub fn moving(radius: f64, wall_velocity: f64, time: f64) -> Result<Self, BubbleError> {
        positive("radius", "m", radius, false)?;
        positive("size of wall_velocity", "m/s", wall_velocity.abs(), true)?;
        positive("size of time", "s", time.abs(), true)?;
        let phase = match wall_velocity {
            v if v > 0.0 => Some(Phase::Growth),
            v if v < 0.0 => Some(Phase::Collapse),
            _ => None,
        };
        Ok(Self {
            time,
            time_rest: 0.0,
            radius,
            wall_velocity,
            phase,
            law: phase.unwrap_or_default(),
            next_step: 0.0,
            stiff_steps: 0,
            stiff: false,
            ledger: Ledger::default(),
            largest: None,
            counters: Counters::default(),
        })
    }

    /// Volume, m3.
    #[must_use]
    pub fn volume(&self) -> f64 {
        4.0 / 3.0 * PI * self.radius.powi(3)
    }

    /// Pressure of vapour and gas, Pa.
    #[must_use]
    pub fn bubble_pressure(&self, liquid: &Liquid, gas: &Gas) -> f64 {
        super::model::bubble_pressure(liquid, gas, self.radius)
    }

    /// The energies of this instant with the ledger, J.
    #[must_use]
    pub fn energy(&self, liquid: &Liquid, gas: &Gas, ambient: &Ambient) -> super::Energy {
        super::Energy::new(
            liquid,
            gas,
            ambient,
            self.radius,
            self.wall_velocity,
            &self.ledger,
        )
    }
}
