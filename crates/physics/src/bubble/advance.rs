//! A bubble in time: steps with error control that land exactly on the largest and smallest radii.

mod extremes;
mod stepping;

use super::ode::DenseStep;
use super::{BubbleError, BubbleModel, BubbleState, Driving, Event, Gas, Liquid};
use stepping::Stepping;

/// How carefully to integrate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Controls {
    /// Error allowed in each step, relative to radius and wall velocity.
    pub tolerance: f64,
    /// Steps allowed in one call, rejected ones included.
    pub max_steps: u64,
    /// A bubble without gas has closed where its radius is this fraction of the reference radius.
    pub closure: f64,
}

impl Default for Controls {
    fn default() -> Self {
        Self {
            tolerance: 1e-10,
            max_steps: 1_000_000,
            closure: 1e-4,
        }
    }
}

/// Where [`advance`] stopped.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Progress {
    /// At the time asked for.
    Reached,
    /// Before it: the bubble has closed.
    Closed,
}

/// Someone who looks at a bubble in time. Both methods are called in the order of time, the step before the event at
/// its end.
pub trait Watch {
    /// Whether [`Watch::step`] is to be called, with values inside the step (a quarter more work).
    const STEPS: bool = false;
    /// A step was accepted.
    fn step(&mut self, _step: &DenseStep) {}
    /// Something happened.
    fn event(&mut self, _event: &Event) {}
}

/// Nobody looks.
impl Watch for () {}

/// Every event is kept.
impl Watch for Vec<Event> {
    fn event(&mut self, event: &Event) {
        self.push(*event);
    }
}

/// Advances a bubble to a time, s. `state` may be written down after any call and continued: the same calls give the
/// same bits. It does not allocate.
///
/// # Errors
/// [`BubbleError::Backwards`], [`BubbleError::StepLimit`], [`BubbleError::StepTooSmall`]; `state` is then the last good
/// one.
#[allow(clippy::too_many_arguments)]
pub fn advance<M: BubbleModel + ?Sized, D: Driving + ?Sized, W: Watch>(
    model: &M,
    liquid: &Liquid,
    gas: &Gas,
    driving: &D,
    controls: &Controls,
    state: &mut BubbleState,
    until: f64,
    watch: &mut W,
) -> Result<Progress, BubbleError> {
    if until < state.time || until.is_nan() {
        return Err(BubbleError::Backwards {
            time: state.time,
            until,
        });
    }
    let stepping = Stepping {
        model,
        liquid,
        gas,
        driving,
        controls,
        until,
    };
    stepping.run(state, watch)
}
