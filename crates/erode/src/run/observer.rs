//! Who watches a run, and what is told.

/// Progress for people.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Progress<'a> {
    /// Simulated time, s.
    pub time: f64,
    /// Simulated time at the end, s.
    pub end_time: f64,
    /// Steps done.
    pub step: u64,
    /// Steps per second of computing.
    pub steps_per_second: f64,
    /// Last time step, s.
    pub dt: f64,
    /// What limited it.
    pub limiter: &'a str,
    /// Energy that the ledger cannot account for, relative to what was put in.
    pub energy_drift: Option<f64>,
    /// Where a sequence of impacts stands.
    pub stage: Option<Stage>,
}

/// Where a sequence of impacts stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Stage {
    /// Impact in progress, from 1.
    pub impact: usize,
    /// Number of impacts.
    pub impacts: usize,
    /// Whether the wall settles after it.
    pub settling: bool,
}

impl std::fmt::Display for Stage {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let settling = if self.settling { ", settling" } else { "" };
        write!(f, "impact {} of {}{settling}", self.impact, self.impacts)
    }
}

/// Who watches a run.
pub trait Observer {
    /// A sentence.
    fn say(&mut self, text: &str);
    /// Called once before the first step: of a run that goes on the simulated time is not zero.
    fn begin(&mut self, _progress: &Progress) {}
    /// Called about once a second.
    fn progress(&mut self, progress: &Progress);
    /// Called once at the end, before the last sentences.
    fn finish(&mut self) {}
}

/// Nobody watches.
#[derive(Debug, Clone, Copy)]
pub struct Quiet;

impl Observer for Quiet {
    fn say(&mut self, _: &str) {}
    fn progress(&mut self, _: &Progress) {}
}
