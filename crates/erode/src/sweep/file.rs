//! The sweep file as written: the case, what all runs share, and what is varied.

use super::plan::{LONGEST_NAME, plain};
use super::setting::{Setting, Value};
use crate::case::CaseErrors;
use crate::case::error::{Findings, Span};
use crate::case::keys::CASE;
use crate::case::load::read_text;
use crate::case::raw::{Entry, Raw, RawTable, RawValue, parse};
use crate::case::suggest::did_you_mean;
use crate::case::units;
use std::path::{Path, PathBuf};

const KEYS: [&str; 7] = ["title", "case", "set", "quick", "grid", "zip", "run"];
const LIST_HELP: &str =
    "write a list of values: \"setup.bubble_near_wall.standoff\" = [0.66, 1.33]";

/// A key and the values that it takes in turn.
pub(super) type List = (String, Vec<Value>);

/// A run that is listed by itself.
#[derive(Debug, Clone)]
pub(super) struct Listed {
    pub(super) name: Option<String>,
    pub(super) settings: Vec<Setting>,
}

/// A sweep file that could be read.
#[derive(Debug, Clone, Default)]
pub(super) struct SweepFile {
    pub(super) source: String,
    pub(super) title: String,
    /// Case file or folder.
    pub(super) case: PathBuf,
    /// For all runs.
    pub(super) set: Vec<Setting>,
    /// For all runs of the quick form.
    pub(super) quick: Vec<Setting>,
    /// Every combination of these.
    pub(super) grid: Vec<List>,
    /// The first values of all, the second values of all, and so on.
    pub(super) zip: Vec<List>,
    pub(super) runs: Vec<Listed>,
}

/// Reads a sweep file.
///
/// # Errors
/// Everything that is wrong with it as a text; the cases are checked later.
pub(super) fn read(path: &Path) -> Result<SweepFile, CaseErrors> {
    let source = read_text(path)?;
    let mut findings = Findings::default();
    let number = findings.add_source(path.display().to_string(), &source);
    let raw = parse(number, &mut findings);
    let mut reader = Reader {
        source: &source,
        whole: Span {
            source: number,
            start: 0,
            end: 0,
        },
        findings: &mut findings,
    };
    let mut file = SweepFile {
        source: source.clone(),
        ..SweepFile::default()
    };
    reader.table(&raw, path, &mut file);
    match findings.into_errors() {
        Some(errors) => Err(errors),
        None => Ok(file),
    }
}

struct Reader<'a> {
    source: &'a str,
    whole: Span,
    findings: &'a mut Findings,
}

impl Reader<'_> {
    fn table(&mut self, raw: &RawTable, path: &Path, file: &mut SweepFile) {
        for entry in &raw.entries {
            match (entry.key.as_str(), &entry.value.value) {
                ("title", RawValue::Text(t)) => file.title = t.clone(),
                ("case", RawValue::Text(t)) => {
                    file.case = path.parent().unwrap_or(Path::new("")).join(t);
                }
                ("set", RawValue::Table(t)) => self.settings("", t, &mut file.set),
                ("quick", RawValue::Table(t)) => self.settings("", t, &mut file.quick),
                ("grid", RawValue::Table(t)) => self.lists("", t, &mut file.grid),
                ("zip", RawValue::Table(t)) => self.lists("", t, &mut file.zip),
                ("run", RawValue::List(l)) => self.runs(l, file),
                (key, _) if KEYS.contains(&key) => self.wrong_kind(entry),
                (key, _) => {
                    let help = did_you_mean(key, KEYS.iter().copied(), "allowed");
                    let message = format!("a sweep has no key `{key}`");
                    self.findings
                        .error(entry.key_span, message, "unknown key", help);
                }
            }
        }
        if raw.get("case").is_none() {
            let help = "write case = \"path\", a case file or folder, relative to the sweep file";
            self.findings
                .error(self.whole, "the sweep names no case", "", help);
        }
        self.equal_lengths(&file.zip);
        self.varied_once(file);
        let varied = !(file.grid.is_empty() && file.zip.is_empty() && file.runs.is_empty());
        if !varied && self.findings.count() == 0 {
            let help = "write [grid] (every combination), [zip] (values taken together) or [[run]]";
            self.findings
                .error(self.whole, "the sweep varies nothing", "", help);
        }
    }

    fn wrong_kind(&mut self, entry: &Entry) {
        let (wanted, help) = match entry.key.as_str() {
            "title" | "case" => ("a text", "write it in quotes"),
            "run" => ("a list of tables", "write [[run]], one block for each run"),
            _ => ("a table", "write it as [name] with one key per line"),
        };
        let message = format!(
            "`{}` must be {wanted}, but this is {}",
            entry.key,
            entry.value.value.kind()
        );
        self.findings
            .error(entry.value.span, message, "wrong kind", help);
    }

    /// Settings of a table; tables in it are parts of the path.
    fn settings(&mut self, above: &str, table: &RawTable, into: &mut Vec<Setting>) {
        for entry in &table.entries {
            let key = join(above, &entry.key);
            match &entry.value.value {
                RawValue::Table(inner) if !inner.entries.is_empty() => {
                    self.settings(&key, inner, into);
                }
                _ => {
                    let value = self.value(&key, &entry.value);
                    into.push(Setting { key, value });
                }
            }
        }
    }

    /// Lists of a table; tables in it are parts of the path.
    fn lists(&mut self, above: &str, table: &RawTable, into: &mut Vec<List>) {
        for entry in &table.entries {
            let key = join(above, &entry.key);
            match &entry.value.value {
                RawValue::Table(inner) => self.lists(&key, inner, into),
                RawValue::List(items) if items.is_empty() => {
                    let message =
                        format!("the list of `{key}` is empty, so there is nothing to run");
                    self.findings
                        .error(entry.value.span, message, "no value", LIST_HELP);
                }
                RawValue::List(items) => {
                    let values = items.iter().map(|v| self.value(&key, v)).collect();
                    into.push((key, values));
                }
                other => {
                    let message = format!("`{key}` must be a list, but this is {}", other.kind());
                    let help = format!("{LIST_HELP}; what all runs share goes under [set]");
                    self.findings
                        .error(entry.value.span, message, "not a list", help);
                }
            }
        }
    }

    fn runs(&mut self, items: &[Raw], file: &mut SweepFile) {
        for item in items {
            let RawValue::Table(table) = &item.value else {
                let message = format!("a run must be a table, but this is {}", item.value.kind());
                let help = "write [[run]] and under it the keys of the case with their values";
                self.findings.error(item.span, message, "wrong kind", help);
                continue;
            };
            let mut settings = Vec::new();
            self.settings("", table, &mut settings);
            let at = settings.iter().position(|s| s.key == "name");
            let name = at.map(|k| settings.remove(k).value.shown);
            if let Some(name) = &name
                && (plain(name) != *name || name.chars().count() > LONGEST_NAME)
            {
                let message = format!("`{name}` cannot be the name of a run");
                let help = format!(
                    "it is that of a folder: letters, digits and + - . _ = , in any order, {LONGEST_NAME} at most, not dots alone; for \
                     example `{}`",
                    plain(name).chars().take(LONGEST_NAME).collect::<String>()
                );
                self.findings.error(item.span, message, "not a name", help);
            }
            if let Some(twice) = &name
                && file.runs.iter().any(|r| r.name.as_ref() == Some(twice))
            {
                let message = format!("two runs have the name `{twice}`");
                let help = "names are those of folders, so each run needs one of its own; without one it is named after its values";
                self.findings.error(item.span, message, "again", help);
            }
            file.runs.push(Listed { name, settings });
        }
    }

    /// The value of `key`: the unit of a number is that of the key, whether it was written or not.
    fn value(&self, key: &str, raw: &Raw) -> Value {
        let written = self
            .source
            .get(raw.span.start..raw.span.end)
            .unwrap_or_default();
        let (shown, number) = match &raw.value {
            RawValue::Text(t) => (t.clone(), units::parse(t).ok().map(|q| q.value)),
            RawValue::Integer(x) | RawValue::Float(x) => (written.to_owned(), Some(*x)),
            RawValue::Switch(b) => (b.to_string(), Some(f64::from(u8::from(*b)))),
            _ => (written.to_owned(), None),
        };
        let dimension = CASE.dimension(key).filter(|d| *d != units::NUMBER);
        let unit = dimension.map_or("-".into(), |d| d.to_string().replace('^', ""));
        Value {
            text: written.to_owned(),
            shown,
            number,
            unit,
        }
    }

    fn equal_lengths(&mut self, zip: &[List]) {
        let Some(((first, values), others)) = zip.split_first() else {
            return;
        };
        for (key, list) in others.iter().filter(|(_, l)| l.len() != values.len()) {
            let message = format!(
                "the lists under [zip] are taken together, but `{first}` has {} values and `{key}` has {}",
                values.len(),
                list.len()
            );
            self.findings.error(
                self.whole,
                message,
                "",
                "give all of them the same number of values",
            );
        }
    }

    fn varied_once(&mut self, file: &SweepFile) {
        let varied: Vec<&String> = file.grid.iter().chain(&file.zip).map(|l| &l.0).collect();
        let fixed = file.set.iter().chain(&file.quick).map(|s| &s.key);
        for (k, key) in varied.iter().enumerate() {
            if varied[..k].contains(key) || fixed.clone().any(|f| f == *key) {
                let message = format!("`{key}` is given more than once");
                let help =
                    "a key stands either under [set] and [quick] or under [grid] or under [zip]";
                self.findings.error(self.whole, message, "", help);
            }
        }
    }
}

/// `above.key`; a key that was written in quotes with dots is a path already.
fn join(above: &str, key: &str) -> String {
    if above.is_empty() {
        key.to_owned()
    } else {
        format!("{above}.{key}")
    }
}
