//! `docs/validation.md` and `docs/reproduction.md`: outcomes as tables of a document.

use super::{ALL, Check, Figure, Kind, Outcome, number};
use crate::output::OutputError;
use crate::output::atomic::write_atomic;
use std::fmt::Write;
use std::fs::create_dir_all;
use std::path::Path;
use std::time::{SystemTime, UNIX_EPOCH};

/// A document with outcomes, and a folder of the same name with their figures.
#[derive(Debug, Clone)]
pub struct Document {
    /// Name without ending, `validation`.
    pub name: &'static str,
    /// First lines, with the title.
    pub head: &'static str,
    /// What its outcomes are.
    pub subject: &'static str,
    /// Names of all that may stand in it, in their order.
    pub order: Vec<&'static str>,
    /// Whether figures of different outcomes may have the same name.
    pub prefixed: bool,
}

impl Document {
    /// That of `erode validate`.
    #[must_use]
    pub fn validation() -> Self {
        Self {
            name: "validation",
            head: "# Validation\n\
                 Written by `erode validate --markdown`, not by hand; what is not run keeps its last result. Errors are relative in \
                 percent where\nthe tolerance is, otherwise in the unit of the quantity. `shown` stands beside its reference \
                 without being judged.\n",
            subject: "validation",
            order: ALL.iter().map(|v| v.name).collect(),
            prefixed: false,
        }
    }

    /// File name of a figure, without ending.
    fn figure(&self, o: &Outcome, figure: &Figure) -> String {
        if self.prefixed {
            format!("{}-{}", o.name, figure.name)
        } else {
            figure.name.clone()
        }
    }
}

/// One outcome in the document.
#[derive(Debug, Clone, PartialEq)]
struct Entry {
    name: String,
    /// Its row in the first table.
    row: String,
    section: String,
}

impl Entry {
    fn of(document: &Document, o: &Outcome, version: &str, date: &str) -> Self {
        let judged = (o.finding.checks.iter()).filter(|c| c.kind != Kind::Shown);
        let form = if o.quick { "quick" } else { "full" };
        let row = format!(
            "| [{0}](#{0}) | {form} | {1} | {2} | {3:.1} s | {version}, {date} |",
            o.name,
            judged.count(),
            o.missed(),
            o.seconds
        );
        let mut out = String::new();
        section(&mut out, document, o);
        Self {
            name: o.name.clone(),
            row,
            section: out,
        }
    }

    /// The outcomes of a document that [`text`] wrote; nothing of any other text.
    fn all_of(text: &str) -> Vec<Self> {
        let mut sections = text.split("\n## ");
        let head = sections.next().unwrap_or_default();
        let rows: Vec<&str> = head.lines().filter(|l| l.starts_with("| [")).collect();
        sections
            .filter_map(|section| {
                let name = section.lines().next()?;
                let row = (rows.iter()).find(|r| r.starts_with(&format!("| [{name}]")))?;
                Some(Self {
                    name: name.to_owned(),
                    row: (*row).to_owned(),
                    section: format!("\n## {}\n", section.trim_end_matches('\n')),
                })
            })
            .collect()
    }
}

/// The document: what was run now, then in place what an earlier document holds of the others.
fn text(
    document: &Document,
    outcomes: &[Outcome],
    earlier: &str,
    version: &str,
    date: &str,
) -> String {
    let mut entries: Vec<Entry> = (outcomes.iter())
        .map(|o| Entry::of(document, o, version, date))
        .collect();
    for kept in Entry::all_of(earlier) {
        if entries.iter().all(|e| e.name != kept.name) {
            entries.push(kept);
        }
    }
    let all = &document.order;
    entries.sort_by_key(|e| (all.iter().position(|name| *name == e.name)).unwrap_or(all.len()));
    let mut out = format!(
        "{}\n| {} | form | checks | missed | wall time | version, date |\n| --- | --- | --- | --- | --- | --- |\n",
        document.head, document.subject
    );
    for e in &entries {
        let _ = writeln!(out, "{}", e.row);
    }
    for e in &entries {
        out.push_str(&e.section);
    }
    out
}

fn section(out: &mut String, document: &Document, o: &Outcome) {
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
        let (folder, name) = (document.name, document.figure(o, f));
        let _ = write!(out, "\n![{}]({folder}/{name}.svg)\n", f.title);
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

/// Writes the document and its figures into `folder`, for example `docs`. Of an earlier one there the outcomes that are not
/// among the new ones are kept.
///
/// # Errors
/// If a file cannot be written.
pub fn write_markdown(
    folder: &Path,
    document: &Document,
    outcomes: &[Outcome],
    version: &str,
    date: &str,
) -> Result<(), OutputError> {
    let figures = folder.join(document.name);
    create_dir_all(&figures).map_err(|cause| OutputError::NotWritable {
        path: figures.clone(),
        cause,
    })?;
    let write = |path: &Path, text: &str| write_atomic(path, |f| f.write_all(text.as_bytes()));
    for o in outcomes {
        for figure in &o.finding.figures {
            let name = document.figure(o, figure);
            write(&figures.join(format!("{name}.svg")), &figure.to_svg())?;
        }
    }
    let path = folder.join(format!("{}.md", document.name));
    // No earlier document, or one that cannot be read as text: nothing to keep.
    let earlier = std::fs::read_to_string(&path).unwrap_or_default();
    write(&path, &text(document, outcomes, &earlier, version, date))
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
        write_markdown(
            folder.path(),
            &Document::validation(),
            std::slice::from_ref(&outcome),
            "0.1.0",
            "2025-12-31",
        )
        .unwrap();
        let text = std::fs::read_to_string(folder.path().join("validation.md")).unwrap();
        for part in [
            "| [some-case](#some-case) | full | 1 | 1 | 1.0 s | 0.1.0, 2025-12-31 |",
            "| speed | m/s | 1.000 | 1.200 | +20.00 % | 10 % | **MISS** | the reason |",
            "a note",
            "![Some curve](validation/curve.svg)",
        ] {
            assert!(text.contains(part), "{part} is not in\n{text}");
        }
        // Another one later: the first is kept as it was.
        let other = Outcome {
            name: "other-case".into(),
            ..outcome
        };
        write_markdown(
            folder.path(),
            &Document::validation(),
            &[other],
            "0.2.0",
            "2026-01-01",
        )
        .unwrap();
        let both = std::fs::read_to_string(folder.path().join("validation.md")).unwrap();
        let first = text.split("\n## ").nth(1).unwrap().trim_end();
        assert!(
            both.contains(first) && both.contains("| 0.1.0, 2025-12-31 |"),
            "{both}"
        );
        assert!(
            both.contains("## other-case") && both.contains("| 0.2.0, 2026-01-01 |"),
            "{both}"
        );
        let svg = std::fs::read_to_string(folder.path().join("validation/curve.svg")).unwrap();
        assert!(svg.contains("<svg") && svg.contains("Some curve"));
    }
}
