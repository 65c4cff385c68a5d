//! Checks single values: kind, unit, range.

use super::{
    error::Findings,
    node::{Data, Node},
    raw::{Raw, RawTable, RawValue},
    schema::{Key, Kind, Range},
    suggest::did_you_mean,
    units::{self, Dimension},
};

/// Checks a value that is no table.
pub(crate) fn check_scalar(raw: &Raw, key: &'static Key, findings: &mut Findings) -> Node {
    let data = match (key.kind, &raw.value) {
        (Kind::Text, RawValue::Text(s)) => Data::Text(s.clone()),
        (Kind::Name, RawValue::Text(s)) => name(s, raw, key, findings),
        (Kind::Switch, RawValue::Switch(b)) => Data::Switch(*b),
        (Kind::Count(least), RawValue::Integer(x)) => count(*x, least, raw, key, findings),
        (Kind::Pair(d), RawValue::List(list)) => pair(list, d, raw, key, findings),
        (Kind::Quantity(d, range), _) => {
            quantity(raw, d, range, key, findings).map_or(Data::Bad, Data::Number)
        }
        (Kind::Property(d, range), RawValue::Table(t)) => property(t, raw, d, range, key, findings),
        (Kind::Property(d, range), _) => {
            quantity(raw, d, range, key, findings).map_or(Data::Bad, |x| Data::Property {
                value: x,
                dimension: d,
                source: None,
            })
        }
        (kind, other) => {
            let wanted = match kind {
                Kind::Text | Kind::Name => "a text in quotes",
                Kind::Switch => "true or false",
                Kind::Count(_) => "a whole number",
                _ => "an array of two numbers",
            };
            let message = format!(
                "`{}` must be {wanted}, but this is {}",
                key.name,
                other.kind()
            );
            let help = format!("for example {}", super::check::example(key));
            findings.error(raw.span, message, format!("expected {wanted}"), help);
            Data::Bad
        }
    };
    Node {
        span: raw.span,
        data,
    }
}

fn name(text: &str, raw: &Raw, key: &Key, findings: &mut Findings) -> Data {
    let fits = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    if !text.is_empty() && text.len() <= 60 && text.chars().all(fits) {
        return Data::Text(text.to_owned());
    }
    let message = format!("`{}` cannot be {text:?}", key.name);
    let help = "it names files and columns: 1 to 60 of the characters a-z, A-Z, 0-9, _ and -";
    findings.error(raw.span, message, "not a name", help);
    Data::Bad
}

fn count(x: f64, least: u32, raw: &Raw, key: &Key, findings: &mut Findings) -> Data {
    // Counts up to 2^53 are exact as f64.
    if x >= f64::from(least) && x <= 9.0e15 {
        return Data::Number(x);
    }
    let message = format!(
        "`{}` must be a whole number, at least {least}, but is {x}",
        key.name
    );
    findings.error(
        raw.span,
        message,
        "out of range",
        format!("it is the {}", key.about),
    );
    Data::Bad
}

fn pair(list: &[Raw], d: Dimension, raw: &Raw, key: &Key, findings: &mut Findings) -> Data {
    let [a, b] = list else {
        let message = format!(
            "`{}` must have two numbers, but has {}",
            key.name,
            list.len()
        );
        findings.error(
            raw.span,
            message,
            "expected [a, b]",
            format!("for example {}", super::check::example(key)),
        );
        return Data::Bad;
    };
    let a = quantity(a, d, Range::Any, key, findings);
    let b = quantity(b, d, Range::Any, key, findings);
    a.zip(b).map_or(Data::Bad, |(a, b)| Data::Pair([a, b]))
}

/// `{ value = ..., source = "..." }`
fn property(
    table: &RawTable,
    raw: &Raw,
    d: Dimension,
    range: Range,
    key: &Key,
    findings: &mut Findings,
) -> Data {
    for e in table
        .entries
        .iter()
        .filter(|e| e.key != "value" && e.key != "source")
    {
        let help = did_you_mean(&e.key, ["value", "source"].into_iter(), "allowed keys");
        findings.error(
            e.key_span,
            format!("unknown key `{}` in `{}`", e.key, key.name),
            "not known here",
            help,
        );
    }
    let Some(value) = table.get("value") else {
        let help = format!(
            "for example {} = {{ value = {}, source = \"...\" }}",
            key.name,
            d.example()
        );
        findings.error(
            raw.span,
            format!("`{}` lacks its `value`", key.name),
            "needed here",
            help,
        );
        return Data::Bad;
    };
    let source = property_source(table, key, findings);
    quantity(&value.value, d, range, key, findings).map_or(Data::Bad, |x| Data::Property {
        value: x,
        dimension: d,
        source,
    })
}

fn property_source(table: &RawTable, key: &Key, findings: &mut Findings) -> Option<String> {
    let given = &table.get("source")?.value;
    if let RawValue::Text(s) = &given.value {
        return Some(s.clone());
    }
    let message = format!("the source of `{}` must be a text", key.name);
    findings.error(given.span, message, "expected a text in quotes", "");
    None
}

/// A number in SI, or the error that keeps it from being one.
fn quantity(
    raw: &Raw,
    d: Dimension,
    range: Range,
    key: &Key,
    findings: &mut Findings,
) -> Option<f64> {
    let value = match number(raw, d) {
        Ok(value) => value,
        Err((found, label, hint)) => {
            let help = format!("{hint}{}", how_to_write(d, key));
            let message = format!("`{}` is {}, but {found}", key.name, d.name());
            findings.error(raw.span, message, label, help);
            return None;
        }
    };
    if !value.is_finite() {
        let message = format!("`{}` must be finite, but is {value}", key.name);
        findings.error(
            raw.span,
            message,
            "not a finite number",
            how_to_write(d, key),
        );
        return None;
    }
    if !range.contains(value) {
        let unit = if d == units::NUMBER {
            String::new()
        } else {
            format!(" {d}")
        };
        let message = format!(
            "`{}` must be {}, but is {value}{unit}",
            key.name,
            range.rule()
        );
        findings.error(
            raw.span,
            message,
            "out of range",
            format!("it is the {}", key.about),
        );
        return None;
    }
    Some(value)
}

/// The number of a quantity of dimension `d`, or (what was found, label, hint).
fn number(raw: &Raw, d: Dimension) -> Result<f64, (String, String, String)> {
    match &raw.value {
        RawValue::Integer(x) | RawValue::Float(x) => Ok(*x),
        RawValue::Text(text) => match units::parse(text) {
            Ok(q) if q.dimension.is_none_or(|found| found == d) => Ok(q.value),
            Ok(q) => {
                let found = q.dimension.map_or_else(String::new, Dimension::name);
                Err((
                    format!("{text:?} is {found}"),
                    "wrong dimension".to_owned(),
                    String::new(),
                ))
            }
            Err(e) => {
                let hint = format!(
                    "{}{} ",
                    e.hint,
                    if e.hint.ends_with('?') { "" } else { ";" }
                );
                Err((format!("{text:?} cannot be read"), e.why, hint))
            }
        },
        other => Err((
            format!("this is {}", other.kind()),
            "expected a number".to_owned(),
            String::new(),
        )),
    }
}

fn how_to_write(d: Dimension, key: &Key) -> String {
    let example = super::check::example(key);
    if d == units::NUMBER {
        return format!("write a plain number, for example {example}");
    }
    format!("plain numbers are SI ({d}); with a unit, for example {example}")
}
