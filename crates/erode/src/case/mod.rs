//! Case files: from the user's TOML to a checked [`Simulation`] in SI units.
//!
//! The way of a text: `raw` (TOML with places) -> `overrides` (`--set`) -> `check` against the one list of keys
//! (`keys`, `keys_body`, `keys_material`) -> `build` (setups expand, bodies, relations between them) -> [`Simulation`].
//! Each stage records all its errors and goes on with what is right.

mod advice;
mod body;
pub mod bubbles;
mod build;
pub(crate) mod check;
mod check_blocks;
mod check_value;
pub mod cloud;
mod cloud_flow;
pub(crate) mod error;
pub mod estimate;
pub mod format;
mod impacts;
mod json_schema;
pub(crate) mod keys;
mod keys_body;
mod keys_bubbles;
mod keys_cloud;
mod keys_damage;
mod keys_impacts;
mod keys_load;
pub(crate) mod keys_material;
mod keys_region;
mod laws;
mod layers;
pub(crate) mod load;
mod loads;
pub(crate) mod node;
mod overrides;
pub(crate) mod raw;
mod relations;
mod resolved;
mod resolved_items;
mod resolved_loads;
mod schema;
mod setups;
mod setups_solid;
mod simulation;
pub(crate) mod suggest;
#[cfg(test)]
mod tests;
pub(crate) mod units;

pub use advice::check_advice;
pub use cloud_flow::Flow;
pub use error::{CaseError, CaseErrors};
pub use impacts::{Impact, Impacts, Relaxation};
pub use json_schema::json_schema;
pub use load::{Case, Loaded};
pub use loads::{Indenter, Loads, Pressure, Ramp, Settling};
pub use simulation::{
    Body, BodyKind, Bubble, BubbleGas, Fluid, FluidFormulation, Output, Probe, Refinement, Run,
    Side, Sides, Simulation, Solid, SolidFormulation, Wave,
};
