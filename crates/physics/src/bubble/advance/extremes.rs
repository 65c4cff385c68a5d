//! Largest and smallest radii: found inside a step, then stepped to exactly.

use super::Watch;
use super::stepping::{Law, Stepping, direction};
use crate::bubble::ode::{DenseStep, Rates, Start, Values, explicit_step, implicit_step};
use crate::bubble::{BubbleModel, BubbleState, Collapse, Driving, EventKind, Largest, Phase};

/// An extreme radius whose pressure imbalance is below this fraction of the pressures is rounding and not reported.
const NEGLIGIBLE: f64 = 1e-9;
/// Parts of a step that are searched for the first turn of the wall.
const PARTS: u32 = 16;

impl<M: BubbleModel + ?Sized, D: Driving + ?Sized> Stepping<'_, M, D> {
    /// Which way a bubble at rest sets off. In equilibrium the rate of the pressure decides.
    pub(super) fn set_off(&self, state: &mut BubbleState, watch: &mut impl Watch) {
        let rates = self.law(Phase::Growth).rates(state.time, state.radius, 0.0);
        let significant = self.significant(state, rates[1]);
        let grows = if significant {
            rates[1] > 0.0
        } else {
            self.driving.at(state.time).pressure_rate <= 0.0
        };
        let phase = if grows {
            Phase::Growth
        } else {
            Phase::Collapse
        };
        self.change_phase(state, phase);
        if !grows && significant {
            self.begin_collapse(state, watch);
        }
    }

    /// Turns the wall: the law follows, unless the new law would push straight back (its pressure rate outweighs a
    /// small imbalance); then the old law stays in force, and that is counted.
    pub(super) fn change_phase(&self, state: &mut BubbleState, phase: Phase) {
        state.phase = Some(phase);
        if !self.model.switches() {
            state.law = phase;
            return;
        }
        let push = self.law(phase).rates(state.time, state.radius, 0.0)[1];
        if push * direction(state) >= 0.0 {
            state.law = phase;
        } else {
            state.counters.held += 1;
        }
    }

    /// Looks for the first turn inside the step and moves there. `false`: there is none worth an event.
    pub(super) fn turn<W: Watch>(
        &self,
        state: &mut BubbleState,
        law: &Law<'_, M, D>,
        start: &Start,
        h: f64,
        watch: &mut W,
    ) -> bool {
        let dense = self.trial_at(law, state, start, h).1;
        let Some(fraction) = first_turn(&dense, direction(state)) else {
            return false;
        };
        let (values, length, dense) = self.land(law, state, start, h, fraction);
        let push = law.rates(start.time + length, values[0], 0.0)[1];
        if push * direction(state) >= 0.0 || !self.significant(state, push) {
            return false;
        }
        self.move_to(state, &values, length);
        state.wall_velocity = 0.0;
        if W::STEPS {
            watch.step(&dense);
        }
        match state.phase {
            Some(Phase::Growth) => {
                self.change_phase(state, Phase::Collapse);
                self.begin_collapse(state, watch);
            }
            _ => {
                self.change_phase(state, Phase::Growth);
                self.end_collapse(state, watch);
            }
        }
        true
    }

    /// The step that ends where the wall rests: Newton on its length.
    fn land(
        &self,
        law: &Law<'_, M, D>,
        state: &BubbleState,
        start: &Start,
        h: f64,
        fraction: f64,
    ) -> (Values, f64, DenseStep) {
        let mut length = fraction * h;
        let (mut values, mut dense) = self.trial_at(law, state, start, length);
        for _ in 0..3 {
            let push = law.rates(start.time + length, values[0], values[1])[1];
            let correction = -values[1] / push;
            if !correction.is_finite() || correction.abs() <= f64::EPSILON * length {
                break;
            }
            length = (length + correction).clamp(0.5 * length, h);
            (values, dense) = self.trial_at(law, state, start, length);
        }
        (values, length, dense)
    }

    /// End and inside of a step of a length.
    fn trial_at(
        &self,
        law: &Law<'_, M, D>,
        state: &BubbleState,
        start: &Start,
        h: f64,
    ) -> (Values, DenseStep) {
        let tolerance = self.tolerance(state);
        let trial = if state.stiff {
            implicit_step(law, start, h, &tolerance, 0.0)
        } else {
            explicit_step(law, start, h, &tolerance, 0.0, true)
        };
        (trial.values, trial.dense)
    }

    /// Whether an acceleration at rest is more than rounding.
    fn significant(&self, state: &BubbleState, acceleration: f64) -> bool {
        let imbalance = self.liquid.density * state.radius * acceleration.abs();
        imbalance > NEGLIGIBLE * self.pressure_scale(state)
    }

    fn begin_collapse(&self, state: &mut BubbleState, watch: &mut impl Watch) {
        let event = self.event(state, EventKind::CollapseBegins);
        state.largest = Some(Largest {
            time: state.time,
            radius: state.radius,
            ambient_pressure: event.ambient_pressure,
        });
        watch.event(&event);
    }

    fn end_collapse(&self, state: &mut BubbleState, watch: &mut impl Watch) {
        let mut event = self.event(state, EventKind::SmallestRadius);
        event.collapse = state.largest.map(|begin| Collapse {
            begin,
            end_time: state.time,
            smallest_radius: state.radius,
            peak_pressure: event.bubble_pressure,
        });
        state.counters.collapses += 1;
        watch.event(&event);
    }
}

/// Fraction of the step at which the wall velocity first loses the sign of `direction`. `None` if it does not, or if
/// it never had it.
fn first_turn(dense: &DenseStep, direction: f64) -> Option<f64> {
    let velocity = |x: f64| dense.at_fraction(x)[1] * direction;
    let mut low = 1e-6;
    if velocity(low) < 0.0 {
        return None;
    }
    let mut high = (1..=PARTS)
        .map(|i| f64::from(i) / f64::from(PARTS))
        .find(|&x| {
            let turned = velocity(x) < 0.0;
            if !turned {
                low = x;
            }
            turned
        })?;
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        if velocity(middle) < 0.0 {
            high = middle;
        } else {
            low = middle;
        }
    }
    Some(0.5 * (low + high))
}
