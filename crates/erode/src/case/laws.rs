//! Materials and formulations of bodies and setups.

use super::{
    error::{Findings, Span},
    node::Fields,
    simulation::{FluidFormulation, SolidFormulation},
    suggest::{closest, did_you_mean},
};
use crate::materials::{Library, Material, Terms};
use erode_physics::{Elastic, eos::Tait, strength::Strength};

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
        strain_rate: fields.switch("strain_rate")?,
        thermal_softening: fields.switch("thermal_softening")?,
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
        let all: Vec<&str> = library.iter().map(|m| m.name.as_str()).collect();
        let mut help = did_you_mean(
            name,
            usable.clone(),
            &format!("materials that can be {role}"),
        );
        if let (None, Some(other)) = (closest(name, usable), closest(name, all.into_iter())) {
            help = format!("did you mean `{other}`? {help}");
        }
        help.push_str(
            "; `erode materials` shows them, a folder `materials` beside the case adds own ones",
        );
        findings.error(
            span,
            format!("there is no material `{name}`"),
            "not in the library",
            help,
        );
        return;
    };
    let list = missing.join(", ");
    let mut reasons: Vec<String> = Vec::new();
    for path in missing {
        if let Some(why) = material.missing.get(path) {
            let last = path.rsplit('.').next().unwrap_or(path);
            reasons.push(format!("{last}: {why}"));
        }
    }
    let mut help = String::new();
    if !reasons.is_empty() {
        help = format!("{}. ", reasons.join("; "));
    }
    let table = missing[0].rsplit_once('.').map_or("", |(table, _)| table);
    let last = missing[0].rsplit('.').next().unwrap_or_default();
    help.push_str(&format!(
        "Give what is missing in the case, as [material.{name}.{table}] {last} = ..."
    ));
    if missing
        .iter()
        .all(|m| m.ends_with(".c") || m.ends_with(".reference_rate"))
    {
        help.push_str(", or switch the rate term off with strain_rate = false");
    }
    let usable: Vec<&str> = usable.collect();
    help.push_str(&format!(". Complete as {role}: {}", usable.join(", ")));
    findings.error(
        span,
        format!("`{name}` cannot be used as {role}: it lacks {list}"),
        "incomplete",
        help,
    );
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
        },
    })
}
