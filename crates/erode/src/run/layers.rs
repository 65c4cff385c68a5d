//! What the layers of a solid suffered, for the summary.

use super::monitor::solid;
use crate::case::{BodyKind, Simulation, format::si};
use erode_sph::solid::Solid;
use erode_sph::world::World;
use serde_json::{Value, json};

/// One entry per layer from the top, then one for the body below; none without layers.
pub(super) fn rows(world: &World, simulation: &Simulation) -> Vec<Value> {
    let asked = simulation.bodies.iter().find_map(|b| match &b.kind {
        BodyKind::Solid(s) if !s.layers.is_empty() => Some(s),
        _ => None,
    });
    let (Some(asked), Some(body)) = (asked, solid(world)) else {
        return Vec::new();
    };
    let layers = asked.layers.iter().enumerate();
    let mut rows: Vec<Value> = layers
        .map(|(k, l)| row(body, k + 1, &l.material, json!(l.thickness)))
        .collect();
    let all: f64 = asked.layers.iter().map(|l| l.thickness).sum();
    let rest = body.block.upper[1] - body.block.lower[1] - all;
    rows.push(row(body, 0, &asked.material, json!(rest)));
    rows
}

/// A layer made of particles is resolved by whole rows: told where that changes its thickness by more than this share.
const MISFIT: f64 = 0.1;

/// Layers whose particles make them thicker or thinner than asked.
pub(super) fn misfits(world: &World, simulation: &Simulation) -> Vec<String> {
    let of = |row: &Value, key: &str| row[key].as_f64().unwrap_or(f64::NAN);
    let mut rows = rows(world, simulation);
    // The last one is the body below the layers.
    rows.pop();
    let all = rows.iter().enumerate().map(|(k, row)| {
        let (asked, found) = (of(row, "thickness"), of(row, "resolved_thickness"));
        let off = found / asked - 1.0;
        (off.abs() > MISFIT).then(|| {
            format!(
                "layer {} ({}) is {} thick in its particles, {:+.0} % of the {} asked for: a finer spacing fits better",
                k + 1,
                row["material"].as_str().unwrap_or_default(),
                si(found, "m"),
                100.0 * off,
                si(asked, "m")
            )
        })
    });
    all.flatten().collect()
}

fn row(s: &Solid, layer: usize, material: &str, thickness: Value) -> Value {
    let of = || (0..s.len()).filter(move |&a| s.layers.index(a) == layer);
    let width = s.block.upper[0] - s.block.lower[0];
    // A sum of nothing is -0 in Rust.
    let sum = |value: &dyn Fn(usize) -> f64| of().map(value).sum::<f64>() + 0.0;
    let strain = of().map(|a| s.state.plastic_strain[a]);
    json!({
        "material": material,
        "thickness": thickness,
        "resolved_thickness": sum(&|a| s.reference.area[a]) / width,
        "max_plastic_strain": strain.fold(0.0, f64::max),
        "plastic_work": sum(&|a| s.state.plastic_work[a] * s.reference.volume[a]),
        "lost_mass": of().filter(|&a| s.is_removed(a)).map(|a| s.reference.mass[a]).sum::<f64>() + 0.0,
    })
}
