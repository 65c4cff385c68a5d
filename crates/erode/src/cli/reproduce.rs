//! `erode reproduce`.

use super::{
    args::ReproduceArgs,
    failure::{Failure, INTERRUPTED, Outcome},
    json,
    run::stop_flag,
    say::say,
    sweep::Audience,
};
use erode::reproduce::{self, Options, Reproduction, Session};
use erode::sweep::{self, SweepError};
use erode::validate;

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
    let (mut missed, mut without, mut outcomes) = (0, 0, Vec::new());
    for r in chosen {
        let reproduced = r.compute(&session, &mut |text| eprintln!("{}: {text}", r.id));
        let outcome = &reproduced.outcome;
        say!("{}", validate::text(outcome).replace(" (full)", ""));
        let page = reproduce::write(&args.output, &reproduced)?;
        say!("  {}: {}", r.id, reproduce::verdict(outcome));
        say!("  drawn: {}\n", page.display());
        missed += outcome.missed();
        without += outcome.without_data();
        outcomes.push(reproduced.outcome);
    }
    if let Some(folder) = &args.markdown {
        validate::write_markdown(
            folder,
            &reproduce::document(),
            &outcomes,
            env!("CARGO_PKG_VERSION"),
            &validate::today(),
        )?;
    }
    let ended = conclude(interrupted, missed, without);
    json::write_and_end(args.json.as_deref(), &outcomes, ended)
}

fn conclude(interrupted: bool, missed: usize, without: usize) -> Outcome {
    if interrupted {
        return Err(Failure::Other {
            code: INTERRUPTED,
            message: "interrupted; complete runs are kept, checkpoints are written".into(),
            help: "the same command goes on".into(),
        });
    }
    let parts = [
        (missed, "not met"),
        (without, "not judged for want of data"),
    ];
    let parts = parts.iter().filter(|(n, _)| *n > 0);
    let parts: Vec<String> = parts.map(|(n, what)| format!("{n} {what}")).collect();
    if parts.is_empty() {
        return Ok(());
    }
    let help = "the table above says which, and what is known of the cause";
    Err(Failure::failed(
        format!("statements of the source: {}", parts.join(", ")),
        help,
    ))
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
        SweepError::Output(e) => e.into(),
        SweepError::Changed { .. } => Failure::failed(e.to_string(), ""),
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
    let mut audience = Audience::new(None);
    let outcomes = session.execute(&stop, &mut audience);
    audience.screen.finish();
    let outcomes = outcomes?;
    Ok(outcomes
        .iter()
        .any(|o| matches!(o, sweep::Outcome::Interrupted | sweep::Outcome::Waiting)))
}
