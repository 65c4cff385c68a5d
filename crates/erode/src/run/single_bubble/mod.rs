//! A run of one spherical bubble: the radius over time, written as a run folder like any other.
//!
//! The run advances from mark to mark: checkpoints, kinks of the given pressure, the end. Marks depend on the case alone,
//! so a resumed run makes the same steps and ends with the same bits.

mod record;
mod results;
mod tables;

use super::RunError;
use super::course::Course;
use super::observer::{Observer, Progress as Seen};
use crate::case::Simulation;
use crate::case::bubbles::SingleBubble;
use crate::output::{
    Checkpoint, CheckpointMeta, CheckpointStore, RunFolder, RunPaths, State, Summary,
};
use erode_physics::bubble::{BubbleState, Controls, Progress, advance};
use record::{Record, Recorder};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;
use tables::Tables;

/// Seconds between updates of `status.json`.
const STATUS_EVERY: f64 = 1.0;
/// Steps allowed where the case gives no limit.
const MOST_STEPS: u64 = 1_000_000_000;

/// A run in progress.
pub(crate) struct Run {
    folder: RunFolder,
    tables: Tables,
    simulation: Simulation,
    bubble: SingleBubble,
    hash: String,
    state: BubbleState,
    record: Record,
    begun: Instant,
    first_step: u64,
}

impl Run {
    /// A run at its start, with its first row and checkpoint.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub(crate) fn new(
        folder: RunFolder,
        simulation: Simulation,
        bubble: SingleBubble,
        hash: String,
    ) -> Result<Self, RunError> {
        let state = BubbleState::moving(bubble.radius, bubble.wall_velocity, 0.0)?;
        let tables = Tables::open(folder.paths(), None)?;
        let record = Record::at_start(&bubble, &state);
        let mut run = Self::with(folder, tables, simulation, bubble, hash, state, record);
        let row = record::row(&run.bubble, &run.piece(0.0, 0.0), &run.state, &run.record);
        run.tables.history.write_row(&row)?;
        run.write_checkpoint()?;
        Ok(run)
    }

    /// A run as it was at a checkpoint.
    ///
    /// # Errors
    /// If the checkpoint does not fit the case, or a file cannot be written.
    pub(crate) fn from_checkpoint(
        folder: RunFolder,
        simulation: Simulation,
        bubble: SingleBubble,
        hash: String,
        checkpoint: &Checkpoint,
    ) -> Result<Self, RunError> {
        let extra = &checkpoint.meta.extra;
        let wrong = |what: &str, e: serde_json::Error| {
            RunError::Checkpoint(format!("its {what} is not readable ({e})"))
        };
        let state =
            serde_json::from_value(extra["state"].clone()).map_err(|e| wrong("state", e))?;
        let record =
            serde_json::from_value(extra["record"].clone()).map_err(|e| wrong("record", e))?;
        let tables = Tables::open(folder.paths(), Some(extra))?;
        Ok(Self::with(
            folder, tables, simulation, bubble, hash, state, record,
        ))
    }

    fn with(
        folder: RunFolder,
        tables: Tables,
        simulation: Simulation,
        bubble: SingleBubble,
        hash: String,
        state: BubbleState,
        record: Record,
    ) -> Self {
        Self {
            folder,
            tables,
            simulation,
            bubble,
            hash,
            first_step: state.counters.steps,
            state,
            record,
            begun: Instant::now(),
        }
    }

    /// The next time to stop at, and whether a checkpoint is due there.
    fn next_mark(&self) -> (f64, bool) {
        let end = self.simulation.run.end_time;
        // Counts stay far below 2^53.
        #[allow(clippy::cast_precision_loss)]
        let checkpoint =
            (self.record.checkpoints + 1) as f64 * self.simulation.output.checkpoint_every;
        let breaks = self.bubble.ambient_pressure.breaks();
        let kink = breaks.into_iter().filter(|t| *t > self.state.time);
        let kink = kink.fold(f64::INFINITY, f64::min);
        let mark = checkpoint.min(kink).min(end);
        (mark, mark == checkpoint)
    }

    fn piece(&self, begin: f64, end: f64) -> crate::case::bubbles::Piece {
        self.bubble.ambient_pressure.between(begin, end)
    }

    fn advance_to(&mut self, mark: f64) -> Result<(), RunError> {
        let counters = &self.state.counters;
        let done = counters.steps + counters.rejected;
        let most = self.simulation.run.max_steps.unwrap_or(MOST_STEPS);
        let controls = Controls {
            tolerance: self.bubble.tolerance,
            max_steps: most.saturating_sub(done),
            ..Controls::default()
        };
        let b = &self.bubble;
        let piece = self.piece(self.state.time, mark);
        let every = self.simulation.output.history_every;
        let end = self.simulation.run.end_time;
        let mut recorder = Recorder::new(b, &piece, every, &mut self.record);
        let state = &mut self.state;
        let ended = advance(
            &b.model,
            &b.liquid,
            &b.gas,
            &piece,
            &controls,
            state,
            mark,
            &mut recorder,
        );
        if state.time >= end || ended == Ok(Progress::Closed) {
            recorder.end(state);
        }
        let (rows, events) = recorder.finish();
        for row in rows {
            self.tables.history.write_row(&row)?;
        }
        for event in events {
            self.tables.events.write_row(&event)?;
        }
        match ended {
            Ok(Progress::Reached) => Ok(()),
            Ok(Progress::Closed) => {
                self.record.closed = true;
                Ok(())
            }
            Err(error) => {
                self.tables.flush()?;
                Err(error.into())
            }
        }
    }
}

impl Course for Run {
    /// From mark to mark; whether it reached the end.
    fn advance(
        &mut self,
        stop: &AtomicBool,
        observer: &mut dyn Observer,
    ) -> Result<bool, RunError> {
        observer.say(&format!("one bubble, {}", model_name(&self.bubble)));
        let mut shown = Instant::now();
        self.write_status(State::Running, None)?;
        while self.state.time < self.simulation.run.end_time && !self.record.closed {
            if stop.load(Ordering::Relaxed) {
                return Ok(false);
            }
            let (mark, checkpoint) = self.next_mark();
            self.advance_to(mark)?;
            if checkpoint {
                self.record.checkpoints += 1;
                self.write_checkpoint()?;
            }
            if shown.elapsed().as_secs_f64() > STATUS_EVERY {
                shown = Instant::now();
                observer.progress(&self.progress());
                self.write_status(State::Running, None)?;
            }
        }
        Ok(true)
    }

    fn write_checkpoint(&mut self) -> Result<(), RunError> {
        let mut record = self.record.clone();
        record.wall_time += self.begun.elapsed().as_secs_f64();
        let json = |value: Result<serde_json::Value, serde_json::Error>| {
            value.map_err(|e| RunError::Checkpoint(e.to_string()))
        };
        let mut extra = self.tables.mark()?;
        extra.insert("state".into(), json(serde_json::to_value(self.state))?);
        extra.insert("record".into(), json(serde_json::to_value(record))?);
        let checkpoint = Checkpoint::new(CheckpointMeta {
            code_version: env!("CARGO_PKG_VERSION").to_owned(),
            case_hash: self.hash.clone(),
            time: self.state.time,
            step: self.state.counters.steps,
            extra: extra.into(),
        });
        CheckpointStore::new(self.folder.paths().checkpoints()).write(&checkpoint)?;
        Ok(())
    }

    fn progress(&self) -> Seen<'_> {
        let steps = self.state.counters.steps - self.first_step;
        #[allow(clippy::cast_precision_loss)] // a rate for people
        let rate = steps as f64 / self.begun.elapsed().as_secs_f64();
        Seen {
            time: self.state.time,
            end_time: self.simulation.run.end_time,
            step: self.state.counters.steps,
            steps_per_second: rate,
            dt: self.state.next_step,
            limiter: "tolerance",
            energy_drift: Some(self.record.drift()),
            stage: None,
        }
    }

    fn results(&mut self) -> Result<(Summary, String), RunError> {
        let wall_time = self.record.wall_time + self.begun.elapsed().as_secs_f64();
        let summary = results::summary(&self.bubble, &self.state, &self.record, wall_time);
        let words = format!(
            "{} steps in {wall_time:.1} s, energy ledger {:+.1e} %",
            self.state.counters.steps,
            100.0 * self.record.drift()
        );
        Ok((summary, words))
    }

    fn paths(&self) -> &RunPaths {
        self.folder.paths()
    }

    fn hash(&self) -> &str {
        &self.hash
    }
}

/// Name of the law of a bubble.
fn model_name(bubble: &SingleBubble) -> &'static str {
    use erode_physics::bubble::BubbleModel;
    bubble.model.name()
}
