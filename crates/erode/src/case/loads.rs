//! Loads on solids: `[indenter]`, `[[pressure]]`, `[settling]`.

use super::{
    body::Built,
    error::{Findings, Span},
    node::Fields,
    relations::{extent_help, of_name},
    simulation::{BodyKind, Side},
};
use erode_physics::load::{GaussianPressure, GaussianPulse};
use erode_sph::Geometry;
use serde::{Deserialize, Serialize};

/// All loads of a case.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Loads {
    /// A rigid indenter.
    pub indenter: Option<Indenter>,
    /// Pressures on tops; where two act on one body they add up.
    pub pressures: Vec<Pressure>,
    /// Damping of the solids.
    pub settling: Option<Settling>,
}

impl Loads {
    /// Whether something presses on the top of a body.
    #[must_use]
    pub fn presses(&self, body: &str) -> bool {
        self.indenter.iter().any(|i| i.body == body)
            || self.pressures.iter().any(|p| p.body == body)
    }

    /// Whether nothing is prescribed.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.indenter.is_none() && self.pressures.is_empty()
    }
}

/// A rigid circle pressed on the upper side of a solid.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Indenter {
    /// Name of the solid.
    pub body: String,
    /// Radius, m.
    pub radius: f64,
    /// Depth of its lowest point below the undeformed side at full load, m.
    pub depth: f64,
    /// Place along the side, m.
    pub centre: f64,
    /// Course of the depth.
    pub ramp: Ramp,
}

/// A Gaussian pressure on the upper side of a solid.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Pressure {
    /// Name of the solid.
    pub body: String,
    /// Course in space, and in time if it is a pulse.
    pub gaussian: GaussianPressure,
    /// Place along the side, m.
    pub centre: f64,
    /// Course in time if it is not a pulse.
    pub ramp: Option<Ramp>,
}

/// A smooth rise, a hold, a smooth fall; all in s.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Ramp {
    /// When the rise begins.
    pub start: f64,
    /// Its duration.
    pub rise: f64,
    /// Time at the top.
    pub hold: f64,
    /// Duration of the fall; 0: the load stays.
    pub fall: f64,
}

/// Mass damping of the solids.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Settling {
    /// When it begins, s.
    pub start: f64,
    /// Rate, 1/s.
    pub damping: f64,
}

/// Reads the loads and checks them against the bodies; with `complete` false a missing body may be one that failed.
pub(crate) fn read(
    f: Fields<'_>,
    bodies: &[Built],
    complete: bool,
    geometry: Geometry,
    findings: &mut Findings,
) -> Option<Loads> {
    let mut loads = Loads::default();
    let mut check = |body: &str, centre: f64, f: Fields<'_>, what: &str| {
        if complete {
            check_place(body, centre, f, what, bodies, geometry, findings);
        }
    };
    if let Some(i) = f.table("indenter") {
        let indenter = indenter(i)?;
        check(&indenter.body, indenter.centre, i, "indenter");
        loads.indenter = Some(indenter);
    }
    for node in f.list("pressure") {
        let p = node.fields()?;
        let pressure = pressure(p)?;
        check(&pressure.body, pressure.centre, p, "pressure");
        loads.pressures.push(pressure);
    }
    if let Some(s) = f.table("settling") {
        loads.settling = Some(Settling {
            start: s.number("start")?,
            damping: s.number("damping")?,
        });
    }
    Some(loads)
}

fn indenter(f: Fields<'_>) -> Option<Indenter> {
    Some(Indenter {
        body: f.text("body")?.to_owned(),
        radius: f.number("radius")?,
        depth: f.number("depth")?,
        centre: f.number("centre")?,
        ramp: ramp(f.table("ramp")?)?,
    })
}

fn pressure(f: Fields<'_>) -> Option<Pressure> {
    let pulse = match f.table("pulse") {
        Some(p) => Some(GaussianPulse {
            peak_time: p.number("peak_time")?,
            rise_time: p.number("rise_time")?,
        }),
        None => None,
    };
    let ramp = match f.table("ramp") {
        Some(r) => Some(ramp(r)?),
        None => None,
    };
    Some(Pressure {
        body: f.text("body")?.to_owned(),
        gaussian: GaussianPressure {
            amplitude: f.number("amplitude")?,
            diameter: f.number("diameter")?,
            pulse,
        },
        centre: f.number("centre")?,
        ramp,
    })
}

fn ramp(f: Fields<'_>) -> Option<Ramp> {
    Some(Ramp {
        start: f.number("start")?,
        rise: f.number("rise")?,
        hold: f.number("hold")?,
        fall: f.number("fall")?,
    })
}

/// A load needs a solid with a free upper side, and must lie on it.
fn check_place(
    body: &str,
    centre: f64,
    f: Fields<'_>,
    what: &str,
    bodies: &[Built],
    geometry: Geometry,
    findings: &mut Findings,
) {
    let at: Span = f.at("body");
    let asker = format!("the {what}");
    let Some(b) = of_name(body, bodies, &asker, at, findings) else {
        return;
    };
    if !matches!(b.body.kind, BodyKind::Solid(_)) {
        let help = "a load acts on a solid; a liquid is driven by a wave through a side";
        findings.error(
            at,
            format!("the {what} is put on `{body}`, which is a liquid"),
            "not a solid",
            help,
        );
        return;
    }
    if b.body.sides.top != Side::Free {
        let help = format!("leave `top` of `{body}` out, or write top.free = {{}}");
        findings.error(
            b.sides[3],
            format!("the {what} acts on the top of `{body}`, which is not free"),
            "must be `free`",
            help,
        );
    }
    let (lower, upper) = b.body.shape.bounding_box();
    if geometry == Geometry::Axisymmetric && centre != 0.0 {
        let help = "leave `centre` out; for a load beside the centre write [geometry.plane]";
        findings.error(
            f.at("centre"),
            format!("in axisymmetry the {what} must be on the axis"),
            "must be 0",
            help,
        );
    } else if !(lower[0]..=upper[0]).contains(&centre) {
        findings.error(
            f.at("centre"),
            format!("the {what} at {centre} m lies outside `{body}`"),
            "outside",
            extent_help(b),
        );
    }
}
