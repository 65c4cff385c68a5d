//! Loading a case: the texts, then the checks, then the simulation.

use super::{
    build,
    check::check_table,
    error::{CaseError, CaseErrors, Findings, Span},
    keys::CASE,
    overrides,
    raw::parse,
    resolved,
    simulation::Simulation,
};
use crate::materials::Library;
use std::path::{Path, PathBuf};

/// A case that was found correct.
#[derive(Debug, Clone)]
pub struct Loaded {
    /// What to run.
    pub simulation: Simulation,
    /// The case with every default written out; it can itself be run.
    pub resolved_toml: String,
    /// The case file as given.
    pub source: String,
    /// The file that was read.
    pub file: PathBuf,
}

/// Reading case files.
#[derive(Debug, Clone, Copy)]
pub struct Case;

impl Case {
    /// Reads and checks a case file, or the `case.toml` of a folder.
    ///
    /// `overrides` are texts `path.to.key=value`. Materials come from the program, from `materials_dirs` and from a
    /// folder `materials` beside the case; later ones win.
    ///
    /// # Errors
    /// Everything that is wrong with the case, each with its place and what is allowed.
    pub fn load(
        path: &Path,
        overrides: &[String],
        materials_dirs: &[PathBuf],
    ) -> Result<Loaded, CaseErrors> {
        let file = find_file(path)?;
        let source = read_text(&file)?;
        if source.trim().is_empty() {
            let message = format!("{} is empty", file.display());
            return Err(CaseError::whole(
                message,
                "start from a template: erode new bubble-near-wall",
            )
            .into());
        }
        let mut folders = materials_dirs.to_vec();
        folders.extend(
            file.parent()
                .map(|p| p.join("materials"))
                .filter(|p| p.is_dir()),
        );
        let simulation = read(&file.display().to_string(), &source, overrides, &folders)?;
        Ok(Loaded {
            resolved_toml: resolved::write(&simulation),
            simulation,
            source,
            file,
        })
    }

    /// Checks a case that the program has as a text, with the materials of the program.
    ///
    /// # Errors
    /// As for [`Case::load`]; `name` stands for the file.
    pub(crate) fn load_text(
        name: &str,
        text: &str,
        overrides: &[String],
    ) -> Result<Loaded, CaseErrors> {
        let simulation = Self::parse(name, text, overrides)?;
        Ok(Loaded {
            resolved_toml: resolved::write(&simulation),
            simulation,
            source: text.to_owned(),
            file: name.into(),
        })
    }

    /// Checks a case that is given as text, with the materials of the program.
    ///
    /// # Errors
    /// As for [`Case::load`]; `name` stands for the file.
    pub fn parse(name: &str, text: &str, overrides: &[String]) -> Result<Simulation, CaseErrors> {
        read(name, text, overrides, &[])
    }
}

fn read(
    name: &str,
    text: &str,
    overrides: &[String],
    folders: &[PathBuf],
) -> Result<Simulation, CaseErrors> {
    let mut library = Library::embedded()?;
    let mut findings = Findings::default();
    let source = findings.add_source(name, text);
    let mut raw = parse(source, &mut findings);
    let syntax_errors = findings.count();
    for text in overrides {
        overrides::apply(&mut raw, text, &mut findings);
    }
    for folder in folders {
        library.read_folder(folder, &mut findings)?;
    }
    // What was lost to a syntax error would be reported again as missing.
    let mut simulation = None;
    if syntax_errors == 0 {
        let node = check_table(
            &raw,
            Span {
                source,
                start: 0,
                end: 0,
            },
            &CASE,
            "",
            &mut findings,
        );
        simulation = build::simulation(&node, &mut library, &mut findings);
    }
    match (findings.into_errors(), simulation) {
        (None, Some(s)) => Ok(s),
        (Some(errors), _) => Err(errors),
        (None, None) => {
            let message = "the case cannot be understood, and Erode cannot say why";
            Err(
                CaseError::whole(message, "this is a fault of Erode: please report the case")
                    .into(),
            )
        }
    }
}

fn find_file(path: &Path) -> Result<PathBuf, CaseError> {
    if path.is_dir() {
        let file = path.join("case.toml");
        if file.is_file() {
            return Ok(file);
        }
        let message = format!("{} is a folder without a case.toml", path.display());
        let found = toml_files(path);
        let help = if found.is_empty() {
            "give a case file or a folder that contains case.toml; `erode new bubble-near-wall DIR` writes one".to_owned()
        } else {
            format!(
                "give a case file or a folder that contains case.toml; in here: {}",
                found.join(", ")
            )
        };
        return Err(CaseError::whole(message, help));
    }
    if path.exists() {
        return Ok(path.to_owned());
    }
    let message = format!("there is no file {}", path.display());
    Err(CaseError::whole(message, missing_file_help(path)))
}

/// Names what lies in the folder where the file was looked for.
fn missing_file_help(path: &Path) -> String {
    let folder = path
        .parent()
        .filter(|p| !p.as_os_str().is_empty())
        .unwrap_or(Path::new("."));
    if !folder.is_dir() {
        return format!("the folder {} does not exist either", folder.display());
    }
    let entries = std::fs::read_dir(folder)
        .into_iter()
        .flatten()
        .filter_map(Result::ok);
    let mut names: Vec<String> = entries
        .map(|e| e.file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    let wanted = path
        .file_name()
        .map(|n| n.to_string_lossy().into_owned())
        .unwrap_or_default();
    match super::suggest::closest(&wanted, names.iter().map(String::as_str)) {
        Some(name) => format!("did you mean {}?", folder.join(name).display()),
        None => "`erode new bubble-near-wall DIR` writes a case to start from".to_owned(),
    }
}

fn toml_files(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder)
        .into_iter()
        .flatten()
        .filter_map(Result::ok);
    let names = entries.map(|e| e.file_name().to_string_lossy().into_owned());
    let mut names: Vec<String> = names.filter(|n| n.ends_with(".toml")).collect();
    names.sort();
    names.truncate(8);
    names
}

/// Reads a text file.
pub(crate) fn read_text(file: &Path) -> Result<String, CaseError> {
    let bytes = std::fs::read(file).map_err(|e| {
        CaseError::whole(
            format!("{} cannot be read: {e}", file.display()),
            "check the path and its permissions",
        )
    })?;
    String::from_utf8(bytes).map_err(|e| {
        let valid = e.utf8_error().valid_up_to();
        let before = &e.as_bytes()[..valid];
        let line = before.iter().filter(|b| **b == b'\n').count() + 1;
        let column = before.iter().rev().take_while(|b| **b != b'\n').count() + 1;
        let message = format!(
            "{}:{line}:{column}: the file is not UTF-8 (byte 0x{:02x} cannot stand here)",
            file.display(),
            e.as_bytes()[valid]
        );
        CaseError::whole(
            message,
            "save the file as UTF-8 text; a compressed or binary file is no case",
        )
    })
}
