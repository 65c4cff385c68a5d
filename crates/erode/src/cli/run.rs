//! `erode run` and `erode resume`: the run with its progress bar, signals and exit codes.

use super::{
    args::{ResumeArgs, RunArgs},
    failure::{FAILED, Failure, INTERRUPTED, Outcome, WRONG_INPUT},
    say::{say, say_if_heard},
};
use erode::run::{self, Ended, Observer, Progress, RunError, Start};
use indicatif::{ProgressBar, ProgressStyle};
use std::{
    io::IsTerminal,
    path::{Path, PathBuf},
    sync::{Arc, atomic::AtomicBool},
    time::{Duration, Instant},
};

/// Positions of the bar: per mille of the simulated time.
const BAR: u64 = 1000;
/// Without a terminal, one line of progress in so many seconds.
const LINE_EVERY: Duration = Duration::from_secs(10);

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
    let folder = if case.is_dir() || case.file_stem().is_none_or(|s| s != "case") {
        Some(case)
    } else {
        case.parent()
    };
    let name = folder
        .and_then(Path::file_stem)
        .map_or("run".into(), |s| s.to_string_lossy().into_owned());
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
        if let Err(e) = registered {
            return Err(Failure::Other {
                code: FAILED,
                message: format!("signals cannot be handled: {e}"),
                help: String::new(),
            });
        }
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
        Err(RunError::Case(errors)) => Err(errors.into()),
        Err(error) => Err(failure(&error)),
    }
}

fn failure(error: &RunError) -> Failure {
    let (code, help) = match error {
        RunError::Output(e) => {
            use erode::output::OutputError::{Locked, NotAFolder, NotARun, NotWritable, Occupied};
            let wrong = matches!(
                e,
                Occupied { .. }
                    | NotAFolder { .. }
                    | NotWritable { .. }
                    | NotARun { .. }
                    | Locked { .. }
            );
            (if wrong { WRONG_INPUT } else { FAILED }, e.hint())
        }
        RunError::Packing { .. } | RunError::Unsupported { .. } | RunError::Solid { .. } => (
            WRONG_INPUT,
            "`erode check CASE` shows the bodies and their spacing".to_owned(),
        ),
        _ => (FAILED, String::new()),
    };
    Failure::Other {
        code,
        message: error.to_string(),
        help,
    }
}

/// A bar on a terminal, plain lines elsewhere.
struct Screen {
    bar: Option<ProgressBar>,
    line: Instant,
}

impl Screen {
    fn new() -> Self {
        let bar = std::io::stderr().is_terminal().then(|| {
            let bar = ProgressBar::new(BAR);
            let style = ProgressStyle::with_template("[{bar:30}] {percent}% {msg}");
            bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
            bar
        });
        Self {
            bar,
            line: Instant::now() - LINE_EVERY,
        }
    }
}

impl Observer for Screen {
    fn say(&mut self, text: &str) {
        match &self.bar {
            Some(bar) => bar.println(text),
            None => say_if_heard(text),
        }
    }

    fn progress(&mut self, p: &Progress) {
        let left = (p.end_time - p.time).max(0.0) / p.dt / p.steps_per_second;
        let ledger = (p.energy_drift)
            .map(|drift| format!(", ledger {:+.2} %", 100.0 * drift))
            .unwrap_or_default();
        let text = format!(
            "t = {:.4} of {:.4} us, {:.0} s left, {:.0} steps/s, dt {:.3e} s ({}){ledger}",
            p.time * 1e6,
            p.end_time * 1e6,
            left,
            p.steps_per_second,
            p.dt,
            p.limiter
        );
        match &self.bar {
            Some(bar) => {
                bar.set_position((p.time / p.end_time * BAR as f64) as u64);
                bar.set_message(text);
            }
            None if self.line.elapsed() >= LINE_EVERY => {
                self.line = Instant::now();
                say_if_heard(&text);
            }
            None => {}
        }
    }

    fn finish(&mut self) {
        if let Some(bar) = self.bar.take() {
            bar.finish_and_clear();
        }
    }
}
