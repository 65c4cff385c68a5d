//! Where the time of a step goes: one stopwatch, read a few times per step.

use serde::{Deserialize, Serialize};
use std::time::Instant;

/// Part of a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Phase {
    /// Order of the particles in clusters.
    Sort,
    /// Search of neighbours.
    List,
    /// Ghosts, images, surfaces, loads and contact on them.
    Boundaries,
    /// Sums over neighbours and what is done to a particle with them: volume, strain, stress, forces.
    Sweeps,
    /// Kick, drift, ledgers, checks.
    Integrate,
}

impl Phase {
    /// All phases.
    pub const ALL: [Self; 5] = [
        Self::Sort,
        Self::List,
        Self::Boundaries,
        Self::Sweeps,
        Self::Integrate,
    ];

    /// Name in tables and files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Sort => "sort",
            Self::List => "list",
            Self::Boundaries => "boundaries",
            Self::Sweeps => "sweeps",
            Self::Integrate => "integrate",
        }
    }
}

/// Seconds spent in each phase so far.
#[derive(Debug, Clone, Copy)]
pub struct Phases {
    seconds: [f64; Phase::ALL.len()],
    last: Instant,
}

impl Default for Phases {
    fn default() -> Self {
        Self {
            seconds: [0.0; Phase::ALL.len()],
            last: Instant::now(),
        }
    }
}

impl Phases {
    /// Starts the stopwatch: the time before belongs to no phase.
    pub(crate) fn start(&mut self) {
        self.last = Instant::now();
    }

    /// Books the time since the last call to a phase.
    pub(crate) fn lap(&mut self, phase: Phase) {
        let now = Instant::now();
        self.seconds[phase as usize] += (now - self.last).as_secs_f64();
        self.last = now;
    }

    /// Seconds spent in a phase.
    #[must_use]
    pub fn seconds(&self, phase: Phase) -> f64 {
        self.seconds[phase as usize]
    }

    /// Seconds spent in all of them.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.seconds.iter().sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn laps_add_up_to_the_time_that_passed() {
        let begun = Instant::now();
        let mut phases = Phases::default();
        phases.start();
        for phase in Phase::ALL {
            std::thread::sleep(std::time::Duration::from_millis(2));
            phases.lap(phase);
            assert!(phases.seconds(phase) >= 0.002);
        }
        assert!(phases.total() <= begun.elapsed().as_secs_f64());
    }
}
