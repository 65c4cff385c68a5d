//! Sweeps: one case, many runs, one table of results.
//!
//! The way of a sweep: `file` (the user's TOML to lists of settings) -> `plan` (every run with its name and its checked
//! case) -> `folder` (what an earlier sweep left; refused when the plan has changed) -> `execute` (runs one after the
//! other, each resumable, failures isolated) -> `table` and `report`. [`execute`] and [`Planned`] also serve
//! reproductions, whose runs are listed in the program.

mod chart;
mod error;
mod execute;
mod file;
mod folder;
mod parquet;
mod pictures;
mod plan;
mod report;
mod results;
mod setting;
mod table;

pub use error::SweepError;
pub use execute::{Execution, Outcome, Overall, Watcher, execute};
pub use folder::{Folder, Stand, Unfit, stand_of};
pub use pictures::{Picture, final_picture};
pub use plan::{Cost, Plan, Planned};
pub use report::write_report;
pub use results::Results;
pub use setting::{Setting, Value};
pub use table::{Table, write_csv};
