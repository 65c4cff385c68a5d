//! The cloud: bubbles as named arrays, advanced together.
//!
//! Bubbles do not feel each other, and the flow does not feel them. Each is computed for itself and put back in order, so the
//! bits do not depend on the number of threads. Written down and read back (serde), a cloud continues with the same bits.

use super::carrier::{Carrier, CarrierError};
use super::motion::SlipLedger;
use super::records::{Begin, CloudLedger, CollapseRecord, Fate, Lost};
use super::settings::{Settings, SettingsError};
use super::traveller::{Bubble, Stop, Traveller};
use crate::vector::{Vector, finite};
use erode_physics::bubble::{BubbleError, BubbleState, Gas};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// A bubble to be put in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NewBubble {
    /// Centre, m.
    pub position: Vector,
    /// Velocity, m/s.
    pub velocity: Vector,
    /// Radius, m.
    pub radius: f64,
    /// dR/dt, m/s.
    pub wall_velocity: f64,
    /// Its gas.
    pub gas: Gas,
    /// Its mass, kg; may be zero.
    pub mass: f64,
}

/// What can go wrong with a cloud.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum CloudError {
    /// Data of a bubble.
    #[error("the bubble cannot be put in: {0}")]
    Bubble(#[from] BubbleError),
    /// A setting.
    #[error("the cloud cannot be computed: {0}")]
    Settings(#[from] SettingsError),
    /// A place, velocity or mass that is not a number.
    #[error("the bubble cannot be put in: its {quantity} must be finite{also}")]
    NotFinite {
        /// Which.
        quantity: &'static str,
        /// Further condition.
        also: &'static str,
    },
    /// The flow has no answer within its domain.
    #[error("bubble {bubble}: {error}; the cloud stays as it was")]
    Flow {
        /// Number of the bubble.
        bubble: u64,
        /// Why.
        error: CarrierError,
    },
    /// Time must run forwards.
    #[error("the cloud is at {time:e} s and cannot be advanced to {until:e} s")]
    Backwards {
        /// Time of the cloud, s.
        time: f64,
        /// Time asked for, s.
        until: f64,
    },
}

/// Bubbles as arrays of the same length, in the order in which they were put in.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Cloud {
    /// Time, s.
    pub time: f64,
    /// Number of each bubble; never used twice.
    pub bubble: Vec<u64>,
    /// Centres, m.
    pub position: Vec<Vector>,
    /// Velocities, m/s.
    pub velocity: Vec<Vector>,
    /// Radius, wall velocity and what their integration needs.
    pub state: Vec<BubbleState>,
    /// Gas.
    pub gas: Vec<Gas>,
    /// Masses, kg.
    pub mass: Vec<f64>,
    /// What the slip gained and lost.
    pub slip_ledger: Vec<SlipLedger>,
    /// Where the collapse in progress began.
    pub begin: Vec<Option<Begin>>,
    /// Bubbles that are gone.
    pub lost: Vec<Lost>,
    /// Counts.
    pub ledger: CloudLedger,
}

/// One bubble after a call.
struct Outcome {
    bubble: Bubble,
    stop: Option<Stop>,
    records: Vec<CollapseRecord>,
    counts: CloudLedger,
}

impl Cloud {
    /// An empty cloud at a time, s.
    #[must_use]
    pub fn new(time: f64) -> Self {
        Self {
            time,
            ..Self::default()
        }
    }

    /// Number of bubbles present.
    #[must_use]
    pub fn len(&self) -> usize {
        self.bubble.len()
    }

    /// Whether no bubble is present.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.bubble.is_empty()
    }

    /// Puts a bubble in at the time of the cloud; its number.
    ///
    /// # Errors
    /// If radius, gas, place, velocity or mass are out of range.
    pub fn inject(&mut self, new: &NewBubble) -> Result<u64, CloudError> {
        new.gas.check()?;
        let state = BubbleState::moving(new.radius, new.wall_velocity, self.time)?;
        for (quantity, value) in [("position", new.position), ("velocity", new.velocity)] {
            if !finite(value) {
                return Err(CloudError::NotFinite { quantity, also: "" });
            }
        }
        if !(new.mass >= 0.0 && new.mass.is_finite()) {
            let (quantity, also) = ("mass", " and not negative");
            return Err(CloudError::NotFinite { quantity, also });
        }
        let id = self.ledger.injected;
        self.push(Bubble {
            id,
            position: new.position,
            velocity: new.velocity,
            state,
            gas: new.gas,
            mass: new.mass,
            slip_ledger: SlipLedger::default(),
            begin: None,
        });
        self.ledger.injected += 1;
        Ok(id)
    }

    /// Advances to a time (s); the collapses on the way, by bubble and time. A bubble that leaves the domain, closes or fails
    /// moves to `lost` and is counted.
    ///
    /// # Errors
    /// If time would run backwards, a setting is out of range, or the flow has no answer within its domain; the cloud is then as before.
    pub fn advance<C: Carrier>(
        &mut self,
        carrier: &C,
        settings: &Settings,
        until: f64,
    ) -> Result<Vec<CollapseRecord>, CloudError> {
        if until < self.time || until.is_nan() {
            return Err(CloudError::Backwards {
                time: self.time,
                until,
            });
        }
        settings.check()?;
        let outcomes: Vec<Outcome> = (0..self.len())
            .into_par_iter()
            .map(|k| travel(carrier, settings, self.get(k), (self.time, until)))
            .collect();
        for outcome in &outcomes {
            if let Some(Stop::Flow(error)) = &outcome.stop {
                return Err(CloudError::Flow {
                    bubble: outcome.bubble.id,
                    error: *error,
                });
            }
        }
        Ok(self.take(outcomes, until))
    }

    fn take(&mut self, outcomes: Vec<Outcome>, until: f64) -> Vec<CollapseRecord> {
        self.clear();
        let mut records = Vec::new();
        for outcome in outcomes {
            self.ledger.add(&outcome.counts);
            records.extend(outcome.records);
            match outcome.stop {
                Some(Stop::Gone(fate)) => self.lose(&outcome.bubble, fate),
                _ => self.push(outcome.bubble),
            }
        }
        self.time = until;
        records
    }

    fn lose(&mut self, b: &Bubble, fate: Fate) {
        let counter = match fate {
            Fate::LeftDomain => &mut self.ledger.left_domain,
            Fate::Closed => &mut self.ledger.closed,
            Fate::Failed(_) | Fate::TooManySubsteps => &mut self.ledger.failed,
        };
        *counter += 1;
        self.lost.push(Lost {
            bubble: b.id,
            time: b.state.time,
            position: b.position,
            radius: b.state.radius,
            mass: b.mass,
            slip_ledger: b.slip_ledger,
            fate,
        });
    }

    fn get(&self, k: usize) -> Bubble {
        Bubble {
            id: self.bubble[k],
            position: self.position[k],
            velocity: self.velocity[k],
            state: self.state[k],
            gas: self.gas[k],
            mass: self.mass[k],
            slip_ledger: self.slip_ledger[k],
            begin: self.begin[k],
        }
    }

    fn push(&mut self, b: Bubble) {
        self.bubble.push(b.id);
        self.position.push(b.position);
        self.velocity.push(b.velocity);
        self.state.push(b.state);
        self.gas.push(b.gas);
        self.mass.push(b.mass);
        self.slip_ledger.push(b.slip_ledger);
        self.begin.push(b.begin);
    }

    fn clear(&mut self) {
        self.bubble.clear();
        self.position.clear();
        self.velocity.clear();
        self.state.clear();
        self.gas.clear();
        self.mass.clear();
        self.slip_ledger.clear();
        self.begin.clear();
    }
}

fn travel<C: Carrier>(
    carrier: &C,
    settings: &Settings,
    bubble: Bubble,
    (now, until): (f64, f64),
) -> Outcome {
    let mut traveller = Traveller::new(carrier, settings, bubble, now);
    let stop = traveller.run(until).err();
    Outcome {
        bubble: traveller.bubble,
        stop,
        records: traveller.records,
        counts: traveller.counts,
    }
}

#[cfg(test)]
mod tests;
