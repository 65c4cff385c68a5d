//! How fast whole steps are: standard workloads on this machine, with one thread and with two.
//!
//! Rates are particles x steps / second; the fastest of several blocks of steps counts, because other work on the machine
//! can only slow a block down. The rate per second of processor time stands beside it.

mod machine;
mod measure;
mod peak;
mod subject;
mod table;
mod workloads;

pub use machine::Machine;
pub use measure::{Measurement, Run};
pub use table::text;
pub use workloads::{ALL, Workload};

use crate::case::CaseErrors;
use crate::run::RunError;
use erode_sph::solid::SolidError;
use erode_sph::solid::space::SpaceError;
use erode_sph::world::WorldError;
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// Why a benchmark failed.
#[derive(Debug, Error)]
pub enum BenchError {
    /// Not the name of a workload.
    #[error("there is no workload `{name}`; there are {known}", known = names().join(", "))]
    Unknown {
        /// What was asked for.
        name: String,
    },
    /// The workload could not be built.
    #[error("the workload could not be built: {0}")]
    Build(#[from] RunError),
    /// A solid could not be built.
    #[error("the solid of the workload could not be built: {0}")]
    Solid(#[from] SolidError),
    /// A solid in three dimensions could not be built or advanced.
    #[error("the solid in three dimensions: {0}")]
    Space(#[from] SpaceError),
    /// A step failed.
    #[error("a step of the workload failed: {0}")]
    Step(#[from] WorldError),
    /// The material library lacks what a workload is made of.
    #[error("the material of the workload is not there: {0}")]
    Material(String),
    /// A temporary folder or a file in it.
    #[error("a checkpoint could not be written to measure the output: {0}")]
    Folder(String),
    /// No threads of the wanted number.
    #[error("{threads} threads cannot be started: {why}")]
    Threads {
        /// Number of threads.
        threads: usize,
        /// Cause.
        why: String,
    },
    /// The results of one and two threads differ.
    #[error(
        "workload `{name}` gave other bits with {threads} threads than with one: please report this"
    )]
    OtherBits {
        /// Workload.
        name: String,
        /// Number of threads.
        threads: usize,
    },
}

impl From<CaseErrors> for BenchError {
    fn from(e: CaseErrors) -> Self {
        Self::Material(e.to_string())
    }
}

/// Everything that `erode bench` finds out.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Outcome {
    /// Version of Erode.
    pub version: String,
    /// Where it ran.
    pub machine: Machine,
    /// One entry per workload.
    pub workloads: Vec<Measurement>,
}

/// Names of all workloads.
#[must_use]
pub fn names() -> Vec<&'static str> {
    ALL.iter().map(|w| w.name).collect()
}

/// The workloads with these names; without names those that are measured unasked.
///
/// # Errors
/// If a name is unknown.
pub fn selected(names: &[String]) -> Result<Vec<&'static Workload>, BenchError> {
    if names.is_empty() {
        return Ok(ALL.iter().filter(|w| w.usual).collect());
    }
    let find = |name: &String| {
        let unknown = || BenchError::Unknown { name: name.clone() };
        ALL.iter().find(|w| w.name == name).ok_or_else(unknown)
    };
    names.iter().map(find).collect()
}

impl Outcome {
    /// Puts the outcomes of several workloads, each measured in a process of its own, together; the machine is what the fastest of
    /// them saw. `None` without outcomes.
    #[must_use]
    pub fn joined(parts: Vec<Self>) -> Option<Self> {
        parts.into_iter().reduce(|mut all, part| {
            let (a, b) = (&mut all.machine, &part.machine);
            a.peak_one_thread = a.peak_one_thread.max(b.peak_one_thread);
            a.peak_two_threads = a.peak_two_threads.max(b.peak_two_threads);
            all.workloads.extend(part.workloads);
            all
        })
    }
}

/// Measures one workload; `particles` replaces their usual number. What a workload leaves in the memory of the process would
/// count as memory of the next, so each wants a process of its own.
///
/// # Errors
/// If it cannot be built or advanced, or gives other bits with another number of threads.
pub fn run(workload: &Workload, particles: Option<usize>) -> Result<Outcome, BenchError> {
    Ok(Outcome {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        workloads: vec![measure::measure(
            workload,
            particles.unwrap_or(workload.particles),
        )?],
        machine: Machine::here()?,
    })
}
