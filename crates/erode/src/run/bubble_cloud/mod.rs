//! A run of a cloud of bubbles in a given flow.
//!
//! The cloud advances from row to row of `history.csv`; rows depend on the case alone, so a resumed run ends with the same
//! bits, for any number of threads.

mod results;
mod rows;
mod tables;

use super::RunError;
use super::course::Course;
use super::observer::{Observer, Progress};
use crate::case::Simulation;
use crate::case::cloud::BubbleCloud;
use crate::output::{
    Array, Checkpoint, CheckpointMeta, CheckpointStore, RunFolder, RunPaths, State, Summary,
};
use erode_fv::bubbles::{Averaging, Cloud, CloudError, Settings, deposit};
use erode_physics::bubble::Controls;
use erode_physics::erosion::PotentialMap;
use serde::{Deserialize, Serialize};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;
use tables::Tables;

/// Seconds between updates of `status.json`.
const STATUS_EVERY: f64 = 1.0;
/// Name of the cloud in a checkpoint.
const STATE: &str = "cloud";

/// Everything the next step depends on.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Present {
    cloud: Cloud,
    map: Option<PotentialMap>,
    rows: u64,
    peak_impact: f64,
    largest_radius: f64,
    smallest_radius: f64,
}

/// A run in progress.
pub(crate) struct Run {
    folder: RunFolder,
    tables: Tables,
    simulation: Simulation,
    case: BubbleCloud,
    settings: Settings,
    hash: String,
    present: Present,
    wall_time: f64,
    begun: Instant,
    first_rows: u64,
}

/// Laws and steps of the cloud of a case.
pub(crate) fn settings(case: &BubbleCloud) -> Settings {
    Settings {
        controls: Controls {
            tolerance: case.tolerance,
            ..Controls::default()
        },
        forces: case.forces,
        averaging: if case.surface_average {
            Averaging::Surface
        } else {
            Averaging::Centre
        },
        slip: case.slip,
        ..Settings::new(case.liquid, Some(case.model))
    }
}

impl Run {
    /// A run at its start.
    ///
    /// # Errors
    /// If a bubble cannot be put in or a file cannot be written.
    pub(crate) fn new(
        folder: RunFolder,
        simulation: Simulation,
        case: BubbleCloud,
        hash: String,
    ) -> Result<Self, RunError> {
        let mut cloud = Cloud::new(0.0);
        for bubble in case.bubbles().map_err(RunError::Cloud)? {
            cloud.inject(&bubble).map_err(failed)?;
        }
        let map = rows::wall(&case).map_err(|e| RunError::Cloud(e.to_string()))?;
        let radii = || cloud.state.iter().map(|s| s.radius);
        let present = Present {
            map,
            rows: 0,
            peak_impact: 0.0,
            largest_radius: radii().fold(0.0, f64::max),
            smallest_radius: radii().fold(f64::INFINITY, f64::min),
            cloud,
        };
        let tables = Tables::open(folder.paths(), &case, None)?;
        let mut run = Self::with(folder, tables, simulation, case, hash, present, 0.0);
        run.write_row()?;
        run.tables.write_fields(&run.present.cloud)?;
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
        case: BubbleCloud,
        hash: String,
        checkpoint: &Checkpoint,
    ) -> Result<Self, RunError> {
        let extra = &checkpoint.meta.extra;
        let bytes = checkpoint.bytes(STATE)?;
        let present = serde_json::from_slice(bytes)
            .map_err(|e| RunError::Checkpoint(format!("its cloud is not readable ({e})")))?;
        let tables = Tables::open(folder.paths(), &case, Some(extra))?;
        let wall_time = extra["wall_time"].as_f64().unwrap_or(0.0);
        Ok(Self::with(
            folder, tables, simulation, case, hash, present, wall_time,
        ))
    }

    fn with(
        folder: RunFolder,
        tables: Tables,
        simulation: Simulation,
        case: BubbleCloud,
        hash: String,
        present: Present,
        wall_time: f64,
    ) -> Self {
        Self {
            folder,
            tables,
            settings: settings(&case),
            simulation,
            case,
            hash,
            first_rows: present.rows,
            present,
            wall_time,
            begun: Instant::now(),
        }
    }

    fn next_row(&mut self) -> Result<(), RunError> {
        // Counts stay far below 2^53.
        #[allow(clippy::cast_precision_loss)]
        let next = (self.present.rows + 1) as f64 * self.simulation.output.history_every;
        let p = &mut self.present;
        let until = next.min(self.simulation.run.end_time);
        let records = p
            .cloud
            .advance(&self.case.flow, &self.settings, until)
            .map_err(failed)?;
        p.rows += 1;
        if let Some(map) = &mut p.map {
            deposit(map, &records).map_err(|e| RunError::Cloud(e.to_string()))?;
        }
        for record in &records {
            let row = rows::collapse(record);
            if row[rows::IMPACT] > p.peak_impact {
                p.peak_impact = row[rows::IMPACT];
            }
            p.smallest_radius = p.smallest_radius.min(record.min_radius);
            p.largest_radius = p.largest_radius.max(record.begin.max_radius);
            self.tables.collapses.write_row(&row)?;
        }
        self.write_row()
    }

    fn write_row(&mut self) -> Result<(), RunError> {
        let p = &mut self.present;
        for state in &p.cloud.state {
            p.largest_radius = p.largest_radius.max(state.radius);
            p.smallest_radius = p.smallest_radius.min(state.radius);
        }
        let totals = p
            .cloud
            .totals(&self.case.flow, &self.settings)
            .map_err(|e| RunError::Cloud(e.to_string()))?;
        self.tables.write_row(&p.cloud, &totals)
    }
}

impl Course for Run {
    /// From row to row; whether it reached the end.
    fn advance(
        &mut self,
        stop: &AtomicBool,
        observer: &mut dyn Observer,
    ) -> Result<bool, RunError> {
        observer.say(&format!(
            "{} bubbles, {} threads",
            self.present.cloud.len(),
            rayon::current_num_threads()
        ));
        let mut shown = Instant::now();
        self.write_status(State::Running, None)?;
        let end = self.simulation.run.end_time;
        while self.present.cloud.time < end {
            if stop.load(Ordering::Relaxed) {
                return Ok(false);
            }
            let before = self.present.cloud.time;
            self.next_row()?;
            let now = self.present.cloud.time;
            let output = &self.simulation.output;
            let due = |every: f64| (now / every).floor() > (before / every).floor();
            if due(output.fields_every) || now >= end {
                self.tables.write_fields(&self.present.cloud)?;
            }
            if due(output.checkpoint_every) {
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
        let mut extra = self.tables.mark()?;
        let wall_time = self.wall_time + self.begun.elapsed().as_secs_f64();
        extra.insert("wall_time".into(), wall_time.into());
        let mut checkpoint = Checkpoint::new(CheckpointMeta {
            code_version: env!("CARGO_PKG_VERSION").to_owned(),
            case_hash: self.hash.clone(),
            time: self.present.cloud.time,
            step: self.present.rows,
            extra: extra.into(),
        });
        let bytes =
            serde_json::to_vec(&self.present).map_err(|e| RunError::Checkpoint(e.to_string()))?;
        checkpoint.push(STATE, Array::U8(bytes))?;
        CheckpointStore::new(self.folder.paths().checkpoints()).write(&checkpoint)?;
        Ok(())
    }

    fn progress(&self) -> Progress<'_> {
        let rows = self.present.rows - self.first_rows;
        #[allow(clippy::cast_precision_loss)] // a rate for people
        let rate = rows as f64 / self.begun.elapsed().as_secs_f64();
        Progress {
            time: self.present.cloud.time,
            end_time: self.simulation.run.end_time,
            step: self.present.rows,
            steps_per_second: rate,
            dt: self.simulation.output.history_every,
            limiter: "history_every",
            // The flow gives and takes energy: a cloud has no ledger of energy that closes, only one of bubbles.
            energy_drift: None,
            stage: None,
        }
    }

    fn results(&mut self) -> Result<(Summary, String), RunError> {
        if let Some(map) = &self.present.map {
            tables::write_map(&self.folder.paths().surface("erosion_potential"), map)?;
        }
        let wall_time = self.wall_time + self.begun.elapsed().as_secs_f64();
        let l = &self.present.cloud.ledger;
        let words = format!(
            "{} collapses, {} impacts, {} bubbles left in {wall_time:.1} s",
            l.collapses,
            l.impacts,
            self.present.cloud.len()
        );
        Ok((results::summary(&self.present, wall_time), words))
    }

    fn paths(&self) -> &RunPaths {
        self.folder.paths()
    }

    fn hash(&self) -> &str {
        &self.hash
    }
}

fn failed(error: CloudError) -> RunError {
    RunError::Cloud(error.to_string())
}
