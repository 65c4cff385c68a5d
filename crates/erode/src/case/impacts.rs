//! `[impacts]`: bubbles that collapse one after the other next to the same wall.

use super::{
    body::Built,
    error::{Findings, Span},
    node::Fields,
    resolved::{Item, Items},
    simulation::{BodyKind, Bubble, Side, SolidFormulation},
};
use erode_physics::nuclei::{NucleiDistribution, Stream};
use erode_sph::shapes::Shape;
use serde::{Deserialize, Serialize};

/// Least number of particles over the radius of a bubble, as for `particles_per_radius`.
const LEAST_PER_RADIUS: f64 = 4.0;
/// Longest settling in units of 1/damping.
const LONGEST: f64 = 50.0;

/// A sequence of impacts.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Impacts {
    /// The bubbles in their order.
    pub bubbles: Vec<Impact>,
    /// How the wall comes to rest after each.
    pub settling: Relaxation,
}

/// One bubble of a sequence.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Impact {
    /// Radius, m.
    pub radius: f64,
    /// Distance of its centre from the wall / radius.
    pub standoff: f64,
    /// Pressure that drives the collapse, Pa.
    pub driving_pressure: f64,
    /// Time until the liquid is taken away, s.
    pub duration: f64,
}

/// Mass damping of the wall between two impacts.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Relaxation {
    /// Kinetic energy at which it has settled / largest since the impact began.
    pub residual: f64,
    /// Rate, 1/s.
    pub damping: f64,
    /// Time after which it ends in any case, s.
    pub longest: f64,
}

/// What the bubbles of a sequence have in common: the first one of the case and the bodies around it.
pub(crate) struct Around<'a> {
    pub(crate) bodies: &'a [Built],
    pub(crate) bubble: Option<Bubble>,
    /// Time that a bubble of a radius (m) and pressure (Pa) needs, s; none where nothing tells.
    pub(crate) duration: &'a dyn Fn(f64, f64) -> Option<f64>,
    pub(crate) loads: bool,
}

/// Reads and checks the sequence; nothing when it is wrong.
pub(crate) fn read(f: Fields<'_>, around: &Around<'_>, findings: &mut Findings) -> Option<Impacts> {
    let at = f.at("impacts");
    let f = f.table("impacts")?;
    let wall = Wall::of(around, at, findings)?;
    let bubbles = if f.node("random").is_some() {
        drawn(f.table("random")?, &wall, around, findings)?
    } else {
        listed(f, &wall, around, findings)?
    };
    let s = f.table("settling")?;
    let given = |key: &str| s.node(key).map(|_| s.number(key));
    let damping = given("damping").unwrap_or(Some(2.0 * wall.speed / wall.longer))?;
    let sound = bubbles
        .iter()
        .enumerate()
        .all(|(k, (b, at))| wall.admits(k + 1, b, *at, findings));
    sound.then_some(Impacts {
        bubbles: bubbles.into_iter().map(|(b, _)| b).collect(),
        settling: Relaxation {
            residual: s.number("residual")?,
            damping,
            longest: given("longest").unwrap_or(Some(LONGEST / damping))?,
        },
    })
}

/// The bodies of a sequence.
struct Wall {
    first: Bubble,
    standoff: f64,
    /// Finest spacing of the liquid, its extent from the axis, height of the wall below the surface, m.
    spacing: f64,
    width: f64,
    depth: f64,
    /// Longer side of the wall, m, and longitudinal wave speed in it, m/s.
    longer: f64,
    speed: f64,
}

impl Wall {
    fn of(around: &Around<'_>, at: Span, findings: &mut Findings) -> Option<Self> {
        let refuse = |findings: &mut Findings, what: &str, help: &str| {
            findings.error(at, what.to_owned(), "not for this case", help);
        };
        let needed = "write [impacts] beside [setup.bubble_near_wall], or beside one liquid above one solid and [bubble] with `wall_distance`";
        if around.loads {
            let help = "leave the load out: between two impacts the wall is free of pressure";
            refuse(
                findings,
                "repeated impacts do not go with another load",
                help,
            );
            return None;
        }
        let bubble = around.bubble.and_then(|b| Some((b, b.wall_distance?)));
        let mut liquids = around.bodies.iter().filter(|b| is_liquid(b));
        let mut solids = around.bodies.iter().filter(|b| !is_liquid(b));
        let (Some((first, distance)), Some(liquid), None, Some(solid), None) = (
            bubble,
            liquids.next(),
            liquids.next(),
            solids.next(),
            solids.next(),
        ) else {
            refuse(
                findings,
                "repeated impacts need a bubble next to a wall",
                needed,
            );
            return None;
        };
        let cavity = Shape::Disc {
            centre: first.centre,
            radius: first.radius,
        };
        let meets = matches!(liquid.body.sides.bottom, Side::Interface { .. });
        if first.centre[0] != 0.0 || liquid.body.holes != [cavity] || !meets {
            let what = "repeated impacts need one hole in the liquid, the bubble, on the axis above the wall";
            refuse(findings, what, needed);
            return None;
        }
        let BodyKind::Solid(metal) = &solid.body.kind else {
            return None;
        };
        if let SolidFormulation::Joshi { .. } = metal.formulation {
            let help = "leave the formulation of the wall out, or write total_lagrangian = {}";
            refuse(
                findings,
                "repeated impacts need the total Lagrangian form of the wall",
                help,
            );
            return None;
        }
        let (lower, upper) = solid.body.shape.bounding_box();
        let (_, end) = liquid.body.shape.bounding_box();
        Some(Self {
            first,
            standoff: distance / first.radius,
            spacing: liquid.body.spacing.finest,
            width: end[0],
            depth: upper[1] - lower[1],
            longer: (upper[0] - lower[0]).max(upper[1] - lower[1]),
            speed: metal.elastic.longitudinal_speed(metal.density),
        })
    }

    /// Whether a bubble fits between wall and sides and is resolved.
    fn admits(&self, number: usize, b: &Impact, at: Span, findings: &mut Findings) -> bool {
        let mut fine = true;
        let mut refuse = |message: String, label: &str, help: String| {
            findings.error(at, message, label, help);
            fine = false;
        };
        let across = b.radius / self.spacing;
        if across < LEAST_PER_RADIUS * (1.0 - 1e-9) {
            let message = format!(
                "bubble {number} of the sequence has a radius of {} m, {across:.1} particles",
                b.radius
            );
            let help = format!(
                "at least {LEAST_PER_RADIUS} are needed, 10 show an outline: the finest spacing is {} m for all bubbles",
                self.spacing
            );
            refuse(message, "too small", help);
        }
        if b.radius >= self.width {
            let message = format!(
                "bubble {number} of the sequence lies outside the liquid: its radius is {} m, the liquid reaches {} m from the axis",
                b.radius, self.width
            );
            refuse(
                message,
                "too large",
                "make the domain wider (`width`) or the bubble smaller".to_owned(),
            );
        }
        let below = (1.0 - b.standoff) * b.radius;
        if below > self.depth {
            let message = format!(
                "bubble {number} of the sequence reaches through the wall: {below} m below its surface, which is {} m thick",
                self.depth
            );
            refuse(
                message,
                "beyond the far side",
                "a larger `standoff` or a thicker wall".to_owned(),
            );
        }
        fine
    }

    fn impact(
        &self,
        radius: f64,
        standoff: f64,
        pressure: f64,
        around: &Around<'_>,
    ) -> Option<Impact> {
        Some(Impact {
            radius,
            standoff,
            driving_pressure: pressure,
            duration: (around.duration)(radius, pressure)?,
        })
    }
}

fn is_liquid(b: &Built) -> bool {
    matches!(b.body.kind, BodyKind::Fluid(_))
}

fn listed(
    f: Fields<'_>,
    wall: &Wall,
    around: &Around<'_>,
    findings: &mut Findings,
) -> Option<Vec<(Impact, Span)>> {
    let mut bubbles = Vec::new();
    for node in f.list("bubble") {
        let b = node.fields()?;
        let number = |key: &str, otherwise: f64| match b.node(key) {
            Some(_) => b.number(key),
            None => Some(otherwise),
        };
        if b.number("position")? != 0.0 {
            let message = "every bubble of a sequence lies on the axis (in plane strain on the plane of symmetry): only half of what happens is computed";
            let help = "leave `position` out; impacts beside each other need three dimensions";
            findings.error(b.at("position"), message, "must be 0", help);
            return None;
        }
        let radius = number("radius", wall.first.radius)?;
        let standoff = number("standoff", wall.standoff)?;
        let pressure = number("driving_pressure", wall.first.driving_pressure)?;
        let mut impact = wall.impact(radius, standoff, pressure, around)?;
        impact.duration = number("duration", impact.duration)?;
        let times = b.number("times")? as usize;
        bubbles.extend(std::iter::repeat_n((impact, b.span), times));
    }
    // An empty list has been refused before.
    (!bubbles.is_empty()).then_some(bubbles)
}

/// A distribution of what a bubble has.
enum Drawn {
    Same(f64),
    Uniform { smallest: f64, largest: f64 },
    Lognormal(NucleiDistribution),
}

impl Drawn {
    fn at(&self, stream: Stream, place: u64) -> f64 {
        match self {
            Self::Same(x) => *x,
            Self::Uniform { smallest, largest } => {
                smallest + (largest - smallest) * stream.uniform(place)
            }
            Self::Lognormal(d) => d.sample(stream, place),
        }
    }

    fn read(f: Fields<'_>, key: &str, same: f64, findings: &mut Findings) -> Option<Self> {
        if f.node(key).is_none() {
            return Some(Self::Same(same));
        }
        let (name, d) = f.chosen(key)?;
        if name == "lognormal" {
            return Some(Self::Lognormal(NucleiDistribution::Lognormal {
                median: d.number("median")?,
                deviation: d.number("deviation")?,
            }));
        }
        let (smallest, largest) = (d.number("smallest")?, d.number("largest")?);
        if largest < smallest {
            let message = format!("the largest {key} of the bubbles is below the smallest");
            let help = format!("`largest` must be {smallest} at least");
            findings.error(d.at("largest"), message, "too small", help);
            return None;
        }
        Some(Self::Uniform { smallest, largest })
    }
}

fn drawn(
    f: Fields<'_>,
    wall: &Wall,
    around: &Around<'_>,
    findings: &mut Findings,
) -> Option<Vec<(Impact, Span)>> {
    let stream = Stream {
        seed: f.number("seed")? as u64,
    };
    let radius = Drawn::read(f, "radius", wall.first.radius, findings)?;
    let standoff = Drawn::read(f, "standoff", wall.standoff, findings)?;
    let one = |k: u64| {
        let radius = radius.at(stream.branch(0), k);
        let standoff = standoff.at(stream.branch(1), k);
        let pressure = wall.first.driving_pressure;
        Some((wall.impact(radius, standoff, pressure, around)?, f.span))
    };
    (0..f.number("count")? as u64).map(one).collect()
}

/// `[impacts]` written out: every bubble by itself.
pub(crate) fn impacts_items(i: &Impacts) -> Items {
    let number = |key, x| (key, Item::Number(x));
    let bubble = |b: &Impact| {
        vec![
            number("radius", b.radius),
            number("standoff", b.standoff),
            number("driving_pressure", b.driving_pressure),
            number("duration", b.duration),
        ]
    };
    let s = &i.settling;
    let settling = vec![
        number("residual", s.residual),
        number("damping", s.damping),
        number("longest", s.longest),
    ];
    vec![
        ("bubble", Item::List(i.bubbles.iter().map(bubble).collect())),
        ("settling", Item::Table(settling)),
    ]
}
