//! The machine that is measured, as Linux describes it in /proc.

use super::{BenchError, peak};
use serde::{Deserialize, Serialize};
use std::fs;

/// Bytes of a page of memory on the machines that /proc/self/statm speaks of here.
const PAGE: f64 = 4096.0;

/// The machine.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Machine {
    /// Model of its processor.
    pub processor: String,
    /// Logical cores.
    pub cores: usize,
    /// Measured peak of one thread, 1e9 multiplications and additions (f64) per second.
    pub peak_one_thread: f64,
    /// The same of two threads together.
    pub peak_two_threads: f64,
}

impl Machine {
    /// The machine this runs on.
    ///
    /// # Errors
    /// If no threads can be started.
    pub fn here() -> Result<Self, BenchError> {
        Ok(Self {
            processor: processor(),
            cores: std::thread::available_parallelism().map_or(1, usize::from),
            peak_one_thread: peak::measured(1)? / 1e9,
            peak_two_threads: peak::measured(2)? / 1e9,
        })
    }
}

fn processor() -> String {
    let text = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let line = text.lines().find(|l| l.starts_with("model name"));
    let name = line.and_then(|l| l.split(':').nth(1)).map(str::trim);
    name.unwrap_or("unknown processor").to_owned()
}

/// Resident memory of this process, bytes; none where the system does not tell.
pub(super) fn resident_memory() -> Option<f64> {
    let text = fs::read_to_string("/proc/self/statm").ok()?;
    let pages: f64 = text.split_whitespace().nth(1)?.parse().ok()?;
    Some(pages * PAGE)
}

/// Processor time of all threads of this process that live, s; none where the system does not tell.
pub(super) fn processor_time() -> Option<f64> {
    let tasks = fs::read_dir("/proc/self/task").ok()?;
    let of_task = |folder: fs::DirEntry| {
        let text = fs::read_to_string(folder.path().join("schedstat")).ok()?;
        text.split_whitespace().next()?.parse::<f64>().ok()
    };
    let nanoseconds: f64 = tasks.flatten().filter_map(of_task).sum();
    (nanoseconds > 0.0).then_some(1e-9 * nanoseconds)
}
