//! `erode validate`.

use super::{
    args::ValidateArgs,
    failure::{FAILED, Failure, Outcome},
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
        missed += outcome.missed();
    }
    if let Some(file) = &args.json {
        let failed = |e: &dyn std::fmt::Display| Failure::Other {
            code: FAILED,
            message: format!("{} cannot be written: {e}", file.display()),
            help: String::new(),
        };
        let text = serde_json::to_string_pretty(&outcomes).map_err(|e| failed(&e))?;
        std::fs::write(file, text + "\n").map_err(|e| failed(&e))?;
    }
    if let Some(folder) = &args.markdown {
        validate::write_markdown(
            folder,
            &outcomes,
            env!("CARGO_PKG_VERSION"),
            &validate::today(),
        )
        .map_err(|e| Failure::Other {
            code: FAILED,
            message: e.to_string(),
            help: e.hint(),
        })?;
    }
    if missed > 0 {
        let message = format!("{missed} tolerance(s) missed");
        return Err(Failure::Other {
            code: FAILED,
            message,
            help: "the table above says which, and why they are what they are".into(),
        });
    }
    Ok(())
}
