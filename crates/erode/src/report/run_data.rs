//! What a run folder holds, as far as it is there: the report shows it all, and names what is missing.

use std::path::{Path, PathBuf};

use serde_json::Value;

use super::ReportError;
use super::snapshot::{Frame, read_frames};
use crate::output::{RunPaths, Table};

/// Everything the report is made of except the snapshots, which are large and read one by one.
#[derive(Debug, Default)]
pub(crate) struct RunData {
    /// The folder.
    pub(crate) dir: PathBuf,
    /// Final numbers; empty while the run goes on.
    pub(crate) summary: Value,
    /// Where the run stands.
    pub(crate) status: Value,
    /// `case.toml` as text.
    pub(crate) case: String,
    /// `resolved.toml` as text.
    pub(crate) resolved: String,
    /// One row per monitor step.
    pub(crate) history: Option<Table>,
    /// Pressure at the wall: time, then one column per radius.
    pub(crate) wall: Option<Table>,
    /// One row per impact of a sequence.
    pub(crate) impacts: Option<Table>,
    /// Name and table of each probe, by name.
    pub(crate) probes: Vec<(String, Table)>,
    /// Instants of the snapshots in order of time.
    pub(crate) frames: Vec<Frame>,
    /// Sentences about files that are there but cannot be read.
    pub(crate) troubles: Vec<String>,
}

impl RunData {
    /// Reads a run folder.
    ///
    /// # Errors
    /// When there is no folder, or nothing in it that a run writes.
    pub(crate) fn read(dir: &Path) -> Result<Self, ReportError> {
        if !dir.is_dir() {
            return Err(ReportError::NoFolder {
                path: dir.to_path_buf(),
            });
        }
        let written = [
            "summary.json",
            "history.csv",
            "fields.pvd",
            "status.json",
            "case.toml",
        ];
        if !written.iter().any(|name| dir.join(name).is_file()) {
            return Err(ReportError::NotARun {
                path: dir.to_path_buf(),
            });
        }
        let paths = RunPaths::new(dir);
        let mut data = Self {
            dir: dir.to_path_buf(),
            ..Self::default()
        };
        data.summary = data.json("summary.json");
        data.status = data.json("status.json");
        data.case = data.text("case.toml");
        data.resolved = data.text("resolved.toml");
        data.history = data.table(&paths.history());
        data.wall = data.table(&paths.surface("wall_pressure"));
        data.impacts = data.table(&paths.impacts());
        data.probes = data.probes();
        data.frames = match read_frames(&paths) {
            Ok(frames) => frames,
            Err(trouble) => {
                data.troubles.push(trouble);
                Vec::new()
            }
        };
        Ok(data)
    }

    /// A number of the summary.
    pub(crate) fn number(&self, key: &str) -> Option<f64> {
        self.summary.get(key)?.as_f64().filter(|v| v.is_finite())
    }

    /// The unit of a number of the summary.
    pub(crate) fn unit(&self, key: &str) -> &str {
        self.summary
            .get("units")
            .and_then(|u| u.get(key))
            .and_then(Value::as_str)
            .unwrap_or("-")
    }

    /// A column of the history together with the time, as points; values that are not finite stay as gaps.
    pub(crate) fn history_points(&self, name: &str) -> Option<Vec<[f64; 2]>> {
        let history = self.history.as_ref()?;
        Some(points(history.column("time")?, history.column(name)?))
    }

    fn text(&mut self, name: &str) -> String {
        let path = self.dir.join(name);
        match std::fs::read(&path) {
            Ok(bytes) => String::from_utf8_lossy(&bytes).into_owned(),
            Err(cause) if cause.kind() == std::io::ErrorKind::NotFound => String::new(),
            Err(cause) => {
                self.troubles
                    .push(format!("{name} cannot be read ({cause})."));
                String::new()
            }
        }
    }

    fn json(&mut self, name: &str) -> Value {
        let text = self.text(name);
        if text.is_empty() {
            return Value::Null;
        }
        serde_json::from_str(&text).unwrap_or_else(|cause| {
            self.troubles.push(format!(
                "{name} is damaged ({cause}); what it says is left out."
            ));
            Value::Null
        })
    }

    fn table(&mut self, path: &Path) -> Option<Table> {
        if !path.is_file() {
            return None;
        }
        match Table::read(path) {
            Ok(table) => Some(table),
            Err(trouble) => {
                self.troubles.push(format!("{trouble}; it is left out."));
                None
            }
        }
    }

    fn probes(&mut self) -> Vec<(String, Table)> {
        let Ok(entries) = std::fs::read_dir(self.dir.join("probes")) else {
            return Vec::new();
        };
        let mut paths: Vec<PathBuf> = entries
            .filter_map(|entry| entry.ok().map(|e| e.path()))
            .filter(|path| path.extension().is_some_and(|e| e == "csv"))
            .collect();
        paths.sort();
        let name = |path: &Path| {
            path.file_stem()
                .unwrap_or_default()
                .to_string_lossy()
                .into_owned()
        };
        paths
            .iter()
            .filter_map(|path| Some((name(path), self.table(path)?)))
            .collect()
    }
}

/// Two columns as points.
pub(crate) fn points(x: &[f64], y: &[f64]) -> Vec<[f64; 2]> {
    x.iter().zip(y).map(|(x, y)| [*x, *y]).collect()
}
