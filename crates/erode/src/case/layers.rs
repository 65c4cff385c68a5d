//! `layers` of a solid: coatings.

use super::{
    body::Built,
    error::{Findings, Span},
    laws,
    node::Fields,
    simulation::{BodyKind, Layer, SolidFormulation},
};
use crate::materials::Library;

/// The layers under `key`; nothing when one of them is wrong.
pub(crate) fn read(
    fields: Fields<'_>,
    key: &str,
    library: &Library,
    findings: &mut Findings,
) -> Option<Vec<Layer>> {
    let layers: Vec<Option<Layer>> = fields
        .list(key)
        .iter()
        .map(|node| layer(node.fields()?, library, findings))
        .collect();
    layers.into_iter().collect()
}

fn layer(f: Fields<'_>, library: &Library, findings: &mut Findings) -> Option<Layer> {
    let laws = laws::solid(f, "material", Some(f), library, findings);
    let damage = laws::damage(f, "material", library, findings);
    let (density, elastic, strength) = laws?;
    Some(Layer {
        thickness: f.number("thickness")?,
        material: f.text("material")?.to_owned(),
        density,
        elastic,
        strength,
        damage: damage?,
    })
}

/// Layers must be thicker than the particles and leave room for the body below them.
pub(crate) fn check(b: &Built, findings: &mut Findings) {
    let BodyKind::Solid(solid) = &b.body.kind else {
        return;
    };
    if solid.layers.is_empty() {
        return;
    }
    let at = b.layers;
    let name = &b.body.name;
    let (lower, upper) = b.body.shape.bounding_box();
    let height = upper[1] - lower[1];
    let all: f64 = solid.layers.iter().map(|l| l.thickness).sum();
    if all >= height {
        let message = format!(
            "the layers of `{name}` are {all} m thick together, the body is {height} m high"
        );
        let help = "what is left below the layers is of the body's own material; make them thinner or the body higher";
        findings.error(at, message, "beyond the body", help);
    }
    let finest = b.body.spacing.finest;
    for (k, layer) in solid.layers.iter().enumerate() {
        if layer.thickness * (1.0 + 1e-9) < finest {
            too_thin(at, k, layer, finest, findings);
        }
    }
    if let SolidFormulation::Joshi { .. } = solid.formulation {
        let help = "leave `formulation` out, or write formulation.total_lagrangian = {}";
        let message = "the published form of the solid has one material and no layers";
        findings.error(at, message, "not with this form", help);
    }
}

fn too_thin(at: Span, k: usize, layer: &Layer, finest: f64, findings: &mut Findings) {
    let message = format!(
        "layer {} ({}) is {} m thick, less than the particle spacing of {finest} m",
        k + 1,
        layer.material,
        layer.thickness
    );
    let help = format!(
        "a layer needs one row of particles at least, four or more to be resolved: a spacing of {:.3e} m or less",
        layer.thickness / 4.0
    );
    findings.error(at, message, "too thin", help);
}
