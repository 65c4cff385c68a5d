//! Doing the runs of a plan one after the other: complete ones are skipped, begun ones go on, a failed one stops none.

use super::folder::{Stand, set_aside, stand_of};
use super::plan::Planned;
use crate::output::{RunPaths, Summary};
use crate::run::{self, Observer, Progress, RunError, Start};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

/// Before this share of the first run is done, the time that is left is not told.
const TELLING: f64 = 0.02;
/// Every run counts as at least so many seconds: runs without particles are not free either.
const SHORTEST: f64 = 0.1;

/// What to do, and where.
#[derive(Debug, Clone)]
pub struct Execution<'a> {
    /// The case that all runs start from.
    pub case: &'a Path,
    /// The runs with their folders.
    pub runs: Vec<(&'a Planned, PathBuf)>,
    /// Number of threads; all cores if none.
    pub threads: Option<usize>,
    /// Raised when everything should stop; the run at work writes a checkpoint.
    pub stop: &'a AtomicBool,
}

/// How a run ended.
#[derive(Debug, Clone, PartialEq)]
pub enum Outcome {
    /// It was complete before.
    Kept,
    /// It reached its end.
    Done,
    /// It failed, and why.
    Failed(String),
    /// It was asked to stop.
    Interrupted,
    /// The sweep was stopped before its turn.
    Waiting,
}

impl Outcome {
    /// Whether there are results.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        matches!(self, Self::Kept | Self::Done)
    }

    /// In one word.
    #[must_use]
    pub fn word(&self) -> &'static str {
        match self {
            Self::Kept | Self::Done => "complete",
            Self::Failed(_) => "failed",
            Self::Interrupted => "interrupted",
            Self::Waiting => "waiting",
        }
    }
}

/// Where all runs together stand.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Overall<'a> {
    /// Number of the run at work, from 1.
    pub number: usize,
    /// How many there are.
    pub of: usize,
    /// Its name.
    pub name: &'a str,
    /// Part of its simulated time that is done.
    pub share: f64,
    /// Part of the whole work that is done, as far as it was not there before.
    pub whole: f64,
    /// Seconds until the last run ends; unknown at first.
    pub left: Option<f64>,
}

/// Who watches a sweep.
pub trait Watcher {
    /// A sentence.
    fn say(&mut self, text: &str);
    /// Called about once a second.
    fn progress(&mut self, overall: &Overall);
    /// Called when a run has ended, with the outcomes of all so far.
    fn ended(&mut self, _outcomes: &[Outcome]) {}
}

/// Does the runs. A run that fails, even by a panic, is an outcome like any other.
pub fn execute(what: &Execution, watcher: &mut dyn Watcher) -> Vec<Outcome> {
    let stands: Vec<Stand> = what.runs.iter().map(|(r, f)| stand_of(f, r)).collect();
    let mut outcomes: Vec<Outcome> = stands
        .iter()
        .map(|s| match s {
            Stand::Complete => Outcome::Kept,
            _ => Outcome::Waiting,
        })
        .collect();
    let weight = |k: usize| what.runs[k].0.seconds.max(SHORTEST);
    let open: Vec<usize> = (0..outcomes.len())
        .filter(|k| outcomes[*k] == Outcome::Waiting)
        .collect();
    let total: f64 = open.iter().map(|k| weight(*k)).sum();
    let (begun, mut done) = (Instant::now(), 0.0);
    for k in open {
        if what.stop.load(Ordering::Relaxed) {
            break;
        }
        let (planned, folder) = &what.runs[k];
        let mut inner = Inner {
            watcher,
            number: k + 1,
            of: what.runs.len(),
            name: &planned.name,
            begun,
            done,
            weight: weight(k),
            total,
        };
        let outcome = isolated(|| one(what, planned, folder, &stands[k], &mut inner));
        if let Outcome::Failed(why) = &outcome {
            watcher.say(&format!("{} failed: {why}", planned.name));
        }
        outcomes[k] = outcome;
        done += weight(k);
        watcher.ended(&outcomes);
    }
    outcomes
}

/// A panic of one run is its failure and no end of the others.
fn isolated(work: impl FnOnce() -> Outcome) -> Outcome {
    catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|cause| {
        let text = cause.downcast_ref::<String>().cloned();
        let text = text.or_else(|| cause.downcast_ref::<&str>().map(|t| (*t).to_owned()));
        let text = text.unwrap_or_default();
        Outcome::Failed(format!(
            "a fault of Erode ({text}): please report it with the case"
        ))
    })
}

fn one(
    what: &Execution,
    planned: &Planned,
    folder: &Path,
    stand: &Stand,
    observer: &mut Inner,
) -> Outcome {
    observer.tell(0.0);
    let failed = |e: &dyn std::fmt::Display| Outcome::Failed(e.to_string());
    if *stand == Stand::Unfit {
        match set_aside(folder) {
            Ok(path) => observer.say(&format!(
                "another case, or one without a checkpoint, was moved to {}",
                path.display()
            )),
            Err(e) => return failed(&e),
        }
    }
    let ended = if *stand == Stand::Begun {
        run::resume(folder, what.threads, what.stop, observer)
    } else {
        let start = Start {
            case: what.case.to_path_buf(),
            overrides: planned.overrides.clone(),
            output: folder.to_path_buf(),
            threads: what.threads,
        };
        run::start(&start, what.stop, observer)
    };
    match ended {
        Ok(run::Ended::Done { .. }) => Outcome::Done,
        Ok(run::Ended::Interrupted { .. }) => Outcome::Interrupted,
        Err(RunError::Case(errors)) => failed(&errors),
        Err(error) => failed(&error),
    }
}

/// The final numbers of a complete run.
///
/// # Errors
/// If they cannot be read.
pub(super) fn summary_of(folder: &Path) -> Result<Summary, crate::output::OutputError> {
    Summary::read(&RunPaths::new(folder).summary())
}

/// Hands the progress of one run on as that of all.
struct Inner<'a> {
    watcher: &'a mut dyn Watcher,
    number: usize,
    of: usize,
    name: &'a str,
    begun: Instant,
    /// Estimated seconds of the runs that ended before, of this one, and of all.
    done: f64,
    weight: f64,
    total: f64,
}

impl Inner<'_> {
    fn tell(&mut self, share: f64) {
        let done = self.done + share * self.weight;
        let spent = self.begun.elapsed().as_secs_f64();
        // The estimate of the cost says how the runs compare; the clock says how fast this machine is.
        let known = self.done > 0.0 || share > TELLING;
        let left = known.then(|| spent / done * (self.total - done));
        self.watcher.progress(&Overall {
            number: self.number,
            of: self.of,
            name: self.name,
            share,
            whole: done / self.total,
            left,
        });
    }
}

impl Observer for Inner<'_> {
    fn say(&mut self, text: &str) {
        self.watcher
            .say(&format!("[{}/{}] {text}", self.number, self.of));
    }

    fn progress(&mut self, p: &Progress) {
        self.tell((p.time / p.end_time).clamp(0.0, 1.0));
    }
}
