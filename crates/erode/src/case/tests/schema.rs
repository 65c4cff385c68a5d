//! The JSON schema accepts what the reader accepts and refuses what it refuses.

use super::{ATTACHED, IN_LIQUID, NEAR_STEEL, OWN_BODIES, UNUSUAL};
use crate::case::json_schema;
use serde_json::Value;

/// A validator of the few words of JSON Schema that are used; any other word is a failure.
fn valid(value: &Value, schema: &Value) -> bool {
    schema
        .as_object()
        .unwrap()
        .iter()
        .all(|(word, rule)| match word.as_str() {
            "$schema" | "title" | "description" => true,
            "type" => match rule.as_str().unwrap() {
                "object" => value.is_object(),
                "array" => value.is_array(),
                "string" => value.is_string(),
                "boolean" => value.is_boolean(),
                "integer" => value.is_u64() || value.is_i64(),
                "number" => value.is_number(),
                other => panic!("unknown type {other}"),
            },
            "anyOf" => rule.as_array().unwrap().iter().any(|s| valid(value, s)),
            "oneOf" => {
                rule.as_array()
                    .unwrap()
                    .iter()
                    .filter(|s| valid(value, s))
                    .count()
                    == 1
            }
            "required" => rule
                .as_array()
                .unwrap()
                .iter()
                .all(|k| value.get(k.as_str().unwrap()).is_some()),
            "properties" => value.as_object().is_none_or(|map| {
                map.iter()
                    .all(|(k, v)| rule.get(k).is_none_or(|s| valid(v, s)))
            }),
            "additionalProperties" => value.as_object().is_none_or(|map| {
                let known =
                    |k: &String| schema.get("properties").is_some_and(|p| p.get(k).is_some());
                map.iter()
                    .all(|(k, v)| known(k) || (rule.is_object() && valid(v, rule)))
            }),
            "items" => value
                .as_array()
                .is_none_or(|list| list.iter().all(|v| valid(v, rule))),
            "minItems" => value
                .as_array()
                .is_none_or(|list| list.len() as u64 >= rule.as_u64().unwrap()),
            "maxItems" => value
                .as_array()
                .is_none_or(|list| list.len() as u64 <= rule.as_u64().unwrap()),
            "minimum" => value.as_f64().is_none_or(|x| x >= rule.as_f64().unwrap()),
            "maximum" => value.as_f64().is_none_or(|x| x <= rule.as_f64().unwrap()),
            "exclusiveMinimum" => value.as_f64().is_none_or(|x| x > rule.as_f64().unwrap()),
            "exclusiveMaximum" => value.as_f64().is_none_or(|x| x < rule.as_f64().unwrap()),
            // No regular expressions here: only whether it begins like a number.
            "pattern" => value.as_str().is_none_or(|s| {
                !rule.as_str().unwrap().contains("[0-9._]+") || begins_with_number(s)
            }),
            other => panic!("the schema uses `{other}`, which this test does not know"),
        })
}

fn begins_with_number(text: &str) -> bool {
    text.trim_start()
        .trim_start_matches(['+', '-'])
        .starts_with(|c: char| c.is_ascii_digit() || c == '.')
}

fn accepts(text: &str) -> bool {
    let value: toml::Table = text.parse().unwrap();
    valid(&serde_json::to_value(value).unwrap(), &json_schema())
}

#[test]
fn all_cases_satisfy_the_schema() {
    let templates = [NEAR_STEEL, ATTACHED, IN_LIQUID, OWN_BODIES];
    for text in templates.into_iter().chain(UNUSUAL) {
        assert!(accepts(text), "{text}");
        let resolved = super::resolved::write(&super::read(text, &[]));
        assert!(accepts(&resolved), "{resolved}");
    }
}

#[test]
fn wrong_cases_do_not() {
    for (old, new) in [
        ("radius = ", "radios = "),
        ("radius = \"0.15 mm\"", ""),
        ("radius = \"0.15 mm\"", "radius = -1"),
        ("radius = \"0.15 mm\"", "radius = \"big\""),
        ("radius = \"0.15 mm\"", "radius = true"),
        ("particles_per_radius = 30", "particles_per_radius = 1.5"),
        ("liquid = \"water\"", "liquid = 3"),
        ("name = \"wall_centre\"", "name = 3"),
        ("position = [0, \"0.01 mm\"]", "position = [0]"),
        ("[setup.bubble_near_wall]", "[setup.bubble_near_wal]"),
    ] {
        let text = NEAR_STEEL.replacen(old, new, 1);
        assert_ne!(text, NEAR_STEEL, "{old} is not in the case");
        assert!(!accepts(&text), "{new}");
    }
}
