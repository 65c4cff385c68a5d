//! Filling the constants of laws from a material, noting what is missing.

use super::{Material, Terms};
use erode_physics::damage::{Damage, JohnsonCookDamage, RuptureStrain};
use erode_physics::strength::{JohnsonCook, Strength, Thermal};

/// Collects what is missing while laws are filled in.
pub(super) struct Need<'a> {
    material: &'a Material,
    missing: Vec<String>,
}

impl<'a> Need<'a> {
    pub(super) fn new(material: &'a Material) -> Self {
        Self {
            material,
            missing: Vec::new(),
        }
    }

    pub(super) fn get(&mut self, path: &str) -> f64 {
        if let Some(p) = self.material.properties.get(path) {
            return p.value;
        }
        self.missing.push(path.to_owned());
        f64::NAN
    }

    pub(super) fn finish<T>(self, value: T) -> Result<T, Vec<String>> {
        if self.missing.is_empty() {
            Ok(value)
        } else {
            Err(self.missing)
        }
    }

    pub(super) fn strength(&mut self, terms: Terms) -> Strength {
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
        let [a, b, n] = ["a", "b", "n"].map(|key| self.get(&path(key)));
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
            a,
            b,
            n,
            c,
            reference_rate,
            thermal,
        }
    }

    pub(super) fn damage(&mut self, law: &str) -> Damage {
        match law {
            "rupture_strain" | "linear_modulus_loss" => Damage::RuptureStrain(RuptureStrain {
                rupture_strain: self.rupture_strain(law),
                modulus_loss: law == "linear_modulus_loss",
            }),
            _ => Damage::JohnsonCook(self.johnson_cook_damage()),
        }
    }

    /// The same number serves both laws, unless the one asked for has its own.
    fn rupture_strain(&mut self, law: &str) -> f64 {
        let own = format!("solid.damage.{law}.rupture_strain");
        if self.material.properties.contains_key(&own) {
            return self.get(&own);
        }
        self.get("solid.damage.rupture_strain.rupture_strain")
    }

    /// Rate and temperatures are needed where their coefficients are not zero.
    fn johnson_cook_damage(&mut self) -> JohnsonCookDamage {
        let path = |key: &str| format!("solid.damage.johnson_cook.{key}");
        let [d1, d2, d3, d4, d5] = ["d1", "d2", "d3", "d4", "d5"].map(|key| self.get(&path(key)));
        let reference_rate = if d4 == 0.0 {
            1.0
        } else {
            self.get(&path("reference_rate"))
        };
        let temperatures = (d5 != 0.0).then(|| {
            ["reference_temperature", "melting_temperature"]
                .map(|key| self.get(&format!("solid.strength.johnson_cook.{key}")))
        });
        JohnsonCookDamage {
            d1,
            d2,
            d3,
            d4,
            d5,
            reference_rate,
            temperatures,
        }
    }
}
