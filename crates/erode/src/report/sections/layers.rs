//! The layers of a coated solid.

use serde_json::Value;

use crate::report::html::Page;
use crate::report::run_data::RunData;
use crate::report::units::quantity;

/// Writes the section; nothing for a solid without layers.
pub(crate) fn write(page: &mut Page, data: &RunData) {
    let Some(layers) = data.summary.get("layers").and_then(Value::as_array) else {
        return;
    };
    if layers.is_empty() {
        return;
    }
    page.section("Layers");
    let rows: Vec<Vec<String>> = layers
        .iter()
        .enumerate()
        .map(|(k, layer)| {
            let name = if k + 1 < layers.len() {
                format!("layer {}", k + 1)
            } else {
                "below".to_owned()
            };
            let material = layer["material"].as_str().unwrap_or("").to_owned();
            let number = |key: &str, unit: &str| {
                let value = layer[key].as_f64();
                value.map_or_else(String::new, |v| quantity(v, unit))
            };
            vec![
                name,
                material,
                number("thickness", "m"),
                number("resolved_thickness", "m"),
                number("max_plastic_strain", "-"),
                number("plastic_work", "J"),
                number("lost_mass", "kg"),
            ]
        })
        .collect();
    let head = [
        "",
        "material",
        "thickness",
        "as filled with particles",
        "largest plastic strain",
        "plastic work",
        "lost mass",
    ];
    page.table(&head, &rows);
}
