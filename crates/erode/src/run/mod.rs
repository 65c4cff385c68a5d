//! Runs: from a case to a run folder.

mod background;
mod bubble_cloud;
mod build;
mod course;
mod drive;
mod error;
mod files;
mod gas;
mod impact;
mod impacts;
mod layers;
mod ledger;
mod loads;
mod monitor;
mod observer;
mod probes;
mod refinement;
mod results;
mod single_bubble;
mod state;
mod status;
mod steps;
mod strain_profile;
mod watch;
mod writing;

pub use build::world;
pub use drive::{Ended, Start, resume, start};
pub use error::RunError;
pub use ledger::Ledger;
pub use monitor::{BubbleState, Metal, bubble};
pub use observer::{Observer, Progress, Quiet, Stage};
pub(crate) use state::{accounts, store as store_state};
pub use strain_profile::{Column, columns, off_axis_maximum};
