//! The folder of a run: where everything lies, how it is made and how it is opened again.

use super::atomic::{clean_temporaries, list, write_atomic};
use super::error::OutputError;
use super::lines::difference;
use super::lock::{self, RunLock};
use std::fs;
use std::path::{Path, PathBuf};

const FOLDERS: [&str; 5] = ["fields", "probes", "surface", "checkpoints", "report"];

/// The places in a run folder. Only names: nothing is created or checked.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RunPaths {
    root: PathBuf,
}

impl RunPaths {
    /// The places under `root`.
    pub fn new(root: impl Into<PathBuf>) -> Self {
        Self { root: root.into() }
    }

    /// The places of a run that exists, for commands that only read.
    ///
    /// # Errors
    /// [`OutputError::NotAFolder`], [`OutputError::NotARun`].
    pub fn existing(root: impl Into<PathBuf>) -> Result<Self, OutputError> {
        let paths = Self::new(root);
        let path = paths.root.clone();
        if path.is_file() {
            Err(OutputError::NotAFolder { path })
        } else if !path.is_dir() {
            Err(OutputError::NotARun {
                path,
                missing: "the folder itself".into(),
            })
        } else if !paths.case().is_file() {
            Err(OutputError::NotARun {
                path,
                missing: "case.toml".into(),
            })
        } else {
            Ok(paths)
        }
    }

    /// The folder itself.
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// The case as the user gave it.
    pub fn case(&self) -> PathBuf {
        self.root.join("case.toml")
    }

    /// The case with every default written out.
    pub fn resolved(&self) -> PathBuf {
        self.root.join("resolved.toml")
    }

    /// One row per monitor step.
    pub fn history(&self) -> PathBuf {
        self.root.join("history.csv")
    }

    /// What happened to a bubble, one row each.
    pub fn events(&self) -> PathBuf {
        self.root.join("events.csv")
    }

    /// Repeated impacts, one row each.
    pub fn impacts(&self) -> PathBuf {
        self.root.join("impacts.csv")
    }

    /// The collapses of a cloud of bubbles, one row each.
    pub fn collapses(&self) -> PathBuf {
        self.root.join("collapses.csv")
    }

    /// The table of a probe.
    pub fn probe(&self, name: &str) -> PathBuf {
        self.root.join("probes").join(format!("{name}.csv"))
    }

    /// A table along a surface.
    pub fn surface(&self, name: &str) -> PathBuf {
        self.root.join("surface").join(format!("{name}.csv"))
    }

    /// The snapshots of all bodies, as a collection.
    pub fn collection(&self) -> PathBuf {
        self.root.join("fields.pvd")
    }

    /// Snapshot number `index` of `body`.
    pub fn snapshot(&self, body: &str, index: u64) -> PathBuf {
        self.root
            .join("fields")
            .join(format!("{body}_{index:06}.vtu"))
    }

    /// The folder of the checkpoints.
    pub fn checkpoints(&self) -> PathBuf {
        self.root.join("checkpoints")
    }

    /// The case as the run began with it: `case.toml` may be changed by its owner.
    pub fn begun_with(&self) -> PathBuf {
        self.checkpoints().join("case.toml")
    }

    /// The folder of the report.
    pub fn report(&self) -> PathBuf {
        self.root.join("report")
    }

    /// The final numbers.
    pub fn summary(&self) -> PathBuf {
        self.root.join("summary.json")
    }

    /// Where the run stands.
    pub fn status(&self) -> PathBuf {
        self.root.join("status.json")
    }

    /// The particles around the place where a run failed.
    pub fn failure(&self) -> PathBuf {
        self.root.join("failure.vtu")
    }

    /// Number of the process that writes to this folder now; `None` if there is none.
    pub fn holder(&self) -> Option<u32> {
        lock::holder(&self.root)
    }

    /// What a user would miss if it were overwritten: everything but the lock and empty folders of ours.
    fn contents(&self) -> Result<Vec<String>, OutputError> {
        let mut found = Vec::new();
        for path in list(&self.root)? {
            let name = path
                .file_name()
                .unwrap_or_default()
                .to_string_lossy()
                .into_owned();
            let ours_and_empty =
                FOLDERS.contains(&name.as_str()) && path.is_dir() && list(&path)?.is_empty();
            if !ours_and_empty && !lock::is_lock(&path) {
                found.push(name);
            }
        }
        Ok(found)
    }

    fn require_empty(&self) -> Result<(), OutputError> {
        let path = self.root.clone();
        if path.is_file() {
            return Err(OutputError::NotAFolder { path });
        }
        if !path.is_dir() {
            return Ok(());
        }
        let contents = self.contents()?;
        if contents.is_empty() {
            return Ok(());
        }
        let is_run = self.case().is_file();
        Err(OutputError::Occupied {
            path,
            found: in_words(&contents, is_run),
            is_run,
        })
    }
}

/// A run folder that this process may write to; no other process can while this value lives.
#[derive(Debug)]
pub struct RunFolder {
    paths: RunPaths,
    lock: RunLock,
}

impl RunFolder {
    /// Makes the folder of a new run with its subfolders. An existing folder must be empty.
    ///
    /// # Errors
    /// [`OutputError::Occupied`] (nothing is touched), [`OutputError::NotAFolder`], [`OutputError::NotWritable`],
    /// [`OutputError::Locked`].
    pub fn create(root: impl Into<PathBuf>) -> Result<Self, OutputError> {
        let paths = RunPaths::new(root);
        let unwritable = |cause| OutputError::NotWritable {
            path: paths.root.clone(),
            cause,
        };
        paths.require_empty()?;
        fs::create_dir_all(&paths.root).map_err(unwritable)?;
        let lock = RunLock::acquire(&paths.root)?;
        // Another process may have had the folder, filled it and left between the first look and the lock.
        paths.require_empty()?;
        for name in FOLDERS {
            fs::create_dir_all(paths.root.join(name)).map_err(unwritable)?;
        }
        Ok(Self { paths, lock })
    }

    /// Opens the folder of an earlier run to continue it; removes half-written files of a killed process.
    ///
    /// # Errors
    /// [`OutputError::NotARun`], [`OutputError::NotAFolder`], [`OutputError::Locked`], [`OutputError::NotWritable`].
    pub fn open(root: impl Into<PathBuf>) -> Result<Self, OutputError> {
        let paths = RunPaths::existing(root)?;
        if !paths.resolved().is_file() {
            return Err(OutputError::NotARun {
                path: paths.root,
                missing: "resolved.toml".into(),
            });
        }
        let lock = RunLock::acquire(&paths.root)?;
        clean_temporaries(&paths.root)?;
        for name in FOLDERS {
            let folder = paths.root.join(name);
            fs::create_dir_all(&folder).map_err(|cause| OutputError::NotWritable {
                path: paths.root.clone(),
                cause,
            })?;
            clean_temporaries(&folder)?;
        }
        Ok(Self { paths, lock })
    }

    /// Where everything lies.
    pub fn paths(&self) -> &RunPaths {
        &self.paths
    }

    /// Number of the process that had this folder before and was killed, if there was one.
    pub fn killed_process(&self) -> Option<u32> {
        self.lock.stale
    }

    /// Writes the case as given (`case.toml`, byte for byte) and with every default (`resolved.toml`).
    ///
    /// # Errors
    /// [`OutputError::Write`].
    pub fn write_case(&self, given: &[u8], resolved: &str) -> Result<(), OutputError> {
        // `case.toml` makes the folder a run, so it comes last.
        write_atomic(&self.paths.begun_with(), |file| file.write_all(given))?;
        write_atomic(&self.paths.resolved(), |file| {
            file.write_all(resolved.as_bytes())
        })?;
        write_atomic(&self.paths.case(), |file| file.write_all(given))
    }
}

/// Most lines of a difference that are shown.
const SHOWN_LINES: usize = 24;

impl RunFolder {
    /// Refuses a run whose `case.toml` is no longer the one that it began with.
    ///
    /// # Errors
    /// [`OutputError::CaseChanged`], [`OutputError::Read`].
    pub fn require_same_case(&self) -> Result<(), OutputError> {
        let read = |path: PathBuf| match fs::read(&path) {
            Ok(bytes) => Ok(bytes),
            Err(cause) => Err(OutputError::Read { path, cause }),
        };
        // Folders of earlier versions do not have it.
        if !self.paths.begun_with().is_file() {
            return Ok(());
        }
        let (was, is) = (read(self.paths.begun_with())?, read(self.paths.case())?);
        if was == is {
            return Ok(());
        }
        let [was, is] = [was, is].map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
        Err(OutputError::CaseChanged {
            path: self.paths.case(),
            difference: difference(&was, &is, SHOWN_LINES).join("\n"),
        })
    }
}

fn in_words(contents: &[String], is_run: bool) -> String {
    const SHOWN: usize = 4;
    let mut text = String::from(if is_run { "a run (" } else { "other files (" });
    text.push_str(&contents[..contents.len().min(SHOWN)].join(", "));
    if contents.len() > SHOWN {
        text.push_str(&format!(" and {} more", contents.len() - SHOWN));
    }
    text.push(')');
    text
}

#[cfg(test)]
#[path = "run_folder_tests.rs"]
mod tests;
