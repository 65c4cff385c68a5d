//! What a run writes on its way, and when.

use super::steps::Run;
use super::{RunError, monitor, state, status, watch};
use crate::output::{Checkpoint, CheckpointMeta, CheckpointStore, State};

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

    pub(super) fn write_checkpoint(&mut self) -> Result<(), RunError> {
        let mut extra = self.files.mark(&self.simulation)?;
        let mut record = self.record.clone();
        record.wall_time += self.begun.elapsed().as_secs_f64();
        let record =
            serde_json::to_value(record).map_err(|e| RunError::Checkpoint(e.to_string()))?;
        extra.insert("first_dt".into(), self.first_dt.into());
        extra.insert("record".into(), record);
        extra.insert("accounts".into(), state::accounts(&self.world));
        let mut checkpoint = Checkpoint::new(CheckpointMeta {
            code_version: env!("CARGO_PKG_VERSION").to_owned(),
            case_hash: self.hash.clone(),
            time: self.world.time,
            step: self.world.step,
            extra: extra.into(),
        });
        state::store(&self.world, &mut checkpoint)?;
        CheckpointStore::new(self.files.paths().checkpoints()).write(&checkpoint)?;
        Ok(())
    }

    pub(super) fn write_status(&self, state: State, message: Option<&str>) -> Result<(), RunError> {
        let status = status::of(&self.progress(), state, message);
        Ok(status.write(&self.files.paths().status())?)
    }
}
