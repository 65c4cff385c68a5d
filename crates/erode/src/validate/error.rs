//! What can go wrong with validations.

use crate::case::suggest::closest;
use erode_fv::bubbles::CloudError;
use erode_fv::bubbles::carrier::CarrierError;
use erode_physics::bubble::BubbleError;
use erode_physics::material_point::PathError;
use erode_sph::packing::PackingError;
use erode_sph::solid::SolidError;
use erode_sph::world::WorldError;
use thiserror::Error;

/// Why nothing was run.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum ValidateError {
    /// No such validation.
    #[error("there is no validation `{0}`; {hint}there are: {list}", hint = hint(.0), list = list())]
    Unknown(String),
    /// Neither names nor `--all`.
    #[error("name the validations to run, or give --all; there are: {}", list())]
    NothingChosen,
}

fn list() -> String {
    super::names().join(", ")
}

fn hint(name: &str) -> String {
    let near = closest(name, super::names().into_iter());
    near.map_or_else(String::new, |n| format!("did you mean `{n}`? "))
}

/// Why a validation could not be completed.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum Failure {
    /// A simulation stopped.
    #[error("the simulation stopped: {0}")]
    World(#[from] WorldError),
    /// A solid could not be built or advanced.
    #[error("the solid failed: {0}")]
    Solid(#[from] SolidError),
    /// A region could not be filled.
    #[error("the region could not be filled with particles: {0}")]
    Packing(#[from] PackingError),
    /// A material point could not be driven along its path.
    #[error("the material point failed: {0}")]
    Path(#[from] PathError),
    /// A bubble could not be integrated.
    #[error("the bubble failed: {0}")]
    Bubble(#[from] BubbleError),
    /// A cloud of bubbles could not be advanced.
    #[error("the cloud of bubbles failed: {0}")]
    Cloud(#[from] CloudError),
    /// A flow has no answer.
    #[error("the flow failed: {0}")]
    Carrier(#[from] CarrierError),
    /// A run stopped.
    #[error("the run stopped: {0}")]
    Run(String),
    /// Something expected did not happen.
    #[error("{0}")]
    Absent(String),
}
