//! `status.json` of a run from its progress.

use super::observer::Progress;
use crate::output::{State, Status};

/// Where a run with this progress stands.
pub(super) fn of(p: &Progress<'_>, state: State, message: Option<&str>) -> Status {
    let rate = (state == State::Running && p.steps_per_second > 0.0).then_some(p.steps_per_second);
    Status {
        state,
        time: p.time,
        end_time: p.end_time,
        step: p.step,
        dt: p.dt,
        limiter: p.limiter.to_owned(),
        steps_per_second: rate,
        eta: rate.map(|r| (p.end_time - p.time).max(0.0) / p.dt / r),
        energy_drift: p.energy_drift,
        pid: std::process::id(),
        message: message
            .map(str::to_owned)
            .or_else(|| p.stage.map(|s| s.to_string())),
    }
}
