//! Everything written to and read from a run folder: tables, snapshots, checkpoints, summary, status.
//!
//! Nothing here knows the physics: callers hand over named arrays with units. Every file that a reader may look at
//! while the run goes on is written beside its final name and renamed, so it is either the old or the new one. Tables
//! grow by whole rows. Errors are [`OutputError`], a sentence with the path and the cause, and a hint.

pub mod atomic;
pub mod checkpoint;
pub mod csv;
pub mod error;
pub mod failure;
pub mod hash;
pub(crate) mod lines;
pub mod lock;
pub mod pvd;
pub mod run_folder;
pub mod status;
pub mod summary;
pub mod vtu;

pub use checkpoint::{
    Array, Checkpoint, CheckpointMeta, CheckpointStore, Loaded, Refusal, Refused,
};
pub use csv::{Column, Sync, Table, TableWriter};
pub use error::OutputError;
pub use failure::write_failure;
pub use hash::hash_hex;
pub use pvd::{Collection, Entry};
pub use run_folder::{RunFolder, RunPaths};
pub use status::{State, Status};
pub use summary::Summary;
pub use vtu::{Data, Encoding, Field, Snapshot};
