//! The material library: data files with a unit and a source for each number.
//!
//! A property is named by its path in the file, for example `solid.elastic.young_modulus`. A material may lack some;
//! what a law needs and does not find is named, never guessed.

use crate::case::{
    check::check_table,
    error::{CaseError, CaseErrors, Findings, Span},
    keys_material::MATERIAL,
    node::{Data, Fields, Node},
    raw::parse,
};
use erode_physics::{
    Elastic,
    eos::Tait,
    strength::{JohnsonCook, Strength, Thermal},
};
use std::{collections::BTreeMap, path::Path};

/// Files compiled into the program: (name, text).
const EMBEDDED: &[(&str, &str)] = &[
    (
        "aluminium_6061_t6",
        include_str!("../../../materials/aluminium_6061_t6.toml"),
    ),
    (
        "aluminium_cao2022",
        include_str!("../../../materials/aluminium_cao2022.toml"),
    ),
    (
        "copper_annealed",
        include_str!("../../../materials/copper_annealed.toml"),
    ),
    (
        "steel_1045",
        include_str!("../../../materials/steel_1045.toml"),
    ),
    (
        "steel_316l",
        include_str!("../../../materials/steel_316l.toml"),
    ),
    (
        "steel_a2205",
        include_str!("../../../materials/steel_a2205.toml"),
    ),
    (
        "titanium_6al4v",
        include_str!("../../../materials/titanium_6al4v.toml"),
    ),
    ("water", include_str!("../../../materials/water.toml")),
];

/// One number of a material.
#[derive(Debug, Clone, PartialEq)]
pub struct Property {
    /// Value in SI.
    pub value: f64,
    /// Where it comes from, in full; none for values given in a case.
    pub source: Option<String>,
}

/// A material: what is known about it.
#[derive(Debug, Clone, PartialEq)]
pub struct Material {
    /// Name used in cases.
    pub name: String,
    /// What it is.
    pub title: String,
    /// What a user should know.
    pub notes: String,
    /// Known numbers by path.
    pub properties: BTreeMap<String, Property>,
    /// What the sources do not give, by path, and why.
    pub missing: BTreeMap<String, String>,
    /// The yield law the numbers belong to, for example `johnson_cook`.
    pub law: Option<String>,
}

/// Which terms of the yield law are used.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Terms {
    /// Growth with the strain rate.
    pub strain_rate: bool,
    /// Softening by plastic heating.
    pub thermal_softening: bool,
}

impl Material {
    /// A material about which nothing is known yet.
    pub(crate) fn empty(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            title: String::new(),
            notes: String::new(),
            properties: BTreeMap::new(),
            missing: BTreeMap::new(),
            law: None,
        }
    }

    /// Adds what a checked `[material]` table says; it wins over what is known.
    fn overlay_material(&mut self, fields: Fields<'_>) {
        for (key, text) in [("title", &mut self.title), ("notes", &mut self.notes)] {
            if let Some(s) = fields.text(key) {
                s.clone_into(text);
            }
        }
        for (path, node) in fields.table("missing").map_or(&[][..], |t| t.entries) {
            if let Data::Text(why) = &node.data {
                self.missing.insert(path.clone(), why.clone());
            }
        }
        let sources = fields.table("sources");
        for part in ["fluid", "solid"] {
            if let Some(t) = fields.table(part) {
                self.overlay(part, t, sources);
            }
        }
    }

    /// Adds the properties of a checked table that stands at `path`.
    pub(crate) fn overlay(&mut self, path: &str, fields: Fields<'_>, sources: Option<Fields<'_>>) {
        if path == "solid"
            && let Some((law, _)) = fields.chosen("strength")
        {
            if self.law.as_deref().is_some_and(|old| old != law) {
                self.properties
                    .retain(|p, _| !p.starts_with("solid.strength."));
            }
            self.law = Some(law.to_owned());
        }
        for (key, node) in fields.entries {
            let inner = format!("{path}.{key}");
            match &node.data {
                Data::Property(value, source) => {
                    let full = |s: &String| {
                        sources
                            .and_then(|t| t.text(s))
                            .map_or_else(|| s.clone(), str::to_owned)
                    };
                    self.properties.insert(
                        inner,
                        Property {
                            value: *value,
                            source: source.as_ref().map(full),
                        },
                    );
                }
                // Formulations are no properties of the material.
                Data::Table(entries) if key != "formulation" => {
                    self.overlay(
                        &inner,
                        Fields {
                            span: node.span,
                            entries,
                        },
                        sources,
                    );
                }
                _ => {}
            }
        }
    }

    /// Equation of state of the liquid.
    ///
    /// # Errors
    /// The paths of the properties that are missing.
    pub fn fluid(&self) -> Result<Tait, Vec<String>> {
        let mut need = Need::new(self);
        let eos = Tait {
            reference_density: need.get("fluid.tait.reference_density"),
            sound_speed: need.get("fluid.tait.sound_speed"),
            gamma: need.get("fluid.tait.gamma"),
        };
        need.finish(eos)
    }

    /// Density, elasticity and yield law of the solid.
    ///
    /// # Errors
    /// The paths of the properties that are missing.
    pub fn solid(&self, terms: Terms) -> Result<(f64, Elastic, Strength), Vec<String>> {
        let mut need = Need::new(self);
        let density = need.get("solid.density");
        let elastic = Elastic {
            young_modulus: need.get("solid.elastic.young_modulus"),
            poisson_ratio: need.get("solid.elastic.poisson_ratio"),
        };
        let strength = need.strength(terms);
        need.finish((density, elastic, strength))
    }

    /// Whether the material can be used as a liquid.
    #[must_use]
    pub fn is_fluid(&self) -> bool {
        self.fluid().is_ok()
    }

    /// Whether the material can be used as a solid, with the strain-rate term where its law has one.
    #[must_use]
    pub fn is_solid(&self) -> bool {
        self.solid(Terms {
            strain_rate: true,
            thermal_softening: false,
        })
        .is_ok()
    }
}

/// Collects what is missing while laws are filled in.
struct Need<'a> {
    material: &'a Material,
    missing: Vec<String>,
}

impl<'a> Need<'a> {
    fn new(material: &'a Material) -> Self {
        Self {
            material,
            missing: Vec::new(),
        }
    }

    fn get(&mut self, path: &str) -> f64 {
        if let Some(p) = self.material.properties.get(path) {
            return p.value;
        }
        self.missing.push(path.to_owned());
        f64::NAN
    }

    fn finish<T>(self, value: T) -> Result<T, Vec<String>> {
        if self.missing.is_empty() {
            Ok(value)
        } else {
            Err(self.missing)
        }
    }

    fn strength(&mut self, terms: Terms) -> Strength {
        match self.material.law.as_deref() {
            Some("elastic") => Strength::Elastic,
            Some("perfectly_plastic") => Strength::PerfectlyPlastic {
                yield_stress: self.get("solid.strength.perfectly_plastic.yield_stress"),
            },
            Some("linear_hardening") => Strength::LinearHardening {
                yield_stress: self.get("solid.strength.linear_hardening.yield_stress"),
                hardening_modulus: self.get("solid.strength.linear_hardening.hardening_modulus"),
            },
            Some(_) => Strength::JohnsonCook(self.johnson_cook(terms)),
            None => {
                self.missing.push("solid.strength".to_owned());
                Strength::Elastic
            }
        }
    }

    fn johnson_cook(&mut self, terms: Terms) -> JohnsonCook {
        let path = |key: &str| format!("solid.strength.johnson_cook.{key}");
        let (c, reference_rate) = if terms.strain_rate {
            (self.get(&path("c")), self.get(&path("reference_rate")))
        } else {
            let known = self.material.properties.get(&path("reference_rate"));
            (0.0, known.map_or(1.0, |p| p.value))
        };
        let thermal = terms.thermal_softening.then(|| Thermal {
            m: self.get(&path("m")),
            reference_temperature: self.get(&path("reference_temperature")),
            melting_temperature: self.get(&path("melting_temperature")),
            heat_capacity: self.get(&path("heat_capacity")),
            taylor_quinney: self.get(&path("taylor_quinney")),
        });
        JohnsonCook {
            a: self.get(&path("a")),
            b: self.get(&path("b")),
            n: self.get(&path("n")),
            c,
            reference_rate,
            thermal,
        }
    }
}

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
            let text = crate::case::load::read_text(&file)?;
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
            Data::Property(_, source) => {
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

#[cfg(test)]
mod tests;
