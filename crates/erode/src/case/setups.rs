//! Ready-made arrangements and the bodies they stand for.

use super::{
    body::Built,
    build,
    error::{Findings, Span},
    format::si,
    laws, layers,
    loads::Loads,
    node::Fields,
    setups_solid,
    simulation::{Body, BodyKind, Bubble, BubbleGas, Fluid, Side, Sides, Solid, Wave},
};
use crate::materials::Library;
use erode_physics::eos::Tait;
use erode_sph::{Geometry, packing::Spacing, shapes::Shape};

/// Increase of spacing per distance from the core.
pub(super) const GROWTH: f64 = 0.06;
/// Rayleigh's collapse time of an empty bubble is 0.915 R sqrt(rho/p).
const RAYLEIGH: f64 = 0.915;

/// What a setup stands for.
pub(crate) struct Expansion {
    pub(crate) title: String,
    pub(crate) bodies: Vec<Built>,
    pub(crate) bubble: Option<Bubble>,
    pub(crate) loads: Loads,
    pub(crate) end_time: f64,
    /// How long other bubbles next to the same wall take.
    pub(crate) near_wall: Option<NearWallTime>,
}

/// How long bubbles next to a wall take.
pub(crate) struct NearWallTime {
    eos: Tait,
    /// Liquid above the centre / radius.
    height: f64,
}

impl Expansion {
    /// Time that a bubble of a radius (m) and driving pressure (Pa) next to the same wall needs, s.
    pub(crate) fn duration(&self, radius: f64, pressure: f64) -> Option<f64> {
        let own = self.bubble?;
        if radius == own.radius && pressure == own.driving_pressure {
            return Some(self.end_time);
        }
        let t = self.near_wall.as_ref()?;
        Some(near_wall_time(
            &t.eos,
            radius,
            pressure,
            (t.height - 1.0) * radius,
        ))
    }
}

/// Expands the chosen setup.
pub(crate) fn expand(
    name: &str,
    fields: Fields<'_>,
    geometry: Geometry,
    library: &Library,
    findings: &mut Findings,
) -> Option<Expansion> {
    match name {
        "bubble_in_liquid" => bubble_in_liquid(fields, geometry, library, findings),
        "indentation" => setups_solid::indentation(fields, geometry, library, findings),
        "pressure_pulse" => setups_solid::pressure_pulse(fields, geometry, library, findings),
        _ => bubble_near_wall(fields, geometry, library, findings),
    }
}

/// The numbers of `[setup.bubble_near_wall]`, lengths in m.
struct NearWall {
    radius: f64,
    distance: f64,
    pressure: f64,
    spacing: f64,
    coarsest: f64,
    width: f64,
    height: f64,
    depth: f64,
}

impl NearWall {
    fn read(f: Fields<'_>, findings: &mut Findings) -> Option<Self> {
        check_inside(f, "height", "top of the bubble", findings);
        check_inside(f, "width", "side of the bubble", findings);
        check_far_side(f, findings);
        let radius = f.number("radius")?;
        let distance = f.number("standoff")? * radius;
        let spacing = radius / f.number("particles_per_radius")?;
        Some(Self {
            radius,
            distance,
            pressure: f.number("driving_pressure")?,
            spacing,
            coarsest: f.number("coarsening")? * spacing,
            width: f.number("width")? * radius,
            height: distance + f.number("height")? * radius,
            depth: f.number("wall_depth")? * radius,
        })
    }

    /// The step reaches the top of the bubble, the bubble collapses, the shock runs into the wall.
    fn end_time(&self, eos: &Tait) -> f64 {
        let above = self.height - self.distance - self.radius;
        near_wall_time(eos, self.radius, self.pressure, above)
    }

    fn liquid(&self, kind: Fluid, axis: Side) -> Body {
        let (r, d) = (self.radius, self.distance);
        let at_rest = kind.pressure;
        let wave = Wave {
            pressure: self.pressure - at_rest,
            start: 0.0,
        };
        Body {
            name: "liquid".to_owned(),
            kind: BodyKind::Fluid(kind),
            shape: Shape::Rectangle {
                lower: [0.0, 0.0],
                upper: [self.width, self.height],
            },
            holes: vec![Shape::Disc {
                centre: [0.0, d],
                radius: r,
            }],
            spacing: self.spacing([0.0, 0.0], [1.5 * r, d + 1.4 * r]),
            sides: Sides {
                left: axis,
                right: Side::Rigid,
                bottom: Side::Interface {
                    with: "wall".to_owned(),
                },
                top: Side::NonReflecting {
                    pressure: at_rest,
                    wave: Some(wave),
                },
            },
        }
    }

    fn wall(&self, kind: Solid, axis: Side) -> Body {
        let r = self.radius;
        let open = Side::NonReflecting {
            pressure: 0.0,
            wave: None,
        };
        Body {
            name: "wall".to_owned(),
            kind: BodyKind::Solid(kind),
            shape: Shape::Rectangle {
                lower: [0.0, -self.depth],
                upper: [self.width, 0.0],
            },
            holes: Vec::new(),
            spacing: self.spacing([0.0, -0.75 * r], [2.0 * r, 0.0]),
            sides: Sides {
                left: axis,
                right: open.clone(),
                bottom: open,
                top: Side::Interface {
                    with: "liquid".to_owned(),
                },
            },
        }
    }

    fn spacing(&self, lower: [f64; 2], upper: [f64; 2]) -> Spacing {
        let core = Some(Shape::Rectangle { lower, upper });
        Spacing {
            finest: self.spacing,
            coarsest: self.coarsest,
            growth: GROWTH,
            core,
        }
    }
}

/// The same for a bubble with so much liquid above its top, m.
fn near_wall_time(eos: &Tait, radius: f64, pressure: f64, above: f64) -> f64 {
    let c = eos.sound_speed;
    let collapse = RAYLEIGH * radius * (eos.reference_density / pressure).sqrt();
    above / c + 1.25 * collapse + 4.0 * radius / c
}

fn bubble_near_wall(
    f: Fields<'_>,
    geometry: Geometry,
    library: &Library,
    findings: &mut Findings,
) -> Option<Expansion> {
    // All of these are asked before the first one that fails ends the expansion: each records its errors.
    let numbers = NearWall::read(f, findings);
    let gas = build::gas(f)?;
    let eos = laws::fluid(f, "liquid", None, library, findings);
    let solid = laws::solid(f, "wall", None, library, findings);
    let damage = laws::damage(f, "wall", library, findings);
    let layers = layers::read(f, "wall_layers", library, findings);
    let (n, eos, (density, elastic, strength)) = (numbers?, eos?, solid?);
    if let Some(gas) = gas {
        check_driven(gas, n.pressure, f.at("gas"), findings);
    }
    let fluid = Fluid {
        material: f.text("liquid")?.to_owned(),
        eos,
        formulation: laws::fluid_formulation(f, "liquid_formulation")?,
        pressure: gas.map_or(0.0, |g| g.pressure),
        velocity: [0.0; 2],
    };
    let solid = Solid {
        material: f.text("wall")?.to_owned(),
        layers: layers?,
        density,
        elastic,
        strength,
        damage: damage?,
        formulation: laws::solid_formulation(f, "wall_formulation")?,
        velocity: [0.0; 2],
    };
    let place = |body| Built {
        layers: f.at("wall_layers"),
        ..Built::of_setup(body, f.span, f.at("particles_per_radius"))
    };
    let standoff = n.distance / n.radius;
    Some(Expansion {
        title: format!(
            "{} bubble, stand-off {standoff:.3}, {} next to {}",
            filling(gas),
            fluid.material,
            solid.material
        ),
        end_time: n.end_time(&eos),
        near_wall: Some(NearWallTime {
            eos,
            height: f.number("height")?,
        }),
        bubble: Some(Bubble {
            centre: [0.0, n.distance],
            radius: n.radius,
            wall_distance: Some(n.distance),
            driving_pressure: n.pressure,
            gas,
        }),
        loads: Loads::default(),
        bodies: vec![
            place(n.liquid(fluid, symmetry(geometry))),
            place(n.wall(solid, symmetry(geometry))),
        ],
    })
}

fn bubble_in_liquid(
    f: Fields<'_>,
    geometry: Geometry,
    library: &Library,
    findings: &mut Findings,
) -> Option<Expansion> {
    check_inside(f, "domain", "surface of the bubble", findings);
    let eos = laws::fluid(f, "liquid", None, library, findings)?;
    let (radius, pressure) = (f.number("radius")?, f.number("pressure")?);
    let gas = build::gas(f)?;
    let spacing = radius / f.number("particles_per_radius")?;
    let extent = f.number("domain")? * radius;
    let fluid = Fluid {
        material: f.text("liquid")?.to_owned(),
        eos,
        formulation: laws::fluid_formulation(f, "liquid_formulation")?,
        pressure,
        velocity: [0.0; 2],
    };
    let title = format!(
        "{} bubble in {} far from walls",
        filling(gas),
        fluid.material
    );
    let coarsest = f.number("coarsening")? * spacing;
    let body = ball_of_liquid(
        fluid,
        radius,
        extent,
        (spacing, coarsest),
        symmetry(geometry),
    );
    Some(Expansion {
        title,
        // An empty bubble closes at the Rayleigh time, a little later in a compressible liquid; with gas it comes back.
        end_time: gas.map_or(1.1, |_| 2.4)
            * RAYLEIGH
            * radius
            * (eos.reference_density / pressure).sqrt(),
        near_wall: None,
        bubble: Some(Bubble {
            centre: [0.0, 0.0],
            radius,
            wall_distance: None,
            driving_pressure: pressure,
            gas,
        }),
        loads: Loads::default(),
        bodies: vec![Built::of_setup(body, f.span, f.at("particles_per_radius"))],
    })
}

/// What is in the bubble, for titles.
fn filling(gas: Option<BubbleGas>) -> &'static str {
    gas.map_or("empty", |_| "gas")
}

/// Liquid about a bubble at (0, 0), going on without end.
fn ball_of_liquid(
    kind: Fluid,
    radius: f64,
    extent: f64,
    (finest, coarsest): (f64, f64),
    axis: Side,
) -> Body {
    let far = Side::NonReflecting {
        pressure: kind.pressure,
        wave: None,
    };
    let near = 1.5 * radius;
    let core = Shape::Rectangle {
        lower: [0.0, -near],
        upper: [near, near],
    };
    Body {
        name: "liquid".to_owned(),
        kind: BodyKind::Fluid(kind),
        shape: Shape::Rectangle {
            lower: [0.0, -extent],
            upper: [extent, extent],
        },
        holes: vec![Shape::Disc {
            centre: [0.0, 0.0],
            radius,
        }],
        spacing: Spacing {
            finest,
            coarsest,
            growth: GROWTH,
            core: Some(core),
        },
        sides: Sides {
            left: axis,
            right: far.clone(),
            bottom: far.clone(),
            top: far,
        },
    }
}

/// The plane of symmetry through the bubble.
pub(super) fn symmetry(geometry: Geometry) -> Side {
    match geometry {
        Geometry::Axisymmetric => Side::Axis,
        Geometry::Plane => Side::Rigid,
    }
}

/// The liquid is at rest at the pressure of the gas until the wave arrives, which must press it.
fn check_driven(gas: BubbleGas, pressure: f64, at: Span, findings: &mut Findings) {
    if gas.pressure >= pressure {
        let message = format!(
            "the gas is at {}, not less than the driving pressure of {}: no wave would squeeze the bubble",
            si(gas.pressure, "Pa"),
            si(pressure, "Pa")
        );
        let help =
            "give the gas a lower pressure; a bubble that grows by itself is `bubble_in_liquid`";
        findings.error(at, message, "nothing drives it", help);
    }
}

/// A bubble that the wall cuts must not reach through it.
fn check_far_side(f: Fields<'_>, findings: &mut Findings) {
    let numbers = f.number("standoff").zip(f.number("wall_depth"));
    if let Some((standoff, depth)) = numbers
        && standoff + depth < 1.0
    {
        let message = format!(
            "the bubble reaches through the wall: it lies {:.3} radii below its surface, which is {depth} radii thick",
            1.0 - standoff
        );
        let help = format!(
            "`standoff` + `wall_depth` must be 1 at least; here they are {:.3}",
            standoff + depth
        );
        findings.error(f.at("standoff"), message, "beyond the far side", help);
    }
}

/// The bubble must lie inside the liquid: an extent in radii must exceed one.
fn check_inside(f: Fields<'_>, key: &str, what: &str, findings: &mut Findings) {
    if let Some(x) = f.number(key)
        && x <= 1.0
    {
        let message = format!(
            "the bubble lies outside the liquid: with `{key}` = {x} the {what} is beyond its edge"
        );
        let help = format!("`{key}` counts in bubble radii; 4 to 10 are sensible");
        findings.error(f.at(key), message, "too small", help);
    }
}
