//! Setups of a solid alone: what is pressed or hit, and by what.

use super::{
    body::Built,
    error::Findings,
    laws, layers,
    loads::{Indenter, Loads, Pressure, Ramp, Settling},
    node::Fields,
    setups::{Expansion, GROWTH, symmetry},
    simulation::{Body, BodyKind, Side, Sides, Solid},
};
use crate::materials::Library;
use erode_physics::load::{GaussianPressure, GaussianPulse};
use erode_sph::{Geometry, packing::Spacing, shapes::Shape};

/// Transits of a longitudinal wave through the height in which a load rises slowly enough.
const TRANSITS: f64 = 8.0;
/// Mass damping after a slow load, 1/s.
const DAMPING: f64 = 5e6;
/// Name of the body.
const BLOCK: &str = "block";

fn solid(f: Fields<'_>, library: &Library, findings: &mut Findings) -> Option<Solid> {
    let layers = layers::read(f, "layers", library, findings);
    let (density, elastic, strength) = laws::solid(f, "material", None, library, findings)?;
    Some(Solid {
        material: f.text("material")?.to_owned(),
        layers: layers?,
        density,
        elastic,
        strength,
        damage: laws::damage(f, "material", library, findings)?,
        formulation: laws::solid_formulation(f, "formulation")?,
        velocity: [0.0; 2],
    })
}

/// A block below z = 0 that is finest within `core` of its top centre.
fn block(kind: Solid, size: [f64; 2], spacing: [f64; 2], core: [f64; 2], sides: Sides) -> Body {
    Body {
        name: BLOCK.to_owned(),
        kind: BodyKind::Solid(kind),
        shape: Shape::Rectangle {
            lower: [0.0, -size[1]],
            upper: [size[0], 0.0],
        },
        holes: Vec::new(),
        spacing: Spacing {
            finest: spacing[0],
            coarsest: spacing[1],
            growth: GROWTH,
            core: Some(Shape::Rectangle {
                lower: [0.0, -core[1].min(size[1])],
                upper: [core[0].min(size[0]), 0.0],
            }),
        },
        sides,
    }
}

/// `[setup.indentation]`.
pub(super) fn indentation(
    f: Fields<'_>,
    geometry: Geometry,
    library: &Library,
    findings: &mut Findings,
) -> Option<Expansion> {
    let solid = solid(f, library, findings)?;
    let (radius, depth, spacing) = (
        f.number("radius")?,
        f.number("depth")?,
        f.number("spacing")?,
    );
    let size = [f.number("width")?, f.number("height")?];
    let rise = match f.node("rise") {
        Some(_) => f.number("rise")?,
        None => TRANSITS * size[1] / solid.elastic.longitudinal_speed(solid.density),
    };
    let ramp = Ramp {
        start: 0.0,
        rise,
        hold: 0.5 * rise,
        fall: if f.switch("unload")? { rise } else { 0.0 },
    };
    // The circle of contact of a stiff circle has about this radius; plastic strain reaches 2 to 3 of them.
    let contact = (2.0 * radius * depth).sqrt();
    let spacings = [spacing, f.number("coarsening")? * spacing];
    let title = format!(
        "{} indented by {depth:.3e} m with a radius of {radius:.3e} m",
        solid.material
    );
    let sides = Sides {
        left: symmetry(geometry),
        right: Side::Free,
        bottom: Side::Rigid,
        top: Side::Free,
    };
    let body = block(solid, size, spacings, [3.0 * contact; 2], sides);
    let loads = Loads {
        indenter: Some(Indenter {
            body: BLOCK.to_owned(),
            radius,
            depth,
            centre: 0.0,
            ramp,
        }),
        pressures: Vec::new(),
        settling: Some(Settling {
            start: rise,
            damping: DAMPING,
        }),
    };
    Some(Expansion {
        title,
        bodies: vec![Built {
            layers: f.at("layers"),
            ..Built::of_setup(body, f.span, f.at("spacing"))
        }],
        bubble: None,
        loads,
        near_wall: None,
        end_time: ramp.rise + ramp.hold + ramp.fall * 1.5,
    })
}

/// `[setup.pressure_pulse]`.
pub(super) fn pressure_pulse(
    f: Fields<'_>,
    geometry: Geometry,
    library: &Library,
    findings: &mut Findings,
) -> Option<Expansion> {
    let solid = solid(f, library, findings)?;
    let (amplitude, diameter) = (f.number("amplitude")?, f.number("diameter")?);
    let rise_time = f.number("rise_time")?;
    let radius = 0.5 * diameter;
    let extent = f.number("extent")? * radius;
    let spacing = radius / f.number("particles_per_radius")?;
    let spacings = [spacing, f.number("coarsening")? * spacing];
    let transit = extent / solid.elastic.longitudinal_speed(solid.density);
    // Three rise times before its peak the pulse is 1e-4 of it.
    let peak_time = 3.0 * rise_time;
    let open = Side::NonReflecting {
        pressure: 0.0,
        wave: None,
    };
    let sides = Sides {
        left: symmetry(geometry),
        right: open.clone(),
        bottom: open,
        top: Side::Free,
    };
    let title = format!(
        "{} hit by a pressure of {amplitude:.3e} Pa over {diameter:.3e} m within {rise_time:.3e} s",
        solid.material
    );
    let body = block(solid, [extent; 2], spacings, [2.0 * radius; 2], sides);
    let loads = Loads {
        pressures: vec![Pressure {
            body: BLOCK.to_owned(),
            gaussian: GaussianPressure {
                amplitude,
                diameter,
                pulse: Some(GaussianPulse {
                    peak_time,
                    rise_time,
                }),
            },
            centre: 0.0,
            ramp: None,
        }],
        ..Loads::default()
    };
    Some(Expansion {
        title,
        bodies: vec![Built {
            layers: f.at("layers"),
            ..Built::of_setup(body, f.span, f.at("particles_per_radius"))
        }],
        bubble: None,
        loads,
        near_wall: None,
        end_time: 2.0 * peak_time + 3.0 * transit,
    })
}
