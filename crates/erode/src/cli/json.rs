//! Results as a JSON file, for `--json FILE`.

use super::failure::{Failure, Outcome};
use serde::Serialize;
use std::fmt::Display;
use std::path::Path;

/// Writes results to a file.
pub(crate) fn write(file: &Path, results: &impl Serialize) -> Outcome {
    let wrong = |e: &dyn Display| {
        let message = format!("{} cannot be written: {e}", file.display());
        Failure::failed(message, String::new())
    };
    let text = serde_json::to_string_pretty(results).map_err(|e| wrong(&e))?;
    std::fs::write(file, text + "\n").map_err(|e| wrong(&e))
}

/// Writes results to the file, if one was asked for, and ends as `ended`: what was found is told before a file that could
/// not be written.
pub(crate) fn write_and_end(
    file: Option<&Path>,
    results: &impl Serialize,
    ended: Outcome,
) -> Outcome {
    let written = file.map_or(Ok(()), |file| write(file, results));
    if let (Err(found), Err(_)) = (&ended, &written) {
        found.report();
        return written;
    }
    ended.and(written)
}
