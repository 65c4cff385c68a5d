//! `erode validate`.

use super::{
    args::ValidateArgs,
    failure::{Failure, Outcome},
    json,
    say::say,
};
use erode::validate::{self, ALL};

/// Runs validations and prints reference, result, error and tolerance.
pub(crate) fn run(args: &ValidateArgs) -> Outcome {
    if args.names.is_empty() && !args.all {
        say!("Validations, to be used as `erode validate NAME..` or `erode validate --all`:");
        for v in &ALL {
            say!("  {:18} {}", v.name, v.description);
            say!("  {:18} reference: {}", "", v.reference);
        }
        return Ok(());
    }
    let outcomes = validate::run(&args.names, args.all, args.quick, &mut |text| {
        eprintln!("{text}")
    })
    .map_err(|e| Failure::input(e.to_string(), "`erode validate` lists them"))?;
    let mut missed = 0;
    for outcome in &outcomes {
        say!("{}", validate::text(outcome));
        missed += outcome.missed() + outcome.without_data();
    }
    if let Some(folder) = &args.markdown {
        validate::write_markdown(
            folder,
            &validate::Document::validation(),
            &outcomes,
            env!("CARGO_PKG_VERSION"),
            &validate::today(),
        )?;
    }
    let ended = if missed > 0 {
        let help = "the table above says which, and why they are what they are";
        Err(Failure::failed(
            format!("{missed} tolerance(s) missed"),
            help,
        ))
    } else {
        Ok(())
    };
    json::write_and_end(args.json.as_deref(), &outcomes, ended)
}
