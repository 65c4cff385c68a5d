//! The final numbers of a run, `summary.json`.

use super::atomic::write_atomic;
use super::error::OutputError;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
use std::fs;
use std::path::Path;

/// Names that are tables of the summary and so cannot be scalars.
const TABLES: [&str; 9] = [
    "findings",
    "layers",
    "seconds",
    "units",
    "versions",
    "input_hashes",
    "ledger",
    "limiters",
    "comparison",
];

/// Scalars by name (top level of the file, in the order of adding) and the tables about them.
///
/// A scalar that is not a finite number is `null`: it could not be determined.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Summary {
    #[serde(flatten)]
    scalars: Map<String, Value>,
    /// Unit of each scalar, SI; `-` for a pure number.
    units: Map<String, Value>,
    /// Versions of the program and of the formats it wrote.
    versions: Map<String, Value>,
    /// SHA-256 of each input.
    input_hashes: Map<String, Value>,
    /// The conservation ledger: energies (J), masses (kg) and counts of whatever left the computation.
    ledger: Map<String, Value>,
    /// Number of steps that each criterion limited.
    limiters: Map<String, Value>,
    /// Seconds of computing in each part of the run.
    #[serde(default)]
    seconds: Map<String, Value>,
    /// Values beside those of a source: `quantity`, `value`, `reference`, `unit`, `source` each.
    #[serde(default)]
    comparison: Vec<Value>,
    /// Layers of a solid from the top: `material`, `thickness`, `resolved_thickness`, `max_plastic_strain`, `plastic_work`,
    /// `lost_mass` each, SI; the last one is the body below them. Empty without layers.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    layers: Vec<Value>,
    /// Sentences that a reader of the numbers must know. Empty as a rule.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    findings: Vec<String>,
}

impl Summary {
    /// Sets the scalar `name` in `unit`; a later value replaces an earlier one.
    pub fn set(&mut self, name: &str, unit: &str, value: f64) {
        self.scalars.insert(name.into(), value.into());
        self.units.insert(name.into(), unit.into());
    }

    /// Sets the whole number `name`.
    pub fn set_count(&mut self, name: &str, value: u64) {
        self.scalars.insert(name.into(), value.into());
        self.units.insert(name.into(), "-".into());
    }

    /// Sets a version, such as `erode`, `checkpoint_schema`.
    pub fn set_version(&mut self, name: &str, version: &str) {
        self.versions.insert(name.into(), version.into());
    }

    /// The version of a program or format that wrote it.
    #[must_use]
    pub fn version(&self, name: &str) -> Option<&str> {
        self.versions.get(name)?.as_str()
    }

    /// Sets the fingerprint of an input.
    pub fn set_input_hash(&mut self, name: &str, hash: &str) {
        self.input_hashes.insert(name.into(), hash.into());
    }

    /// Sets an entry of the ledger; its unit is listed with the others.
    pub fn set_ledger(&mut self, name: &str, unit: &str, value: f64) {
        self.ledger.insert(name.into(), value.into());
        self.units.insert(format!("ledger.{name}"), unit.into());
    }

    /// Sets how many steps a criterion limited.
    pub fn set_limiter(&mut self, name: &str, steps: u64) {
        self.limiters.insert(name.into(), steps.into());
    }

    /// Sets the seconds of computing in a part of the run.
    pub fn set_seconds(&mut self, part: &str, seconds: f64) {
        self.seconds.insert(part.into(), seconds.into());
    }

    /// Sets the comparison with a source.
    pub fn set_comparison(&mut self, rows: Vec<Value>) {
        self.comparison = rows;
    }

    /// Sets what is told of each layer of a solid.
    pub fn set_layers(&mut self, rows: Vec<Value>) {
        self.layers = rows;
    }

    /// Adds a sentence that a reader of the numbers must know.
    pub fn add_finding(&mut self, sentence: String) {
        self.findings.push(sentence);
    }

    /// Sentences that a reader of the numbers must know.
    #[must_use]
    pub fn findings(&self) -> &[String] {
        &self.findings
    }

    /// The comparison with a source.
    #[must_use]
    pub fn comparison(&self) -> &[Value] {
        &self.comparison
    }

    /// The scalar `name`; `None` if it is absent or could not be determined.
    pub fn get(&self, name: &str) -> Option<f64> {
        self.scalars.get(name)?.as_f64()
    }

    /// The unit of the scalar `name`.
    pub fn unit(&self, name: &str) -> Option<&str> {
        self.units.get(name)?.as_str()
    }

    /// All scalars in the order of adding, with their units; the value is `None` if it could not be determined.
    pub fn scalars(&self) -> impl Iterator<Item = (&str, Option<f64>, &str)> {
        self.scalars.iter().map(|(name, value)| {
            (
                name.as_str(),
                value.as_f64(),
                self.unit(name).unwrap_or("-"),
            )
        })
    }

    /// The ledger in the order of adding.
    pub fn ledger(&self) -> impl Iterator<Item = (&str, Option<f64>)> {
        self.ledger
            .iter()
            .map(|(name, value)| (name.as_str(), value.as_f64()))
    }

    /// The criteria and the number of steps each limited.
    pub fn limiters(&self) -> impl Iterator<Item = (&str, u64)> {
        self.limiters
            .iter()
            .map(|(name, steps)| (name.as_str(), steps.as_u64().unwrap_or(0)))
    }

    /// Writes the file, complete or not at all.
    ///
    /// # Errors
    /// [`OutputError::Write`]; [`OutputError::Content`] if a scalar has the name of a table.
    pub fn write(&self, path: &Path) -> Result<(), OutputError> {
        if let Some(name) = TABLES.iter().find(|name| self.scalars.contains_key(**name)) {
            return Err(OutputError::content(
                name,
                "it is the name of a table of the summary",
            ));
        }
        write_json(path, self)
    }

    /// Reads what [`Summary::write`] wrote.
    ///
    /// # Errors
    /// [`OutputError::Read`], [`OutputError::Malformed`].
    pub fn read(path: &Path) -> Result<Self, OutputError> {
        read_json(path)
    }
}

pub(super) fn write_json(path: &Path, value: &impl Serialize) -> Result<(), OutputError> {
    let mut text = serde_json::to_string_pretty(value)
        .map_err(|error| OutputError::content(&path.to_string_lossy(), error.to_string()))?;
    text.push('\n');
    write_atomic(path, |file| file.write_all(text.as_bytes()))
}

pub(super) fn read_json<T: for<'a> Deserialize<'a>>(path: &Path) -> Result<T, OutputError> {
    let text = fs::read(path).map_err(|cause| OutputError::Read {
        path: path.into(),
        cause,
    })?;
    serde_json::from_slice(&text).map_err(|error| OutputError::Malformed {
        path: path.into(),
        what: error.to_string(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn summary() -> Summary {
        let mut summary = Summary::default();
        summary.set("collapse_time", "s", 0.1 + 0.2);
        summary.set("pit_depth", "m", f64::NAN);
        summary.set_count("steps", 9_007_199_254_740_993);
        summary.set_version("erode", "0.1.0");
        summary.set_input_hash("case.toml", "ab");
        summary.set_ledger("kinetic_energy", "J", 1.0 / 3.0);
        summary.set_limiter("sound_speed", 41);
        summary
    }

    #[test]
    fn scalars_are_at_the_top_level_in_order_and_come_back() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("summary.json");
        summary().write(&path).unwrap();
        let value: Value = serde_json::from_slice(&fs::read(&path).unwrap()).unwrap();
        assert_eq!(value["collapse_time"].as_f64(), Some(0.1 + 0.2));
        assert_eq!(value["pit_depth"], Value::Null);
        assert_eq!(value["steps"].as_u64(), Some(9_007_199_254_740_993));
        assert_eq!(value["units"]["collapse_time"], "s");
        let names: Vec<_> = value.as_object().unwrap().keys().collect();
        assert_eq!(names[..4], ["collapse_time", "pit_depth", "steps", "units"]);
        let read = Summary::read(&path).unwrap();
        assert_eq!(read, summary());
        assert_eq!(
            (read.get("pit_depth"), read.unit("pit_depth")),
            (None, Some("m"))
        );
        assert_eq!(read.limiters().collect::<Vec<_>>(), [("sound_speed", 41)]);
    }

    #[test]
    fn a_scalar_cannot_hide_a_table() {
        let folder = tempfile::tempdir().unwrap();
        let mut summary = summary();
        summary.set("units", "-", 1.0);
        assert!(summary.write(&folder.path().join("summary.json")).is_err());
    }

    #[test]
    fn a_broken_file_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("summary.json");
        assert!(matches!(
            Summary::read(&path),
            Err(OutputError::Read { .. })
        ));
        fs::write(&path, "{\"steps\": ").unwrap();
        assert!(matches!(
            Summary::read(&path),
            Err(OutputError::Malformed { .. })
        ));
    }
}
