//! Key results and their comparison with the source.

use serde_json::Value;

use crate::report::html::Page;
use crate::report::run_data::RunData;
use crate::report::units::{in_words, quantity, significant};

/// Keys of the summary in the order of the table, with their words.
const KEY_RESULTS: [(&str, &str); 44] = [
    ("impacts", "Impacts"),
    ("incubation_impacts", "Impact in which mass was lost first"),
    (
        "incubation_impacts_estimate",
        "… estimated, Miner's rule from the last impacts",
    ),
    ("lost_mass_per_impact", "Mass lost per impact after that"),
    ("max_damage", "Largest damage"),
    ("settling_residual", "Motion left after settling, largest"),
    ("settling_energy", "Energy that settling took out"),
    (
        "collapse_time",
        "Collapse time, from the arrival of the wave",
    ),
    ("collapse_instant", "… at the instant"),
    ("rayleigh_time", "Rayleigh's collapse time"),
    (
        "smallest_bubble_radius",
        "Smallest equivalent radius of the bubble",
    ),
    ("jet_speed", "Jet speed"),
    ("jet_time", "… at the instant"),
    ("jet_half_width", "Half-width of the jet"),
    ("toroid_r", "Ring of void, distance from the axis"),
    ("toroid_z", "… height above the wall"),
    ("toroid_time", "… at the instant"),
    ("max_pressure", "Largest pressure in the liquid"),
    ("peak_wall_pressure", "Largest wall pressure"),
    ("peak_wall_pressure_time", "… at the instant"),
    ("peak_wall_pressure_r", "… at the radius"),
    (
        "shock_front_speed",
        "Shock front along the wall, one radius from the axis",
    ),
    ("max_plastic_strain", "Largest plastic strain"),
    ("max_plastic_strain_r", "… at the radius"),
    ("max_plastic_strain_depth", "… at the depth"),
    (
        "off_axis_plastic_strain",
        "Largest plastic strain apart from the axis",
    ),
    ("off_axis_plastic_strain_r", "… at the radius"),
    ("max_strain_rate", "Largest plastic strain rate"),
    ("plastic_volume", "Volume that yielded"),
    ("plastic_work", "Plastic work"),
    (
        "absorbed_energy_density",
        "Plastic work per volume that yielded",
    ),
    ("loading_time", "Time of load where the strain is largest"),
    ("material_time", "Time of the metal there"),
    ("lost_mass", "Mass that failed and was removed"),
    (
        "bubble_energy",
        "Energy of the bubble, pressure times volume",
    ),
    (
        "plastic_deformation_potential_share",
        "Plastic work per energy of the bubble",
    ),
    ("pit_depth", "Pit depth"),
    ("pit_radius", "Pit radius"),
    ("max_indenter_force", "Largest force of the indenter"),
    ("inertia_share", "Kinetic over internal energy at the end"),
    ("energy_drift", "Energy ledger, largest closing error"),
    ("energy_residual", "… in joules"),
    ("mass_drift", "Mass, closing error"),
    (
        "resolved_radius",
        "Radius down to which the collapse is resolved",
    ),
];

/// Numbers that the section on the run shows.
pub(super) const FACTS: [(&str, &str); 6] = [
    ("particles", "Particles"),
    ("end_time", "Simulated time"),
    ("steps", "Steps"),
    ("wall_time", "Wall time"),
    ("threads", "Threads"),
    ("version", "Version of Erode"),
];

/// The table of final numbers: first those with words of their own, then all others.
pub(crate) fn write(page: &mut Page, data: &RunData) {
    page.section("Results");
    let mut rows: Vec<Vec<String>> = Vec::new();
    for (key, words) in KEY_RESULTS {
        rows.extend(
            data.summary
                .get(key)
                .and_then(|value| row(data, key, words, value)),
        );
    }
    let known = |key: &str| {
        KEY_RESULTS
            .iter()
            .chain(&FACTS)
            .any(|(name, _)| *name == key)
    };
    for (key, value) in data
        .summary
        .as_object()
        .into_iter()
        .flatten()
        .filter(|(key, _)| !known(key))
    {
        rows.extend(row(data, key, &in_words(key), value));
    }
    if rows.is_empty() {
        page.absent("No final numbers: summary.json is missing or holds none.");
    } else {
        page.table(&[], &rows);
    }
}

/// A number that the run could not determine is null in the summary.
fn row(data: &RunData, key: &str, words: &str, value: &Value) -> Option<Vec<String>> {
    let text = match value {
        Value::Number(number) => shown(key, number.as_f64()?, data.unit(key)),
        Value::Null => "not determined".into(),
        _ => return None,
    };
    Some(vec![words.to_string(), text])
}

/// Value with unit; strains and shares in per cent.
fn shown(name: &str, value: f64, unit: &str) -> String {
    let share = matches!(unit, "-" | "1" | "")
        && ["strain", "drift", "share"]
            .iter()
            .any(|word| name.contains(word));
    if share && !name.contains("rate") {
        format!("{} %", significant(100.0 * value, 3))
    } else {
        quantity(value, unit)
    }
}

/// The table that puts this run beside the source (`comparison` in the summary).
pub(crate) fn write_comparison(page: &mut Page, data: &RunData) {
    page.section("Comparison with the source");
    let list = data.summary.get("comparison").and_then(Value::as_array);
    let rows: Vec<Vec<String>> = list.into_iter().flatten().map(comparison_row).collect();
    if rows.is_empty() {
        page.absent(
            "No reference values are known for this case (summary.json has no comparison).",
        );
    } else {
        page.table(
            &["quantity", "this run", "reference", "difference", "source"],
            &rows,
        );
    }
}

/// The words of a known key, else the name itself.
fn key_in_words(name: &str) -> String {
    let Some(index) = KEY_RESULTS.iter().position(|(key, _)| *key == name) else {
        return in_words(name);
    };
    let words = KEY_RESULTS[index].1;
    // "… at the radius" continues the words above it.
    let head = KEY_RESULTS[..index]
        .iter()
        .rfind(|(_, words)| !words.starts_with('…'));
    match (words.strip_prefix("… "), head) {
        (Some(rest), Some((_, head))) => format!("{head}, {rest}"),
        _ => words.to_string(),
    }
}

fn comparison_row(entry: &Value) -> Vec<String> {
    let text = |key: &str| {
        entry
            .get(key)
            .and_then(Value::as_str)
            .unwrap_or("")
            .to_string()
    };
    let name = text("quantity");
    let unit = entry.get("unit").and_then(Value::as_str).unwrap_or("-");
    let cell = |key: &str| match entry.get(key) {
        Some(Value::Number(number)) => number
            .as_f64()
            .map_or(String::new(), |v| shown(&name, v, unit)),
        Some(Value::String(words)) => words.clone(),
        _ => "not available".into(),
    };
    let number = |key: &str| entry.get(key).and_then(Value::as_f64);
    let difference = match (number("value"), number("reference")) {
        (Some(value), Some(reference)) if reference != 0.0 => {
            let percent = 100.0 * (value / reference - 1.0);
            format!(
                "{}{} %",
                if percent > 0.0 { "+" } else { "" },
                significant(percent, 2)
            )
        }
        _ => String::new(),
    };
    vec![
        key_in_words(&name),
        cell("value"),
        cell("reference"),
        difference,
        text("source"),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strains_are_shown_in_per_cent_and_compared() {
        let entry = serde_json::json!({"quantity": "max_plastic_strain", "value": 0.0025, "reference": 0.0023,
            "unit": "-", "source": "Joshi 2018, figure 6.7d"});
        assert_eq!(
            comparison_row(&entry),
            [
                "Largest plastic strain",
                "0.250 %",
                "0.230 %",
                "+8.7 %",
                "Joshi 2018, figure 6.7d"
            ]
        );
        let words =
            serde_json::json!({"quantity": "place", "value": "off the axis", "reference": null});
        assert_eq!(
            comparison_row(&words),
            ["Place", "off the axis", "not available", "", ""]
        );
        assert_eq!(
            key_in_words("max_plastic_strain_r"),
            "Largest plastic strain, at the radius"
        );
        assert_eq!(key_in_words("place_of_it"), "Place of it");
        assert_eq!(shown("max_strain_rate", 2.0e6, "1/s"), "2.000×10⁶ 1/s");
    }
}
