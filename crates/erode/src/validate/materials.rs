//! Materials of the validations: those of the library.

use super::Failure;
use crate::materials::{Library, Material, Terms};
use erode_physics::Elastic;
use erode_physics::eos::Tait;
use erode_physics::strength::Strength;

fn named(name: &str) -> Result<Material, Failure> {
    let library = Library::embedded().map_err(|e| Failure::Absent(e.to_string()))?;
    let found = library.get(name).cloned();
    found.ok_or_else(|| Failure::Absent(format!("the library has no material `{name}`")))
}

fn missing(what: Vec<String>) -> Failure {
    Failure::Absent(format!("the library does not give {}", what.join(", ")))
}

/// Water.
pub(super) fn water() -> Result<Tait, Failure> {
    named("water")?.fluid().map_err(missing)
}

/// Density (kg/m3), elasticity and yield law of a solid of the library.
pub(super) fn named_solid(name: &str, terms: Terms) -> Result<(f64, Elastic, Strength), Failure> {
    named(name)?.solid(terms).map_err(missing)
}

/// Density (kg/m3), elasticity and Johnson-Cook law of A-2205.
pub(super) fn steel() -> Result<(f64, Elastic, Strength), Failure> {
    let terms = Terms {
        strain_rate: true,
        thermal_softening: false,
    };
    named("steel_a2205")?.solid(terms).map_err(missing)
}

/// The same without the growth of its yield stress with the strain rate.
pub(super) fn steel_without_rate() -> Result<(f64, Elastic, Strength), Failure> {
    let terms = Terms {
        strain_rate: false,
        thermal_softening: false,
    };
    named("steel_a2205")?.solid(terms).map_err(missing)
}
