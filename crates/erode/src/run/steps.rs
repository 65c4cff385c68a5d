//! The loop of a run: step, watch, write; stop when asked.

use super::course::Course;
use super::files::Files;
use super::impacts::{self, Sequence};
use super::monitor::Record;
use super::observer::{Observer, Progress};
use super::writing::Due;
use super::{RunError, findings, impact, layers, loads, refinement, results, state, watch};
use crate::case::Simulation;
use crate::output::{Checkpoint, CheckpointMeta, RunFolder, RunPaths, State, Summary};
use erode_sph::phases::Phase;
use erode_sph::world::{Body, Limiter, World};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

/// Seconds between updates of `status.json`.
const STATUS_EVERY: f64 = 1.0;
/// Particles within this many finest spacings of a failure are written out.
const SURROUNDINGS: f64 = 10.0;

/// Sums of time steps are exact to this share.
const ROUNDING: f64 = 1e-9;

/// A run in progress.
pub(crate) struct Run {
    pub(super) files: Files,
    pub(super) simulation: Simulation,
    pub(super) world: World,
    /// Repeated impacts.
    pub(super) sequence: Option<Sequence>,
    pub(super) hash: String,
    pub(super) record: Record,
    pub(super) cell: f64,
    pub(super) first_dt: f64,
    /// Last time step and what limited it.
    pub(super) last: (f64, Limiter),
    pub(super) begun: Instant,
    /// Seconds spent on files.
    written: f64,
    pub(super) first_step: u64,
}

impl Run {
    /// A run at its start, with its first row, snapshot and checkpoint: it can be resumed from the first step on.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub(crate) fn new(
        folder: RunFolder,
        simulation: Simulation,
        world: World,
        sequence: Option<Sequence>,
        hash: String,
    ) -> Result<Self, RunError> {
        let files = Files::open(folder, &simulation, &world, None)?;
        let last = world.stable_time_step();
        let mut run = Self::with(files, simulation, world, hash, last);
        run.sequence = sequence;
        run.record.initial_balance = super::Ledger::of(&run.world).balance();
        run.see_beginning();
        run.write_row(0.0)?;
        run.files.write_fields(&run.world)?;
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
        mut world: World,
        sequence: Option<Sequence>,
        hash: String,
        checkpoint: &Checkpoint,
    ) -> Result<Self, RunError> {
        let extra = &checkpoint.meta.extra;
        let wrong = |what: &str, e: serde_json::Error| {
            RunError::Checkpoint(format!("its {what} is not readable ({e})"))
        };
        state::restore(&mut world, checkpoint, &extra["accounts"])?;
        loads::prepare(&mut world, &simulation)?;
        if let Some(sequence) = &sequence {
            sequence.prepare(&mut world);
        }
        let files = Files::open(folder, &simulation, &world, Some(extra))?;
        let last = world.stable_time_step();
        let mut run = Self::with(files, simulation, world, hash, last);
        run.sequence = sequence;
        run.first_dt = serde_json::from_value(extra["first_dt"].clone())
            .map_err(|e| wrong("first time step", e))?;
        run.record =
            serde_json::from_value(extra["record"].clone()).map_err(|e| wrong("record", e))?;
        Ok(run)
    }

    fn with(
        files: Files,
        simulation: Simulation,
        world: World,
        hash: String,
        last: (f64, Limiter),
    ) -> Self {
        let finest = simulation
            .bodies
            .iter()
            .map(|b| b.spacing.finest)
            .fold(f64::INFINITY, f64::min);
        Self {
            files,
            simulation,
            sequence: None,
            hash,
            record: Record::default(),
            cell: 0.5 * finest,
            first_dt: last.0,
            last,
            begun: Instant::now(),
            written: 0.0,
            first_step: world.step,
            world,
        }
    }

    pub(super) fn finished(&self) -> bool {
        let run = &self.simulation.run;
        self.sequence
            .as_ref()
            .map_or_else(|| self.stage_over(), Sequence::is_over)
            || run.max_steps.is_some_and(|n| self.world.step >= n)
    }

    /// Whether an impact, or settling after one, is over; that is the whole run where there is but one.
    pub(super) fn stage_over(&self) -> bool {
        self.world.time >= self.simulation.run.end_time * (1.0 - ROUNDING)
            || (self.sequence.as_ref()).is_some_and(|s| s.has_settled(&self.world))
    }

    fn drift(&self) -> f64 {
        self.record.energy_drift / self.record.energy_scale.max(f64::MIN_POSITIVE)
    }

    fn checked_step(&mut self) -> Result<(), RunError> {
        let (dt, limiter) = &self.last;
        let mut finding = watch::short_step(*dt, self.first_dt, limiter);
        self.meet_the_end();
        let (dt, limiter) = self.last.clone();
        if finding.is_none() {
            let loads = &self.simulation.loads;
            let end = self.world.time + dt;
            loads::apply(&mut self.world, loads, end);
            finding = match self.world.advance(dt) {
                Ok(()) => {
                    loads::settle(&mut self.world, loads, dt);
                    if let Some(sequence) = &mut self.sequence {
                        sequence.follow(&mut self.world, dt);
                    }
                    match refinement::follow(&mut self.world, &self.simulation, self.cell) {
                        Ok(()) => watch::implausible(&self.world),
                        Err(error) => Some(watch::failed_step(error, &limiter)?),
                    }
                }
                Err(error) => Some(watch::failed_step(error, &limiter)?),
            };
        }
        self.refuse(finding)?;
        self.record.see_step(&self.world, limiter.reason);
        Ok(())
    }

    /// Steps until something is to be written, at least one; until it is asked to stop, or `STATUS_EVERY` after `shown`.
    fn steps_until_due(&mut self, stop: &AtomicBool, shown: Instant) -> Result<Due, RunError> {
        loop {
            let before = self.world.time;
            self.last = self.world.stable_time_step();
            self.checked_step()?;
            let begun = Instant::now();
            let due = self.due_since(before);
            self.written += begun.elapsed().as_secs_f64();
            let over = self.finished() || self.stage_over() || stop.load(Ordering::Relaxed);
            if over || !due.is_nothing() || shown.elapsed().as_secs_f64() > STATUS_EVERY {
                return Ok(due);
            }
        }
    }

    /// Shortens the last two steps so that they end at the end time, and neither is much shorter than the stable one.
    fn meet_the_end(&mut self) {
        let left = self.simulation.run.end_time - self.world.time;
        let (dt, limiter) = &mut self.last;
        if left < 2.0 * *dt {
            *dt = if left <= *dt * (1.0 + ROUNDING) {
                left
            } else {
                0.5 * left
            };
            limiter.reason = "end of the run";
        }
    }

    /// Ends the run if the watch found something.
    pub(super) fn refuse(&self, finding: Option<watch::Finding>) -> Result<(), RunError> {
        let Some(finding) = finding else {
            return Ok(());
        };
        let step = watch::Step {
            dt: self.last.0,
            limiter: &self.last.1,
            safety: self.simulation.run.safety,
            radius: 2.0 * SURROUNDINGS * self.cell,
        };
        Err(finding.into_error(&self.world, &step, self.files.paths()))
    }
}

impl Run {
    /// Begins to write a state to go on from.
    pub(super) fn begin_checkpoint(&mut self) -> Result<(), RunError> {
        let (mut extra, syncs) = self.files.mark(&self.simulation)?;
        let record = self.record_until_now();
        let record =
            serde_json::to_value(record).map_err(|e| RunError::Checkpoint(e.to_string()))?;
        extra.insert("first_dt".into(), self.first_dt.into());
        extra.insert("record".into(), record);
        extra.insert("accounts".into(), state::accounts(&self.world));
        if let Some(sequence) = &self.sequence {
            let state = serde_json::to_value(&sequence.state);
            let state = state.map_err(|e| RunError::Checkpoint(e.to_string()))?;
            extra.insert("impacts".into(), state);
        }
        let mut checkpoint = Checkpoint::new(CheckpointMeta {
            code_version: env!("CARGO_PKG_VERSION").to_owned(),
            case_hash: self.hash.clone(),
            time: self.world.time,
            step: self.world.step,
            extra: extra.into(),
        });
        state::store(&self.world, &mut checkpoint)?;
        self.files.begin_checkpoint(checkpoint, syncs)
    }

    /// The record with the times of this process.
    fn record_until_now(&self) -> Record {
        let mut record = self.record.clone();
        let elapsed = self.begun.elapsed().as_secs_f64();
        record.wall_time += elapsed;
        let phases = &self.world.phases;
        let rest = (elapsed - phases.total() - self.written).max(0.0);
        let steps = Phase::ALL.map(|p| (p.name(), phases.seconds(p)));
        let others = [("output", self.written), ("watch_and_rest", rest)];
        for (part, seconds) in steps.into_iter().chain(others) {
            *record.seconds.entry(part.to_owned()).or_default() += seconds;
        }
        record
    }
}

impl Course for Run {
    fn advance(
        &mut self,
        stop: &AtomicBool,
        observer: &mut dyn Observer,
    ) -> Result<bool, RunError> {
        let particles: usize = self.world.bodies.iter().map(|b| count(&b.body)).sum();
        observer.say(&format!(
            "{particles} particles, {} threads",
            rayon::current_num_threads()
        ));
        for misfit in layers::misfits(&self.world, &self.simulation) {
            observer.say(&format!("note: {misfit}"));
        }
        let mut shown = Instant::now();
        self.write_status(State::Running, None)?;
        while !self.finished() {
            if stop.load(Ordering::Relaxed) {
                return Ok(false);
            }
            // Inside the pool of threads parallel loops begin at once; from outside each of them would have to be handed over.
            // Files are written outside of it: whoever waits for them keeps no thread from its work.
            let due = rayon::scope(|_| self.steps_until_due(stop, shown))?;
            let begun = Instant::now();
            self.write(due)?;
            if self.sequence.is_some() && !self.finished() && self.stage_over() {
                self.next_stage()?;
            }
            self.written += begun.elapsed().as_secs_f64();
            if shown.elapsed().as_secs_f64() > STATUS_EVERY {
                shown = Instant::now();
                observer.progress(&self.progress());
                self.write_status(State::Running, None)?;
            }
        }
        Ok(true)
    }

    fn write_checkpoint(&mut self) -> Result<(), RunError> {
        self.begin_checkpoint()?;
        self.files.settle()
    }

    fn settle(&mut self) -> Result<(), RunError> {
        self.files.settle()
    }

    fn progress(&self) -> Progress<'_> {
        Progress {
            time: self.world.time,
            end_time: self
                .sequence
                .as_ref()
                .map_or(self.simulation.run.end_time, |s| {
                    s.end_time(self.world.time)
                }),
            step: self.world.step,
            steps_per_second: (self.world.step - self.first_step) as f64
                / self.begun.elapsed().as_secs_f64(),
            dt: self.last.0,
            limiter: self.last.1.reason,
            energy_drift: Some(self.drift()),
            stage: self.sequence.as_ref().map(Sequence::seen),
        }
    }

    fn results(&mut self) -> Result<(Summary, String), RunError> {
        let record = self.record_until_now();
        let wall_time = record.wall_time;
        let threads = rayon::current_num_threads();
        let (world, simulation) = (&self.world, &self.simulation);
        let mut summary = results::summary(world, simulation, &record, wall_time, threads);
        let sequence = self.sequence.as_ref();
        impact::add(
            &mut summary,
            world,
            simulation,
            &record,
            (self.files.paths(), sequence),
        )?;
        if let Some(sequence) = sequence {
            impacts::add(&mut summary, sequence);
        }
        let mut words = format!(
            "{} steps in {wall_time:.1} s, energy ledger {:+.2} %",
            world.step,
            100.0 * self.drift()
        );
        for finding in findings::of(&summary, world, simulation) {
            words.push_str(&format!("\nnote: {finding}"));
            summary.add_finding(finding);
        }
        Ok((summary, words))
    }

    fn paths(&self) -> &RunPaths {
        self.files.paths()
    }

    fn hash(&self) -> &str {
        &self.hash
    }
}

fn count(body: &Body) -> usize {
    match body {
        Body::Fluid(f) => f.len(),
        Body::Solid(s) => s.len(),
    }
}
