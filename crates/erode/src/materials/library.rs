//! Materials by name: those of the program and those of folders.

use super::Material;
use crate::case::{
    check::check_table,
    error::{CaseError, CaseErrors, Findings, Span},
    keys_material::MATERIAL,
    load::read_text,
    node::{Data, Node},
    raw::parse,
};
use std::{
    collections::BTreeMap,
    path::{Path, PathBuf},
};

/// Files compiled into the program: (name, text).
const EMBEDDED: &[(&str, &str)] = &[
    (
        "aluminium_6061_t6",
        include_str!("../../../../materials/aluminium_6061_t6.toml"),
    ),
    (
        "aluminium_cao2022",
        include_str!("../../../../materials/aluminium_cao2022.toml"),
    ),
    (
        "copper_annealed",
        include_str!("../../../../materials/copper_annealed.toml"),
    ),
    (
        "copper_ofhc",
        include_str!("../../../../materials/copper_ofhc.toml"),
    ),
    (
        "steel_1045",
        include_str!("../../../../materials/steel_1045.toml"),
    ),
    (
        "steel_316l",
        include_str!("../../../../materials/steel_316l.toml"),
    ),
    (
        "steel_a2205",
        include_str!("../../../../materials/steel_a2205.toml"),
    ),
    (
        "titanium_6al4v",
        include_str!("../../../../materials/titanium_6al4v.toml"),
    ),
    ("water", include_str!("../../../../materials/water.toml")),
];

/// Materials by name.
#[derive(Debug, Clone, Default)]
pub struct Library {
    materials: BTreeMap<String, Material>,
}

impl Library {
    /// The materials compiled into the program.
    ///
    /// # Errors
    /// When one of them is wrong, which the tests rule out.
    pub fn embedded() -> Result<Self, CaseErrors> {
        let mut library = Self::default();
        let mut findings = Findings::default();
        for (name, text) in EMBEDDED {
            library.read_text(name, &format!("materials/{name}.toml"), text, &mut findings);
        }
        findings.into_errors().map_or(Ok(library), Err)
    }

    /// The materials of the program and those of folders, which win.
    ///
    /// # Errors
    /// What is wrong with the files, each with its place.
    pub fn with_folders(folders: &[PathBuf]) -> Result<Self, CaseErrors> {
        let mut library = Self::embedded()?;
        let mut findings = Findings::default();
        for folder in folders {
            library.read_folder(folder, &mut findings)?;
        }
        findings.into_errors().map_or(Ok(library), Err)
    }

    /// Adds the `NAME.toml` files of a folder; they replace materials of the same name.
    pub(crate) fn read_folder(
        &mut self,
        folder: &Path,
        findings: &mut Findings,
    ) -> Result<(), CaseError> {
        let fail = |e: std::io::Error| {
            let message = format!(
                "the materials folder {} cannot be read: {e}",
                folder.display()
            );
            CaseError::whole(message, "check the path and its permissions")
        };
        let mut files: Vec<_> = std::fs::read_dir(folder)
            .map_err(fail)?
            .filter_map(|entry| entry.ok().map(|e| e.path()))
            .filter(|p| p.extension().is_some_and(|e| e == "toml"))
            .collect();
        files.sort();
        for file in files {
            let text = read_text(&file)?;
            let name = file
                .file_stem()
                .map(|s| s.to_string_lossy().into_owned())
                .unwrap_or_default();
            self.materials.remove(&name);
            self.read_text(&name, &file.display().to_string(), &text, findings);
        }
        Ok(())
    }

    fn read_text(&mut self, name: &str, file: &str, text: &str, findings: &mut Findings) {
        let source = findings.add_source(file, text);
        let before = findings.count();
        let raw = parse(source, findings);
        if findings.count() > before {
            return;
        }
        let node = check_table(
            &raw,
            Span {
                source,
                start: 0,
                end: 0,
            },
            &MATERIAL,
            "",
            findings,
        );
        require_sources(&node, findings);
        self.add(name, &node);
    }

    /// Completes or adds a material from a checked table.
    pub(crate) fn add(&mut self, name: &str, node: &Node) {
        let material = self
            .materials
            .entry(name.to_owned())
            .or_insert_with(|| Material::empty(name));
        if let Some(fields) = node.fields() {
            material.overlay_material(fields);
        }
    }

    /// The material of that name.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<&Material> {
        self.materials.get(name)
    }

    /// All materials in the order of their names.
    pub fn iter(&self) -> impl Iterator<Item = &Material> + Clone {
        self.materials.values()
    }
}

/// In a material file each number names one of `[sources]`.
fn require_sources(node: &Node, findings: &mut Findings) {
    let Some(root) = node.fields() else { return };
    let sources = root.table("sources");
    let mut stack: Vec<&Node> = ["fluid", "solid"]
        .iter()
        .filter_map(|k| root.node(k))
        .collect();
    while let Some(node) = stack.pop() {
        match &node.data {
            Data::Table(entries) => stack.extend(entries.iter().map(|(_, n)| n)),
            Data::Property { source, .. } => {
                let known = source
                    .as_ref()
                    .is_some_and(|s| sources.is_some_and(|t| t.text(s).is_some()));
                if !known {
                    let help = "write { value = \"...\", source = \"key\" } and explain the key under [sources]";
                    findings.error(
                        node.span,
                        "this number has no source",
                        "its source is not in [sources]",
                        help,
                    );
                }
            }
            _ => {}
        }
    }
}
