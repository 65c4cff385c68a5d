//! The tables of a run of one bubble.

use crate::output::{Column, RunPaths, TableWriter};
use crate::run::RunError;
use serde_json::{Map, Value};

const HISTORY: [(&str, &str); super::record::WIDTH] = [
    ("time", "s"),
    ("dt", "s"),
    ("bubble_radius", "m"),
    ("wall_velocity", "m/s"),
    ("bubble_pressure", "Pa"),
    ("ambient_pressure", "Pa"),
    ("energy_kinetic", "J"),
    ("energy_potential", "J"),
    ("energy_gas", "J"),
    ("energy_viscous", "J"),
    ("energy_radiated", "J"),
    ("energy_driven", "J"),
    ("energy_residual", "J"),
];

const EVENTS: [(&str, &str); 5] = [
    ("time", "s"),
    ("largest", "-"),
    ("bubble_radius", "m"),
    ("bubble_pressure", "Pa"),
    ("ambient_pressure", "Pa"),
];

/// `history.csv` and `events.csv`.
pub(super) struct Tables {
    pub(super) history: TableWriter,
    pub(super) events: TableWriter,
}

impl Tables {
    /// New tables, or old ones as they were when `marks` was taken.
    pub(super) fn open(paths: &RunPaths, marks: Option<&Value>) -> Result<Self, RunError> {
        let columns = |list: &[(&str, &str)]| -> Vec<Column> {
            list.iter()
                .map(|(name, unit)| Column::new(*name, *unit))
                .collect()
        };
        let open = |path: &std::path::Path, columns: &[Column], key: &str| match marks {
            Some(m) => TableWriter::resume(path, columns, m["rows"][key].as_u64().unwrap_or(0)),
            None => TableWriter::create(path, columns),
        };
        Ok(Self {
            history: open(&paths.history(), &columns(&HISTORY), "history")?,
            events: open(&paths.events(), &columns(&EVENTS), "events")?,
        })
    }

    /// Brings the tables to the disk; tells how long they are, for a checkpoint.
    pub(super) fn mark(&mut self) -> Result<Map<String, Value>, RunError> {
        self.history.sync()?;
        self.events.sync()?;
        let mut rows = Map::new();
        rows.insert("history".into(), self.history.rows().into());
        rows.insert("events".into(), self.events.rows().into());
        let mut marks = Map::new();
        marks.insert("rows".into(), rows.into());
        Ok(marks)
    }

    /// Hands the rows to the operating system.
    pub(super) fn flush(&mut self) -> Result<(), RunError> {
        self.history.flush()?;
        Ok(self.events.flush()?)
    }
}
