//! Materials and formulations of bodies and setups.

use super::{
    error::{Findings, Span},
    node::Fields,
    simulation::{FluidFormulation, Refinement, SolidFormulation},
    suggest::{closest, did_you_mean},
};
use crate::materials::{Library, Material, Terms};
use erode_physics::{Elastic, damage::Damage, eos::Tait, strength::Strength};

/// Equation of state of the liquid named under `key`; `own` are constants given on the spot.
pub(crate) fn fluid(
    fields: Fields<'_>,
    key: &str,
    own: Option<Fields<'_>>,
    library: &Library,
    findings: &mut Findings,
) -> Option<Tait> {
    let name = fields.text(key)?;
    let material = with_own(name, "fluid", own, library);
    match material.fluid() {
        Ok(eos) => Some(eos),
        Err(missing) => {
            let usable = library
                .iter()
                .filter(|m| m.is_fluid())
                .map(|m| m.name.as_str());
            report(
                fields.at(key),
                name,
                "a liquid",
                &missing,
                usable,
                library,
                findings,
            );
            None
        }
    }
}

/// Density, elasticity and yield law of the solid named under `key`; `own` are constants given on the spot.
pub(crate) fn solid(
    fields: Fields<'_>,
    key: &str,
    own: Option<Fields<'_>>,
    library: &Library,
    findings: &mut Findings,
) -> Option<(f64, Elastic, Strength)> {
    let terms = Terms {
        strain_rate: fields.switch("strain_rate").unwrap_or(true),
        thermal_softening: fields.switch("thermal_softening").unwrap_or(false),
    };
    let name = fields.text(key)?;
    let material = with_own(name, "solid", own, library);
    match material.solid(terms) {
        Ok(laws) => Some(laws),
        Err(missing) => {
            let usable = library
                .iter()
                .filter(|m| m.solid(terms).is_ok())
                .map(|m| m.name.as_str());
            report(
                fields.at(key),
                name,
                "a solid",
                &missing,
                usable,
                library,
                findings,
            );
            None
        }
    }
}

/// Damage law of the solid named under `key`, where the case asks for one.
pub(crate) fn damage(
    fields: Fields<'_>,
    key: &str,
    library: &Library,
    findings: &mut Findings,
) -> Option<Damage> {
    let Some((law, _)) = fields.chosen("damage") else {
        return Some(Damage::None);
    };
    let name = fields.text(key)?;
    let material = with_own(name, "solid", Some(fields), library);
    match material.damage(law) {
        Ok(damage) => Some(damage),
        Err(missing) => {
            let usable = library
                .iter()
                .filter(|m| m.damage(law).is_ok())
                .map(|m| m.name.as_str());
            let role = format!("a solid that fails by {law}");
            let at = fields.at("damage");
            report(at, name, &role, &missing, usable, library, findings);
            None
        }
    }
}

fn with_own(name: &str, part: &str, own: Option<Fields<'_>>, library: &Library) -> Material {
    let mut material = library
        .get(name)
        .cloned()
        .unwrap_or_else(|| Material::empty(name));
    if let Some(own) = own {
        material.overlay(part, own, None);
    }
    material
}

fn report<'a>(
    span: Span,
    name: &str,
    role: &str,
    missing: &[String],
    usable: impl Iterator<Item = &'a str> + Clone,
    library: &Library,
    findings: &mut Findings,
) {
    let Some(material) = library.get(name) else {
        let help = unknown_help(name, role, usable, library);
        findings.error(
            span,
            format!("there is no material `{name}`"),
            "not in the library",
            help,
        );
        return;
    };
    let mut help = reasons(material, missing);
    let (table, last) = missing[0]
        .rsplit_once('.')
        .unwrap_or(("solid", &missing[0]));
    help.push_str(&format!(
        "Give what is missing in the case: [material.{name}.{table}] {last} = ..."
    ));
    if missing
        .iter()
        .all(|m| m.ends_with(".c") || m.ends_with(".reference_rate"))
    {
        help.push_str(", or switch the rate term off with strain_rate = false");
    }
    let usable: Vec<&str> = usable.collect();
    help.push_str(&format!(". Complete as {role}: {}", usable.join(", ")));
    let message = format!(
        "`{name}` cannot be used as {role}: it lacks {}",
        missing.join(", ")
    );
    findings.error(span, message, "incomplete", help);
}

fn unknown_help<'a>(
    name: &str,
    role: &str,
    usable: impl Iterator<Item = &'a str> + Clone,
    library: &Library,
) -> String {
    let list = did_you_mean(
        name,
        usable.clone(),
        &format!("materials that can be {role}"),
    );
    // A misspelt name may also belong to a material that cannot be used here.
    let other = closest(name, library.iter().map(|m| m.name.as_str()));
    let other = other.filter(|_| closest(name, usable).is_none());
    let other = other.map_or_else(String::new, |o| format!("did you mean `{o}`? "));
    format!(
        "{other}{list}; `erode materials` shows them, a folder `materials` beside the case adds own ones"
    )
}

/// What the sources say about missing properties: "b, n: no hardening in the source. "
fn reasons(material: &Material, missing: &[String]) -> String {
    let mut grouped: Vec<(&str, Vec<&str>)> = Vec::new();
    for path in missing {
        let Some(why) = material.missing.get(path) else {
            continue;
        };
        let last = path.rsplit('.').next().unwrap_or(path);
        match grouped.iter_mut().find(|(w, _)| w == why) {
            Some((_, names)) => names.push(last),
            None => grouped.push((why, vec![last])),
        }
    }
    grouped
        .iter()
        .map(|(why, names)| format!("{}: {why}. ", names.join(", ")))
        .collect()
}

/// Discrete form of a liquid under `key`.
pub(crate) fn fluid_formulation(fields: Fields<'_>, key: &str) -> Option<FluidFormulation> {
    let (name, f) = fields.chosen(key)?;
    Some(match name {
        "joshi" => FluidFormulation::Joshi {
            alpha: f.number("alpha")?,
            beta: f.number("beta")?,
        },
        _ => FluidFormulation::Corrected {
            shifting: f.number("shifting")?,
            refinement: match f.table("refinement") {
                Some(r) => Some(Refinement {
                    per_radius: r.number("per_radius")?,
                    growth: r.number("growth")?,
                    smallest: r.number("smallest")?,
                }),
                None => None,
            },
        },
    })
}

/// Discrete form of a solid under `key`.
pub(crate) fn solid_formulation(fields: Fields<'_>, key: &str) -> Option<SolidFormulation> {
    let (name, f) = fields.chosen(key)?;
    Some(match name {
        "joshi" => SolidFormulation::Joshi {
            alpha: f.number("alpha")?,
            beta: f.number("beta")?,
            xsph: f.number("xsph")?,
        },
        _ => SolidFormulation::TotalLagrangian {
            viscosity: f.number("viscosity")?,
            hourglass: f.number("hourglass")?,
            renewal: f.number("renewal"),
        },
    })
}
