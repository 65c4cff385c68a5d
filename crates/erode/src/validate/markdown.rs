//! `docs/validation.md`: the outcomes as tables of a document.

use super::{Check, Kind, Outcome, number};
use crate::output::OutputError;
use crate::output::atomic::write_atomic;
use std::fmt::Write;
use std::fs::create_dir_all;
use std::path::Path;

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
