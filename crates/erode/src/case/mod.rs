//! Case files: from the user's TOML to a checked [`Simulation`] in SI units.

mod simulation;

pub use simulation::{
    Body, BodyKind, Bubble, Fluid, FluidFormulation, Output, Probe, Run, Side, Sides, Simulation,
    Solid, SolidFormulation, Wave,
};
