//! Checks a text against its keys and records every error in one pass.

use super::{
    check_blocks::{check_list, check_map, check_texts},
    check_value::check_scalar,
    error::{Findings, Span},
    node::{Data, Node},
    raw::{Entry, Raw, RawTable, RawValue},
    schema::{Key, Kind, Need, Table},
    suggest::{closest, did_you_mean},
};

/// Checks a table. `path` is its name as written in brackets, empty for the whole file.
pub(crate) fn check_table(
    raw: &RawTable,
    span: Span,
    schema: &'static Table,
    path: &str,
    findings: &mut Findings,
) -> Node {
    let mut entries = Vec::new();
    let chosen = check_choice(raw, span, schema, path, findings);
    // A key that is only misspelt is not reported as missing too.
    let mut meant = Vec::new();
    for entry in raw.entries.iter().filter(|e| schema.key(&e.key).is_none()) {
        unknown_key(entry, schema, path, findings);
        meant.extend(closest(&entry.key, schema.keys.iter().map(|k| k.name)));
    }
    for key in schema.keys {
        let is_alternative = schema.one_of.contains(&key.name);
        if is_alternative && chosen != Some(key.name) {
            continue;
        }
        let node = match raw.get(key.name) {
            Some(entry) => Some(check_entry(entry, key, &join(path, key.name), findings)),
            None if key.need == Need::Required && meant.contains(&key.name) => None,
            None => absent(key, span, path, findings),
        };
        entries.extend(node.map(|n| (key.name.to_owned(), n)));
    }
    Node {
        span,
        data: Data::Table(entries),
    }
}

/// The alternative that is meant, when the table has alternatives. An override replaces the choice of the file.
fn check_choice(
    raw: &RawTable,
    span: Span,
    schema: &'static Table,
    path: &str,
    findings: &mut Findings,
) -> Option<&'static str> {
    let alternatives = schema.one_of;
    if alternatives.is_empty() {
        return None;
    }
    let present: Vec<&Entry> = raw
        .entries
        .iter()
        .filter(|e| alternatives.contains(&e.key.as_str()))
        .collect();
    let newest = present.iter().map(|e| e.newest).max();
    let latest: Vec<&&Entry> = present
        .iter()
        .filter(|e| Some(e.newest) == newest)
        .collect();
    let allowed = alternatives
        .iter()
        .map(|a| format!("[{}]", join(path, a)))
        .collect::<Vec<_>>()
        .join(", ");
    let help = format!("write exactly one of {allowed}");
    match latest.as_slice() {
        [] => {
            let has_unknown = raw.entries.iter().any(|e| schema.key(&e.key).is_none());
            if !has_unknown {
                findings.error(
                    span,
                    format!("{} does not say what it is", title(path)),
                    "nothing chosen",
                    help,
                );
            }
            None
        }
        [one] => schema.key(&one.key).map(|k| k.name),
        [first, .., last] => {
            let message = format!("{} is both `{}` and `{}`", title(path), first.key, last.key);
            findings.error(last.key_span, message, "one too many", help);
            None
        }
    }
}

fn unknown_key(entry: &Entry, schema: &'static Table, path: &str, findings: &mut Findings) {
    let names = schema.keys.iter().map(|k| k.name);
    let what = if schema.one_of.is_empty() {
        "allowed keys"
    } else {
        "allowed"
    };
    let help = if schema.keys.is_empty() {
        "this table takes no keys".to_owned()
    } else {
        did_you_mean(&entry.key, names, what)
    };
    let message = format!("unknown key `{}` in {}", entry.key, title(path));
    findings.error(entry.key_span, message, "not known here", help);
}

fn check_entry(entry: &Entry, key: &'static Key, path: &str, findings: &mut Findings) -> Node {
    let raw = &entry.value;
    let span = match raw.value {
        RawValue::Table(_) => entry.key_span,
        _ => raw.span,
    };
    match (key.kind, &raw.value) {
        (Kind::Table(schema), RawValue::Table(t)) => check_table(t, span, schema, path, findings),
        (Kind::List(schema), RawValue::List(list)) => {
            check_list(list, span, schema, path, findings)
        }
        (Kind::Map(schema), RawValue::Table(t)) => check_map(t, span, schema, path, findings),
        (Kind::Texts, RawValue::Table(t)) => check_texts(t, span, path, findings),
        (Kind::Table(_) | Kind::List(_) | Kind::Map(_) | Kind::Texts, other) => {
            let (wanted, example) = match key.kind {
                Kind::List(_) => ("an array of tables", format!("[[{path}]]")),
                _ => ("a table", format!("[{path}]")),
            };
            let message = format!(
                "`{}` must be {wanted}, but this is {}",
                key.name,
                other.kind()
            );
            findings.error(
                span,
                message,
                format!("expected {wanted}"),
                format!("write it as {example}"),
            );
            Node {
                span,
                data: Data::Bad,
            }
        }
        _ => check_scalar(raw, key, findings),
    }
}

/// What an absent key stands for.
fn absent(key: &'static Key, span: Span, path: &str, findings: &mut Findings) -> Option<Node> {
    match key.need {
        Need::Optional => None,
        Need::Required => {
            let message = format!("{} lacks `{}`", title(path), key.name);
            let help = format!(
                "`{}` is the {}; for example {}",
                key.name,
                key.about,
                example(key)
            );
            findings.error(span, message, "needed here", help);
            None
        }
        Need::Default(text) => match key.kind {
            Kind::Table(schema) => {
                let table = default_table(text, span);
                Some(check_table(
                    &table,
                    span,
                    schema,
                    &join(path, key.name),
                    findings,
                ))
            }
            _ => Some(check_scalar(
                &default_value(key.kind, text, span),
                key,
                findings,
            )),
        },
    }
}

/// The table of a choice with its default, or an empty one.
fn default_table(choice: &str, span: Span) -> RawTable {
    let entry = |name: &str| Entry {
        key: name.to_owned(),
        key_span: span,
        value: Raw {
            span,
            value: RawValue::Table(RawTable::default()),
        },
        newest: 0,
    };
    RawTable {
        entries: Some(choice)
            .filter(|c| !c.is_empty())
            .map(entry)
            .into_iter()
            .collect(),
    }
}

fn default_value(kind: Kind, text: &str, span: Span) -> Raw {
    let number = || RawValue::Float(text.parse().unwrap_or(f64::NAN));
    let value = match kind {
        Kind::Switch => RawValue::Switch(text == "true"),
        Kind::Count(_) => RawValue::Integer(text.parse().unwrap_or(f64::NAN)),
        Kind::Text | Kind::Name => RawValue::Text(text.to_owned()),
        Kind::Pair(_) => RawValue::List(vec![
            Raw {
                span,
                value: number(),
            },
            Raw {
                span,
                value: number(),
            },
        ]),
        _ => number(),
    };
    Raw { span, value }
}

/// An example line for a key.
pub(crate) fn example(key: &Key) -> String {
    match key.kind {
        Kind::Text | Kind::Name => format!("{} = \"...\"", key.name),
        Kind::Switch => format!("{} = true", key.name),
        Kind::Count(_) => format!("{} = 30", key.name),
        Kind::Quantity(d, _) | Kind::Property(d, _) => match key.need {
            Need::Default(value) if d == super::units::NUMBER => format!("{} = {value}", key.name),
            _ => format!("{} = {}", key.name, d.example()),
        },
        Kind::Pair(d) => format!("{} = [{e}, {e}]", key.name, e = d.example()),
        Kind::Table(t) if !t.one_of.is_empty() => {
            format!("{}.{} = {{ ... }}", key.name, t.one_of[0])
        }
        Kind::Table(_) | Kind::Map(_) | Kind::Texts => format!("a table [{}]", key.name),
        Kind::List(_) => format!("[[{}]]", key.name),
    }
}

pub(super) fn join(path: &str, key: &str) -> String {
    if path.is_empty() {
        key.to_owned()
    } else {
        format!("{path}.{key}")
    }
}

/// How a table is called in messages.
pub(super) fn title(path: &str) -> String {
    if path.is_empty() {
        "the case".to_owned()
    } else {
        format!("[{path}]")
    }
}
