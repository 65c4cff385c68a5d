//! Runs: from a case to a run folder.

mod build;
mod drive;
mod error;
mod ledger;
mod monitor;
mod probes;
mod results;
mod state;

pub use build::world;
pub use drive::{Ended, Observer, Progress, Quiet, Start, resume, start};
pub use error::RunError;
pub use ledger::Ledger;
pub use monitor::{BubbleState, Metal, bubble};
