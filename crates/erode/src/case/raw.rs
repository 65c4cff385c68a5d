//! TOML as written, each value with its place; overrides of the command line are merged into it.

use super::error::{Findings, Span};
use toml::de::{DeTable, DeValue};

/// A value as written.
#[derive(Debug, Clone)]
pub(crate) struct Raw {
    pub(crate) span: Span,
    pub(crate) value: RawValue,
}

/// Kinds of TOML values.
#[derive(Debug, Clone)]
pub(crate) enum RawValue {
    Text(String),
    Integer(f64),
    Float(f64),
    Switch(bool),
    Date,
    List(Vec<Raw>),
    Table(RawTable),
}

impl RawValue {
    /// What the value is, with article.
    pub(crate) fn kind(&self) -> &'static str {
        match self {
            Self::Text(_) => "a text",
            Self::Integer(_) => "an integer",
            Self::Float(_) => "a decimal number",
            Self::Switch(_) => "true or false",
            Self::Date => "a date",
            Self::List(_) => "an array",
            Self::Table(_) => "a table",
        }
    }
}

/// A table as written; keys in the order of the text.
#[derive(Debug, Clone, Default)]
pub(crate) struct RawTable {
    pub(crate) entries: Vec<Entry>,
}

/// A key with its value.
#[derive(Debug, Clone)]
pub(crate) struct Entry {
    pub(crate) key: String,
    pub(crate) key_span: Span,
    pub(crate) value: Raw,
    /// Number of the last text that touched this entry.
    pub(crate) newest: usize,
}

impl RawTable {
    pub(crate) fn get(&self, key: &str) -> Option<&Entry> {
        self.entries.iter().find(|e| e.key == key)
    }
}

/// Parses one of the texts; all syntax errors are recorded.
pub(crate) fn parse(source: usize, findings: &mut Findings) -> RawTable {
    let text = findings.sources[source].text.clone();
    let (table, errors) = DeTable::parse_recoverable(&text);
    for e in &errors {
        let at = e.span().unwrap_or(text.len()..text.len());
        let span = Span {
            source,
            start: at.start,
            end: at.end,
        };
        let what = e.message().trim_end_matches(", expected nothing");
        let message = format!("this is not valid TOML: {what}");
        let help = "a line is `key = value` or `[table]`; texts and quantities stand in quotes: radius = \"0.15 mm\"";
        findings.error(span, message, "", help);
    }
    convert_table(source, table.get_ref())
}

fn convert_table(source: usize, table: &DeTable<'_>) -> RawTable {
    let entries = table.iter().map(|(key, value)| Entry {
        key: key.get_ref().to_string(),
        key_span: span(source, key.span()),
        value: Raw {
            span: span(source, value.span()),
            value: convert(source, value.get_ref()),
        },
        newest: source,
    });
    RawTable {
        entries: entries.collect(),
    }
}

fn convert(source: usize, value: &DeValue<'_>) -> RawValue {
    match value {
        DeValue::String(s) => RawValue::Text(s.to_string()),
        DeValue::Integer(i) => {
            // Digits beyond 64 bits are still a number; the range check of the key decides about them.
            let exact = i64::from_str_radix(i.as_str(), i.radix()).ok();
            #[allow(clippy::cast_precision_loss)]
            let value = exact.map(|v| v as f64);
            RawValue::Integer(
                value
                    .or_else(|| i.as_str().parse().ok())
                    .unwrap_or(f64::INFINITY),
            )
        }
        DeValue::Float(f) => RawValue::Float(f.as_str().parse().unwrap_or(f64::NAN)),
        DeValue::Boolean(b) => RawValue::Switch(*b),
        DeValue::Datetime(_) => RawValue::Date,
        DeValue::Array(a) => RawValue::List(
            a.iter()
                .map(|v| Raw {
                    span: span(source, v.span()),
                    value: convert(source, v.get_ref()),
                })
                .collect(),
        ),
        DeValue::Table(t) => RawValue::Table(convert_table(source, t)),
    }
}

fn span(source: usize, range: std::ops::Range<usize>) -> Span {
    Span {
        source,
        start: range.start,
        end: range.end,
    }
}
