//! `erode sweep`: the plan with its cost, the runs with their progress, the results.

use super::{
    args::SweepArgs,
    failure::{Failure, INTERRUPTED, Outcome},
    format::{columns, count, duration},
    json,
    names::telling_name,
    progress::Screen,
    run::stop_flag,
    say::say,
};
use erode::case::estimate::PARTICLE_STEPS_PER_SECOND;
use erode::output::{OutputError, lock::RunLock};
use erode::sweep::{
    self, Execution, Folder, Overall, Plan, Planned, Results, Stand, SweepError, Watcher, stand_of,
};
use std::{
    fs,
    path::{Path, PathBuf},
};

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
        OutputError::NotWritable { path, cause }
    })?;
    let _lock = RunLock::acquire(folder.root())?;
    // Another process may have recorded a plan of its own before the lock was ours.
    agree()?;
    folder.record(&plan)?;
    let stop = stop_flag()?;
    let runs = plan.runs.iter().map(|r| (r, folder.run(&r.name)));
    let execution = Execution {
        case: &plan.case,
        runs: runs.collect(),
        threads: args.threads.map(usize::from),
        stop: &stop,
    };
    let mut audience = Audience::new(Some((&plan, &folder)));
    let outcomes = sweep::execute(&execution, &mut audience);
    audience.screen.finish();
    let results = Results::read(&plan, &folder, &outcomes);
    folder.write_results(&results.table(&plan))?;
    let report =
        sweep::write_report(&plan, &folder, &results).map_err(|e| failure(e, &args.file))?;
    say!("results: {}", folder.csv().display());
    say!("report: {}", report.display());
    let ended = conclude(&plan, &results);
    json::write_and_end(args.json.as_deref(), &rows(&plan, &results), ended)
}

/// `sweeps/NAME`, NAME being the file's, or that of its folder if the file is `sweep.toml`.
fn default_folder(file: &Path, quick: bool) -> PathBuf {
    let name = telling_name(file, "sweep").unwrap_or_else(|| "sweep".into());
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
    let mut rows = vec![
        ["run", "particles", "steps", "time", ""]
            .map(str::to_owned)
            .to_vec(),
    ];
    let mut open = Vec::new();
    for (run, folder) in runs {
        let stand = stand_of(folder, run);
        if stand != Stand::Complete {
            open.push(*run);
        }
        let word = match stand {
            Stand::New => String::new(),
            Stand::Complete => "complete".into(),
            Stand::Begun => "begun: goes on".into(),
            Stand::Unfit(why) => format!("{why}: set aside, begins anew"),
        };
        let [particles, steps, time] = match run.cost {
            Some(c) => [count(c.particles), count(c.steps), duration(c.seconds)],
            None => ["-", "-", "unknown"].map(str::to_owned),
        };
        rows.push(vec![run.name.clone(), particles, steps, time, word]);
    }
    columns(&rows).iter().for_each(|l| say!("  {l}"));
    say!("{} runs, {}", runs.len(), left(&open));
}

/// What is left to be done, in words.
fn left(open: &[&Planned]) -> String {
    let known = open.iter().filter_map(|r| r.cost).map(|c| c.seconds);
    let seconds: f64 = known.clone().sum();
    let unknown = open.len() - known.count();
    let assumed = format!(
        "{} left at an assumed {} million particle steps per second",
        duration(seconds),
        PARTICLE_STEPS_PER_SECOND / 1e6
    );
    match (open.len(), unknown) {
        (0, _) => "none left".into(),
        (_, 0) => assumed,
        (n, unknown) if n == unknown => {
            format!("{n} left; what they cost is not known before (they have no particles)")
        }
        (_, unknown) => format!("{assumed}, and {unknown} of which the cost is not known"),
    }
}

fn conclude(plan: &Plan, results: &Results) -> Outcome {
    use sweep::Outcome as O;
    let outcomes = &results.outcomes;
    let complete = outcomes.iter().filter(|o| o.is_complete()).count();
    say!("{complete} of {} runs complete", plan.runs.len());
    let named = plan.runs.iter().zip(outcomes);
    let failed: Vec<String> = named
        .filter_map(|(run, o)| match o {
            O::Failed(why) => Some(format!("{}: {why}", run.name)),
            _ => None,
        })
        .collect();
    let told = format!("{} run(s) failed:\n  {}", failed.len(), failed.join("\n  "));
    let stopped = |o: &O| matches!(o, O::Interrupted | O::Waiting);
    if outcomes.iter().any(stopped) {
        let mut message =
            "interrupted; what is complete is kept, checkpoints are written".to_owned();
        if !failed.is_empty() {
            message = format!("{message}; before that, {told}");
        }
        return Err(Failure::Other {
            code: INTERRUPTED,
            message,
            help: "the same command goes on".into(),
        });
    }
    if failed.is_empty() {
        return Ok(());
    }
    let help = "the same command tries them again, from their last checkpoint where there is one; all others are complete";
    Err(Failure::failed(told, help))
}

/// One entry per run, for `--json`.
fn rows(plan: &Plan, results: &Results) -> Vec<serde_json::Value> {
    let runs = plan
        .runs
        .iter()
        .zip(&results.outcomes)
        .zip(&results.summaries);
    let row = |((run, outcome), summary): ((&Planned, &sweep::Outcome), _)| {
        let message = match outcome {
            sweep::Outcome::Failed(why) => Some(why),
            _ => None,
        };
        serde_json::json!({
            "run": run.name, "state": outcome.word(), "message": message, "set": run.overrides, "case_hash": run.hash,
            "summary": summary,
        })
    };
    runs.map(row).collect()
}

fn failure(error: SweepError, file: &Path) -> Failure {
    match error {
        SweepError::Case(errors) => errors.into(),
        SweepError::Output(e) => e.into(),
        changed @ SweepError::Changed { .. } => {
            let help = format!(
                "undo the change, or choose another folder with -o DIR; `erode sweep {} --accept-changes` keeps the runs \
                 whose case is the same and does the others anew",
                file.display()
            );
            Failure::input(changed.to_string(), help)
        }
    }
}

/// Shows a sweep on the screen; the table is written anew after each run.
pub(super) struct Audience<'a> {
    pub(super) screen: Screen,
    table: Option<(&'a Plan, &'a Folder)>,
}

impl<'a> Audience<'a> {
    pub(super) fn new(table: Option<(&'a Plan, &'a Folder)>) -> Self {
        Self {
            screen: Screen::new(),
            table,
        }
    }
}

impl Watcher for Audience<'_> {
    fn say(&mut self, text: &str) {
        self.screen.say(text);
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
        self.screen.show(o.whole, text, o.share == 0.0);
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

#[cfg(test)]
mod tests {
    use super::*;
    use sweep::Outcome as O;

    /// How a sweep of three runs ends that end so.
    fn ended(outcomes: [O; 3]) -> Outcome {
        let root = tempfile::tempdir().unwrap();
        let case = include_str!("../../../../cases/single-bubble/case.toml");
        fs::write(root.path().join("bubble.toml"), case).unwrap();
        let file = root.path().join("sweep.toml");
        let text =
            "case = \"bubble.toml\"\n[grid]\nsetup.single_bubble.radius = [1e-6, 2e-6, 3e-6]\n";
        fs::write(&file, text).unwrap();
        let plan = Plan::read(&file, false).unwrap();
        let results = Results {
            outcomes: outcomes.to_vec(),
            summaries: vec![None; 3],
        };
        conclude(&plan, &results)
    }

    #[test]
    fn an_interruption_does_not_hide_what_failed_before() {
        let end = ended([O::Failed("too fast".into()), O::Interrupted, O::Waiting]);
        let Err(Failure::Other { code, message, .. }) = end else {
            panic!("{end:?}")
        };
        assert_eq!(code, INTERRUPTED);
        assert!(
            message.contains("interrupted") && message.contains("radius=1e-6: too fast"),
            "{message}"
        );
        let end = ended([O::Done, O::Interrupted, O::Waiting]);
        assert!(matches!(end, Err(Failure::Other { message, .. }) if !message.contains("failed")));
        assert!(ended([O::Done, O::Kept, O::Done]).is_ok());
    }
}
