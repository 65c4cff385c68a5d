//! Figures and tables of the sources: computed again, drawn, and compared with what the text beside them states.
//!
//! A figure itself is not digitised here: what is judged is what the source says in words and numbers. A statement that is not
//! met stays on the list with its cause; nothing is tuned to it. Each source has a file with a list of [`Reproduction`]s.

mod peters;
mod peters_vortex;
mod write;

pub use write::write;

use crate::validate::{Check, Failure, Finding, Outcome};
use std::time::Instant;
use thiserror::Error;

/// Computes a reproduction and says what it does.
type Run = fn(&mut dyn FnMut(&str)) -> Result<Finding, Failure>;

/// A figure or table of a source.
#[derive(Debug, Clone, Copy)]
pub struct Reproduction {
    /// As given on the command line.
    pub id: &'static str,
    /// What it shows, in one line.
    pub shows: &'static str,
    /// Source with section.
    pub source: &'static str,
    run: Run,
}

/// Every reproduction there is, source by source.
#[must_use]
pub fn all() -> Vec<Reproduction> {
    [&peters::ALL[..], &peters_vortex::ALL[..]].concat()
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

impl Reproduction {
    /// Computes it. A calculation that fails is an outcome like any other.
    pub fn compute(&self, say: &mut dyn FnMut(&str)) -> Outcome {
        let start = Instant::now();
        let (finding, failure) = match (self.run)(say) {
            Ok(finding) => (finding, None),
            Err(failure) => (Finding::default(), Some(failure.to_string())),
        };
        Outcome {
            name: self.id.into(),
            description: self.shows.into(),
            reference: self.source.into(),
            quick: false,
            finding,
            failure,
            seconds: start.elapsed().as_secs_f64(),
        }
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
    fn at_most_passes_below_and_misses_above() {
        assert!(at_most("x", "-", 0.9, 1.0, "").passed);
        assert!(!at_most("x", "-", 1.1, 1.0, "").passed);
        assert!(!at_most("x", "-", f64::NAN, 1.0, "").passed);
    }
}
