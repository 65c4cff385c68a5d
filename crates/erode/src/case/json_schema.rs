//! JSON schema of case files, generated from the list of keys, for editors.

use super::{
    keys::CASE,
    schema::{Key, Kind, Need, Range, Table},
};
use serde_json::{Map, Value, json};

/// The schema (draft 2020-12).
#[must_use]
pub fn json_schema() -> Value {
    let mut schema = table(&CASE);
    if let Value::Object(map) = &mut schema {
        map.insert(
            "$schema".to_owned(),
            json!("https://json-schema.org/draft/2020-12/schema"),
        );
        map.insert("title".to_owned(), json!("Erode case"));
    }
    schema
}

fn table(t: &'static Table) -> Value {
    let properties: Map<String, Value> =
        t.keys.iter().map(|k| (k.name.to_owned(), key(k))).collect();
    let required: Vec<&str> = t
        .keys
        .iter()
        .filter(|k| k.need == Need::Required)
        .map(|k| k.name)
        .collect();
    let mut schema = json!({
        "type": "object",
        "description": t.about,
        "properties": properties,
        "required": required,
        "additionalProperties": false,
    });
    if !t.one_of.is_empty() {
        let alternatives: Vec<Value> = t
            .one_of
            .iter()
            .map(|name| json!({ "required": [name] }))
            .collect();
        schema["oneOf"] = json!(alternatives);
    }
    schema
}

fn key(k: &'static Key) -> Value {
    let mut schema = kind(k.kind);
    let default = match k.need {
        Need::Default(text) if !text.is_empty() => format!(" (default: {text})"),
        _ => String::new(),
    };
    let unit = match k.kind {
        Kind::Quantity(d, _) | Kind::Pair(d) | Kind::Property(d, _)
            if d != super::units::NUMBER =>
        {
            format!("; plain numbers in {d}")
        }
        _ => String::new(),
    };
    schema["description"] = json!(format!("{}{unit}{default}", k.about));
    schema
}

fn kind(kind: Kind) -> Value {
    match kind {
        Kind::Text => json!({ "type": "string" }),
        Kind::Name => json!({ "type": "string", "pattern": "^[A-Za-z0-9_-]{1,60}$" }),
        Kind::Switch => json!({ "type": "boolean" }),
        Kind::Count(least) => json!({ "type": "integer", "minimum": least }),
        Kind::Quantity(_, range) => quantity(range),
        Kind::Pair(_) => {
            json!({ "type": "array", "items": quantity(Range::Any), "minItems": 2, "maxItems": 2 })
        }
        Kind::Property(_, range) => json!({ "anyOf": [
            quantity(range),
            {
                "type": "object",
                "properties": { "value": quantity(range), "source": { "type": "string" } },
                "required": ["value"],
                "additionalProperties": false,
            },
        ] }),
        Kind::Table(t) => table(t),
        Kind::List(t) => json!({ "type": "array", "items": table(t), "minItems": 1 }),
        Kind::Map(t) => json!({ "type": "object", "additionalProperties": table(t) }),
        Kind::Texts => json!({ "type": "object", "additionalProperties": { "type": "string" } }),
    }
}

/// A number in SI, or a text with a number and a unit.
fn quantity(range: Range) -> Value {
    let mut number = json!({ "type": "number" });
    match range {
        Range::Any => {}
        Range::Positive => number["exclusiveMinimum"] = json!(0),
        Range::NotNegative => number["minimum"] = json!(0),
        Range::Between(a, b) => {
            number["exclusiveMinimum"] = json!(a);
            number["exclusiveMaximum"] = json!(b);
        }
        Range::Within(a, b) => {
            number["minimum"] = json!(a);
            number["maximum"] = json!(b);
        }
    }
    let text =
        json!({ "type": "string", "pattern": r"^\s*[+-]?[0-9._]+([eE][+-]?[0-9]+)?\s*\S*.*$" });
    json!({ "anyOf": [number, text] })
}
