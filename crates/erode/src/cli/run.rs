//! `erode run` and `erode resume`: the run with its progress bar, signals and exit codes.

use super::{
    args::{ResumeArgs, RunArgs},
    failure::{Failure, INTERRUPTED, Outcome},
    names::telling_name,
    progress::Screen,
    say::say,
};
use erode::run::{self, Ended, Observer, Progress, RunError, Start};
use std::{
    path::{Path, PathBuf},
    sync::{Arc, atomic::AtomicBool},
};

/// Runs a case.
pub(crate) fn run(args: &RunArgs) -> Outcome {
    let output = args
        .output
        .clone()
        .unwrap_or_else(|| default_folder(&args.case));
    let options = Start {
        case: args.case.clone(),
        overrides: args.set.clone(),
        output: output.clone(),
        threads: args.threads.map(usize::from),
    };
    let stop = stop_flag()?;
    let ended = run::start(&options, &stop, &mut Screen::new());
    conclude(ended, &output)
}

/// Goes on with a run.
pub(crate) fn resume(args: &ResumeArgs) -> Outcome {
    let stop = stop_flag()?;
    let ended = run::resume(
        &args.dir,
        args.threads.map(usize::from),
        &stop,
        &mut Screen::new(),
    );
    conclude(ended, &args.dir)
}

/// `runs/NAME`, NAME being the case's folder or file; a number is added when that is taken.
fn default_folder(case: &Path) -> PathBuf {
    let name = telling_name(case, "case").unwrap_or_else(|| "run".into());
    let first = PathBuf::from("runs").join(&name);
    let numbered = (2..).map(|k| PathBuf::from("runs").join(format!("{name}-{k}")));
    std::iter::once(first)
        .chain(numbered)
        .find(|p| !p.exists())
        .unwrap_or_default()
}

/// Raised by Ctrl-C and SIGTERM; a second signal ends the program at once.
pub(super) fn stop_flag() -> Result<Arc<AtomicBool>, Failure> {
    let stop = Arc::new(AtomicBool::new(false));
    for signal in [signal_hook::consts::SIGINT, signal_hook::consts::SIGTERM] {
        let registered = signal_hook::flag::register_conditional_shutdown(
            signal,
            i32::from(INTERRUPTED),
            stop.clone(),
        )
        .and_then(|_| signal_hook::flag::register(signal, stop.clone()));
        registered.map_err(|e| Failure::failed(format!("signals cannot be handled: {e}"), ""))?;
    }
    Ok(stop)
}

fn conclude(ended: Result<Ended, RunError>, folder: &Path) -> Outcome {
    match ended {
        Ok(Ended::Done { report }) => {
            say!("done; report: {}", report.display());
            Ok(())
        }
        Ok(Ended::Interrupted { time }) => Err(Failure::Other {
            code: INTERRUPTED,
            message: format!("interrupted at t = {time:.4e} s; a checkpoint is written"),
            help: format!("`erode resume {}` goes on", folder.display()),
        }),
        Err(error) => Err(failure(error)),
    }
}

fn failure(error: RunError) -> Failure {
    match error {
        RunError::Case(errors) => errors.into(),
        RunError::Output(e) => e.into(),
        RunError::Packing { .. } | RunError::Unsupported { .. } | RunError::Solid { .. } => {
            let help = "`erode check CASE` shows the bodies and their spacing";
            Failure::input(error.to_string(), help)
        }
        _ => Failure::failed(error.to_string(), ""),
    }
}

impl Observer for Screen {
    fn say(&mut self, text: &str) {
        Screen::say(self, text);
    }

    fn progress(&mut self, p: &Progress) {
        let left = (p.end_time - p.time).max(0.0) / p.dt / p.steps_per_second;
        let ledger = (p.energy_drift)
            .map(|drift| format!(", ledger {:+.2} %", 100.0 * drift))
            .unwrap_or_default();
        let stage = p.stage.map(|s| format!("{s}, ")).unwrap_or_default();
        let text = format!(
            "{stage}t = {:.4} of {:.4} us, {:.0} s left, {:.0} steps/s, dt {:.3e} s ({}){ledger}",
            p.time * 1e6,
            p.end_time * 1e6,
            left,
            p.steps_per_second,
            p.dt,
            p.limiter
        );
        self.show(p.time / p.end_time, text, false);
    }

    fn finish(&mut self) {
        Screen::finish(self);
    }
}
