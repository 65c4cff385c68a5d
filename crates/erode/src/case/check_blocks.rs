//! Checks blocks whose number or names the user chooses.

use super::{
    check::{check_table, join, title},
    error::{Findings, Span},
    node::{Data, Node},
    raw::{Raw, RawTable, RawValue},
    schema::Table,
};

pub(super) fn check_list(
    list: &[Raw],
    span: Span,
    schema: &'static Table,
    path: &str,
    findings: &mut Findings,
) -> Node {
    if list.is_empty() {
        let help = format!("write [[{path}]] blocks, or leave `{path}` out");
        findings.error(
            span,
            format!("`{path}` is an empty array"),
            "nothing in here",
            help,
        );
    }
    let mut nodes = Vec::new();
    for (i, raw) in list.iter().enumerate() {
        nodes.push(match &raw.value {
            RawValue::Table(t) => {
                check_table(t, raw.span, schema, &format!("{path}.{i}"), findings)
            }
            other => {
                let message = format!("`{path}` must hold tables, but this is {}", other.kind());
                findings.error(
                    raw.span,
                    message,
                    "expected a table",
                    format!("write it as [[{path}]]"),
                );
                Node {
                    span: raw.span,
                    data: Data::Bad,
                }
            }
        });
    }
    Node {
        span,
        data: Data::List(nodes),
    }
}

pub(super) fn check_map(
    table: &RawTable,
    span: Span,
    schema: &'static Table,
    path: &str,
    findings: &mut Findings,
) -> Node {
    let mut entries = Vec::new();
    for entry in &table.entries {
        let inner = join(path, &entry.key);
        let node = if let RawValue::Table(t) = &entry.value.value {
            check_table(t, entry.key_span, schema, &inner, findings)
        } else {
            let message = format!(
                "`{inner}` must be a table, but this is {}",
                entry.value.value.kind()
            );
            findings.error(
                entry.value.span,
                message,
                "expected a table",
                format!("write it as [{inner}]"),
            );
            Node {
                span: entry.value.span,
                data: Data::Bad,
            }
        };
        entries.push((entry.key.clone(), node));
    }
    Node {
        span,
        data: Data::Table(entries),
    }
}

pub(super) fn check_texts(
    table: &RawTable,
    span: Span,
    path: &str,
    findings: &mut Findings,
) -> Node {
    let mut entries = Vec::new();
    for entry in &table.entries {
        let data = if let RawValue::Text(s) = &entry.value.value {
            Data::Text(s.clone())
        } else {
            let message = format!("`{}` in {} must be a text", entry.key, title(path));
            findings.error(entry.value.span, message, "expected a text in quotes", "");
            Data::Bad
        };
        entries.push((
            entry.key.clone(),
            Node {
                span: entry.value.span,
                data,
            },
        ));
    }
    Node {
        span,
        data: Data::Table(entries),
    }
}
