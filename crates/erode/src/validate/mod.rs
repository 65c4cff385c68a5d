//! Validations: what the program computes beside what is known, with error and tolerance.
//!
//! One file or folder per validation. Each says what it compares with (a source, an exact solution, an independent
//! code; the data and their origin are in `validation/NAME`), has a quick form that runs in the tests and a full form
//! for `erode validate`.

mod axis_consistency;
mod bubble;
mod bubble_rise;
pub(crate) mod bubble_vortex;
mod check;
mod columns;
mod erosion_formulae;
mod error;
mod figure;
mod gas_rebound;
mod gaussian_pressure_static;
mod indentation_axisym;
mod indentation_planestrain;
mod interface_wave;
mod johnson_cook_point;
mod main_case;
mod markdown;
mod mass_loss;
mod materials;
mod number;
mod rayleigh_collapse;
mod rows;
pub(crate) mod steel_lattice;
mod stress_waves;
pub(crate) mod table;
mod taylor_bar;

pub use check::{Check, Kind};
pub use error::{Failure, ValidateError};
pub use figure::{Curve, Figure, Style};
pub use markdown::{Document, today, write_markdown};
pub use table::text;

use serde::Serialize;
use std::time::Instant;

/// What a validation found.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct Finding {
    /// Numbers with reference, error and tolerance.
    pub checks: Vec<Check>,
    /// Curves worth seeing.
    pub figures: Vec<Figure>,
    /// Sentences that belong to the numbers.
    pub notes: Vec<String>,
}

/// Runs a validation in its quick (`true`) or full form and says what it does.
type Form = fn(bool, &mut dyn FnMut(&str)) -> Result<Finding, Failure>;

/// A validation.
#[derive(Debug, Clone, Copy)]
pub struct Validation {
    /// As given on the command line.
    pub name: &'static str,
    /// What is compared, in one line.
    pub description: &'static str,
    /// What it is compared with, and where that comes from.
    pub reference: &'static str,
    /// Runs it in its quick or full form; says what it does through the last argument.
    run: Form,
}

/// What came out of one validation.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Outcome {
    /// Name of the validation.
    pub name: String,
    /// What is compared.
    pub description: String,
    /// What it is compared with.
    pub reference: String,
    /// Whether this was the quick form.
    pub quick: bool,
    /// What was found; empty after a failure.
    pub finding: Finding,
    /// Why it could not be completed.
    pub failure: Option<String>,
    /// Wall time, s.
    pub seconds: f64,
}

impl Outcome {
    /// Number of missed tolerances; a validation that failed counts as one, what could not be judged is not counted.
    #[must_use]
    pub fn missed(&self) -> usize {
        let missed = |c: &&Check| c.is_judged() && !c.passed;
        self.finding.checks.iter().filter(missed).count() + usize::from(self.failure.is_some())
    }

    /// Number of checks that could not be judged for want of data.
    #[must_use]
    pub fn without_data(&self) -> usize {
        let all = self.finding.checks.iter();
        all.filter(|c| c.kind == Kind::NoData).count()
    }
}

/// All validations in the order in which they are run.
pub const ALL: [Validation; 19] = [
    johnson_cook_point::VALIDATION,
    axis_consistency::VALIDATION,
    stress_waves::BAR,
    stress_waves::PLATE,
    taylor_bar::VALIDATION,
    mass_loss::VALIDATION,
    interface_wave::VALIDATION,
    indentation_axisym::VALIDATION,
    indentation_planestrain::VALIDATION,
    gaussian_pressure_static::VALIDATION,
    rayleigh_collapse::VALIDATION,
    gas_rebound::VALIDATION,
    main_case::DETACHED,
    main_case::ATTACHED,
    bubble::RAYLEIGH,
    bubble::ACOUSTIC,
    bubble_rise::VALIDATION,
    bubble_vortex::VALIDATION,
    erosion_formulae::VALIDATION,
];

/// Names of all validations.
#[must_use]
pub fn names() -> Vec<&'static str> {
    ALL.iter().map(|v| v.name).collect()
}

/// Runs validations by name, or all of them, in their quick or full form. `progress` hears what is being done.
///
/// A validation that fails is an outcome like any other: the others are still run.
///
/// # Errors
/// If a name is unknown or there is nothing to run; nothing is run then.
pub fn run(
    names: &[String],
    all: bool,
    quick: bool,
    progress: &mut dyn FnMut(&str),
) -> Result<Vec<Outcome>, ValidateError> {
    let chosen = choose(names, all)?;
    let outcomes = chosen.iter().map(|v| v.outcome(quick, progress));
    Ok(outcomes.collect())
}

fn choose(names: &[String], all: bool) -> Result<Vec<Validation>, ValidateError> {
    if all {
        return Ok(ALL.to_vec());
    }
    if names.is_empty() {
        return Err(ValidateError::NothingChosen);
    }
    let find = |name: &String| {
        let found = ALL.iter().find(|v| v.name == name).copied();
        found.ok_or_else(|| ValidateError::Unknown(name.clone()))
    };
    names.iter().map(find).collect()
}

impl Validation {
    fn outcome(&self, quick: bool, progress: &mut dyn FnMut(&str)) -> Outcome {
        let start = Instant::now();
        let result = (self.run)(quick, &mut |what| {
            progress(&format!("{}: {what}", self.name))
        });
        let (finding, failure) = match result {
            Ok(finding) => (finding, None),
            Err(failure) => (Finding::default(), Some(failure.to_string())),
        };
        Outcome {
            name: self.name.into(),
            description: self.description.into(),
            reference: self.reference.into(),
            quick,
            finding,
            failure,
            seconds: start.elapsed().as_secs_f64(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unknown_names_are_refused_with_the_list_and_a_suggestion() {
        let run = |name: &str| run(&[name.to_owned()], false, true, &mut |_| ()).unwrap_err();
        let message = run("raleigh-colapse").to_string();
        assert!(
            message.contains("did you mean `rayleigh-collapse`"),
            "{message}"
        );
        let message = run("frobnicate").to_string();
        assert!(!message.contains("did you mean"), "{message}");
        for name in names() {
            assert!(message.contains(name));
        }
        let nothing = super::run(&[], false, true, &mut |_| ()).unwrap_err();
        assert!(nothing.to_string().contains("--all"));
    }

    #[test]
    fn one_wrong_name_runs_nothing() {
        let names = ["johnson-cook-point".to_owned(), "other".to_owned()];
        assert!(choose(&names, false).is_err());
        assert_eq!(choose(&names[..1], false).unwrap().len(), 1);
        assert_eq!(choose(&[], true).unwrap().len(), ALL.len());
    }
}
