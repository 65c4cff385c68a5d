//! The final numbers of a run of one bubble.

use super::model_name;
use super::record::Record;
use crate::case::bubbles::SingleBubble;
use crate::output::Summary;
use erode_physics::bubble::{
    BubbleState, Driving, blake_pressure, bubble_pressure, critical_radius, equilibrium_radius,
};

/// Rayleigh's collapse time of an empty bubble in units of R sqrt(rho/p) (exact: 0.914681).
const RAYLEIGH: f64 = 0.914_681;

pub(super) fn summary(
    b: &SingleBubble,
    state: &BubbleState,
    record: &Record,
    wall_time: f64,
) -> Summary {
    let mut s = Summary::default();
    s.set("largest_bubble_radius", "m", record.largest[0]);
    s.set("largest_bubble_radius_time", "s", record.largest[1]);
    s.set("smallest_bubble_radius", "m", record.smallest[0]);
    s.set("smallest_bubble_radius_time", "s", record.smallest[1]);
    let peak = bubble_pressure(&b.liquid, &b.gas, record.smallest[0]);
    s.set("max_bubble_pressure", "Pa", peak);
    s.set("max_wall_speed", "m/s", record.largest_speed);
    s.set("max_mach", "-", record.largest_speed / b.liquid.sound_speed);
    s.set_count("collapses", state.counters.collapses);
    s.set_count("closed", u64::from(record.closed));
    rest(&mut s, b);
    s.set("energy_drift", "-", record.drift());
    s.set("energy_residual", "J", record.worst);
    s.set_count("steps", state.counters.steps);
    s.set_count("rejected_steps", state.counters.rejected);
    s.set_count("implicit_steps", state.counters.implicit_steps);
    s.set_count("held_laws", state.counters.held);
    s.set("end_time", "s", state.time);
    s.set("wall_time", "s", wall_time);
    s.set_version("erode", env!("CARGO_PKG_VERSION"));
    let ambient = b
        .ambient_pressure
        .between(state.time, state.time)
        .at(state.time);
    let e = state.energy(&b.liquid, &b.gas, &ambient);
    let entries = [
        ("kinetic", e.kinetic),
        ("potential", e.potential),
        ("gas", e.gas),
        ("viscous", e.viscous),
        ("radiated", e.radiated),
        ("driven", e.driven),
    ];
    for (name, value) in entries {
        s.set_ledger(name, "J", value);
    }
    s.set_limiter(
        &format!("tolerance_{}", model_name(b)),
        state.counters.steps,
    );
    s
}

/// Equilibrium and Blake threshold at the pressure of the start.
fn rest(s: &mut Summary, b: &SingleBubble) {
    let pressure = b.ambient_pressure.at_start();
    let none = f64::NAN;
    let radius = equilibrium_radius(&b.liquid, &b.gas, pressure).unwrap_or(none);
    s.set("equilibrium_radius", "m", radius);
    s.set("critical_radius", "m", critical_radius(&b.liquid, &b.gas));
    s.set("blake_pressure", "Pa", blake_pressure(&b.liquid, &b.gas));
    let excess = pressure - b.liquid.vapour_pressure;
    if excess > 0.0 {
        let time = RAYLEIGH * b.radius * (b.liquid.density / excess).sqrt();
        s.set("rayleigh_time", "s", time);
    }
}
