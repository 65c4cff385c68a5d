//! The report of a run: one HTML file that opens offline, made from the run folder alone.
//!
//! [`build`] writes `report/index.html`. [`plot`], [`picture`] and [`map`] draw figures as SVG and serve other commands too.

mod colour;
mod frame;
pub(crate) mod html;
mod instants;
mod lookup;
pub mod map;
mod page;
pub mod picture;
pub mod plot;
mod raster;
mod rayleigh;
mod run_data;
mod sections;
mod snapshot;
mod svg;
mod thin;
mod units;
mod view;

use std::path::{Path, PathBuf};

use crate::output::OutputError;
use crate::output::atomic::write_atomic;

pub use colour::{ColourMap, Colouring};
pub use raster::{CLOSING, REACH, View};
pub use rayleigh::{collapse_curve, collapse_time};
pub(crate) use sections::end::{End, radius_picture};
pub use units::quantity;

/// Why there is no report.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// The path is not a folder.
    #[error("there is no folder {path}; give the run folder that `erode run` wrote")]
    NoFolder {
        /// What was given.
        path: PathBuf,
    },
    /// Nothing that a run writes is in the folder.
    #[error(
        "{path} is not a run folder: none of case.toml, history.csv, fields.pvd, status.json and summary.json is in it; \
         give the folder that `erode run` wrote"
    )]
    NotARun {
        /// What was given.
        path: PathBuf,
    },
    /// The page or a figure cannot be written.
    #[error("{cause}; {hint}", cause = .0, hint = .0.hint())]
    Write(#[from] OutputError),
}

/// Makes `report/index.html` from the run folder `run_dir` and returns its path. A run that goes on or was stopped gets
/// a report of what is there; every section without data says so.
///
/// # Errors
/// No folder, no run in it, or the page cannot be written.
pub fn build(run_dir: &Path) -> Result<PathBuf, ReportError> {
    let data = run_data::RunData::read(run_dir)?;
    let path = run_dir.join("report").join("index.html");
    write_file(&path, page::compose(&data).as_bytes())?;
    Ok(path)
}

/// Writes a file, whole or not at all, and the folder for it.
fn write_file(path: &Path, bytes: &[u8]) -> Result<(), ReportError> {
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).map_err(|cause| OutputError::NotWritable {
            path: folder.to_path_buf(),
            cause,
        })?;
    }
    Ok(write_atomic(path, |file| file.write_all(bytes))?)
}
