//! The folder of a sweep: the plan as it was, the runs, and where each of them stands.
//!
//! `plan/sweep.toml` makes a folder that of a sweep. Only files below `plan` and `runs` are ever replaced or removed.

use super::plan::{Plan, Planned};
use super::{SweepError, Table};
use crate::output::atomic::{list, write_atomic};
use crate::output::lines::difference;
use crate::output::lock::{self, LOCK_FILE};
use crate::output::{OutputError, RunPaths, State, Status, Summary, hash_hex};
use std::fmt::{self, Display};
use std::fs;
use std::path::{Path, PathBuf};

/// Most lines of a difference that are shown.
const SHOWN: usize = 24;

/// Where the runs of a sweep and its results lie.
#[derive(Debug, Clone)]
pub struct Folder {
    root: PathBuf,
}

/// Where a run stands.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Stand {
    /// Nothing is there.
    New,
    /// It reached its end with this very case and this version of Erode.
    Complete,
    /// It has begun and can go on.
    Begun,
    /// What is there cannot be used.
    Unfit(Unfit),
}

/// Why what lies in the folder of a run cannot be used.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unfit {
    /// It belongs to another case, or is no run.
    OtherCase,
    /// It is complete, but another version of Erode has computed it.
    OtherVersion,
    /// It did not reach its end, and there is no checkpoint, or none that is whole.
    NoCheckpoint,
}

impl Display for Unfit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::OtherCase => "of another case",
            Self::OtherVersion => "by another version of Erode",
            Self::NoCheckpoint => "without a usable checkpoint",
        })
    }
}

impl Folder {
    /// The folder `root`; nothing is made yet.
    pub fn new(root: impl Into<PathBuf>) -> Self {
        Self { root: root.into() }
    }

    /// The folder itself.
    #[must_use]
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// The folder of a run.
    #[must_use]
    pub fn run(&self, name: &str) -> PathBuf {
        self.root.join("runs").join(name)
    }

    /// The results, one row per run.
    #[must_use]
    pub fn csv(&self) -> PathBuf {
        self.root.join("results.csv")
    }

    /// The results as Parquet.
    #[must_use]
    pub fn parquet(&self) -> PathBuf {
        self.root.join("results.parquet")
    }

    /// The report.
    #[must_use]
    pub fn report(&self) -> PathBuf {
        self.root.join("report.html")
    }

    fn sweep(&self) -> PathBuf {
        self.root.join("plan").join("sweep.toml")
    }

    fn case(&self, name: &str) -> PathBuf {
        self.cases().join(format!("{name}.toml"))
    }

    fn cases(&self) -> PathBuf {
        self.root.join("plan").join("cases")
    }

    /// Refuses to go on with a plan that is not the one that the folder was made for, unless `accept` says so; a folder
    /// with other things in it is refused in any case.
    ///
    /// # Errors
    /// [`SweepError::Changed`] with the difference; [`OutputError::Occupied`] where something else lies there.
    pub fn agree(&self, plan: &Plan, accept: bool) -> Result<(), SweepError> {
        if !self.sweep().is_file() {
            return Ok(self.require_empty()?);
        }
        if accept {
            return Ok(());
        }
        let old = read(&self.sweep())?;
        let mut told = headed("sweep.toml:", difference(&old, &plan.source, SHOWN));
        let before = self.planned()?;
        let now: Vec<&str> = plan.runs.iter().map(|r| r.name.as_str()).collect();
        let gone = before.iter().filter(|name| !now.contains(&name.as_str()));
        told.extend(gone.map(|name| format!("run {name} is no longer there")));
        let added = now.iter().filter(|name| !before.iter().any(|b| b == *name));
        told.extend(added.map(|name| format!("run {name} is new")));
        for run in plan.runs.iter().filter(|r| before.contains(&r.name)) {
            let was = read(&self.case(&run.name))?;
            if was != run.resolved {
                let what = format!("the case of run {}:", run.name);
                told.extend(headed(&what, difference(&was, &run.resolved, SHOWN)));
                // The others differ in the same way, most of the time.
                break;
            }
        }
        if told.is_empty() {
            return Ok(());
        }
        Err(SweepError::Changed {
            folder: self.root.display().to_string(),
            difference: told.join("\n"),
        })
    }

    /// Records the plan.
    ///
    /// # Errors
    /// If the folder cannot be written.
    pub fn record(&self, plan: &Plan) -> Result<(), OutputError> {
        for path in [self.cases(), self.root.join("runs")] {
            fs::create_dir_all(&path).map_err(|cause| OutputError::NotWritable { path, cause })?;
        }
        let now: Vec<PathBuf> = plan.runs.iter().map(|r| self.case(&r.name)).collect();
        for path in list(&self.cases())? {
            if !now.contains(&path) {
                fs::remove_file(&path).map_err(|cause| OutputError::Write { path, cause })?;
            }
        }
        for run in &plan.runs {
            write(&self.case(&run.name), &run.resolved)?;
        }
        // This makes the folder a sweep, so it comes last.
        write(&self.sweep(), &plan.source)
    }

    /// Writes the table of results in both forms.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub fn write_results(&self, table: &Table) -> Result<(), OutputError> {
        super::write_csv(&self.csv(), table)?;
        super::parquet::write(&self.parquet(), table)
    }

    /// Names of the runs of the plan that was recorded.
    fn planned(&self) -> Result<Vec<String>, OutputError> {
        let files = list(&self.cases())?;
        let stem = |p: &PathBuf| {
            p.file_name()?
                .to_str()?
                .strip_suffix(".toml")
                .map(str::to_owned)
        };
        Ok(files.iter().filter_map(stem).collect())
    }

    fn require_empty(&self) -> Result<(), OutputError> {
        let path = self.root.clone();
        if path.is_file() {
            return Err(OutputError::NotAFolder { path });
        }
        let found = if path.is_dir() {
            list(&path)?
        } else {
            Vec::new()
        };
        // A sweep that was stopped before its plan was recorded leaves these.
        let ours = |p: &PathBuf| {
            ["plan", "runs", LOCK_FILE]
                .iter()
                .any(|name| p.ends_with(name))
        };
        match found.iter().find(|p| !ours(p)) {
            None => Ok(()),
            Some(other) => Err(OutputError::Occupied {
                found: format!("other files ({} and so on)", other.display()),
                path,
                is_run: false,
            }),
        }
    }
}

/// Where the run in `folder` stands that should be `run`.
#[must_use]
pub fn stand_of(folder: &Path, run: &Planned) -> Stand {
    if !folder.exists() {
        return Stand::New;
    }
    let paths = RunPaths::new(folder);
    let same = fs::read(paths.resolved()).is_ok_and(|text| hash_hex(&text) == run.hash);
    if !same {
        return Stand::Unfit(Unfit::OtherCase);
    }
    let done = Status::read(&paths.status()).is_ok_and(|s| s.state == State::Done);
    if done && let Ok(summary) = Summary::read(&paths.summary()) {
        return match summary.version("erode") {
            Some(env!("CARGO_PKG_VERSION")) => Stand::Complete,
            _ => Stand::Unfit(Unfit::OtherVersion),
        };
    }
    let checkpoints = list(&paths.checkpoints()).unwrap_or_default();
    let can_go_on = checkpoints
        .iter()
        .any(|p| p.is_file() && *p != paths.begun_with());
    if can_go_on {
        Stand::Begun
    } else {
        Stand::Unfit(Unfit::NoCheckpoint)
    }
}

/// Gives a folder that cannot be used another name, `NAME.old-1` and so on; that name.
///
/// # Errors
/// If another process writes to it, or it cannot be renamed.
pub(super) fn set_aside(folder: &Path) -> Result<PathBuf, OutputError> {
    let path = folder.to_path_buf();
    if let holder @ Some(_) = lock::holder(folder) {
        return Err(OutputError::Locked { path, holder });
    }
    let name = folder.file_name().unwrap_or_default().to_string_lossy();
    let mut names = (1..).map(|k| folder.with_file_name(format!("{name}.old-{k}")));
    let free = names.find(|p| !p.exists()).unwrap_or_default();
    fs::rename(folder, &free).map_err(|cause| OutputError::Write { path, cause })?;
    Ok(free)
}

fn headed(head: &str, lines: Vec<String>) -> Vec<String> {
    if lines.is_empty() {
        return lines;
    }
    let indented = lines.into_iter().map(|l| format!("  {l}"));
    std::iter::once(head.to_owned()).chain(indented).collect()
}

fn read(path: &Path) -> Result<String, OutputError> {
    fs::read_to_string(path).map_err(|cause| OutputError::Read {
        path: path.to_path_buf(),
        cause,
    })
}

fn write(path: &Path, text: &str) -> Result<(), OutputError> {
    write_atomic(path, |file| file.write_all(text.as_bytes()))
}
