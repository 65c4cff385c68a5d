//! `layers` of a solid: coatings.

use super::{
    body::Built,
    error::{Findings, Span},
    format::si,
    laws,
    node::Fields,
    simulation::{Body, BodyKind, Layer, SolidFormulation},
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
            "the layers of `{name}` are {} thick together, the body is {} high",
            si(all, "m"),
            si(height, "m")
        );
        let help = "what is left below the layers is of the body's own material; make them thinner or the body higher";
        findings.error(at, message, "beyond the body", help);
    }
    for (k, layer) in solid.layers.iter().enumerate() {
        let [finest, _] = spacings(&b.body, &solid.layers, k);
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

/// Smallest and largest spacing of the particles along the middle of layer `k`, m.
pub(crate) fn spacings(body: &Body, layers: &[Layer], k: usize) -> [f64; 2] {
    let (lower, upper) = body.shape.bounding_box();
    let above: f64 = layers[..k].iter().map(|l| l.thickness).sum();
    let height = upper[1] - above - 0.5 * layers[k].thickness;
    let core = body.spacing.core.as_ref().map(|c| c.bounding_box());
    let middle = core.map_or(lower[0], |(l, u)| 0.5 * (l[0] + u[0]));
    let at = |r: f64| body.spacing.at([r, height]);
    let ends = at(lower[0]).max(at(upper[0]));
    [at(middle.clamp(lower[0], upper[0])), ends]
}

fn too_thin(at: Span, k: usize, layer: &Layer, finest: f64, findings: &mut Findings) {
    let message = format!(
        "layer {} ({}) is {} thick, less than the particle spacing of {} at its depth",
        k + 1,
        layer.material,
        si(layer.thickness, "m"),
        si(finest, "m")
    );
    let help = format!(
        "a layer needs one row of particles at least, four or more to be resolved: a spacing of {} or less",
        si(layer.thickness / 4.0, "m")
    );
    findings.error(at, message, "too thin", help);
}
