//! Bubbles of a case: `[setup.single_bubble]` and what it shares with other setups of bubbles.

use super::{
    error::{Findings, Span},
    node::Fields,
    resolved::{Item, Items},
};
use erode_physics::bubble::{
    Ambient, BubbleError, Constant, Driving, Gas, Gilmore, KellerMiksis, Liquid, Model,
    RayleighPlesset, Sine, Switching, TomitaShima, equilibrium_gas,
};
use serde::{Deserialize, Serialize};

/// Rayleigh's collapse time of an empty bubble in units of R sqrt(rho/p).
const RAYLEIGH: f64 = 0.914_681;

/// One spherical bubble in unbounded liquid.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct SingleBubble {
    /// Radius at the start, m.
    pub radius: f64,
    /// dR/dt at the start, m/s.
    pub wall_velocity: f64,
    /// Pressure of the liquid over time.
    pub ambient_pressure: AmbientPressure,
    /// Permanent gas.
    pub gas: Gas,
    /// The liquid.
    pub liquid: Liquid,
    /// The law.
    pub model: Model,
    /// Error allowed in each step.
    pub tolerance: f64,
}

/// Pressure of the liquid over time.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum AmbientPressure {
    /// The same at all times.
    Constant {
        /// Pa.
        pressure: f64,
    },
    /// mean - amplitude sin(2 pi frequency t).
    Sine {
        /// Pa.
        mean: f64,
        /// Pa.
        amplitude: f64,
        /// Hz.
        frequency: f64,
    },
    /// A straight line between two pressures.
    Ramp {
        /// Pressure before, Pa.
        from: f64,
        /// Pressure afterwards, Pa.
        to: f64,
        /// When it begins to change, s.
        start: f64,
        /// How long it changes, s.
        duration: f64,
    },
}

impl AmbientPressure {
    /// Times at which its rate jumps, s; it is smooth between them.
    #[must_use]
    pub fn breaks(&self) -> Vec<f64> {
        match *self {
            Self::Ramp {
                start, duration, ..
            } => vec![start, start + duration],
            _ => Vec::new(),
        }
    }

    /// The pressure within an interval, s, that holds none of [`Self::breaks`] inside.
    #[must_use]
    pub fn between(&self, begin: f64, end: f64) -> Piece {
        match *self {
            Self::Constant { pressure } => Piece::Constant(Constant { pressure }),
            Self::Sine {
                mean,
                amplitude,
                frequency,
            } => Piece::Sine(Sine {
                mean,
                amplitude,
                frequency,
            }),
            Self::Ramp {
                from,
                to,
                start,
                duration,
            } => {
                let middle = 0.5 * (begin + end);
                if middle < start {
                    Piece::Constant(Constant { pressure: from })
                } else if middle > start + duration {
                    Piece::Constant(Constant { pressure: to })
                } else {
                    let rate = (to - from) / duration;
                    Piece::Line {
                        pressure: from,
                        rate,
                        start,
                    }
                }
            }
        }
    }

    /// Pressure at the start, Pa.
    #[must_use]
    pub fn at_start(&self) -> f64 {
        match *self {
            Self::Constant { pressure } => pressure,
            Self::Sine { mean, .. } => mean,
            Self::Ramp { from, .. } => from,
        }
    }
}

/// A smooth piece of an [`AmbientPressure`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Piece {
    /// One pressure.
    Constant(Constant),
    /// A wave.
    Sine(Sine),
    /// A straight line.
    Line {
        /// Pressure at its start, Pa.
        pressure: f64,
        /// Pa/s.
        rate: f64,
        /// s.
        start: f64,
    },
}

impl Driving for Piece {
    fn at(&self, time: f64) -> Ambient {
        match *self {
            Self::Constant(constant) => constant.at(time),
            Self::Sine(sine) => sine.at(time),
            Self::Line {
                pressure,
                rate,
                start,
            } => Ambient {
                pressure: pressure + rate * (time - start),
                pressure_rate: rate,
                ..Ambient::default()
            },
        }
    }
}

/// Reads `[setup.single_bubble]`; also proposes an end time, s.
pub(crate) fn single_bubble(f: Fields<'_>, findings: &mut Findings) -> Option<(SingleBubble, f64)> {
    let liquid = liquid(f.table("liquid")?);
    let ambient_pressure = ambient_pressure(f);
    let radius = f.number("radius");
    let start = ambient_pressure.map(|p| p.at_start());
    let gas = gas(f, liquid.as_ref(), radius, start, findings);
    let model = model(f);
    let bubble = SingleBubble {
        radius: radius?,
        wall_velocity: f.number("wall_velocity")?,
        ambient_pressure: ambient_pressure?,
        gas: gas?,
        liquid: liquid?,
        model: model?,
        tolerance: f.number("tolerance")?,
    };
    Some((bubble, proposed_end(&bubble)))
}

/// Two periods of a wave; else five times what Rayleigh's collapse takes.
fn proposed_end(b: &SingleBubble) -> f64 {
    let (begin, pressure) = match b.ambient_pressure {
        AmbientPressure::Sine { frequency, .. } => return 2.0 / frequency,
        AmbientPressure::Constant { pressure } => (0.0, pressure),
        AmbientPressure::Ramp {
            to,
            start,
            duration,
            ..
        } => (start + duration, to),
    };
    let scale = (pressure - b.liquid.vapour_pressure)
        .abs()
        .max(b.gas.pressure)
        .max(1.0);
    begin + 5.0 * RAYLEIGH * b.radius.max(b.gas.radius) * (b.liquid.density / scale).sqrt()
}

pub(crate) fn liquid(f: Fields<'_>) -> Option<Liquid> {
    Some(Liquid {
        density: f.number("density")?,
        sound_speed: f.number("sound_speed")?,
        viscosity: f.number("viscosity")?,
        surface_tension: f.number("surface_tension")?,
        vapour_pressure: f.number("vapour_pressure")?,
    })
}

fn ambient_pressure(f: Fields<'_>) -> Option<AmbientPressure> {
    let (name, f) = f.chosen("ambient_pressure")?;
    Some(match name {
        "constant" => AmbientPressure::Constant {
            pressure: f.number("pressure")?,
        },
        "sine" => AmbientPressure::Sine {
            mean: f.number("mean")?,
            amplitude: f.number("amplitude")?,
            frequency: f.number("frequency")?,
        },
        _ => AmbientPressure::Ramp {
            from: f.number("from")?,
            to: f.number("to")?,
            start: f.number("start")?,
            duration: f.number("duration")?,
        },
    })
}

/// The gas under `gas` of a setup whose bubble starts with `radius` (m) at `pressure` (Pa).
pub(crate) fn gas(
    f: Fields<'_>,
    liquid: Option<&Liquid>,
    radius: Option<f64>,
    pressure: Option<f64>,
    findings: &mut Findings,
) -> Option<Gas> {
    let span = f.at("gas");
    let (name, g) = f.chosen("gas")?;
    let own = |key: &str, other: Option<f64>| match g.node(key) {
        Some(_) => g.number(key),
        None => other,
    };
    let polytropic_exponent = g.number("polytropic_exponent")?;
    let at_radius = own("radius", radius)?;
    if name == "given" {
        return Some(Gas {
            pressure: g.number("pressure")?,
            radius: at_radius,
            polytropic_exponent,
        });
    }
    let found = equilibrium_gas(
        liquid?,
        at_radius,
        own("pressure", pressure)?,
        polytropic_exponent,
    );
    found.map_err(|e| no_equilibrium(&e, span, findings)).ok()
}

fn no_equilibrium(error: &BubbleError, span: Span, findings: &mut Findings) {
    let help = "raise the pressure above the threshold, take a smaller radius, or write the gas as \
                gas.given = { pressure = ... }";
    findings.error(span, error.to_string(), "no such gas", help);
}

/// The law under `model`.
pub(crate) fn model(f: Fields<'_>) -> Option<Model> {
    let (name, f) = f.chosen("model")?;
    let factor = || {
        Some(TomitaShima {
            density_factor: f.number("density_factor")?,
        })
    };
    Some(match name {
        "rayleigh_plesset" => Model::RayleighPlesset(RayleighPlesset),
        "gilmore" => Model::Gilmore(Gilmore {
            tait_exponent: f.number("tait_exponent")?,
            reference_pressure: f.number("reference_pressure")?,
        }),
        "tomita_shima" => Model::TomitaShima(factor()?),
        "switching" => Model::Switching(Switching {
            collapse: factor()?,
        }),
        _ => Model::KellerMiksis(KellerMiksis),
    })
}

/// What `resolved.toml` says of it.
pub(crate) fn single_bubble_items(b: &SingleBubble) -> Items {
    vec![
        ("radius", Item::Number(b.radius)),
        ("wall_velocity", Item::Number(b.wall_velocity)),
        ("tolerance", Item::Number(b.tolerance)),
        ("ambient_pressure", ambient_item(&b.ambient_pressure)),
        ("gas", gas_item(&b.gas)),
        ("liquid", Item::Table(liquid_items(&b.liquid))),
        ("model", model_item(&b.model)),
    ]
}

fn choice(name: &'static str, items: Items) -> Item {
    Item::Table(vec![(name, Item::Table(items))])
}

fn ambient_item(p: &AmbientPressure) -> Item {
    let number = |key, x| (key, Item::Number(x));
    match *p {
        AmbientPressure::Constant { pressure } => {
            choice("constant", vec![number("pressure", pressure)])
        }
        AmbientPressure::Sine {
            mean,
            amplitude,
            frequency,
        } => choice(
            "sine",
            vec![
                number("mean", mean),
                number("amplitude", amplitude),
                number("frequency", frequency),
            ],
        ),
        AmbientPressure::Ramp {
            from,
            to,
            start,
            duration,
        } => choice(
            "ramp",
            vec![
                number("from", from),
                number("to", to),
                number("start", start),
                number("duration", duration),
            ],
        ),
    }
}

pub(crate) fn gas_item(g: &Gas) -> Item {
    choice(
        "given",
        vec![
            ("pressure", Item::Number(g.pressure)),
            ("radius", Item::Number(g.radius)),
            ("polytropic_exponent", Item::Number(g.polytropic_exponent)),
        ],
    )
}

pub(crate) fn liquid_items(l: &Liquid) -> Items {
    vec![
        ("density", Item::Number(l.density)),
        ("sound_speed", Item::Number(l.sound_speed)),
        ("viscosity", Item::Number(l.viscosity)),
        ("surface_tension", Item::Number(l.surface_tension)),
        ("vapour_pressure", Item::Number(l.vapour_pressure)),
    ]
}

pub(crate) fn model_item(m: &Model) -> Item {
    let factor = |t: &TomitaShima| vec![("density_factor", Item::Number(t.density_factor))];
    match m {
        Model::RayleighPlesset(_) => choice("rayleigh_plesset", Vec::new()),
        Model::KellerMiksis(_) => choice("keller_miksis", Vec::new()),
        Model::Gilmore(g) => choice(
            "gilmore",
            vec![
                ("tait_exponent", Item::Number(g.tait_exponent)),
                ("reference_pressure", Item::Number(g.reference_pressure)),
            ],
        ),
        Model::TomitaShima(t) => choice("tomita_shima", factor(t)),
        Model::Switching(s) => choice("switching", factor(&s.collapse)),
    }
}
