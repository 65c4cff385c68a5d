//! `docs/validation.md`: the outcomes as tables of a document.

use super::{Check, Kind, Outcome, number};
use crate::output::OutputError;
use crate::output::atomic::write_atomic;
use std::fmt::Write;
use std::fs::create_dir_all;
use std::path::Path;
use std::time::{SystemTime, UNIX_EPOCH};

/// Folder of the figures beside the document.
const FIGURES: &str = "validation";

/// The document: `version` of the program and `date` of the runs stand at its head.
#[must_use]
pub fn markdown(outcomes: &[Outcome], version: &str, date: &str) -> String {
    let mut out = format!(
        "# Validation\n\
         Written by `erode validate`, not by hand: erode {version}, {date}. Errors are relative in percent where the \
         tolerance is,\notherwise in the unit of the quantity. `shown` stands beside its reference without being \
         judged.\n\n\
         | validation | form | checks | missed | wall time |\n| --- | --- | --- | --- | --- |\n"
    );
    for o in outcomes {
        let judged = o
            .finding
            .checks
            .iter()
            .filter(|c| c.kind != Kind::Shown)
            .count();
        let form = if o.quick { "quick" } else { "full" };
        let _ = writeln!(
            out,
            "| [{0}](#{0}) | {form} | {judged} | {1} | {2:.1} s |",
            o.name,
            o.missed(),
            o.seconds
        );
    }
    for outcome in outcomes {
        section(&mut out, outcome);
    }
    out
}

fn section(out: &mut String, o: &Outcome) {
    let _ = write!(
        out,
        "\n## {}\n{}\n\nReference: {}\n",
        o.name, o.description, o.reference
    );
    if let Some(failure) = &o.failure {
        let _ = write!(out, "\n**Failed**: {failure}\n");
    }
    if !o.finding.checks.is_empty() {
        out.push_str(
            "\n| quantity | unit | reference | result | error | tolerance | | why this tolerance |\n\
             | --- | --- | --- | --- | --- | --- | --- | --- |\n",
        );
    }
    for c in &o.finding.checks {
        row(out, c);
    }
    for note in &o.finding.notes {
        let _ = write!(out, "\n{note}\n");
    }
    for f in &o.finding.figures {
        let _ = write!(out, "\n![{}]({FIGURES}/{}.svg)\n", f.title, f.name);
    }
}

fn row(out: &mut String, c: &Check) {
    let verdict = match number::verdict(c) {
        "MISS" => "**MISS**",
        other => other,
    };
    let _ = writeln!(
        out,
        "| {} | {} | {} | {} | {} | {} | {verdict} | {} |",
        c.quantity,
        c.unit,
        number::reference(c),
        number::value(c.value),
        number::error(c),
        number::tolerance(c),
        c.reason_for_tolerance
    );
}

/// Writes `validation.md` and its figures into `folder`, for example `docs`.
///
/// # Errors
/// If a file cannot be written.
pub fn write_markdown(
    folder: &Path,
    outcomes: &[Outcome],
    version: &str,
    date: &str,
) -> Result<(), OutputError> {
    let figures = folder.join(FIGURES);
    create_dir_all(&figures).map_err(|cause| OutputError::NotWritable {
        path: figures.clone(),
        cause,
    })?;
    let write = |path: &Path, text: &str| write_atomic(path, |f| f.write_all(text.as_bytes()));
    for figure in outcomes.iter().flat_map(|o| &o.finding.figures) {
        write(
            &figures.join(format!("{}.svg", figure.name)),
            &figure.to_svg(),
        )?;
    }
    write(
        &folder.join("validation.md"),
        &markdown(outcomes, version, date),
    )
}

/// Today's date (UTC) as year-month-day.
#[must_use]
pub fn today() -> String {
    let since = SystemTime::now().duration_since(UNIX_EPOCH);
    date(since.map_or(0, |d| d.as_secs() / 86_400))
}

/// Gregorian date of a number of days after 1970-01-01.
fn date(mut days: u64) -> String {
    let leap = |y: u64| y.is_multiple_of(4) && (!y.is_multiple_of(100) || y.is_multiple_of(400));
    let mut year = 1970;
    while days >= 365 + u64::from(leap(year)) {
        days -= 365 + u64::from(leap(year));
        year += 1;
    }
    let february = 28 + u64::from(leap(year));
    let mut month = 1;
    for length in [31, february, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31] {
        if days < length {
            break;
        }
        days -= length;
        month += 1;
    }
    format!("{year}-{month:02}-{:02}", days + 1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::validate::{Figure, Finding, Style};

    #[test]
    fn dates_are_those_of_the_calendar() {
        for (days, text) in [
            (0, "1970-01-01"),
            (58, "1970-02-28"),
            (59, "1970-03-01"),
            (11_016, "2000-02-29"),
            (19_722, "2023-12-31"),
            (19_723, "2024-01-01"),
            (20_453, "2025-12-31"),
        ] {
            assert_eq!(date(days), text);
        }
    }

    #[test]
    fn the_document_and_its_figures_are_written() {
        let mut figure = Figure::new("curve", "Some curve", ("time", "s"), ("radius", "m"));
        figure.add("result", Style::Line, vec![[0.0, 1.0], [1.0, 2.0]]);
        let outcome = Outcome {
            name: "some-case".into(),
            description: "what".into(),
            reference: "whom".into(),
            quick: false,
            finding: Finding {
                checks: vec![Check::relative(
                    "speed",
                    "m/s",
                    (1.2, 1.0),
                    0.1,
                    "the reason",
                )],
                figures: vec![figure],
                notes: vec!["a note".into()],
            },
            failure: None,
            seconds: 1.0,
        };
        let folder = tempfile::tempdir().unwrap();
        write_markdown(folder.path(), &[outcome], "0.1.0", "2025-12-31").unwrap();
        let text = std::fs::read_to_string(folder.path().join("validation.md")).unwrap();
        for part in [
            "erode 0.1.0, 2025-12-31",
            "| [some-case](#some-case) | full | 1 | 1 | 1.0 s |",
            "| speed | m/s | 1.000 | 1.200 | +20.00 % | 10 % | **MISS** | the reason |",
            "a note",
            "![Some curve](validation/curve.svg)",
        ] {
            assert!(text.contains(part), "{part} is not in\n{text}");
        }
        let svg = std::fs::read_to_string(folder.path().join("validation/curve.svg")).unwrap();
        assert!(svg.contains("<svg") && svg.contains("Some curve"));
    }
}
