//! Where a run stands, `status.json`: for `erode status` and for scripts.

use super::error::OutputError;
use super::summary::{read_json, write_json};
use serde::{Deserialize, Serialize};
use std::path::Path;

/// What a run is doing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum State {
    /// It computes. If no process holds the folder ([`super::RunPaths::holder`]), the process was killed.
    Running,
    /// It reached its end.
    Done,
    /// It stopped with an error.
    Failed,
    /// It was asked to stop and wrote a checkpoint.
    Interrupted,
}

/// Where a run stands.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Status {
    /// What it is doing.
    pub state: State,
    /// Simulated time, s.
    pub time: f64,
    /// Simulated time at the end, s.
    pub end_time: f64,
    /// Steps done.
    pub step: u64,
    /// Last time step, s.
    pub dt: f64,
    /// What limited the last time step.
    pub limiter: String,
    /// Steps per second of computing; unknown at first.
    pub steps_per_second: Option<f64>,
    /// Seconds of computing that are left; unknown at first.
    pub eta: Option<f64>,
    /// Energy that the ledger cannot account for, relative to the energy put in.
    pub energy_drift: Option<f64>,
    /// Number of the process.
    pub pid: u32,
    /// Why it failed or was interrupted.
    pub message: Option<String>,
}

impl Status {
    /// Writes the file, complete or not at all. Waits for the disk: about once a second is often enough.
    ///
    /// # Errors
    /// [`OutputError::Write`].
    pub fn write(&self, path: &Path) -> Result<(), OutputError> {
        write_json(path, self)
    }

    /// Reads what [`Status::write`] wrote.
    ///
    /// # Errors
    /// [`OutputError::Read`], [`OutputError::Malformed`].
    pub fn read(path: &Path) -> Result<Self, OutputError> {
        read_json(path)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comes_back_and_uses_the_documented_words() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("status.json");
        let status = Status {
            state: State::Interrupted,
            time: 1e-7 / 3.0,
            end_time: 1e-6,
            step: 12,
            dt: 1e-10,
            limiter: "sound_speed".into(),
            steps_per_second: Some(7.5),
            eta: None,
            energy_drift: Some(-1e-4),
            pid: 17,
            message: Some("SIGTERM".into()),
        };
        status.write(&path).unwrap();
        let text = std::fs::read_to_string(&path).unwrap();
        assert!(
            text.contains("\"state\": \"interrupted\"") && text.contains("\"eta\": null"),
            "{text}"
        );
        assert_eq!(Status::read(&path).unwrap(), status);
    }
}
