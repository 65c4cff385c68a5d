//! Why a run could not start or did not reach its end.

use crate::case::CaseErrors;
use crate::output::OutputError;
use crate::report::ReportError;
use erode_physics::bubble::BubbleError;
use erode_sph::packing::PackingError;
use erode_sph::solid::SolidError;
use erode_sph::world::WorldError;
use thiserror::Error;

/// Why a run failed.
#[derive(Debug, Error)]
pub enum RunError {
    /// The case is wrong.
    #[error("the case is wrong")]
    Case(CaseErrors),
    /// A body cannot be filled with particles.
    #[error("body `{body}` cannot be filled with particles: {source}")]
    Packing {
        /// Body.
        body: String,
        /// Cause.
        source: PackingError,
    },
    /// A solid cannot be built.
    #[error("body `{body}`: {source}")]
    Solid {
        /// Body.
        body: String,
        /// Cause.
        source: SolidError,
    },
    /// Not in this version.
    #[error("body `{body}` asks for {what}, which this version does not have")]
    Unsupported {
        /// Body.
        body: String,
        /// What.
        what: String,
    },
    /// The world cannot be built.
    #[error(transparent)]
    World(#[from] WorldError),
    /// A bubble cannot be integrated.
    #[error(transparent)]
    Bubble(#[from] BubbleError),
    /// A cloud of bubbles cannot go on.
    #[error("{0}")]
    Cloud(String),
    /// Files.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// The report.
    #[error("the run is complete, but its report could not be written: {0}")]
    Report(#[from] ReportError),
    /// The calculation became unstable.
    #[error(
        "{what} at t = {time:.6e} s (step {step})\n  time step {dt:.3e} s, limited by {limiter}\n  {causes}"
    )]
    Unstable {
        /// Field, particle, place.
        what: String,
        /// Simulated time, s.
        time: f64,
        /// Step.
        step: u64,
        /// Time step, s.
        dt: f64,
        /// What limited it.
        limiter: String,
        /// Likely causes and what to do.
        causes: String,
    },
    /// A checkpoint that does not fit the case.
    #[error("the checkpoint does not fit the case: {0}")]
    Checkpoint(String),
    /// Threads.
    #[error("the threads could not be started: {0}")]
    Threads(String),
}
