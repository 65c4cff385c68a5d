//! Doing the runs of a plan one after the other: complete ones are skipped, begun ones go on, a failed one stops none.

use super::folder::{Stand, Unfit, set_aside, stand_of};
use super::plan::Planned;
use crate::output::{OutputError, RunPaths, Summary};
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
    let weight = |k: usize| {
        let cost = what.runs[k].0.cost;
        cost.map_or(SHORTEST, |c| c.seconds.max(SHORTEST))
    };
    let open: Vec<usize> = (0..outcomes.len())
        .filter(|k| outcomes[*k] == Outcome::Waiting)
        .collect();
    let mut work = Work {
        begun: Instant::now(),
        done: 0.0,
        total: open.iter().map(|k| weight(*k)).sum(),
    };
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
            work,
            weight: weight(k),
            first: 0.0,
            share: 0.0,
        };
        let outcome = isolated(|| one(what, planned, folder, &stands[k], &mut inner));
        work = inner.work_after(&outcome);
        if let Outcome::Failed(why) = &outcome {
            watcher.say(&format!("{} failed: {why}", planned.name));
        }
        outcomes[k] = outcome;
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
    let mut unfit = match stand {
        Stand::Unfit(why) => Some(*why),
        _ => None,
    };
    let mut resumed = None;
    if *stand == Stand::Begun {
        match run::resume(folder, what.threads, what.stop, observer) {
            Err(RunError::Output(error @ OutputError::NoCheckpoint { .. })) => {
                observer.say(&error.to_string());
                unfit = Some(Unfit::NoCheckpoint);
            }
            ended => resumed = Some(ended),
        }
    }
    if let Some(why) = unfit {
        match set_aside(folder) {
            Ok(path) => observer.say(&format!("a run {why} was moved to {}", path.display())),
            Err(e) => return failed(&e),
        }
    }
    let ended = resumed.unwrap_or_else(|| {
        let start = Start {
            case: what.case.to_path_buf(),
            overrides: planned.overrides.clone(),
            output: folder.to_path_buf(),
            threads: what.threads,
        };
        run::start(&start, what.stop, observer)
    });
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
pub(super) fn summary_of(folder: &Path) -> Result<Summary, OutputError> {
    Summary::read(&RunPaths::new(folder).summary())
}

/// What this call has done so far, in estimated seconds; what was there before it is in none of them.
#[derive(Debug, Clone, Copy)]
struct Work {
    begun: Instant,
    done: f64,
    total: f64,
}

/// Hands the progress of one run on as that of all.
struct Inner<'a> {
    watcher: &'a mut dyn Watcher,
    number: usize,
    of: usize,
    name: &'a str,
    /// Of the runs before this one.
    work: Work,
    /// Estimated seconds of this one.
    weight: f64,
    /// Part of it that was done before.
    first: f64,
    /// Part of it that is done.
    share: f64,
}

impl Inner<'_> {
    /// The work with this run as far as it is.
    fn work_now(&self) -> Work {
        Work {
            done: self.work.done + (self.share - self.first) * self.weight,
            total: self.work.total - self.first * self.weight,
            ..self.work
        }
    }

    /// The work when this run has ended: of one that failed, what it did not do is no longer to be done.
    fn work_after(&self, outcome: &Outcome) -> Work {
        let now = self.work_now();
        let rest = (1.0 - self.share) * self.weight;
        match outcome {
            Outcome::Failed(_) => Work {
                total: now.total - rest,
                ..now
            },
            _ => Work {
                done: now.done + rest,
                ..now
            },
        }
    }

    fn tell(&mut self, share: f64) {
        self.share = share;
        let work = self.work_now();
        let spent = work.begun.elapsed().as_secs_f64();
        // The estimate of the cost says how the runs compare; the clock says how fast this machine is.
        let known = work.done > TELLING * self.weight;
        let left = known.then(|| spent / work.done * (work.total - work.done));
        self.watcher.progress(&Overall {
            number: self.number,
            of: self.of,
            name: self.name,
            share,
            whole: work.done / work.total,
            left,
        });
    }
}

/// Part of the simulated time that is done.
fn share_of(p: &Progress) -> f64 {
    (p.time / p.end_time).clamp(0.0, 1.0)
}

impl Observer for Inner<'_> {
    fn say(&mut self, text: &str) {
        self.watcher
            .say(&format!("[{}/{}] {text}", self.number, self.of));
    }

    fn begin(&mut self, p: &Progress) {
        (self.first, self.share) = (share_of(p), share_of(p));
    }

    fn progress(&mut self, p: &Progress) {
        self.tell(share_of(p));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    /// Keeps what it is told.
    #[derive(Default)]
    struct Ear(Vec<(f64, Option<f64>)>);

    impl Watcher for Ear {
        fn say(&mut self, _: &str) {}

        fn progress(&mut self, o: &Overall) {
            self.0.push((o.whole, o.left));
        }
    }

    fn at(time: f64) -> Progress<'static> {
        Progress {
            time,
            end_time: 1.0,
            step: 0,
            steps_per_second: 0.0,
            dt: 0.1,
            limiter: "",
            energy_drift: None,
            stage: None,
        }
    }

    /// The second of two equal runs of 100 s goes on at 0.8 of its time, ten seconds after the first has begun and ended.
    fn second(ear: &mut Ear) -> Inner<'_> {
        Inner {
            watcher: ear,
            number: 2,
            of: 2,
            name: "b",
            work: Work {
                begun: Instant::now() - Duration::from_secs(10),
                done: 100.0,
                total: 200.0,
            },
            weight: 100.0,
            first: 0.0,
            share: 0.0,
        }
    }

    #[test]
    fn what_a_run_had_done_before_is_neither_done_nor_left() {
        let mut ear = Ear::default();
        let mut inner = second(&mut ear);
        inner.begin(&at(0.8));
        inner.progress(&at(0.9));
        // 110 of 120 are done in 10 s: 0.9 s are left. With the first 80 counted it would be 0.5 s.
        let after = inner.work_after(&Outcome::Done);
        assert!((after.done - 120.0).abs() < 1e-9 && (after.total - 120.0).abs() < 1e-9);
        let (whole, left) = ear.0[0];
        assert!((whole - 110.0 / 120.0).abs() < 1e-9, "{whole}");
        assert!((left.unwrap() - 10.0 / 11.0).abs() < 0.02, "{left:?}");
    }

    #[test]
    fn what_a_failed_run_left_undone_is_no_longer_to_be_done() {
        let mut ear = Ear::default();
        let mut inner = second(&mut ear);
        inner.begin(&at(0.0));
        inner.progress(&at(0.25));
        let after = inner.work_after(&Outcome::Failed(String::new()));
        assert!((after.done - 125.0).abs() < 1e-9 && (after.total - 125.0).abs() < 1e-9);
    }
}
