//! The material library: data files with a unit and a source for each number.
//!
//! A property is named by its path in the file, for example `solid.elastic.young_modulus`. A material may lack some;
//! what a law needs and does not find is named, never guessed.

mod laws;
mod library;

pub use library::Library;

use crate::case::node::{Data, Fields};
use erode_physics::{Elastic, damage::Damage, eos::Tait, strength::Strength};
use laws::Need;
use std::collections::BTreeMap;

/// One number of a material.
#[derive(Debug, Clone, PartialEq)]
pub struct Property {
    /// Value in SI.
    pub value: f64,
    /// SI unit, `1` for plain numbers.
    pub unit: String,
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
    pub(super) fn overlay_material(&mut self, fields: Fields<'_>) {
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
                Data::Property {
                    value,
                    dimension,
                    source,
                } => {
                    let full = |s: &String| {
                        sources
                            .and_then(|t| t.text(s))
                            .map_or_else(|| s.clone(), str::to_owned)
                    };
                    self.properties.insert(
                        inner,
                        Property {
                            value: *value,
                            unit: dimension.to_string(),
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

    /// Damage law of that name: `rupture_strain`, `linear_modulus_loss` or `johnson_cook`.
    ///
    /// # Errors
    /// The paths of the properties that are missing.
    pub fn damage(&self, law: &str) -> Result<Damage, Vec<String>> {
        let mut need = Need::new(self);
        let damage = need.damage(law);
        need.finish(damage)
    }

    /// Whether the material can be used as a liquid.
    #[must_use]
    pub fn is_fluid(&self) -> bool {
        self.fluid().is_ok()
    }

    /// Speed of a plane sound wave: of the liquid at zero pressure, or longitudinal in the solid, m/s.
    #[must_use]
    pub fn sound_speed(&self) -> Option<f64> {
        let get = |path: &str| self.properties.get(path).map(|p| p.value);
        if let Some(c) = get("fluid.tait.sound_speed") {
            return Some(c);
        }
        let elastic = Elastic {
            young_modulus: get("solid.elastic.young_modulus")?,
            poisson_ratio: get("solid.elastic.poisson_ratio")?,
        };
        Some(elastic.longitudinal_speed(get("solid.density")?))
    }

    /// Whether the material can be used as a solid without the strain-rate term.
    #[must_use]
    pub fn is_solid_without_rate(&self) -> bool {
        self.solid(Terms {
            strain_rate: false,
            thermal_softening: false,
        })
        .is_ok()
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

#[cfg(test)]
mod tests;
