//! What can go wrong with a bubble.

use thiserror::Error;

/// An error of a bubble's data or of its integration.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum BubbleError {
    /// A quantity outside the range it is defined in.
    #[error("{quantity} is {value:e} {unit}; it must be {allowed}")]
    OutOfRange {
        /// Name of the quantity.
        quantity: &'static str,
        /// Its value, SI.
        value: f64,
        /// Its unit.
        unit: &'static str,
        /// The range in words.
        allowed: &'static str,
    },
    /// No content of gas keeps a bubble of this radius in stable equilibrium at this pressure.
    #[error(
        "a bubble of radius {radius:.4e} m has no stable equilibrium at {pressure:.4e} Pa: the pressure must be above its \
         Blake threshold of {threshold:.4e} Pa; raise the pressure, take a smaller bubble, or give its gas pressure"
    )]
    NoEquilibriumOfRadius {
        /// Radius, m.
        radius: f64,
        /// Pressure of the liquid, Pa.
        pressure: f64,
        /// Blake threshold of a bubble for which this radius is critical, Pa.
        threshold: f64,
    },
    /// This content of gas has no equilibrium at this pressure.
    #[error(
        "a bubble with this gas has no equilibrium at {pressure:.4e} Pa: its Blake threshold is {threshold:.4e} Pa (at the \
         critical radius {critical_radius:.4e} m), below which it grows without bound"
    )]
    NoEquilibriumOfGas {
        /// Pressure of the liquid, Pa.
        pressure: f64,
        /// Blake threshold, Pa.
        threshold: f64,
        /// Radius at the threshold, m.
        critical_radius: f64,
    },
    /// More steps than allowed.
    #[error(
        "the bubble needed more than {max_steps} steps between {start:e} s and {until:e} s and got to {time:e} s (radius \
         {radius:.4e} m, wall velocity {wall_velocity:.4e} m/s); allow more steps or a larger tolerance"
    )]
    StepLimit {
        /// Steps allowed.
        max_steps: u64,
        /// Start of the interval, s.
        start: f64,
        /// End of the interval, s.
        until: f64,
        /// Time reached, s.
        time: f64,
        /// Radius reached, m.
        radius: f64,
        /// Wall velocity reached, m/s.
        wall_velocity: f64,
    },
    /// The time step fell below what time can resolve, or the law gave no finite number.
    #[error(
        "{model}: the time step fell to {step:e} s at {time:e} s (radius {radius:.4e} m, wall velocity {wall_velocity:.4e} m/s, \
         Mach number {mach:.3}): {reason}"
    )]
    StepTooSmall {
        /// Name of the model.
        model: &'static str,
        /// Size of the step, s.
        step: f64,
        /// Time, s.
        time: f64,
        /// Radius, m.
        radius: f64,
        /// Wall velocity, m/s.
        wall_velocity: f64,
        /// Wall velocity / sound speed.
        mach: f64,
        /// Why, in words.
        reason: &'static str,
    },
    /// Time would have to run backwards.
    #[error("the bubble is at {time:e} s already and cannot be advanced to {until:e} s")]
    Backwards {
        /// Time of the bubble, s.
        time: f64,
        /// Time asked for, s.
        until: f64,
    },
}

/// An error unless `value` (SI) is finite and positive, or zero where that is allowed.
pub(super) fn positive(
    quantity: &'static str,
    unit: &'static str,
    value: f64,
    zero_allowed: bool,
) -> Result<(), BubbleError> {
    let good = value.is_finite() && (value > 0.0 || (zero_allowed && value == 0.0));
    let allowed = if zero_allowed {
        "zero or positive"
    } else {
        "positive"
    };
    match good {
        true => Ok(()),
        false => Err(BubbleError::OutOfRange {
            quantity,
            value,
            unit,
            allowed,
        }),
    }
}
