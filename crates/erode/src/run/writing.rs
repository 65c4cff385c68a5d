//! What a run writes on its way, and when.

use super::course::Course;
use super::impacts::Sequence;
use super::steps::Run;
use super::{RunError, monitor, watch};

impl Run {
    /// Rows, snapshots and checkpoints whose time has come since `before`: at the first step at or behind each multiple
    /// of the interval.
    pub(super) fn write_due(&mut self, before: f64) -> Result<(), RunError> {
        let output = self.simulation.output.clone();
        let now = self.world.time;
        let due = |every: f64| every > 0.0 && (now / every).floor() > (before / every).floor();
        let over = self.finished() || self.stage_over();
        let settling = self.sequence.as_ref().is_some_and(Sequence::is_settling);
        // The first row of the next impact has the same time.
        let followed = (self.sequence.as_ref()).is_some_and(|s| !s.is_last()) && settling && over;
        let followed = followed && !self.finished();
        if (due(output.history_every) || over) && !followed {
            self.write_row(self.last.0)?;
            self.refuse(watch::open_ledger(
                &self.world,
                &self.record,
                self.simulation.bubble.as_ref(),
            ))?;
        }
        // While a wall settles nothing is to be seen but waves; its rest is the beginning of the next impact.
        if (due(output.fields_every) || over) && (!settling || self.finished()) {
            self.files.write_fields(&self.world)?;
        }
        // Between two stages one is written in any case.
        let next = self.sequence.is_some() && over;
        if due(output.checkpoint_every) && !next {
            self.write_checkpoint()?;
        }
        Ok(())
    }

    pub(super) fn write_row(&mut self, dt: f64) -> Result<(), RunError> {
        let row = monitor::row(
            &self.world,
            &self.simulation,
            self.cell,
            dt,
            &mut self.record,
        );
        self.files.write_row(&self.world, &self.simulation, &row)
    }
}
