//! `--set path.to.key=value`: small TOML texts merged over the case file.

use super::{
    error::{Findings, Span},
    raw::{Entry, Raw, RawTable, RawValue, parse},
};

const HELP: &str = "write --set path.to.key=value, for example --set run.end_time=\"2 us\"";

/// Parses one override and merges it into the case.
pub(crate) fn apply(case: &mut RawTable, text: &str, findings: &mut Findings) {
    let source = findings.add_source("--set", text);
    let whole = Span {
        source,
        start: 0,
        end: text.len(),
    };
    let Some(split) = text.find('=') else {
        findings.error(
            whole,
            "an override needs a path and a value",
            "no `=` in here",
            HELP,
        );
        return;
    };
    if parse_alone(text).is_some() {
        merge(case, parse(source, findings), findings);
        return;
    }
    // A value that is no TOML is a text without quotes.
    let (path, value) = (&text[..split], text[split + 1..].trim());
    let quoted = format!("{path}= {}", toml::Value::String(value.to_owned()));
    match parse_alone(&quoted) {
        Some(mut table) if !value.is_empty() => {
            relocate(
                &mut table,
                Span {
                    source,
                    start: split + 1,
                    end: text.len(),
                },
            );
            merge(case, table, findings);
        }
        _ => findings.error(
            whole,
            "this override cannot be read",
            "not `path.to.key=value`",
            HELP,
        ),
    }
}

/// A text by itself, if it is TOML.
fn parse_alone(text: &str) -> Option<RawTable> {
    let mut findings = Findings::default();
    let source = findings.add_source("--set", text);
    let table = parse(source, &mut findings);
    (findings.count() == 0).then_some(table)
}

/// Moves the places of a text that was parsed with added quotes back into the text as given.
fn relocate(table: &mut RawTable, value: Span) {
    for entry in &mut table.entries {
        entry.key_span.source = value.source;
        entry.newest = value.source;
        match &mut entry.value.value {
            RawValue::Table(inner) => {
                entry.value.span = entry.key_span;
                relocate(inner, value);
            }
            _ => entry.value.span = value,
        }
    }
}

/// Lays `over` on `base`: tables are merged key by key, everything else is replaced; an empty list takes one away.
fn merge(base: &mut RawTable, over: RawTable, findings: &mut Findings) {
    for entry in over.entries {
        if matches!(&entry.value.value, RawValue::List(new) if new.is_empty()) {
            let (before, is_list) = (base.entries.len(), |e: &Entry| {
                matches!(e.value.value, RawValue::List(_))
            });
            base.entries.retain(|e| e.key != entry.key || !is_list(e));
            if base.entries.len() < before {
                continue;
            }
        }
        match base.entries.iter_mut().find(|e| e.key == entry.key) {
            None => base.entries.push(entry),
            Some(old) => merge_entry(old, entry, findings),
        }
    }
}

fn merge_entry(old: &mut Entry, new: Entry, findings: &mut Findings) {
    old.newest = new.newest;
    match (&mut old.value.value, new.value.value) {
        (RawValue::Table(a), RawValue::Table(b)) => {
            merge(a, b, findings);
        }
        (RawValue::List(list), RawValue::Table(b)) => merge_list(list, &old.key, b, findings),
        (_, value) => {
            old.key_span = new.key_span;
            old.value = Raw {
                span: new.value.span,
                value,
            };
        }
    }
}

/// `body.wall.KEY` or `body.0.KEY`: an element of an array of tables by its name or number.
fn merge_list(list: &mut [Raw], name: &str, over: RawTable, findings: &mut Findings) {
    for entry in over.entries {
        let position = list
            .iter()
            .position(|r| element_name(r) == Some(&entry.key));
        let position = position.or_else(|| entry.key.parse().ok().filter(|i| *i < list.len()));
        let element = position.map(|i| &mut list[i].value);
        if let (Some(RawValue::Table(a)), RawValue::Table(b)) = (element, entry.value.value) {
            merge(a, b, findings);
            continue;
        }
        let names: Vec<&str> = list
            .iter()
            .filter_map(|r| element_name(r).map(String::as_str))
            .collect();
        let help = super::suggest::did_you_mean(&entry.key, names.iter().copied(), "names");
        let message = format!("there is no [[{name}]] called `{}`", entry.key);
        findings.error(
            entry.key_span,
            message,
            "unknown name",
            format!("{help}; numbers count from 0"),
        );
    }
}

fn element_name(raw: &Raw) -> Option<&String> {
    let RawValue::Table(t) = &raw.value else {
        return None;
    };
    match &t.get("name")?.value.value {
        RawValue::Text(s) => Some(s),
        _ => None,
    }
}
