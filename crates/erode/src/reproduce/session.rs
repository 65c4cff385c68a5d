//! Reproductions that are made of runs: which they need, doing what is missing, handing the results over.

use crate::analysis::{WallPressure, YIELDED};
use crate::output::atomic::write_atomic;
use crate::output::{Collection, OutputError, RunPaths, Snapshot, Summary, Table};
use crate::sweep::{
    Execution, Outcome, Picture, Planned, Setting, Stand, SweepError, Watcher, execute,
    final_picture, stand_of,
};
use crate::validate::{Failure, Finding};
use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

/// A run that a reproduction needs. Needs with the same name are the same run, shared between reproductions.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Need {
    /// Name of its folder.
    pub(super) name: String,
    /// Name of the case and its text.
    pub(super) case: (&'static str, &'static str),
    /// What is laid over the case.
    pub(super) settings: Vec<Setting>,
}

/// How a session is done.
#[derive(Debug, Clone)]
pub struct Options {
    /// Where runs and figures go.
    pub folder: PathBuf,
    /// Low resolution.
    pub quick: bool,
    /// Particles per radius, if not those of the form.
    pub particles_per_radius: Option<u32>,
    /// Number of threads; all cores if none.
    pub threads: Option<usize>,
}

/// The runs that some reproductions need, with their cost.
#[derive(Debug, Clone)]
pub struct Session {
    /// How it is done.
    pub options: Options,
    /// The runs, each with its folder.
    pub runs: Vec<(Planned, PathBuf)>,
    /// Name and text of the case of each run.
    cases: Vec<(&'static str, &'static str)>,
}

impl Session {
    /// Checks the cases of all needs; nothing is run or written.
    ///
    /// # Errors
    /// If a case is wrong, which is a fault of the program.
    pub(super) fn prepare(options: Options, needs: &[Need]) -> Result<Self, SweepError> {
        let mut session = Self {
            options,
            runs: Vec::new(),
            cases: Vec::new(),
        };
        let root = session.options.folder.join("runs");
        for need in needs {
            if session.runs.iter().any(|(r, _)| r.name == need.name) {
                continue;
            }
            let planned = Planned::check_text(need.case, &need.name, &need.settings)?;
            let folder = root.join(&planned.name);
            session.runs.push((planned, folder));
            session.cases.push(need.case);
        }
        Ok(session)
    }

    /// Does what is missing; the outcome of each run.
    ///
    /// # Errors
    /// If the cases cannot be written.
    pub fn execute(
        &self,
        stop: &AtomicBool,
        watcher: &mut dyn Watcher,
    ) -> Result<Vec<Outcome>, OutputError> {
        // One case file at a time: all runs of the first, then all of the next.
        let mut outcomes = vec![Outcome::Waiting; self.runs.len()];
        let mut cases = self.cases.clone();
        cases.sort_unstable();
        cases.dedup();
        for case in cases {
            let members: Vec<usize> = (0..self.runs.len())
                .filter(|k| self.cases[*k] == case)
                .collect();
            let runs = members.iter().map(|k| {
                let (planned, folder) = &self.runs[*k];
                (planned, folder.clone())
            });
            let execution = Execution {
                case: &self.write_case(case)?,
                runs: runs.collect(),
                threads: self.options.threads,
                stop,
            };
            for (k, outcome) in members.iter().zip(execute(&execution, watcher)) {
                outcomes[*k] = outcome;
            }
        }
        Ok(outcomes)
    }

    fn write_case(&self, (name, text): (&str, &str)) -> Result<PathBuf, OutputError> {
        let folder = self.options.folder.join("cases");
        let path = folder.join(format!("{name}.toml"));
        std::fs::create_dir_all(&folder).map_err(|cause| OutputError::NotWritable {
            path: folder,
            cause,
        })?;
        write_atomic(&path, |f| f.write_all(text.as_bytes()))?;
        Ok(path)
    }

    /// The results of a run that is complete.
    ///
    /// # Errors
    /// If it is not, or cannot be read.
    pub(super) fn run(&self, need: &Need) -> Result<Ran, Failure> {
        let missing = |what: String| Failure::Absent(format!("run {}: {what}", need.name));
        let found = self.runs.iter().find(|(r, _)| r.name == need.name);
        let (planned, folder) = found.ok_or_else(|| missing("it was not asked for".into()))?;
        match stand_of(folder, planned) {
            Stand::Complete => {}
            Stand::New | Stand::Begun => {
                return Err(missing(
                    "it is not complete; the same command goes on with it".into(),
                ));
            }
            Stand::Unfit(why) => return Err(missing(format!("what lies in its folder is {why}"))),
        }
        let paths = RunPaths::new(folder);
        let summary = Summary::read(&paths.summary()).map_err(|e| missing(e.to_string()))?;
        Ok(Ran {
            name: need.name.clone(),
            paths,
            summary,
        })
    }
}

/// What a reproduction found, with its pictures.
#[derive(Debug, Clone, Default)]
pub struct Judged {
    /// Numbers, curves, notes.
    pub finding: Finding,
    /// Pictures of fields.
    pub pictures: Vec<Picture>,
}

impl From<Finding> for Judged {
    fn from(finding: Finding) -> Self {
        Self {
            finding,
            pictures: Vec::new(),
        }
    }
}

/// A complete run.
#[derive(Debug, Clone)]
pub(super) struct Ran {
    name: String,
    paths: RunPaths,
    summary: Summary,
}

/// The solid of a run at its end, one entry per particle.
#[derive(Debug, Clone)]
pub(super) struct Metal {
    /// (r, z), m.
    pub(super) position: Vec<[f64; 2]>,
    /// Plastic strain.
    pub(super) plastic_strain: Vec<f64>,
    /// Height of the surface, m.
    pub(super) top: f64,
    /// Finest spacing, m.
    pub(super) spacing: f64,
}

impl Metal {
    /// Height of the particle with the largest plastic strain, m; not a number where nothing yielded.
    pub(super) fn level(&self) -> f64 {
        let all = self.position.iter().zip(&self.plastic_strain);
        let worst = all.max_by(|a, b| a.1.total_cmp(b.1));
        worst
            .filter(|(_, strain)| **strain > YIELDED)
            .map_or(f64::NAN, |(x, _)| x[1])
    }
}

impl Ran {
    /// A scalar of the summary; NaN if it could not be determined.
    pub(super) fn get(&self, name: &str) -> f64 {
        self.summary.get(name).unwrap_or(f64::NAN)
    }

    /// A scalar of the metal for a comparison with other metal: not a number where it did not yield.
    pub(super) fn of_yielded(&self, name: &str) -> f64 {
        if self.get("plastic_volume") > 0.0 {
            self.get(name)
        } else {
            f64::NAN
        }
    }

    /// The unit of a scalar.
    pub(super) fn unit(&self, name: &str) -> &str {
        self.summary.unit(name).unwrap_or("-")
    }

    /// `history.csv`
    pub(super) fn history(&self) -> Result<Table, Failure> {
        Table::read(&self.paths.history()).map_err(|e| self.failed(&e))
    }

    /// The pressure at the wall.
    pub(super) fn wall(&self) -> Result<WallPressure, Failure> {
        let path = self.paths.surface("wall_pressure");
        let table = Table::read(&path).map_err(|e| self.failed(&e))?;
        WallPressure::of(&table).ok_or_else(|| self.failed(&"no wall pressure was recorded"))
    }

    /// The solid in the last snapshot.
    pub(super) fn metal(&self) -> Result<Metal, Failure> {
        let path = self.paths.collection();
        let collection = Collection::read(&path).map_err(|e| self.failed(&e))?;
        let last = collection.entries().iter().rev().find(|e| e.name == "wall");
        let file = last.ok_or_else(|| self.failed(&"no snapshot of the wall was written"))?;
        let snapshot =
            Snapshot::read(&path.with_file_name(&file.file)).map_err(|e| self.failed(&e))?;
        let field = |name: &str| snapshot.values(name).map(<[f64]>::to_vec);
        let (strain, area) = field("plastic_strain")
            .zip(field("area"))
            .ok_or_else(|| self.failed(&"the snapshot of the wall lacks a field"))?;
        let position: Vec<[f64; 2]> = snapshot.points.iter().map(|p| [p[0], p[1]]).collect();
        let spacing = area.iter().copied().fold(f64::INFINITY, f64::min).sqrt();
        let top = position.iter().map(|p| p[1]);
        Ok(Metal {
            // The highest particle centre is half a spacing below the surface.
            top: top.fold(f64::NEG_INFINITY, f64::max) + 0.5 * spacing,
            plastic_strain: strain,
            position,
            spacing,
        })
    }

    /// Plastic strain at the end, if there is any.
    pub(super) fn picture(&self, title: &str) -> Option<Picture> {
        final_picture(self.paths.root(), title, 370.0)
    }

    fn failed(&self, e: &dyn std::fmt::Display) -> Failure {
        Failure::Absent(format!("run {}: {e}", self.name))
    }
}
