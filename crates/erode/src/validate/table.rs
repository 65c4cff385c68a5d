//! Outcomes as a table for the terminal.

use super::{Check, Outcome, number};
use std::fmt::Write;

const HEADER: [&str; 6] = ["quantity", "reference", "result", "error", "tolerance", ""];

/// One outcome as plain text: what was compared with what, a row per check, notes, and the sum.
#[must_use]
pub fn text(outcome: &Outcome) -> String {
    let form = if outcome.quick { "quick" } else { "full" };
    let mut out = format!(
        "{} ({form}): {}\n  reference: {}\n",
        outcome.name, outcome.description, outcome.reference
    );
    let checks = &outcome.finding.checks;
    if !checks.is_empty() {
        let rows: Vec<[String; 6]> = checks.iter().map(row).collect();
        write_rows(&mut out, &rows);
    }
    for note in &outcome.finding.notes {
        let _ = writeln!(out, "  {note}");
    }
    if let Some(failure) = &outcome.failure {
        let _ = writeln!(out, "  FAILED: {failure}");
    }
    let without = match outcome.without_data() {
        0 => String::new(),
        n => format!("{n} not judged for want of data, "),
    };
    let _ = writeln!(
        out,
        "  {} of {} missed, {without}{:.1} s",
        outcome.missed(),
        checks.len() + usize::from(outcome.failure.is_some()),
        outcome.seconds
    );
    out
}

fn row(c: &Check) -> [String; 6] {
    let unit = if c.unit == "-" {
        String::new()
    } else {
        format!(" [{}]", c.unit)
    };
    [
        format!("{}{unit}", c.quantity),
        number::reference(c),
        number::value(c.value),
        number::error(c),
        number::tolerance(c),
        number::verdict(c).into(),
    ]
}

/// The first column to the left, the others to the right.
fn write_rows(out: &mut String, rows: &[[String; 6]]) {
    let header = HEADER.map(String::from);
    let all = || std::iter::once(&header).chain(rows);
    let width: Vec<usize> = (0..HEADER.len())
        .map(|k| all().map(|r| r[k].chars().count()).max().unwrap_or(0))
        .collect();
    for row in all() {
        let mut line = format!("  {:<1$}", row[0], width[0]);
        for k in 1..row.len() {
            let _ = write!(line, "  {:>1$}", row[k], width[k]);
        }
        let _ = writeln!(out, "{}", line.trim_end());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::validate::Finding;

    #[test]
    fn misses_are_seen() {
        let outcome = Outcome {
            name: "some-case".into(),
            description: "what".into(),
            reference: "whom".into(),
            quick: true,
            finding: Finding {
                checks: vec![
                    Check::relative("collapse time", "s", (1.01, 1.0), 0.02, "why"),
                    Check::relative("wall speed", "m/s", (1.2, 1.0), 0.1, "why"),
                    Check::shown("jet speed", "m/s", 1.2, None, "not known"),
                ],
                ..Finding::default()
            },
            failure: None,
            seconds: 1.0,
        };
        let text = text(&outcome);
        assert!(text.contains("1 of 3 missed"), "{text}");
        let line = |word: &str| text.lines().find(|l| l.contains(word)).unwrap().to_owned();
        assert!(line("collapse time").ends_with("pass") && line("wall speed").ends_with("MISS"));
        assert!(line("wall speed").contains("+20.00 %") && line("jet speed").ends_with("shown"));
    }
}
