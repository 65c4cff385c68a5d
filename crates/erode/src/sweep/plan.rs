//! From a sweep file to the list of its runs, each with its checked case.

use super::SweepError;
use super::file::{self, List, SweepFile};
use super::setting::{Setting, Value};
use crate::case::estimate::estimate;
use crate::case::{Case, CaseError, CaseErrors, Loaded};
use crate::output::hash_hex;
use std::path::{Path, PathBuf};

/// Longest name of a run; longer ones are cut and get a part of their fingerprint.
pub(super) const LONGEST_NAME: usize = 120;

/// One run of a sweep.
#[derive(Debug, Clone, PartialEq)]
pub struct Planned {
    /// Name of the run and of its folder.
    pub name: String,
    /// What tells it from the others.
    pub settings: Vec<Setting>,
    /// All that is laid over the case, as `--set` takes it.
    pub overrides: Vec<String>,
    /// Its case with every default.
    pub resolved: String,
    /// Fingerprint of that.
    pub hash: String,
    /// About what it costs; unknown for a run without particles.
    pub cost: Option<Cost>,
}

/// About what a run costs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cost {
    /// Particles.
    pub particles: f64,
    /// Steps.
    pub steps: f64,
    /// Seconds of computing.
    pub seconds: f64,
}

impl Cost {
    fn of(loaded: &Loaded) -> Option<Self> {
        let estimate = estimate(&loaded.simulation);
        let particles: f64 = estimate.particles.iter().sum();
        (particles > 0.0).then_some(Self {
            particles,
            steps: estimate.steps,
            seconds: estimate.wall_time,
        })
    }
}

/// A sweep whose cases are all correct.
#[derive(Debug, Clone)]
pub struct Plan {
    /// One line for people.
    pub title: String,
    /// The case that all runs start from.
    pub case: PathBuf,
    /// The varied keys in the order of the file.
    pub keys: Vec<String>,
    /// Groups of keys whose values are taken together (indices into `keys`).
    pub tied: Vec<usize>,
    /// The runs in the order in which they are done.
    pub runs: Vec<Planned>,
    /// The sweep file as given.
    pub source: String,
    /// Whether this is the quick form.
    pub quick: bool,
}

impl Planned {
    /// Checks the case of a run; `settings` tell it from others, `shared` go before them.
    ///
    /// # Errors
    /// Everything that is wrong with its case.
    pub fn check(
        case: &Path,
        name: &str,
        shared: &[Setting],
        settings: &[Setting],
    ) -> Result<Self, CaseErrors> {
        let all = shared.iter().chain(settings);
        let overrides: Vec<String> = all.map(Setting::to_override).collect();
        let loaded = Case::load(case, &overrides, &[])?;
        Ok(Self::of(name, settings, overrides, loaded))
    }

    /// Checks the case of a run that the program has as a text; `case_name` stands for its file.
    ///
    /// # Errors
    /// Everything that is wrong with it.
    pub(crate) fn check_text(
        (case_name, text): (&str, &str),
        name: &str,
        settings: &[Setting],
    ) -> Result<Self, CaseErrors> {
        let overrides: Vec<String> = settings.iter().map(Setting::to_override).collect();
        let loaded = Case::load_text(case_name, text, &overrides)?;
        Ok(Self::of(name, settings, overrides, loaded))
    }

    fn of(name: &str, settings: &[Setting], overrides: Vec<String>, loaded: Loaded) -> Self {
        Self {
            name: name.to_owned(),
            settings: settings.to_vec(),
            overrides,
            cost: Cost::of(&loaded),
            hash: hash_hex(loaded.resolved_toml.as_bytes()),
            resolved: loaded.resolved_toml,
        }
    }

    /// The value of a key in this run.
    #[must_use]
    pub fn value(&self, key: &str) -> Option<&Value> {
        self.settings
            .iter()
            .find(|s| s.key == key)
            .map(|s| &s.value)
    }
}

impl Plan {
    /// Reads a sweep file and checks the case of every run; `quick` adds the settings under `[quick]`.
    ///
    /// # Errors
    /// Everything that is wrong with the file and with the cases.
    pub fn read(path: &Path, quick: bool) -> Result<Self, SweepError> {
        let file = file::read(path)?;
        if quick && file.quick.is_empty() {
            let message = format!("{} has no quick form", path.display());
            let help =
                "write [quick] with settings that make all runs cheaper, such as fewer particles";
            return Err(CaseErrors::from(CaseError::whole(message, help)).into());
        }
        let mut shared = file.set.clone();
        if quick {
            // A quick setting takes the place of the one it is named after.
            shared.retain(|s| file.quick.iter().all(|q| q.key != s.key));
            shared.extend(file.quick.clone());
        }
        let drafts = drafts(&file);
        let names = names(&drafts);
        let mut runs = Vec::new();
        let mut errors = Vec::new();
        for (draft, name) in drafts.iter().zip(names) {
            match Planned::check(&file.case, &name, &shared, &draft.settings) {
                Ok(run) => runs.push(run),
                Err(found) => merge(&mut errors, found, &name),
            }
        }
        if !errors.is_empty() {
            let told = |(error, run): (CaseError, String)| error.of_run(&run, path);
            let errors = errors.into_iter().map(told).collect();
            return Err(CaseErrors { errors }.into());
        }
        refuse_twins(&runs)?;
        let keys = keys(&drafts);
        let at = |key: &String| keys.iter().position(|k| k == key);
        let title = if file.title.is_empty() {
            format!("Sweep of {}", file.case.display())
        } else {
            file.title.clone()
        };
        Ok(Self {
            title,
            tied: file.zip.iter().filter_map(|(key, _)| at(key)).collect(),
            case: file.case,
            keys,
            runs,
            source: file.source,
            quick,
        })
    }
}

/// A run before its case is checked.
struct Draft {
    name: Option<String>,
    settings: Vec<Setting>,
}

/// Every combination of the grid with every row of the zipped lists, then the runs listed one by one.
fn drafts(file: &SweepFile) -> Vec<Draft> {
    let mut all: Vec<Vec<Setting>> = vec![Vec::new()];
    for list in &file.grid {
        all = all.iter().flat_map(|head| extended(head, list)).collect();
    }
    let rows = file.zip.first().map_or(0, |(_, values)| values.len());
    if rows > 0 {
        let row = |k: usize| -> Vec<Setting> {
            let at = |(key, values): &List| Setting {
                key: key.clone(),
                value: values[k].clone(),
            };
            file.zip.iter().map(at).collect()
        };
        all = all
            .iter()
            .flat_map(|head| (0..rows).map(|k| [head.clone(), row(k)].concat()))
            .collect();
    }
    // Without lists there is one empty combination, which nobody asked for.
    all.retain(|settings| !settings.is_empty());
    let combined = all.into_iter().map(|settings| Draft {
        name: None,
        settings,
    });
    let listed = file.runs.iter().map(|r| Draft {
        name: r.name.clone(),
        settings: r.settings.clone(),
    });
    combined.chain(listed).collect()
}

fn extended(head: &[Setting], (key, values): &List) -> Vec<Vec<Setting>> {
    let with = |value: &Value| {
        let setting = Setting {
            key: key.clone(),
            value: value.clone(),
        };
        [head.to_vec(), vec![setting]].concat()
    };
    values.iter().map(with).collect()
}

/// All varied keys in the order in which they first appear.
fn keys(drafts: &[Draft]) -> Vec<String> {
    let mut keys: Vec<String> = Vec::new();
    for setting in drafts.iter().flat_map(|d| &d.settings) {
        if !keys.contains(&setting.key) {
            keys.push(setting.key.clone());
        }
    }
    keys
}

/// Shortest ends of the keys that tell them apart: `standoff`, or `wave.pressure` beside `gas.pressure`.
pub(super) fn short_keys(keys: &[String]) -> Vec<String> {
    let tail = |key: &str, parts: usize| {
        let all: Vec<&str> = key.split('.').collect();
        all[all.len().saturating_sub(parts)..].join(".")
    };
    let alone = |key: &String, parts: usize| {
        let others = keys.iter().filter(|k| *k != key);
        others
            .map(|o| tail(o, parts))
            .all(|o| o != tail(key, parts))
    };
    keys.iter()
        .map(|key| {
            let parts = (1..=key.split('.').count()).find(|n| alone(key, *n));
            tail(key, parts.unwrap_or(usize::MAX))
        })
        .collect()
}

/// Names that tell the runs apart: `standoff=1.33,driving_pressure=50MPa`, or as given.
fn names(drafts: &[Draft]) -> Vec<String> {
    let keys = keys(drafts);
    let short = short_keys(&keys);
    // Names that were given stay as they are, whatever others are called.
    let given: Vec<&String> = drafts.iter().filter_map(|d| d.name.as_ref()).collect();
    let mut names: Vec<String> = Vec::new();
    for draft in drafts {
        if let Some(name) = &draft.name {
            names.push(name.clone());
            continue;
        }
        let parts = draft.settings.iter().map(|s| {
            let at = keys.iter().position(|k| *k == s.key).unwrap_or(0);
            format!("{}={}", short[at], plain(&s.value.shown))
        });
        let name = parts.collect::<Vec<_>>().join(",");
        let name = if name.chars().count() > LONGEST_NAME {
            let head: String = name.chars().take(LONGEST_NAME).collect();
            format!("{head}-{}", &hash_hex(name.as_bytes())[..8])
        } else {
            name
        };
        let numbered = (2..).map(|k| format!("{name}-{k}"));
        let free = std::iter::once(name.clone())
            .chain(numbered)
            .find(|n| !names.contains(n) && !given.contains(&n));
        names.push(free.unwrap_or(name));
    }
    names
}

/// A text that can be part of a file name anywhere: letters, digits, and a few signs.
pub(super) fn plain(text: &str) -> String {
    let kept = text.chars().filter(|c| !c.is_whitespace());
    let safe = kept.map(|c| {
        if c.is_alphanumeric() || "+-._=,".contains(c) {
            c
        } else {
            '_'
        }
    });
    let name: String = safe.collect();
    // Dots alone would be a folder that exists.
    if name.is_empty() || name.chars().all(|c| c == '.') {
        format!("run{name}")
    } else {
        name
    }
}

/// Adds errors that were not there yet, with the run that has them: a wrong key is wrong in every run, and told once.
fn merge(errors: &mut Vec<(CaseError, String)>, found: CaseErrors, run: &str) {
    for error in found.errors {
        let same =
            |(e, _): &(CaseError, String)| e.message == error.message && e.help == error.help;
        if !errors.iter().any(same) {
            errors.push((error, run.to_owned()));
        }
    }
}

/// Two runs of the same case are a mistake in the lists.
fn refuse_twins(runs: &[Planned]) -> Result<(), CaseErrors> {
    for (k, run) in runs.iter().enumerate() {
        if let Some(twin) = runs[..k].iter().find(|r| r.hash == run.hash) {
            let message = format!(
                "the runs `{}` and `{}` are the same case",
                twin.name, run.name
            );
            let help = "take one of them out of the lists; a key under [quick] or [set] may hide what tells them apart";
            return Err(CaseError::whole(message, help).into());
        }
    }
    Ok(())
}

#[cfg(test)]
#[path = "plan_tests.rs"]
mod tests;
