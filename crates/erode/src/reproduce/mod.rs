//! Figures and tables of the sources: computed again, drawn, and compared with what the text beside them states.
//!
//! A figure itself is not digitised here: what is judged is what the source says in words and numbers. A statement that is not
//! met stays on the list with its cause; nothing is tuned to it. Each source has a file with a list of [`Reproduction`]s.

mod joshi;
mod peters;
mod peters_vortex;
mod session;
mod write;

pub use session::{Judged, Options, Session};
pub use write::write;

use crate::sweep::{Picture, SweepError};
use crate::validate::{Check, Document, Failure, Finding, Outcome};
use session::Need;
use std::time::Instant;
use thiserror::Error;

/// Computes a reproduction and says what it does.
type Run = fn(&mut dyn FnMut(&str)) -> Result<Finding, Failure>;

/// How a reproduction is done.
#[derive(Debug, Clone, Copy)]
enum Kind {
    /// By itself.
    Alone(Run),
    /// From runs that it may share with others.
    OfRuns {
        needs: fn(&Options) -> Vec<Need>,
        judge: fn(&Session) -> Result<Judged, Failure>,
    },
}

/// A figure or table of a source.
#[derive(Debug, Clone, Copy)]
pub struct Reproduction {
    /// As given on the command line.
    pub id: &'static str,
    /// What it shows, in one line.
    pub shows: &'static str,
    /// Source with section.
    pub source: &'static str,
    kind: Kind,
}

/// What came out of a reproduction.
#[derive(Debug, Clone)]
pub struct Reproduced {
    /// Statements of the source with what this program says.
    pub outcome: Outcome,
    /// Pictures of fields.
    pub pictures: Vec<Picture>,
}

/// Every reproduction there is, source by source.
#[must_use]
pub fn all() -> Vec<Reproduction> {
    [&peters::ALL[..], &peters_vortex::ALL[..], &joshi::ALL[..]].concat()
}

/// `docs/reproduction.md`: what came of all of them.
#[must_use]
pub fn document() -> Document {
    Document {
        name: "reproduction",
        head: "# Figures and tables of the sources, computed again\n\
             Written by `erode reproduce --markdown`, not by hand; what is not run keeps its last result. `reference` is what the \
             source states, or a\nbound that its words set (the last column says which); `shown` stands beside it without being \
             judged. A statement that is missed stays here\nwith its cause: nothing is tuned to it.\n",
        subject: "figure or table",
        order: all().iter().map(|r| r.id).collect(),
        prefixed: true,
    }
}

/// No such reproduction.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("there is no reproduction `{id}`; {hint}there are: {list}")]
pub struct Unknown {
    id: String,
    hint: String,
    list: String,
}

/// The reproduction of an ID.
///
/// # Errors
/// If there is none, with the list and the nearest one.
pub fn find(id: &str) -> Result<Reproduction, Unknown> {
    let all = all();
    let ids: Vec<&str> = all.iter().map(|r| r.id).collect();
    let near = crate::case::suggest::closest(id, ids.iter().copied());
    all.iter()
        .find(|r| r.id == id)
        .copied()
        .ok_or_else(|| Unknown {
            id: id.to_owned(),
            hint: near.map_or_else(String::new, |n| format!("did you mean `{n}`? ")),
            list: ids.join(", "),
        })
}

/// The reproductions of some IDs; one that ends in `*` stands for all that begin like it.
///
/// # Errors
/// If there is none of an ID, with the list and the nearest one.
pub fn select(ids: &[String]) -> Result<Vec<Reproduction>, Unknown> {
    let mut chosen: Vec<Reproduction> = Vec::new();
    for id in ids {
        let found: Vec<Reproduction> = match id.strip_suffix('*') {
            Some(head) => all()
                .into_iter()
                .filter(|r| r.id.starts_with(head))
                .collect(),
            None => vec![find(id)?],
        };
        if found.is_empty() {
            // The error is that of an unknown ID.
            find(id)?;
        }
        for r in found {
            if !chosen.iter().any(|c| c.id == r.id) {
                chosen.push(r);
            }
        }
    }
    Ok(chosen)
}

/// The runs that some reproductions need, each once, with their cost; nothing is run.
///
/// # Errors
/// If a case is wrong, which is a fault of the program.
pub fn session(chosen: &[Reproduction], options: Options) -> Result<Session, SweepError> {
    let needs = chosen.iter().flat_map(|r| match r.kind {
        Kind::Alone(_) => Vec::new(),
        Kind::OfRuns { needs, .. } => needs(&options),
    });
    let needs: Vec<Need> = needs.collect();
    Session::prepare(options, &needs)
}

impl Reproduction {
    /// Computes it, from the runs of a session where it is made of runs. A calculation that fails is an outcome like any
    /// other.
    pub fn compute(&self, session: &Session, say: &mut dyn FnMut(&str)) -> Reproduced {
        let start = Instant::now();
        let judged = match self.kind {
            Kind::Alone(run) => run(say).map(Judged::from),
            Kind::OfRuns { judge, .. } => judge(session),
        };
        let (mut judged, failure) = match judged {
            Ok(judged) => (judged, None),
            Err(failure) => (Judged::default(), Some(failure.to_string())),
        };
        let checks = std::mem::take(&mut judged.finding.checks);
        judged.finding.checks = checks.into_iter().map(with_data).collect();
        let of_runs = matches!(self.kind, Kind::OfRuns { .. });
        let outcome = Outcome {
            name: self.id.into(),
            description: self.shows.into(),
            reference: self.source.into(),
            quick: of_runs && session.options.quick,
            finding: judged.finding,
            failure,
            seconds: start.elapsed().as_secs_f64(),
        };
        Reproduced {
            outcome,
            pictures: judged.pictures,
        }
    }
}

/// A statement is judged only by numbers: what is none, or has no bound, was not determined.
fn with_data(check: Check) -> Check {
    let numbers = [Some(check.value), check.reference, check.error];
    let known = numbers.iter().flatten().all(|x| x.is_finite());
    if check.is_judged() && !known {
        check.without_data("a number that it needs could not be determined")
    } else {
        check
    }
}

/// What the comparison says in one word or two: never met where something could not be judged, or nothing was.
#[must_use]
pub fn verdict(outcome: &Outcome) -> String {
    let judged = outcome.finding.checks.iter().filter(|c| c.is_judged());
    let (judged, missed, without) = (judged.count(), outcome.missed(), outcome.without_data());
    match (&outcome.failure, missed, without) {
        (Some(_), ..) => "not computed".into(),
        (None, 0, 0) if judged == 0 => "nothing is judged".into(),
        (None, 0, 0) => "met".into(),
        (None, 0, n) => format!("not judged in full ({n} of {} lack data)", judged + n),
        (None, m, _) => format!("not met ({m} of {judged})"),
    }
}

/// A statement that a value is at most a bound.
fn at_most(quantity: &str, unit: &str, value: f64, most: f64, reason: &str) -> Check {
    Check::at_least(
        format!("{quantity}, margin below {most}"),
        unit,
        most - value,
        0.0,
        reason,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_are_unique_and_unknown_ones_are_named() {
        let mut ids: Vec<&str> = all().iter().map(|r| r.id).collect();
        let count = ids.len();
        ids.sort_unstable();
        ids.dedup();
        assert_eq!(ids.len(), count);
        let message = find("peters-fig-1").unwrap_err().to_string();
        assert!(message.contains("did you mean `peters-fig-"), "{message}");
        assert_eq!(find("peters-fig-17").unwrap().id, "peters-fig-17");
    }

    #[test]
    fn a_star_stands_for_all_that_begin_alike() {
        let ids = |patterns: &[&str]| -> Vec<&str> {
            let patterns: Vec<String> = patterns.iter().map(|p| (*p).to_owned()).collect();
            select(&patterns).unwrap().iter().map(|r| r.id).collect()
        };
        assert_eq!(ids(&["joshi-fig-7.*"]).len(), 9);
        assert_eq!(
            ids(&["joshi-table-4.*", "joshi-table-4.2"]),
            ["joshi-table-4.1", "joshi-table-4.2"]
        );
        assert!(select(&["joshi-fig-9*".to_owned()]).is_err());
    }

    /// Each figure by itself and all of chapter 7 together: every case is correct, shared runs are counted once.
    #[test]
    fn the_cases_of_all_runs_are_correct() {
        let folder = tempfile::tempdir().unwrap();
        for quick in [true, false] {
            let options = Options {
                folder: folder.path().to_path_buf(),
                quick,
                particles_per_radius: None,
                threads: None,
            };
            let chapter = select(&["joshi-fig-7.*".to_owned()]).unwrap();
            let runs = session(&chapter, options.clone()).unwrap().runs;
            // Seven stand-offs, four more pressures, two more radii, three without strain-rate effect.
            assert_eq!(runs.len(), 16);
            assert!(
                runs.iter()
                    .all(|(r, _)| r.cost.is_some_and(|c| c.seconds > 0.0))
            );
            let all = select(&["joshi-*".to_owned()]).unwrap();
            let names: Vec<String> = session(&all, options)
                .unwrap()
                .runs
                .iter()
                .map(|(r, _)| r.hash.clone())
                .collect();
            let mut different = names.clone();
            different.sort();
            different.dedup();
            assert_eq!(different.len(), names.len(), "two names for one case");
        }
    }

    fn outcome(checks: Vec<Check>, failure: Option<&str>) -> Outcome {
        Outcome {
            name: "x".into(),
            description: String::new(),
            reference: String::new(),
            quick: false,
            finding: Finding {
                checks: checks.into_iter().map(with_data).collect(),
                ..Finding::default()
            },
            failure: failure.map(str::to_owned),
            seconds: 0.0,
        }
    }

    #[test]
    fn what_lacks_data_is_never_met() {
        let ratio = |x: f64| Check::at_least("ratio", "-", x, 1.0, "");
        let of = |checks| verdict(&outcome(checks, None));
        assert_eq!(of(vec![ratio(2.0)]), "met");
        assert_eq!(of(vec![ratio(2.0), ratio(0.5)]), "not met (1 of 2)");
        for unknown in [f64::NAN, f64::INFINITY] {
            let lacking = of(vec![ratio(2.0), ratio(unknown)]);
            assert_eq!(lacking, "not judged in full (1 of 2 lack data)");
        }
        let unbounded = Check::more_than("place", "m", 1.0, f64::NAN, "");
        assert_eq!(of(vec![unbounded]), "not judged in full (1 of 1 lack data)");
        let shown = Check::shown("jet", "m/s", 900.0, None, "");
        assert_eq!(of(vec![shown]), "nothing is judged");
        assert_eq!(verdict(&outcome(Vec::new(), Some("why"))), "not computed");
    }

    #[test]
    fn at_most_passes_below_and_misses_above() {
        assert!(at_most("x", "-", 0.9, 1.0, "").passed);
        assert!(!at_most("x", "-", 1.1, 1.0, "").passed);
        assert!(!at_most("x", "-", f64::NAN, 1.0, "").passed);
    }
}
