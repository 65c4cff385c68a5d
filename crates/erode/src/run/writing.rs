//! What a run writes on its way, and when.

use super::impacts::Sequence;
use super::steps::Run;
use super::{RunError, monitor, watch};

/// What is to be written after a step.
#[derive(Debug, Default)]
pub(super) struct Due {
    /// A row of every table, with the values of `history.csv`.
    row: Option<Vec<f64>>,
    fields: bool,
    checkpoint: bool,
}

impl Due {
    pub(super) fn is_nothing(&self) -> bool {
        self.row.is_none() && !self.fields && !self.checkpoint
    }
}

impl Run {
    /// Rows, snapshots and checkpoints whose time has come since `before`: at the first step at or behind each multiple
    /// of the interval.
    pub(super) fn due_since(&mut self, before: f64) -> Due {
        let output = &self.simulation.output;
        let now = self.world.time;
        let due = |every: f64| every > 0.0 && (now / every).floor() > (before / every).floor();
        let over = self.finished() || self.stage_over();
        let settling = self.sequence.as_ref().is_some_and(Sequence::is_settling);
        // The first row of the next impact has the same time.
        let followed = (self.sequence.as_ref()).is_some_and(|s| !s.is_last()) && settling && over;
        let followed = followed && !self.finished();
        let row = (due(output.history_every) || over) && !followed;
        // While a wall settles nothing is to be seen but waves; its rest is the beginning of the next impact.
        let fields = (due(output.fields_every) || over) && (!settling || self.finished());
        // Between two stages one is written in any case.
        let next = self.sequence.is_some() && over;
        let checkpoint = due(output.checkpoint_every) && !next;
        Due {
            row: row.then(|| self.row(self.last.0)),
            fields,
            checkpoint,
        }
    }

    pub(super) fn write(&mut self, due: Due) -> Result<(), RunError> {
        if let Some(row) = due.row {
            self.files.write_row(&self.world, &self.simulation, &row)?;
            let bubble = self.simulation.bubble.as_ref();
            self.refuse(watch::open_ledger(&self.world, &self.record, bubble))?;
        }
        if due.fields {
            self.files.write_fields(&self.world)?;
        }
        if due.checkpoint {
            self.begin_checkpoint()?;
        }
        Ok(())
    }

    /// A row of its own, before the first step.
    pub(super) fn write_row(&mut self, dt: f64) -> Result<(), RunError> {
        let row = rayon::scope(|_| self.row(dt));
        self.files.write_row(&self.world, &self.simulation, &row)
    }

    fn row(&mut self, dt: f64) -> Vec<f64> {
        let (world, simulation) = (&self.world, &self.simulation);
        monitor::row(world, simulation, self.cell, dt, &mut self.record)
    }
}
