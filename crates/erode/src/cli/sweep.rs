//! `erode sweep`: the plan with its cost, the runs with their progress, the results.

use super::{
    args::SweepArgs,
    failure::{FAILED, Failure, INTERRUPTED, Outcome, WRONG_INPUT},
    format::{columns, count, duration},
    run::stop_flag,
    say::{say, say_if_heard},
};
use erode::case::estimate::PARTICLE_STEPS_PER_SECOND;
use erode::output::{OutputError, lock::RunLock};
use erode::sweep::{
    self, Execution, Folder, Overall, Plan, Planned, Results, Stand, SweepError, Watcher, stand_of,
};
use indicatif::{ProgressBar, ProgressStyle};
use std::{
    fs,
    io::IsTerminal,
    path::{Path, PathBuf},
    time::{Duration, Instant},
};

/// Positions of the bar: per mille of the work.
const BAR: u64 = 1000;
/// Without a terminal, one line of progress in so many seconds.
const LINE_EVERY: Duration = Duration::from_secs(10);

/// Plans a sweep, does its runs, writes its results.
pub(crate) fn sweep(args: &SweepArgs) -> Outcome {
    let plan = Plan::read(&args.file, args.quick).map_err(|e| failure(e, &args.file))?;
    let root = args.output.clone();
    let folder = Folder::new(root.unwrap_or_else(|| default_folder(&args.file, args.quick)));
    let agree = || {
        let agreed = folder.agree(&plan, args.accept_changes);
        agreed.map_err(|e| failure(e, &args.file))
    };
    agree()?;
    print_plan(&plan, &folder);
    if args.dry_run {
        return Ok(());
    }
    fs::create_dir_all(folder.root()).map_err(|cause| {
        let path = folder.root().to_path_buf();
        output(OutputError::NotWritable { path, cause })
    })?;
    let _lock = RunLock::acquire(folder.root()).map_err(output)?;
    // Another process may have recorded a plan of its own before the lock was ours.
    agree()?;
    folder.record(&plan).map_err(output)?;
    let stop = stop_flag()?;
    let runs = plan.runs.iter().map(|r| (r, folder.run(&r.name)));
    let execution = Execution {
        case: &plan.case,
        runs: runs.collect(),
        threads: args.threads.map(usize::from),
        stop: &stop,
    };
    let mut screen = Screen::new(Some((&plan, &folder)));
    let outcomes = sweep::execute(&execution, &mut screen);
    screen.finish();
    let results = Results::read(&plan, &folder, &outcomes);
    folder
        .write_results(&results.table(&plan))
        .map_err(output)?;
    let report =
        sweep::write_report(&plan, &folder, &results).map_err(|e| failure(e, &args.file))?;
    say!("results: {}", folder.csv().display());
    say!("report: {}", report.display());
    if let Some(file) = &args.json {
        write_json(file, &plan, &results)?;
    }
    conclude(&plan, &results)
}

/// `sweeps/NAME`, NAME being the file's, or that of its folder if the file is `sweep.toml`.
fn default_folder(file: &Path, quick: bool) -> PathBuf {
    let stem = |p: &Path| p.file_stem().map(|s| s.to_string_lossy().into_owned());
    let own = stem(file).filter(|s| s != "sweep");
    let name = own
        .or_else(|| stem(file.parent()?))
        .unwrap_or_else(|| "sweep".into());
    let form = if quick { "-quick" } else { "" };
    PathBuf::from("sweeps").join(format!("{name}{form}"))
}

/// Every run with its cost and where it stands.
fn print_plan(plan: &Plan, folder: &Folder) {
    say!("{}", plan.title);
    let runs = plan.runs.iter().map(|r| (r, folder.run(&r.name)));
    print_runs(&runs.collect::<Vec<_>>());
    say!("into {}", folder.root().display());
}

/// Runs with their folders: cost, where each stands, what is left in all.
pub(super) fn print_runs(runs: &[(&Planned, PathBuf)]) {
    let mut left = 0.0;
    let mut rows = vec![
        ["run", "particles", "steps", "time", ""]
            .map(str::to_owned)
            .to_vec(),
    ];
    for (run, folder) in runs {
        let stand = stand_of(folder, run);
        if stand != Stand::Complete {
            left += run.seconds;
        }
        let number = |x: f64| if x > 0.0 { count(x) } else { "-".into() };
        let word = match stand {
            Stand::New => "",
            Stand::Complete => "complete",
            Stand::Begun => "begun: goes on",
            Stand::Unfit => "of another case: set aside, begins anew",
        };
        rows.push(vec![
            run.name.clone(),
            number(run.particles),
            number(run.steps),
            duration(run.seconds),
            word.into(),
        ]);
    }
    columns(&rows).iter().for_each(|l| say!("  {l}"));
    say!(
        "{} runs, {} left at an assumed {} million particle steps per second",
        runs.len(),
        duration(left),
        PARTICLE_STEPS_PER_SECOND / 1e6
    );
}

fn conclude(plan: &Plan, results: &Results) -> Outcome {
    use sweep::Outcome as O;
    let outcomes = &results.outcomes;
    let complete = outcomes.iter().filter(|o| o.is_complete()).count();
    say!("{complete} of {} runs complete", plan.runs.len());
    let failed: Vec<String> = plan
        .runs
        .iter()
        .zip(outcomes)
        .filter_map(|(run, o)| match o {
            O::Failed(why) => Some(format!("{}: {why}", run.name)),
            _ => None,
        })
        .collect();
    if outcomes
        .iter()
        .any(|o| matches!(o, O::Interrupted | O::Waiting))
    {
        return Err(Failure::Other {
            code: INTERRUPTED,
            message: "interrupted; what is complete is kept, checkpoints are written".into(),
            help: "the same command goes on".into(),
        });
    }
    if failed.is_empty() {
        return Ok(());
    }
    Err(Failure::Other {
        code: FAILED,
        message: format!("{} run(s) failed:\n  {}", failed.len(), failed.join("\n  ")),
        help:
            "the same command tries them again from their last checkpoint; all others are complete"
                .into(),
    })
}

fn write_json(file: &Path, plan: &Plan, results: &Results) -> Outcome {
    let runs = plan
        .runs
        .iter()
        .zip(&results.outcomes)
        .zip(&results.summaries);
    let runs: Vec<serde_json::Value> = runs
        .map(|((run, outcome), summary)| {
            serde_json::json!({
                "run": run.name, "state": outcome.word(), "set": run.overrides, "case_hash": run.hash, "summary": summary,
            })
        })
        .collect();
    let wrong = |e: &dyn std::fmt::Display| Failure::Other {
        code: FAILED,
        message: format!("{} cannot be written: {e}", file.display()),
        help: String::new(),
    };
    let text = serde_json::to_string_pretty(&runs).map_err(|e| wrong(&e))?;
    std::fs::write(file, text + "\n").map_err(|e| wrong(&e))
}

fn failure(error: SweepError, file: &Path) -> Failure {
    match error {
        SweepError::Case(errors) => errors.into(),
        SweepError::Output(e) => output(e),
        changed @ SweepError::Changed { .. } => Failure::Other {
            code: WRONG_INPUT,
            message: changed.to_string(),
            help: format!(
                "undo the change, or choose another folder with -o DIR; `erode sweep {} --accept-changes` keeps the runs \
                 whose case is the same and sets the others aside",
                file.display()
            ),
        },
    }
}

pub(super) fn output(e: OutputError) -> Failure {
    let code = match &e {
        OutputError::Write { .. } | OutputError::Read { .. } => FAILED,
        _ => WRONG_INPUT,
    };
    Failure::Other {
        code,
        message: e.to_string(),
        help: e.hint(),
    }
}

/// A bar on a terminal, plain lines elsewhere; the table is written anew after each run.
pub(super) struct Screen<'a> {
    bar: Option<ProgressBar>,
    line: Instant,
    table: Option<(&'a Plan, &'a Folder)>,
}

impl<'a> Screen<'a> {
    pub(super) fn new(table: Option<(&'a Plan, &'a Folder)>) -> Self {
        let bar = std::io::stderr().is_terminal().then(|| {
            let bar = ProgressBar::new(BAR);
            let style = ProgressStyle::with_template("[{bar:30}] {percent}% {msg}");
            bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
            bar
        });
        Self {
            bar,
            line: Instant::now(),
            table,
        }
    }

    pub(super) fn finish(&mut self) {
        if let Some(bar) = self.bar.take() {
            bar.finish_and_clear();
        }
    }
}

impl Watcher for Screen<'_> {
    fn say(&mut self, text: &str) {
        match &self.bar {
            Some(bar) => bar.println(text),
            None => say_if_heard(text),
        }
    }

    fn progress(&mut self, o: &Overall) {
        let left = o.left.map_or("time left unknown".into(), |s| {
            format!("{} left", duration(s))
        });
        let text = format!(
            "run {} of {} ({}), {:.0} %; all: {:.0} %, {left}",
            o.number,
            o.of,
            o.name,
            100.0 * o.share,
            100.0 * o.whole
        );
        match &self.bar {
            Some(bar) => {
                bar.set_position((o.whole * BAR as f64) as u64);
                bar.set_message(text);
            }
            None if o.share == 0.0 || self.line.elapsed() >= LINE_EVERY => {
                self.line = Instant::now();
                say_if_heard(&text);
            }
            None => {}
        }
    }

    fn ended(&mut self, outcomes: &[sweep::Outcome]) {
        let Some((plan, folder)) = self.table else {
            return;
        };
        let results = Results::read(plan, folder, outcomes);
        if let Err(e) = folder.write_results(&results.table(plan)) {
            // It is written again at the end, and an error is an error there.
            self.say(&format!("the table of results could not be written: {e}"));
        }
    }
}
