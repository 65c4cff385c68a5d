//! `erode status` and `erode report`.

use super::{
    args::{ReportArgs, StatusArgs},
    failure::{FAILED, Failure, Outcome, WRONG_INPUT},
    say::say,
};
use erode::output::{RunPaths, State, Status};

/// Prints where a run stands.
pub(crate) fn status(args: &StatusArgs) -> Outcome {
    let wrong = |e: erode::output::OutputError| {
        let help = e.hint();
        Failure::input(e.to_string(), help)
    };
    let paths = RunPaths::existing(&args.dir).map_err(wrong)?;
    let s = Status::read(&paths.status()).map_err(wrong)?;
    let killed = s.state == State::Running && paths.holder().is_none();
    let state = match s.state {
        State::Running if killed => "stopped without a word (killed?): `erode resume` goes on",
        State::Running => "running",
        State::Done => "done",
        State::Failed => "failed",
        State::Interrupted => "interrupted: `erode resume` goes on",
    };
    say!("state      {state}");
    say!(
        "time       {:.4e} s of {:.4e} s ({:.1} %)",
        s.time,
        s.end_time,
        100.0 * s.time / s.end_time
    );
    say!(
        "step       {} (dt {:.3e} s, limited by {})",
        s.step,
        s.dt,
        s.limiter
    );
    if let (Some(rate), Some(eta)) = (s.steps_per_second, s.eta) {
        say!("speed      {rate:.1} steps/s, {eta:.0} s left");
    }
    if let Some(drift) = s.energy_drift {
        say!("ledger     {:+.3} %", 100.0 * drift);
    }
    if let Some(message) = s.message {
        say!("message    {message}");
    }
    Ok(())
}

/// Rebuilds a report.
pub(crate) fn report(args: &ReportArgs) -> Outcome {
    match erode::report::build(&args.dir) {
        Ok(path) => {
            say!("report: {}", path.display());
            Ok(())
        }
        Err(e) => {
            use erode::report::ReportError::{NoFolder, NotARun};
            let code = if matches!(e, NoFolder { .. } | NotARun { .. }) {
                WRONG_INPUT
            } else {
                FAILED
            };
            Err(Failure::Other {
                code,
                message: e.to_string(),
                help: String::new(),
            })
        }
    }
}
