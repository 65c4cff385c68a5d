//! What bodies must satisfy together.

use super::{
    body::{Built, named},
    error::{Findings, Span},
    format::si,
    layers,
    simulation::{BodyKind, Bubble, FluidFormulation, Probe, Side},
    suggest::did_you_mean,
};
use erode_sph::{Geometry, shapes::Shape};

/// Checks names, holes, interfaces and overlaps. With `complete` false some bodies are missing because of errors.
pub(crate) fn check(bodies: &[Built], complete: bool, geometry: Geometry, findings: &mut Findings) {
    for (i, b) in bodies.iter().enumerate() {
        if bodies[..i]
            .iter()
            .any(|other| other.body.name == b.body.name)
        {
            let message = format!("there are two bodies called `{}`", b.body.name);
            findings.error(b.at, message, "used twice", "give each body its own name");
        }
        check_fill(b, geometry, findings);
        check_holes(b, findings);
        layers::check(b, findings);
        if complete {
            check_interfaces(b, bodies, findings);
        }
        for other in &bodies[..i] {
            check_overlap(other, b, findings);
        }
        if let Some(other) = bodies[..i].iter().find(|o| are_of_a_kind(o, b)) {
            check_pair(other, b, findings);
        }
    }
}

fn are_of_a_kind(a: &Built, b: &Built) -> bool {
    matches!(
        (&a.body.kind, &b.body.kind),
        (BodyKind::Fluid(_), BodyKind::Fluid(_)) | (BodyKind::Solid(_), BodyKind::Solid(_))
    )
}

/// The table of interactions has none between bodies of a kind.
fn check_pair(a: &Built, b: &Built, findings: &mut Findings) {
    let kind = match b.body.kind {
        BodyKind::Fluid(_) => "liquids",
        BodyKind::Solid(_) => "solids",
    };
    let message = format!(
        "`{}` and `{}` are both {kind}, which this version does not let act on each other",
        a.body.name, b.body.name
    );
    let help =
        "a case has one liquid, one solid, or one of each; a coating is a layer of its solid";
    findings.error(b.at, message, "one too many", help);
}

/// A body needs room for some particles.
fn check_fill(b: &Built, geometry: Geometry, findings: &mut Findings) {
    let (mut lower, upper) = b.body.shape.bounding_box();
    if geometry == Geometry::Axisymmetric {
        lower[0] = lower[0].max(0.0);
    }
    let smallest = (upper[0] - lower[0]).min(upper[1] - lower[1]);
    let finest = b.body.spacing.finest;
    if finest * 2.0 > smallest {
        let message = format!(
            "the spacing {} does not fit into `{}`, which is {} thin",
            si(finest, "m"),
            b.body.name,
            si(smallest, "m")
        );
        let help = "at least two particles must fit across a body; ten are needed for a result";
        findings.error(b.resolution, message, "too coarse", help);
    }
}

/// Refinement needs a cavity to follow.
pub(crate) fn check_refinement(bodies: &[Built], bubble: bool, findings: &mut Findings) {
    for b in bodies.iter().filter(|_| !bubble) {
        let BodyKind::Fluid(fluid) = &b.body.kind else {
            continue;
        };
        if fluid.refinement().is_some() {
            let message = format!(
                "the refinement of `{}` has no cavity to follow",
                b.body.name
            );
            let help = "say where it is in [bubble], or leave `refinement` out";
            findings.error(b.at, message, "needs a [bubble]", help);
        }
    }
}

fn check_holes(b: &Built, findings: &mut Findings) {
    for (i, (hole, span)) in b.body.holes.iter().zip(&b.holes).enumerate() {
        if area_shared(hole, &b.body.shape) == 0.0 {
            let message = format!("the hole lies outside `{}`", b.body.name);
            findings.error(*span, message, "cuts nothing", extent_help(b));
        }
        for other in &b.body.holes[..i] {
            if area_shared(hole, other) > 0.0 {
                let message = format!("two holes of `{}` overlap", b.body.name);
                findings.error(
                    *span,
                    message,
                    "overlaps an earlier hole",
                    "holes may touch, not overlap",
                );
            }
        }
    }
}

/// Shared area, m2; zero where shapes only touch, up to rounding.
fn area_shared(a: &Shape, b: &Shape) -> f64 {
    let shared = a.overlap_area(b);
    if shared > 1e-9 * a.area().min(b.area()) {
        shared
    } else {
        0.0
    }
}

pub(crate) fn extent_help(b: &Built) -> String {
    let (l, u) = b.body.shape.bounding_box();
    format!(
        "`{}` reaches from ({}, {}) m to ({}, {}) m",
        b.body.name, l[0], l[1], u[0], u[1]
    )
}

fn check_overlap(a: &Built, b: &Built, findings: &mut Findings) {
    let (sa, sb) = (&a.body.shape, &b.body.shape);
    let in_a_hole = a.body.holes.iter().any(|h| encloses(h, sb))
        || b.body.holes.iter().any(|h| encloses(h, sa));
    if in_a_hole || area_shared(sa, sb) == 0.0 {
        return;
    }
    let message = format!("the bodies `{}` and `{}` overlap", a.body.name, b.body.name);
    let help = format!(
        "bodies may touch, not overlap: {}, {}",
        extent_help(a),
        extent_help(b)
    );
    findings.error(b.at, message, "overlaps an earlier body", help);
}

/// Whether `inner` lies in `outer` as a whole.
fn encloses(outer: &Shape, inner: &Shape) -> bool {
    area_shared(outer, inner) >= inner.area() * (1.0 - 1e-9)
}

/// Left, right, bottom, top: the side on the other side of an interface.
const FACING: [usize; 4] = [1, 0, 3, 2];

fn check_interfaces(b: &Built, bodies: &[Built], findings: &mut Findings) {
    for (k, (side_name, side)) in named(&b.body.sides).into_iter().enumerate() {
        let Side::Interface { with } = side else {
            continue;
        };
        let span = b.sides[k];
        let Some(other) = bodies
            .iter()
            .find(|o| o.body.name == *with && o.body.name != b.body.name)
        else {
            let names = bodies
                .iter()
                .map(|o| o.body.name.as_str())
                .filter(|n| *n != b.body.name);
            let message = format!(
                "`{}` has an interface with `{with}`, which is no other body",
                b.body.name
            );
            findings.error(
                span,
                message,
                "no such body",
                did_you_mean(with, names, "other bodies"),
            );
            continue;
        };
        check_interface(b, k, side_name, other, span, findings);
    }
}

fn check_interface(
    b: &Built,
    k: usize,
    side_name: &str,
    other: &Built,
    span: Span,
    findings: &mut Findings,
) {
    let (own, name) = (&b.body.name, &other.body.name);
    let (facing_name, facing) = named(&other.body.sides)[FACING[k]];
    if !matches!(facing, Side::Interface { with } if with == own) {
        let message = format!(
            "the {side_name} side of `{own}` meets `{name}`, but the {facing_name} side of `{name}` does not meet `{own}`"
        );
        let help =
            format!("write [body.sides.{facing_name}.interface] with = \"{own}\" in `{name}`");
        findings.error(span, message, "one-sided interface", help);
    }
    let both = (&b.body.kind, &other.body.kind);
    if !matches!(
        both,
        (BodyKind::Fluid(_), BodyKind::Solid(_)) | (BodyKind::Solid(_), BodyKind::Fluid(_))
    ) {
        let message = format!("`{own}` and `{name}` are of the same kind");
        findings.error(
            span,
            message,
            "cannot be an interface",
            "an interface joins a liquid and a solid",
        );
    }
    let edge = |x: &Built, side: usize| {
        let (l, u) = x.body.shape.bounding_box();
        [l[0], u[0], l[1], u[1]][side]
    };
    let gap = edge(b, k) - edge(other, FACING[k]);
    if gap.abs() > 1e-6 * b.body.spacing.finest {
        let message = format!(
            "there is a gap of {} between `{own}` and `{name}`",
            si(gap.abs(), "m")
        );
        findings.error(
            span,
            message,
            "the sides must coincide",
            format!("{}; {}", extent_help(b), extent_help(other)),
        );
    }
}

/// The body of a name; an error, in the words of who asks for it, when there is none.
pub(crate) fn of_name<'a>(
    name: &str,
    bodies: &'a [Built],
    asker: &str,
    at: Span,
    findings: &mut Findings,
) -> Option<&'a Built> {
    let found = bodies.iter().find(|b| b.body.name == name);
    if found.is_none() {
        let names = bodies.iter().map(|b| b.body.name.as_str());
        findings.error(
            at,
            format!("{asker} asks for a body `{name}` that does not exist"),
            "no such body",
            did_you_mean(name, names, "bodies"),
        );
    }
    found
}

/// A probe needs a body, and must lie in it or on its edge.
pub(crate) fn check_probe(
    probe: &Probe,
    bodies: &[Built],
    body_at: Span,
    position_at: Span,
    findings: &mut Findings,
) {
    let asker = format!("the probe `{}`", probe.name);
    let Some(b) = of_name(&probe.body, bodies, &asker, body_at, findings) else {
        return;
    };
    if b.body.shape.distance(probe.position) > 0.5 * b.body.spacing.finest {
        let message = format!("the probe `{}` lies outside `{}`", probe.name, probe.body);
        findings.error(position_at, message, "outside", extent_help(b));
    }
}

/// The published form of the liquid has no place for gas.
pub(crate) fn check_gas(bubble: &Bubble, bodies: &[Built], at: Span, findings: &mut Findings) {
    let published = bodies.iter().any(|b| {
        matches!(&b.body.kind, BodyKind::Fluid(f) if matches!(f.formulation, FluidFormulation::Joshi { .. }))
    });
    if bubble.gas.is_some() && published {
        let help = "leave `gas` out for an empty bubble, or the formulation for the usual one";
        let message = "the published form of the liquid has no gas in its bubble";
        findings.error(at, message, "not with this form", help);
    }
}

/// The bubble must be in a liquid.
pub(crate) fn check_bubble(bubble: &Bubble, bodies: &[Built], at: Span, findings: &mut Findings) {
    let disc = Shape::Disc {
        centre: bubble.centre,
        radius: bubble.radius,
    };
    let liquids: Vec<&Built> = bodies
        .iter()
        .filter(|b| matches!(b.body.kind, BodyKind::Fluid(_)))
        .collect();
    if !liquids
        .iter()
        .any(|b| area_shared(&disc, &b.body.shape) > 0.0)
    {
        let help = liquids
            .first()
            .map_or_else(|| "there is no liquid".to_owned(), |b| extent_help(b));
        findings.error(
            at,
            "the bubble lies outside the liquid",
            "no liquid here",
            help,
        );
    }
}
