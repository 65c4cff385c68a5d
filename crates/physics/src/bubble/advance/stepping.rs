//! The loop over steps: size, acceptance, choice of the method.

use super::{Controls, Progress, Watch};
use crate::bubble::energy::powers;
use crate::bubble::model::bubble_pressure;
use crate::bubble::ode::{Rates, Start, Tolerance, Trial, Values, explicit_step, implicit_step};
use crate::bubble::{
    BubbleError, BubbleModel, BubbleState, Driving, Event, EventKind, Gas, Ledger, Liquid, Phase,
    Wall,
};

/// Rejections in a row after which a step is given up.
const MOST_REJECTIONS: u32 = 60;
/// |h lambda| above which an explicit step looks limited by stability (6.1 in DOP853), how often in a row, and the
/// value below which an explicit step would do again.
const STIFF: f64 = 6.1;
const STIFF_STEPS: u32 = 15;
const NOT_STIFF: f64 = 2.0;
const TOO_SMALL: &str = "the law has no answer here (a wall as fast as sound, liquid torn beyond its equation of state, \
                         or surroundings that are not finite numbers)";

/// One call of [`super::advance`].
pub(super) struct Stepping<'a, M: ?Sized, D: ?Sized> {
    pub(super) model: &'a M,
    pub(super) liquid: &'a Liquid,
    pub(super) gas: &'a Gas,
    pub(super) driving: &'a D,
    pub(super) controls: &'a Controls,
    pub(super) until: f64,
}

/// The rates under one law.
pub(super) struct Law<'a, M: ?Sized, D: ?Sized> {
    on: &'a Stepping<'a, M, D>,
    phase: Phase,
}

impl<M: BubbleModel + ?Sized, D: Driving + ?Sized> Rates for Law<'_, M, D> {
    #[inline]
    fn rates(&self, time: f64, radius: f64, velocity: f64) -> Values {
        if radius.is_nan() || radius <= 0.0 {
            return [f64::NAN; 5];
        }
        let ambient = self.on.driving.at(time);
        let wall = Wall {
            radius,
            velocity,
            phase: self.phase,
        };
        let (liquid, gas) = (self.on.liquid, self.on.gas);
        let acceleration = self.on.model.acceleration(liquid, gas, &wall, &ambient);
        let [viscous, radiated, driven] = powers(liquid, gas, &wall, acceleration, &ambient);
        [velocity, acceleration, viscous, radiated, driven]
    }
}

impl<M: BubbleModel + ?Sized, D: Driving + ?Sized> Stepping<'_, M, D> {
    /// Steps until the end, a closed bubble or an error.
    pub(super) fn run(
        &self,
        state: &mut BubbleState,
        watch: &mut impl Watch,
    ) -> Result<Progress, BubbleError> {
        let begin = state.time;
        let tried = state.counters.steps + state.counters.rejected;
        loop {
            if self.closed(state) {
                return Ok(Progress::Closed);
            }
            let remaining = (self.until - state.time) - state.time_rest;
            if remaining <= 0.0 {
                return Ok(Progress::Reached);
            }
            if state.counters.steps + state.counters.rejected - tried >= self.controls.max_steps {
                return Err(BubbleError::StepLimit {
                    max_steps: self.controls.max_steps,
                    start: begin,
                    until: self.until,
                    time: state.time,
                    radius: state.radius,
                    wall_velocity: state.wall_velocity,
                });
            }
            if state.phase.is_none() {
                self.set_off(state, watch);
            }
            self.step(state, remaining, watch)?;
            if self.closed(state) {
                watch.event(&self.event(state, EventKind::Closed));
            }
        }
    }

    fn closed(&self, state: &BubbleState) -> bool {
        self.gas.pressure == 0.0 && state.radius <= self.controls.closure * self.gas.radius
    }

    /// One accepted step.
    fn step(
        &self,
        state: &mut BubbleState,
        remaining: f64,
        watch: &mut impl Watch,
    ) -> Result<(), BubbleError> {
        let law = self.law(state.law);
        let start = self.start(state);
        let tolerance = self.tolerance(state);
        let mut wanted = if state.next_step > 0.0 {
            state.next_step
        } else {
            self.first_step(state).min(remaining)
        };
        for rejections in 0..MOST_REJECTIONS {
            let last = 1.01 * wanted >= remaining;
            let h = if last { remaining } else { wanted };
            let direction = direction(state);
            let trial = self.attempt(&law, state, &start, h, &tolerance, direction, watch);
            if trial.error > 1.0 {
                wanted = h * trial.factor;
                state.counters.rejected += 1;
                continue;
            }
            let grown = h * if rejections == 0 {
                trial.factor
            } else {
                trial.factor.min(1.0)
            };
            // A step cut by the end says little about the size of the next one.
            state.next_step = if last { grown.max(wanted) } else { grown };
            self.judge_stiffness(state, &trial);
            self.accept(state, &law, &start, trial, h, last, watch);
            return Ok(());
        }
        state.next_step = 0.0;
        Err(BubbleError::StepTooSmall {
            model: self.model.name(),
            step: wanted,
            time: state.time,
            radius: state.radius,
            wall_velocity: state.wall_velocity,
            mach: state.wall_velocity / self.liquid.sound_speed,
            reason: TOO_SMALL,
        })
    }

    /// Tries a step with the method in use.
    #[allow(clippy::too_many_arguments)]
    pub(super) fn attempt<W: Watch>(
        &self,
        law: &Law<'_, M, D>,
        state: &BubbleState,
        start: &Start,
        h: f64,
        tolerance: &Tolerance,
        direction: f64,
        _watch: &W,
    ) -> Trial {
        if state.stiff {
            implicit_step(law, start, h, tolerance, direction)
        } else {
            explicit_step(law, start, h, tolerance, direction, W::STEPS)
        }
    }

    /// Moves the state to the end of a step that was accepted, or to the extreme radius inside it.
    #[allow(clippy::too_many_arguments)]
    fn accept<W: Watch>(
        &self,
        state: &mut BubbleState,
        law: &Law<'_, M, D>,
        start: &Start,
        trial: Trial,
        h: f64,
        last: bool,
        watch: &mut W,
    ) {
        let turned = trial.turned || trial.values[1] * direction(state) < 0.0;
        if turned && self.turn(state, law, start, h, watch) {
            return;
        }
        self.move_to(state, &trial.values, h);
        if last {
            (state.time, state.time_rest) = (self.until, 0.0);
        }
        if W::STEPS {
            watch.step(&trial.dense);
        }
        if trial.values[1] * direction(state) < 0.0 {
            // Too weak a turn to be reported (see `turn`).
            let phase = if trial.values[1] > 0.0 {
                Phase::Growth
            } else {
                Phase::Collapse
            };
            self.change_phase(state, phase);
        }
    }

    /// New values and time; the time keeps the part that its last digit loses.
    pub(super) fn move_to(&self, state: &mut BubbleState, values: &Values, h: f64) {
        [state.radius, state.wall_velocity, ..] = *values;
        state.ledger = Ledger {
            viscous: values[2],
            radiated: values[3],
            driven: values[4],
        };
        let step = h + state.time_rest;
        let time = state.time + step;
        state.time_rest = step - (time - state.time);
        state.time = time;
        state.counters.steps += 1;
        state.counters.implicit_steps += u64::from(state.stiff);
    }

    fn judge_stiffness(&self, state: &mut BubbleState, trial: &Trial) {
        if state.stiff {
            if trial.stiffness < NOT_STIFF {
                (state.stiff, state.stiff_steps) = (false, 0);
            }
        } else if trial.stiffness > STIFF {
            state.stiff_steps += 1;
            state.stiff = state.stiff_steps >= STIFF_STEPS;
        } else {
            state.stiff_steps = 0;
        }
    }

    pub(super) fn law(&self, phase: Phase) -> Law<'_, M, D> {
        Law { on: self, phase }
    }

    fn start(&self, state: &BubbleState) -> Start {
        let ledger = &state.ledger;
        Start {
            time: state.time,
            values: [
                state.radius,
                state.wall_velocity,
                ledger.viscous,
                ledger.radiated,
                ledger.driven,
            ],
            rates: self
                .law(state.law)
                .rates(state.time, state.radius, state.wall_velocity),
        }
    }

    /// Pressures that act on the wall, Pa: the scale of what is negligible.
    pub(super) fn pressure_scale(&self, state: &BubbleState) -> f64 {
        let ambient = self.driving.at(state.time).pressure.abs();
        let capillary = 2.0 * self.liquid.surface_tension / state.radius;
        bubble_pressure(self.liquid, self.gas, state.radius) + ambient + capillary
    }

    pub(super) fn tolerance(&self, state: &BubbleState) -> Tolerance {
        let speed = (self.pressure_scale(state) / self.liquid.density).sqrt();
        Tolerance {
            relative: self.controls.tolerance,
            velocity_floor: 1e-6 * speed,
        }
    }

    /// A small part of the time in which the pressures move the wall by its radius.
    fn first_step(&self, state: &BubbleState) -> f64 {
        let speed = (self.pressure_scale(state) / self.liquid.density).sqrt();
        1e-3 * state.radius / (speed + state.wall_velocity.abs())
    }

    /// An event at the present state.
    pub(super) fn event(&self, state: &BubbleState, kind: EventKind) -> Event {
        Event {
            kind,
            time: state.time,
            radius: state.radius,
            bubble_pressure: bubble_pressure(self.liquid, self.gas, state.radius),
            ambient_pressure: self.driving.at(state.time).pressure,
            collapse: None,
        }
    }
}

/// 1 while the bubble grows, -1 while it collapses.
pub(super) fn direction(state: &BubbleState) -> f64 {
    match state.phase {
        Some(Phase::Growth) => 1.0,
        Some(Phase::Collapse) => -1.0,
        None => 0.0,
    }
}
