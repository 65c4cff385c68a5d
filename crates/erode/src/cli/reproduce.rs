//! `erode reproduce`.

use super::{
    args::ReproduceArgs,
    failure::{FAILED, Failure, Outcome},
    say::say,
};
use erode::{reproduce, validate};

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
    let unknown =
        |e: reproduce::Unknown| Failure::input(e.to_string(), "`erode reproduce` lists them");
    let chosen: Vec<_> = args
        .ids
        .iter()
        .map(|id| reproduce::find(id).map_err(unknown))
        .collect::<Result<_, _>>()?;
    let failed = |message: String, help: String| Failure::Other {
        code: FAILED,
        message,
        help,
    };
    let (mut missed, mut outcomes) = (0, Vec::new());
    for r in chosen {
        let outcome = r.compute(&mut |text| eprintln!("{}: {text}", r.id));
        say!("{}", validate::text(&outcome).replace(" (full)", ""));
        let page = reproduce::write(&args.output, &outcome)
            .map_err(|e| failed(e.to_string(), e.hint()))?;
        say!(
            "  {}: {}",
            r.id,
            if outcome.missed() == 0 {
                "met"
            } else {
                "not met"
            }
        );
        say!("  drawn: {}\n", page.display());
        missed += outcome.missed();
        outcomes.push(outcome);
    }
    if let Some(file) = &args.json {
        let wrong = |e: &dyn std::fmt::Display| {
            failed(
                format!("{} cannot be written: {e}", file.display()),
                String::new(),
            )
        };
        let text = serde_json::to_string_pretty(&outcomes).map_err(|e| wrong(&e))?;
        std::fs::write(file, text + "\n").map_err(|e| wrong(&e))?;
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
