//! `[[body]]`: a region with its material, spacing and sides.

use super::{
    error::{Findings, Span},
    laws, layers,
    node::{Fields, Node},
    simulation::{Body, BodyKind, Fluid, Side, Sides, Solid, Wave},
};
use crate::materials::Library;
use erode_sph::{Geometry, packing::Spacing, shapes::Shape};

/// A body and the places in the text that its later errors point to.
#[derive(Clone)]
pub(crate) struct Built {
    pub(crate) body: Body,
    /// Name or setup.
    pub(crate) at: Span,
    /// What sets the number of particles.
    pub(crate) resolution: Span,
    /// Left, right, bottom, top.
    pub(crate) sides: [Span; 4],
    /// The layers of a solid.
    pub(crate) layers: Span,
    /// Each hole.
    pub(crate) holes: Vec<Span>,
}

impl Built {
    /// A body that a setup stands for.
    pub(crate) fn of_setup(body: Body, setup: Span, resolution: Span) -> Self {
        let holes = vec![setup; body.holes.len()];
        Self {
            body,
            at: setup,
            resolution,
            sides: [setup; 4],
            layers: setup,
            holes,
        }
    }
}

/// Reads one `[[body]]`.
pub(crate) fn read(
    node: &Node,
    geometry: Geometry,
    library: &Library,
    findings: &mut Findings,
) -> Option<Built> {
    let f = node.fields()?;
    // Each part records its errors before the first missing one ends the body.
    let kind = kind(f, library, findings);
    let region = f.table("shape").and_then(|s| shape(s, geometry, findings));
    let holes: Vec<Option<(Shape, Span)>> = f
        .list("hole")
        .iter()
        .map(|hole| Some((shape(hole.fields()?, geometry, findings)?, hole.span)))
        .collect();
    let spacing = f
        .table("spacing")
        .and_then(|s| spacing(s, geometry, findings));
    let (region, kind) = (region?, kind?);
    let sides = sides(f, &region, &kind, geometry, findings);
    let at = f.at("name");
    let side_spans =
        ["left", "right", "bottom", "top"].map(|s| f.table("sides").map_or(at, |t| t.at(s)));
    let holes: Vec<(Shape, Span)> = holes.into_iter().collect::<Option<_>>()?;
    let (holes, hole_spans) = holes.into_iter().unzip();
    let body = Body {
        name: f.text("name")?.to_owned(),
        kind,
        shape: region,
        holes,
        spacing: spacing?,
        sides: sides?,
    };
    let resolution = f.table("spacing")?.at("finest");
    Some(Built {
        body,
        at,
        resolution,
        sides: side_spans,
        layers: f.table("solid").map_or(at, |s| s.at("layers")),
        holes: hole_spans,
    })
}

fn kind(f: Fields<'_>, library: &Library, findings: &mut Findings) -> Option<BodyKind> {
    if let Some(fluid) = f.table("fluid") {
        let eos = laws::fluid(fluid, "material", Some(fluid), library, findings)?;
        return Some(BodyKind::Fluid(Fluid {
            material: fluid.text("material")?.to_owned(),
            eos,
            formulation: laws::fluid_formulation(fluid, "formulation")?,
            pressure: fluid.number("pressure")?,
            velocity: fluid.pair("velocity")?,
        }));
    }
    let solid = f.table("solid")?;
    let layers = layers::read(solid, "layers", library, findings);
    let (density, elastic, strength) =
        laws::solid(solid, "material", Some(solid), library, findings)?;
    Some(BodyKind::Solid(Solid {
        material: solid.text("material")?.to_owned(),
        layers: layers?,
        density,
        elastic,
        strength,
        damage: laws::damage(solid, "material", library, findings)?,
        formulation: laws::solid_formulation(solid, "formulation")?,
        velocity: solid.pair("velocity")?,
    }))
}

fn shape(f: Fields<'_>, geometry: Geometry, findings: &mut Findings) -> Option<Shape> {
    let (name, s) = f.choice()?;
    let (shape, at) = if name == "rectangle" {
        let (lower, upper) = (s.pair("lower")?, s.pair("upper")?);
        if !(lower[0] < upper[0] && lower[1] < upper[1]) {
            let help = "`lower` holds the smaller of both coordinates, `upper` the larger";
            findings.error(
                s.at("upper"),
                "the rectangle has no area",
                "must exceed `lower` in both",
                help,
            );
            return None;
        }
        (Shape::Rectangle { lower, upper }, s.at("lower"))
    } else {
        (
            Shape::Disc {
                centre: s.pair("centre")?,
                radius: s.number("radius")?,
            },
            s.at("centre"),
        )
    };
    let left = shape.bounding_box().0[0];
    let on_axis = matches!(shape, Shape::Disc { centre, .. } if centre[0] == 0.0);
    if geometry == Geometry::Axisymmetric && left < 0.0 && !on_axis {
        let help = "in axisymmetry the first coordinate is a radius; for plane strain write [geometry.plane]";
        findings.error(
            at,
            format!("the shape reaches to r = {left} m, beyond the axis"),
            "crosses r = 0",
            help,
        );
        return None;
    }
    Some(shape)
}

fn spacing(f: Fields<'_>, geometry: Geometry, findings: &mut Findings) -> Option<Spacing> {
    let core = match f.table("core") {
        Some(c) => Some(shape(c, geometry, findings)?),
        None => None,
    };
    let finest = f.number("finest")?;
    let coarsest = if f.node("coarsest").is_some() {
        f.number("coarsest")?
    } else {
        finest
    };
    if coarsest < finest {
        let help = "leave `coarsest` out for the same spacing everywhere";
        findings.error(
            f.at("coarsest"),
            "`coarsest` is smaller than `finest`",
            "must be at least `finest`",
            help,
        );
        return None;
    }
    Some(Spacing {
        finest,
        coarsest,
        growth: f.number("growth")?,
        core,
    })
}

fn sides(
    f: Fields<'_>,
    shape: &Shape,
    kind: &BodyKind,
    geometry: Geometry,
    findings: &mut Findings,
) -> Option<Sides> {
    let at_axis = geometry == Geometry::Axisymmetric && shape.bounding_box().0[0] <= 0.0;
    let default_left = if at_axis { Side::Axis } else { Side::Free };
    let Some(sides) = f.table("sides") else {
        return Some(Sides {
            left: default_left,
            ..Sides::default()
        });
    };
    let result = Sides {
        left: if sides.node("left").is_some() {
            side(sides, "left", kind)?
        } else {
            default_left
        },
        right: side(sides, "right", kind)?,
        bottom: side(sides, "bottom", kind)?,
        top: side(sides, "top", kind)?,
    };
    check_axis(sides, &result, at_axis, findings);
    check_clamped(sides, &result, kind, findings);
    if matches!(shape, Shape::Disc { .. }) {
        for (name, side) in named(&result) {
            if !matches!(side, Side::Free | Side::Axis) {
                let help = "leave the sides of a disc out, or use a rectangle";
                findings.error(
                    sides.at(name),
                    "a disc has no sides",
                    "only a rectangle has a side here",
                    help,
                );
            }
        }
    }
    Some(result)
}

fn check_axis(sides: Fields<'_>, result: &Sides, at_axis: bool, findings: &mut Findings) {
    for (name, side) in named(result) {
        let should_be_axis = at_axis && name == "left";
        if *side == Side::Axis && !should_be_axis {
            let help = "the axis is the left side of a body at r = 0 in axisymmetry; a plane of symmetry elsewhere is `rigid`";
            findings.error(
                sides.at(name),
                format!("the {name} side is not the axis"),
                "cannot be `axis`",
                help,
            );
        } else if *side != Side::Axis && should_be_axis {
            let help = "write left.axis = {}, or leave `left` out";
            findings.error(
                sides.at(name),
                "the left side lies at r = 0 and must be the axis",
                "must be `axis`",
                help,
            );
        }
    }
}

/// Only a solid can be bonded to a wall.
fn check_clamped(sides: Fields<'_>, result: &Sides, kind: &BodyKind, findings: &mut Findings) {
    for (name, side) in named(result) {
        if *side == Side::Clamped && matches!(kind, BodyKind::Fluid(_)) {
            let help = format!("write {name}.rigid = {{}}: a wall that the liquid slides along");
            findings.error(
                sides.at(name),
                "a liquid cannot be clamped",
                "only for solids",
                help,
            );
        }
    }
}

/// The sides with their names.
pub(crate) fn named(sides: &Sides) -> [(&'static str, &Side); 4] {
    [
        ("left", &sides.left),
        ("right", &sides.right),
        ("bottom", &sides.bottom),
        ("top", &sides.top),
    ]
}

fn side(sides: Fields<'_>, key: &str, kind: &BodyKind) -> Option<Side> {
    let (name, f) = sides.chosen(key)?;
    Some(match name {
        "axis" => Side::Axis,
        "rigid" => Side::Rigid,
        "clamped" => Side::Clamped,
        "interface" => Side::Interface {
            with: f.text("with")?.to_owned(),
        },
        "non_reflecting" => {
            let at_rest = match kind {
                BodyKind::Fluid(fluid) => fluid.pressure,
                BodyKind::Solid(_) => 0.0,
            };
            let pressure = if f.node("pressure").is_some() {
                f.number("pressure")?
            } else {
                at_rest
            };
            let wave = match f.table("wave") {
                Some(w) => Some(Wave {
                    pressure: w.number("pressure")?,
                    start: w.number("start")?,
                }),
                None => None,
            };
            Side::NonReflecting { pressure, wave }
        }
        _ => Side::Free,
    })
}
