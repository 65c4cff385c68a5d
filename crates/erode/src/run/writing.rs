//! What a run writes on its way, and when.

use super::course::Course;
use super::steps::Run;
use super::{RunError, monitor, watch};

impl Run {
    /// Rows, snapshots and checkpoints whose time has come since `before`: at the first step at or behind each multiple
    /// of the interval.
    pub(super) fn write_due(&mut self, before: f64) -> Result<(), RunError> {
        let output = self.simulation.output.clone();
        let now = self.world.time;
        let due = |every: f64| every > 0.0 && (now / every).floor() > (before / every).floor();
        if due(output.history_every) || self.finished() {
            self.write_row(self.last.0)?;
            self.refuse(watch::open_ledger(
                &self.world,
                &self.record,
                self.simulation.bubble.as_ref(),
            ))?;
        }
        if due(output.fields_every) || self.finished() {
            self.files.write_fields(&self.world)?;
        }
        if due(output.checkpoint_every) {
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
