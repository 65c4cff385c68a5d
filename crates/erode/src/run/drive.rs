//! The loop of a run: step, watch, write; stop when asked; go on from a checkpoint.

use super::monitor::{self, Record};
use super::{RunError, build, probes, results, state};
use crate::case::{Case, Simulation};
use crate::output::{
    Checkpoint, CheckpointMeta, CheckpointStore, Collection, Column, Encoding, Entry, RunFolder,
    State, Status, TableWriter, hash_hex, write_failure,
};
use erode_sph::solid::Side;
use erode_sph::world::{Body, Limiter, World, WorldError};
use serde_json::json;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

/// A step shorter than this share of the first one is a collapse of the calculation.
const SHORTEST_STEP: f64 = 1e-4;
/// Density outside these multiples of the one at rest, or speed above that many sound speeds, is no liquid any more.
const DENSITY_RANGE: (f64, f64) = (0.02, 4.0);
const FASTEST: f64 = 20.0;
/// Wall pressure is recorded at this many radii at most.
const WALL_COLUMNS: usize = 100;
/// Seconds between updates of `status.json`.
const STATUS_EVERY: f64 = 1.0;

/// What to run, and where to.
#[derive(Debug, Clone)]
pub struct Start {
    /// Case file or folder.
    pub case: PathBuf,
    /// `path.to.key=value` replacements.
    pub overrides: Vec<String>,
    /// Run folder to make.
    pub output: PathBuf,
    /// Number of threads; all cores if none.
    pub threads: Option<usize>,
}

/// How a run ended without an error.
#[derive(Debug, Clone, PartialEq)]
pub enum Ended {
    /// At its end time; the report is written.
    Done {
        /// The report.
        report: PathBuf,
    },
    /// It was asked to stop; a checkpoint is written.
    Interrupted {
        /// Simulated time, s.
        time: f64,
    },
}

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
    pub energy_drift: f64,
}

/// Who watches a run.
pub trait Observer {
    /// A sentence.
    fn say(&mut self, text: &str);
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

/// Starts a run in a new folder. `stop` asks it to write a checkpoint and end.
///
/// # Errors
/// A wrong case, a folder that cannot be used, a calculation that fails.
pub fn start(options: &Start, stop: &AtomicBool, observer: &mut dyn Observer) -> Result<Ended, RunError> {
    let loaded = Case::load(&options.case, &options.overrides, &[]).map_err(RunError::Case)?;
    let folder = RunFolder::create(&options.output)?;
    folder.write_case(loaded.source.as_bytes(), &loaded.resolved_toml)?;
    with_threads(options.threads, || {
        observer.say("filling the bodies with particles");
        let world = build::world(&loaded.simulation)?;
        let hash = hash_hex(loaded.resolved_toml.as_bytes());
        let mut run = Run::new(folder, loaded.simulation, world, hash, None)?;
        run.go(stop, observer)
    })
}

/// Goes on from the newest good checkpoint of a run folder, bitwise as if it had never stopped.
///
/// # Errors
/// No usable checkpoint, a folder that cannot be used, a calculation that fails.
pub fn resume(dir: &Path, threads: Option<usize>, stop: &AtomicBool, observer: &mut dyn Observer) -> Result<Ended, RunError> {
    let folder = RunFolder::open(dir)?;
    let loaded = Case::load(&folder.paths().resolved(), &[], &[]).map_err(RunError::Case)?;
    let text = std::fs::read(folder.paths().resolved())
        .map_err(|cause| crate::output::OutputError::Read { path: folder.paths().resolved(), cause })?;
    let hash = hash_hex(&text);
    let store = CheckpointStore::new(folder.paths().checkpoints());
    let found = store.load_newest(&hash)?;
    for refused in &found.refused {
        observer.say(&format!("{refused}"));
    }
    store.set_aside(&found.refused)?;
    observer.say(&format!("going on from {} (t = {:.4e} s)", found.path.display(), found.checkpoint.meta.time));
    with_threads(threads, || {
        let world = build::world(&loaded.simulation)?;
        let mut run = Run::new(folder, loaded.simulation, world, hash, Some(&found.checkpoint))?;
        run.go(stop, observer)
    })
}

fn with_threads<T: Send>(threads: Option<usize>, work: impl FnOnce() -> Result<T, RunError>) -> Result<T, RunError> {
    if let Some(n) = threads {
        // The global pool can be set once; a second run in one process keeps the first one's pool.
        let built = rayon::ThreadPoolBuilder::new().num_threads(n).build_global();
        if let Err(e) = built
            && rayon::current_num_threads() != n
        {
            return Err(RunError::Threads(e.to_string()));
        }
    }
    work()
}

struct Run {
    folder: RunFolder,
    simulation: Simulation,
    world: World,
    hash: String,
    record: Record,
    history: TableWriter,
    wall: Option<(TableWriter, Vec<usize>)>,
    probes: Vec<TableWriter>,
    fields: Collection,
    snapshots: u64,
    cell: f64,
    first_dt: f64,
    begun: Instant,
}

impl Run {
    fn new(
        folder: RunFolder,
        simulation: Simulation,
        mut world: World,
        hash: String,
        from: Option<&Checkpoint>,
    ) -> Result<Self, RunError> {
        let extra = from.map(|c| c.meta.extra.clone()).unwrap_or_default();
        if let Some(checkpoint) = from {
            state::restore(&mut world, checkpoint, &extra["accounts"])?;
        }
        let paths = folder.paths().clone();
        let rows = |table: &str| extra["rows"][table].as_u64();
        let history = open(&paths.history(), &monitor::columns(&simulation), rows("history"))?;
        let wall = match wall_points(&world) {
            points if points.is_empty() => None,
            points => {
                let columns = wall_columns(&world, &points);
                Some((open(&paths.surface("wall_pressure"), &columns, rows("wall"))?, points))
            }
        };
        let probes = simulation
            .probes
            .iter()
            .map(|p| {
                let columns = body(&world, &p.body).map(probes::columns).unwrap_or_default();
                open(&paths.probe(&p.name), &columns, rows(&format!("probe {}", p.name)))
            })
            .collect::<Result<Vec<_>, RunError>>()?;
        let mut fields = if from.is_some() && paths.collection().exists() {
            Collection::read(&paths.collection())?
        } else {
            Collection::new(paths.collection())
        };
        if from.is_some() {
            fields.truncate(world.time)?;
        }
        let finest = simulation.bodies.iter().map(|b| b.spacing.finest).fold(f64::INFINITY, f64::min);
        let mut run = Self {
            folder,
            simulation,
            hash,
            record: Record::default(),
            history,
            wall,
            probes,
            fields,
            snapshots: extra["snapshots"].as_u64().unwrap_or(0),
            cell: 0.5 * finest,
            first_dt: extra["first_dt"].as_f64().unwrap_or_else(|| world.stable_time_step().0),
            world,
            begun: Instant::now(),
        };
        if from.is_some() {
            run.record = serde_json::from_value(extra["record"].clone())
                .map_err(|e| RunError::Checkpoint(format!("its record is not readable ({e})")))?;
        } else {
            run.record.initial_balance = super::Ledger::of(&run.world).balance();
            run.record.initial_mass = monitor::liquid(&run.world).map_or(0.0, |f| f.mass.iter().sum());
            if let Some(b) = &run.simulation.bubble {
                run.record.initial_volume = monitor::bubble(&run.world, b, run.cell).volume;
                run.record.smallest_volume = run.record.initial_volume;
            }
        }
        Ok(run)
    }

    fn go(&mut self, stop: &AtomicBool, observer: &mut dyn Observer) -> Result<Ended, RunError> {
        let particles: usize = self.world.bodies.iter().map(|b| count(&b.body)).sum();
        observer.say(&format!("{particles} particles, {} threads", rayon::current_num_threads()));
        if self.world.step == 0 {
            self.write_row(0.0)?;
            self.write_fields()?;
        }
        let mut shown = Instant::now();
        let (first_step, mut dt) = (self.world.step, self.first_dt);
        let mut limiter = Limiter { body: 0, particle: 0, position: [0.0; 2], reason: "" };
        self.write_status(State::Running, dt, "", None, None)?;
        while !self.finished() {
            if stop.load(Ordering::Relaxed) {
                self.write_checkpoint()?;
                self.write_status(State::Interrupted, dt, limiter.reason, None, Some("asked to stop"))?;
                observer.finish();
                return Ok(Ended::Interrupted { time: self.world.time });
            }
            (dt, limiter) = self.world.stable_time_step();
            if let Err(error) = self.checked_step(dt, &limiter) {
                observer.finish();
                self.write_status(State::Failed, dt, limiter.reason, None, Some(&error.to_string()))?;
                return Err(error);
            }
            self.write_due(dt)?;
            if shown.elapsed().as_secs_f64() > STATUS_EVERY {
                shown = Instant::now();
                let rate = (self.world.step - first_step) as f64 / self.begun.elapsed().as_secs_f64();
                let progress = Progress {
                    time: self.world.time,
                    end_time: self.simulation.run.end_time,
                    step: self.world.step,
                    steps_per_second: rate,
                    dt,
                    limiter: limiter.reason,
                    energy_drift: self.drift(),
                };
                observer.progress(&progress);
                self.write_status(State::Running, dt, limiter.reason, Some(rate), None)?;
            }
        }
        observer.finish();
        self.finish(dt, limiter.reason)
    }

    fn finished(&self) -> bool {
        let run = &self.simulation.run;
        self.world.time >= run.end_time || run.max_steps.is_some_and(|n| self.world.step >= n)
    }

    fn drift(&self) -> f64 {
        self.record.energy_drift / self.record.energy_scale.max(f64::MIN_POSITIVE)
    }

    fn checked_step(&mut self, dt: f64, limiter: &Limiter) -> Result<(), RunError> {
        if !(dt > SHORTEST_STEP * self.first_dt) {
            let what = format!("the stable time step fell below {SHORTEST_STEP:.0e} of the first one");
            return Err(self.unstable(what, limiter.position, dt, limiter)?);
        }
        if let Err(error) = self.world.advance(dt) {
            let position = match &error {
                WorldError::NotFinite { position, .. } => *position,
                WorldError::Solid { source, .. } => source.position().unwrap_or(limiter.position),
                WorldError::Missing { .. } => return Err(error.into()),
            };
            return Err(self.unstable(error.to_string(), position, dt, limiter)?);
        }
        if let Some((what, position)) = implausible(&self.world) {
            return Err(self.unstable(what, position, dt, limiter)?);
        }
        self.record.see_step(&self.world, limiter.reason);
        Ok(())
    }

    /// Writes the surroundings of a failure and makes the error that tells of it.
    fn unstable(&self, what: String, position: [f64; 2], dt: f64, limiter: &Limiter) -> Result<RunError, RunError> {
        let named = &self.world.bodies[limiter.body];
        let radius = 20.0 * self.cell;
        let mut path = self.folder.paths().failure();
        for (i, b) in self.world.bodies.iter().enumerate() {
            if i > 0 {
                path = self.folder.paths().failure().with_file_name(format!("failure_{}.vtu", b.name));
            }
            let snapshot = probes::snapshot(&b.body, self.world.time);
            write_failure(&path, &snapshot, [position[0], position[1], 0.0], radius)?;
        }
        let p = limiter.position;
        let safety = self.simulation.run.safety;
        Ok(RunError::Unstable {
            what,
            time: self.world.time,
            step: self.world.step,
            dt,
            limiter: format!("{} (body `{}`, r = {:.3e} m, z = {:.3e} m)", limiter.reason, named.name, p[0], p[1]),
            causes: format!(
                "likely causes: a time step above the stable one (run.safety is {safety}; 0.3 is usual), too few \
                 particles across the jet, or a load beyond the range of the material\n  the particles around the \
                 place are in failure*.vtu; the last good checkpoint is kept, `erode resume` goes on from it"
            ),
        })
    }

    /// Rows, snapshots and checkpoints whose time has come: the first step at or behind each multiple of the interval.
    fn write_due(&mut self, dt: f64) -> Result<(), RunError> {
        let output = self.simulation.output.clone();
        let (now, before) = (self.world.time, self.world.time - dt);
        let due = |every: f64| every > 0.0 && (now / every).floor() > (before / every).floor();
        if due(output.history_every) || self.finished() {
            self.write_row(dt)?;
        }
        if due(output.fields_every) || self.finished() {
            self.write_fields()?;
        }
        if due(output.checkpoint_every) {
            self.write_checkpoint()?;
        }
        Ok(())
    }

    fn write_row(&mut self, dt: f64) -> Result<(), RunError> {
        let row = monitor::row(&self.world, &self.simulation, self.cell, dt, &mut self.record);
        self.history.write_row(&row)?;
        if let (Some((table, points)), Some(s)) = (&mut self.wall, monitor::solid(&self.world))
            && let Some(surface) = s.surface(Side::Top)
        {
            let values = points.iter().map(|&j| surface.pressure[j]);
            table.write_row(&std::iter::once(self.world.time).chain(values).collect::<Vec<_>>())?;
        }
        for (probe, table) in self.simulation.probes.iter().zip(&mut self.probes) {
            if let Some(b) = body(&self.world, &probe.body) {
                table.write_row(&probes::row(b, self.world.time, probe.position))?;
            }
        }
        Ok(())
    }

    fn write_fields(&mut self) -> Result<(), RunError> {
        let paths = self.folder.paths();
        let mut entries = Vec::new();
        for (part, named) in self.world.bodies.iter().enumerate() {
            let path = paths.snapshot(&named.name, self.snapshots);
            probes::snapshot(&named.body, self.world.time).write(&path, Encoding::Zlib)?;
            let file = format!("fields/{}", path.file_name().unwrap_or_default().to_string_lossy());
            entries.push(Entry { time: self.world.time, part, name: named.name.clone(), file });
        }
        self.fields.add(entries)?;
        self.snapshots += 1;
        Ok(())
    }

    fn write_checkpoint(&mut self) -> Result<(), RunError> {
        let mut rows = serde_json::Map::new();
        self.history.sync()?;
        rows.insert("history".into(), self.history.rows().into());
        if let Some((wall, _)) = &mut self.wall {
            wall.sync()?;
            rows.insert("wall".into(), wall.rows().into());
        }
        for (probe, table) in self.simulation.probes.iter().zip(&mut self.probes) {
            table.sync()?;
            rows.insert(format!("probe {}", probe.name), table.rows().into());
        }
        let mut record = self.record.clone();
        record.wall_time += self.begun.elapsed().as_secs_f64();
        let extra = json!({
            "rows": rows,
            "snapshots": self.snapshots,
            "first_dt": self.first_dt,
            "record": record,
            "accounts": state::accounts(&self.world),
        });
        let mut checkpoint = Checkpoint::new(CheckpointMeta {
            code_version: env!("CARGO_PKG_VERSION").to_owned(),
            case_hash: self.hash.clone(),
            time: self.world.time,
            step: self.world.step,
            extra,
        });
        state::store(&self.world, &mut checkpoint)?;
        CheckpointStore::new(self.folder.paths().checkpoints()).write(&checkpoint)?;
        Ok(())
    }

    fn write_status(
        &self,
        state: State,
        dt: f64,
        limiter: &str,
        rate: Option<f64>,
        message: Option<&str>,
    ) -> Result<(), RunError> {
        let end_time = self.simulation.run.end_time;
        let eta = rate.filter(|r| *r > 0.0 && dt > 0.0).map(|r| (end_time - self.world.time).max(0.0) / dt / r);
        let status = Status {
            state,
            time: self.world.time,
            end_time,
            step: self.world.step,
            dt,
            limiter: limiter.to_owned(),
            steps_per_second: rate,
            eta,
            energy_drift: Some(self.drift()),
            pid: std::process::id(),
            message: message.map(str::to_owned),
        };
        Ok(status.write(&self.folder.paths().status())?)
    }

    fn finish(&mut self, dt: f64, limiter: &str) -> Result<Ended, RunError> {
        self.write_checkpoint()?;
        let wall_time = self.record.wall_time + self.begun.elapsed().as_secs_f64();
        let threads = rayon::current_num_threads();
        let mut summary = results::summary(&self.world, &self.simulation, &self.record, wall_time, threads);
        summary.set_input_hash("resolved.toml", &self.hash);
        summary.write(&self.folder.paths().summary())?;
        self.write_status(State::Done, dt, limiter, None, None)?;
        let report = crate::report::build(self.folder.paths().root())?;
        Ok(Ended::Done { report })
    }
}

fn open(path: &Path, columns: &[Column], rows: Option<u64>) -> Result<TableWriter, RunError> {
    Ok(match rows {
        Some(rows) => TableWriter::resume(path, columns, rows)?,
        None => TableWriter::create(path, columns)?,
    })
}

fn body<'a>(world: &'a World, name: &str) -> Option<&'a Body> {
    world.bodies.iter().find(|b| b.name == name).map(|b| &b.body)
}

fn count(body: &Body) -> usize {
    match body {
        Body::Fluid(f) => f.len(),
        Body::Solid(s) => s.len(),
    }
}

/// Surface points whose pressure is recorded: evenly among all.
fn wall_points(world: &World) -> Vec<usize> {
    let Some(surface) = monitor::solid(world).and_then(|s| s.surface(Side::Top)) else { return Vec::new() };
    let n = surface.pressure.len();
    let stride = n.div_ceil(WALL_COLUMNS).max(1);
    (0..n).step_by(stride).collect()
}

fn wall_columns(world: &World, points: &[usize]) -> Vec<Column> {
    let radii = monitor::solid(world)
        .and_then(|s| s.surface(Side::Top))
        .map(|surface| points.iter().map(|&j| surface.reference_position[j][0]).collect::<Vec<_>>())
        .unwrap_or_default();
    std::iter::once(Column::new("time", "s"))
        .chain(radii.iter().map(|r| Column::new(format!("r={r:e}"), "Pa")))
        .collect()
}

/// A state that no liquid can have: what and where.
fn implausible(world: &World) -> Option<(String, [f64; 2])> {
    let f = monitor::liquid(world)?;
    (0..f.len()).find_map(|a| {
        let (ratio, x) = (f.density(a) / f.eos.reference_density, f.position[a]);
        let speed = f.velocity[a][0].hypot(f.velocity[a][1]);
        let at = format!("of liquid particle {a} at r = {:.4e} m, z = {:.4e} m", x[0], x[1]);
        if !(ratio > DENSITY_RANGE.0 && ratio < DENSITY_RANGE.1) {
            let (low, high) = DENSITY_RANGE;
            return Some((format!("density {at} is {ratio:.3} times that at rest (plausible: {low} to {high})"), x));
        }
        (speed > FASTEST * f.eos.sound_speed).then(|| {
            (format!("speed {at} is {speed:.3e} m/s, {:.0} times that of sound", speed / f.eos.sound_speed), x)
        })
    })
}
