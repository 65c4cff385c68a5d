//! What can go wrong with a sweep as a whole; a run that fails is no error of the sweep.

use crate::case::CaseErrors;
use crate::output::OutputError;
use thiserror::Error;

/// Why a sweep could not be planned or go on.
#[derive(Debug, Error)]
pub enum SweepError {
    /// The sweep file, or a case that it leads to, is wrong.
    #[error("the sweep is wrong")]
    Case(CaseErrors),
    /// The folder holds a sweep that is not this one.
    #[error("{folder} holds a sweep that differs from this one; nothing was run:\n{difference}")]
    Changed {
        /// The folder.
        folder: String,
        /// What differs, line by line.
        difference: String,
    },
    /// Files.
    #[error(transparent)]
    Output(#[from] OutputError),
}

impl From<CaseErrors> for SweepError {
    fn from(errors: CaseErrors) -> Self {
        Self::Case(errors)
    }
}
