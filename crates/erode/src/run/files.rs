//! What a run writes while it goes on: tables, snapshots, and how far they had come at a checkpoint.

use super::background::{Background, Part};
use super::{RunError, monitor, probes};
use crate::case::Simulation;
use crate::output::{
    Checkpoint, CheckpointStore, Collection, Column, Entry, RunFolder, RunPaths, Sync, TableWriter,
};
use erode_sph::solid::Side;
use erode_sph::world::{Body, World};
use serde_json::{Map, Value};
use std::path::Path;

/// Wall pressure is recorded at this many radii at most.
const WALL_COLUMNS: usize = 100;

/// The open files of a run.
pub(crate) struct Files {
    folder: RunFolder,
    history: TableWriter,
    wall: Option<Wall>,
    probes: Vec<TableWriter>,
    fields: Collection,
    snapshots: u64,
    background: Background,
    /// Names of the bodies in the order of the case.
    bodies: Vec<String>,
}

/// The table of the wall pressure and the surface points in it.
struct Wall {
    table: TableWriter,
    points: Vec<usize>,
}

impl Files {
    /// Opens the files of a new run, or of an old one as they were when `marks` was taken.
    ///
    /// # Errors
    /// If a file cannot be written, or is not as this run left it.
    pub(crate) fn open(
        folder: RunFolder,
        simulation: &Simulation,
        world: &World,
        marks: Option<&Value>,
    ) -> Result<Self, RunError> {
        let paths = folder.paths();
        let rows = |table: &str| marks.map(|m| m["rows"][table].as_u64().unwrap_or(0));
        let history = open(
            &paths.history(),
            &monitor::columns(simulation),
            rows("history"),
        )?;
        let wall = Wall::open(paths, world, rows("wall"))?;
        let probes = simulation
            .probes
            .iter()
            .map(|p| {
                let body = simulation.body(&p.body);
                let columns = body.map(|b| probes::columns(&b.kind)).unwrap_or_default();
                open(&paths.probe(&p.name), &columns, rows(&probe_mark(&p.name)))
            })
            .collect::<Result<Vec<_>, RunError>>()?;
        let mut fields = Collection::new(paths.collection());
        if marks.is_some() && paths.collection().exists() {
            fields = Collection::read(&paths.collection())?;
            fields.truncate(world.time)?;
        }
        let snapshots = marks.and_then(|m| m["snapshots"].as_u64()).unwrap_or(0);
        Ok(Self {
            folder,
            history,
            wall,
            probes,
            fields,
            snapshots,
            background: Background::default(),
            bodies: simulation.bodies.iter().map(|b| b.name.clone()).collect(),
        })
    }

    /// Where everything lies.
    pub(crate) fn paths(&self) -> &RunPaths {
        self.folder.paths()
    }

    /// One row in every table; `row` is that of `history.csv`.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub(crate) fn write_row(
        &mut self,
        world: &World,
        simulation: &Simulation,
        row: &[f64],
    ) -> Result<(), RunError> {
        self.history.write_row(row)?;
        if let Some(wall) = &mut self.wall {
            wall.write_row(world)?;
        }
        for (probe, table) in simulation.probes.iter().zip(&mut self.probes) {
            let row = match body(world, &probe.body) {
                Some(b) => probes::row(b, world.time, probe.position),
                // A liquid that was taken away.
                None => probes::nothing(world.time, table.columns()),
            };
            table.write_row(&row)?;
        }
        Ok(())
    }

    /// One snapshot of every body, written while the calculation goes on.
    ///
    /// # Errors
    /// If a file of the snapshot before could not be written.
    pub(crate) fn write_fields(&mut self, world: &World) -> Result<(), RunError> {
        let mut parts = Vec::new();
        for named in &world.bodies {
            let part = self.bodies.iter().position(|name| *name == named.name);
            let part = part.unwrap_or_default();
            let path = self.folder.paths().snapshot(&named.name, self.snapshots);
            let file = format!(
                "fields/{}",
                path.file_name().unwrap_or_default().to_string_lossy()
            );
            parts.push(Part {
                path,
                snapshot: probes::snapshot(&named.body, world.time),
                entry: Entry {
                    time: world.time,
                    part,
                    name: named.name.clone(),
                    file,
                },
            });
        }
        let before = self.background.begin_snapshot(parts)?;
        self.snapshots += 1;
        self.list(before)
    }

    /// Waits for what is being written; a snapshot is listed.
    ///
    /// # Errors
    /// If it could not be written.
    pub(crate) fn settle(&mut self) -> Result<(), RunError> {
        let entries = self.background.settle()?;
        self.list(entries)
    }

    fn list(&mut self, entries: Vec<Entry>) -> Result<(), RunError> {
        if !entries.is_empty() {
            self.fields.add(entries)?;
        }
        Ok(())
    }

    /// How long all tables are, for a checkpoint; and what brings them to the disk, which has to be done before it.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub(crate) fn mark(
        &mut self,
        simulation: &Simulation,
    ) -> Result<(Map<String, Value>, Vec<Sync>), RunError> {
        self.settle()?;
        let (mut rows, mut syncs) = (Map::new(), Vec::new());
        let wall = self.wall.as_mut().map(|w| ("wall".into(), &mut w.table));
        let probes = (simulation.probes.iter().zip(&mut self.probes))
            .map(|(probe, table)| (probe_mark(&probe.name), table));
        let history = std::iter::once(("history".into(), &mut self.history));
        for (name, table) in history.chain(wall).chain(probes) {
            rows.insert(name, table.rows().into());
            syncs.push(table.begin_sync()?);
        }
        let mut marks = Map::new();
        marks.insert("rows".into(), rows.into());
        marks.insert("snapshots".into(), self.snapshots.into());
        Ok((marks, syncs))
    }

    /// Writes a checkpoint while the calculation goes on, once the rows that it counts are on the disk.
    ///
    /// # Errors
    /// If what was being written before could not be.
    pub(crate) fn begin_checkpoint(
        &mut self,
        checkpoint: Checkpoint,
        syncs: Vec<Sync>,
    ) -> Result<(), RunError> {
        let store = CheckpointStore::new(self.folder.paths().checkpoints());
        let before = self.background.begin(move || {
            syncs.into_iter().try_for_each(Sync::finish)?;
            store.write(&checkpoint)?;
            Ok(Vec::new())
        })?;
        self.list(before)
    }
}

impl Wall {
    /// None if no body of the world has a wetted surface.
    fn open(paths: &RunPaths, world: &World, rows: Option<u64>) -> Result<Option<Self>, RunError> {
        let Some(surface) = monitor::solid(world).and_then(|s| s.surface(Side::Top)) else {
            return Ok(None);
        };
        // Evenly among all points.
        let stride = surface.pressure.len().div_ceil(WALL_COLUMNS).max(1);
        let points: Vec<usize> = (0..surface.pressure.len()).step_by(stride).collect();
        let radii = points.iter().map(|&j| surface.reference_position[j][0]);
        let columns: Vec<Column> = std::iter::once(Column::new("time", "s"))
            .chain(radii.map(|r| Column::new(format!("r={r:e}"), "Pa")))
            .collect();
        let table = open(&paths.surface("wall_pressure"), &columns, rows)?;
        Ok(Some(Self { table, points }))
    }

    fn write_row(&mut self, world: &World) -> Result<(), RunError> {
        if let Some(surface) = monitor::solid(world).and_then(|s| s.surface(Side::Top)) {
            let values = self.points.iter().map(|&j| surface.pressure[j]);
            self.table.write_row(
                &std::iter::once(world.time)
                    .chain(values)
                    .collect::<Vec<_>>(),
            )?;
        }
        Ok(())
    }
}

fn open(path: &Path, columns: &[Column], rows: Option<u64>) -> Result<TableWriter, RunError> {
    Ok(match rows {
        Some(rows) => TableWriter::resume(path, columns, rows)?,
        None => TableWriter::create(path, columns)?,
    })
}

fn probe_mark(name: &str) -> String {
    format!("probe {name}")
}

fn body<'a>(world: &'a World, name: &str) -> Option<&'a Body> {
    world
        .bodies
        .iter()
        .find(|b| b.name == name)
        .map(|b| &b.body)
}
