//! Numbers that the theory needs, searched in the summary and in `resolved.toml`.

use super::run_data::RunData;

/// A number, and whether it is a guess because the run folder does not tell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Found {
    pub(crate) value: f64,
    pub(crate) assumed: bool,
}

/// The pressure that drives the collapse, Pa.
pub(crate) fn driving_pressure(data: &RunData) -> Option<f64> {
    data.number("driving_pressure")
        .or_else(|| in_resolved(data, &["driving_pressure"]))
}

/// Density of the liquid at rest, kg/m3; water if the run folder does not tell.
pub(crate) fn liquid_density(data: &RunData) -> Found {
    let found = data
        .number("liquid_density")
        .or_else(|| in_resolved(data, &["reference_density", "rho0"]));
    Found {
        value: found.unwrap_or(1000.0),
        assumed: found.is_none(),
    }
}

/// The first number under one of `names` anywhere in `resolved.toml`, where all numbers are SI.
fn in_resolved(data: &RunData, names: &[&str]) -> Option<f64> {
    let table: toml::Table = data.resolved.parse().ok()?;
    search(&toml::Value::Table(table), names)
}

fn search(value: &toml::Value, names: &[&str]) -> Option<f64> {
    match value {
        toml::Value::Table(table) => {
            let here = names.iter().find_map(|name| number(table.get(*name)?));
            here.or_else(|| table.iter().find_map(|(_, inner)| search(inner, names)))
        }
        toml::Value::Array(items) => items.iter().find_map(|item| search(item, names)),
        _ => None,
    }
}

fn number(value: &toml::Value) -> Option<f64> {
    value
        .as_float()
        .or_else(|| value.as_integer().map(|i| i as f64))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_found_at_any_depth() {
        let data = RunData {
            resolved:
                "[bubble]\ndriving_pressure = 5e7\n[[body]]\nname = \"l\"\n[body.eos]\nrho0 = 998\n"
                    .into(),
            ..RunData::default()
        };
        assert_eq!(driving_pressure(&data), Some(5e7));
        assert_eq!(
            liquid_density(&data),
            Found {
                value: 998.0,
                assumed: false
            }
        );
        assert!(liquid_density(&RunData::default()).assumed);
    }
}
