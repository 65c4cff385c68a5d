//! `erode reproduce`.

use super::{
    args::ReproduceArgs,
    failure::{FAILED, Failure, INTERRUPTED, Outcome},
    run::stop_flag,
    say::say,
    sweep::Screen,
};
use erode::reproduce::{self, Options, Reproduction, Session};
use erode::sweep::{self, SweepError};
use erode::validate;
use std::path::Path;

/// Lists the reproductions, or computes some and compares them with what the source states.
pub(crate) fn run(args: &ReproduceArgs) -> Outcome {
    if args.ids.is_empty() {
        say!("Figures and tables of the sources, to be used as `erode reproduce ID..`:");
        for r in reproduce::all() {
            say!("  {:15} {}", r.id, r.shows);
            say!("  {:15} {}", "", r.source);
        }
        return Ok(());
    }
    let chosen = reproduce::select(&args.ids)
        .map_err(|e| Failure::input(e.to_string(), "`erode reproduce` lists them"))?;
    let session = prepare(args, &chosen)?;
    if args.dry_run {
        return Ok(());
    }
    let interrupted = do_runs(&session)?;
    let (mut missed, mut outcomes) = (0, Vec::new());
    for r in chosen {
        let reproduced = r.compute(&session, &mut |text| eprintln!("{}: {text}", r.id));
        let outcome = &reproduced.outcome;
        say!("{}", validate::text(outcome).replace(" (full)", ""));
        let page = reproduce::write(&args.output, &reproduced)
            .map_err(|e| failed(e.to_string(), e.hint()))?;
        let verdict = match (outcome.missed(), &outcome.failure) {
            (_, Some(_)) => "not computed",
            (0, None) => "met",
            _ => "not met",
        };
        say!("  {}: {verdict}", r.id);
        say!("  drawn: {}\n", page.display());
        missed += outcome.missed();
        outcomes.push(reproduced.outcome);
    }
    if let Some(file) = &args.json {
        write_json(file, &outcomes)?;
    }
    if interrupted {
        return Err(Failure::Other {
            code: INTERRUPTED,
            message: "interrupted; complete runs are kept, checkpoints are written".into(),
            help: "the same command goes on".into(),
        });
    }
    if missed > 0 {
        let help = "the table above says which, and what is known of the cause".to_owned();
        return Err(failed(
            format!("{missed} statement(s) of the source not met"),
            help,
        ));
    }
    Ok(())
}

fn failed(message: String, help: String) -> Failure {
    Failure::Other {
        code: FAILED,
        message,
        help,
    }
}

fn write_json(file: &Path, outcomes: &[validate::Outcome]) -> Outcome {
    let wrong = |e: &dyn std::fmt::Display| {
        failed(
            format!("{} cannot be written: {e}", file.display()),
            String::new(),
        )
    };
    let text = serde_json::to_string_pretty(outcomes).map_err(|e| wrong(&e))?;
    std::fs::write(file, text + "\n").map_err(|e| wrong(&e))
}

/// The runs that are needed, with their cost.
fn prepare(args: &ReproduceArgs, chosen: &[Reproduction]) -> Result<Session, Failure> {
    let options = Options {
        folder: args.output.clone(),
        quick: args.quick,
        particles_per_radius: args.particles_per_radius,
        threads: args.threads.map(usize::from),
    };
    let session = reproduce::session(chosen, options).map_err(|e| match e {
        SweepError::Case(errors) => errors.into(),
        SweepError::Output(e) => super::sweep::output(e),
        SweepError::Changed { .. } => failed(e.to_string(), String::new()),
    })?;
    if !session.runs.is_empty() {
        let runs = session.runs.iter().map(|(r, f)| (r, f.clone()));
        say!("Runs of {}:", args.ids.join(" "));
        super::sweep::print_runs(&runs.collect::<Vec<_>>());
    }
    Ok(session)
}

/// Does what is missing; whether it was interrupted. A run that fails is told by the figures that need it.
fn do_runs(session: &Session) -> Result<bool, Failure> {
    if session.runs.is_empty() {
        return Ok(false);
    }
    let stop = stop_flag()?;
    let mut screen = Screen::new(None);
    let outcomes = session.execute(&stop, &mut screen);
    screen.finish();
    Ok(outcomes
        .iter()
        .any(|o| matches!(o, sweep::Outcome::Interrupted | sweep::Outcome::Waiting)))
}
