//! Figures 6.18 and 6.19: characteristic times of load and metal along the wall.

use super::super::Options;
use super::super::session::{Judged, Metal, Need, Ran, Session};
use super::chapter6::DETACHED;
use super::chapter6_wall::YIELDED;
use super::near_wall::{Collapse, at, note};
use crate::analysis::{
    FALL, RISE, WallPressure, largest_in_column, loading_time, material_time, zone_depth,
};
use crate::validate::{Check, Failure, Figure, Finding, Style};

/// "Speed of sound in the solid" of the thesis, m/s (table 7.1): that of a bar.
const SOUND: f64 = 4883.33;
const NEAR: Collapse = at(1.2);

/// Both times at one radius, s, with the strain below.
#[derive(Debug, Clone, Copy)]
struct Times {
    r: f64,
    load: f64,
    metal: f64,
    strain: f64,
}

impl Times {
    /// Above one: the load lasts longer than the metal needs.
    fn ratio(&self) -> f64 {
        self.load / self.metal
    }
}

fn times(wall: &WallPressure, metal: &Metal) -> Vec<Times> {
    let depth = zone_depth(
        &metal.position,
        &metal.plastic_strain,
        metal.top,
        &wall.radius,
        YIELDED,
    );
    let strain = largest_in_column(&metal.position, &metal.plastic_strain, &wall.radius);
    (0..wall.radius.len())
        .filter(|k| depth[*k] > 0.0)
        .map(|k| Times {
            r: wall.radius[k],
            // A point that never sees the yield stress is loaded for no time.
            load: loading_time(&wall.time, &wall.pressure[k], RISE, FALL).unwrap_or(0.0),
            metal: material_time(depth[k], SOUND),
            strain: strain[k],
        })
        .collect()
}

fn figure(times: &[Times]) -> Figure {
    let mut figure = Figure::new(
        "times",
        "Characteristic times",
        ("distance from the axis", "m"),
        ("time", "s"),
    );
    let curve = |y: fn(&Times) -> f64| times.iter().map(|t| [t.r, y(t)]).collect();
    figure.add("load", Style::Line, curve(|t| t.load));
    figure.add("metal", Style::Dashed, curve(|t| t.metal));
    figure
}

fn of(run: &Ran) -> Result<Vec<Times>, Failure> {
    let found = times(&run.wall()?, &run.metal()?);
    if found.is_empty() {
        return Err(Failure::Absent(
            "the metal did not yield: there are no times to compare".into(),
        ));
    }
    Ok(found)
}

/// Entry nearest to a radius; nothing in it is a number where the radius is none.
fn nearest(times: &[Times], r: f64) -> Times {
    let none = Times {
        r,
        load: f64::NAN,
        metal: f64::NAN,
        strain: f64::NAN,
    };
    let gap = |t: &&Times| (t.r - r).abs();
    let found = times.iter().min_by(|a, b| gap(a).total_cmp(&gap(b)));
    found.filter(|_| r.is_finite()).copied().unwrap_or(none)
}

pub(super) fn detached(session: &Session) -> Result<Judged, Failure> {
    let run = DETACHED.results(session)?;
    let found = of(&run)?;
    let ring = nearest(&found, run.get("off_axis_plastic_strain_r"));
    let checks = vec![
        Check::at_least(
            "time of the metal / of the load next to the axis (region A)",
            "-",
            1.0 / found[0].ratio(),
            1.0,
            "\"the loading characteristic time is lower than the material characteristic time\"",
        ),
        Check::at_least(
            "time of the load / of the metal at the largest strain apart from the axis (region B)",
            "-",
            ring.ratio(),
            1.0,
            "\"the material characteristic time is lower than the loading characteristic time\"",
        ),
    ];
    Ok(judged(session, &run, &found, checks))
}

pub(super) fn near_needs(options: &Options) -> Vec<Need> {
    vec![NEAR.need(options)]
}

pub(super) fn near(session: &Session) -> Result<Judged, Failure> {
    let run = NEAR.results(session)?;
    let found = of(&run)?;
    // Between the axis and the ring the metal is the slower one, beyond it is the faster one.
    let ring = nearest(&found, run.get("off_axis_plastic_strain_r"));
    let between = found.iter().filter(|t| t.r > found[0].r && t.r < ring.r);
    let slowest = between.map(|t| 1.0 / t.ratio()).fold(f64::NAN, f64::max);
    let checks = vec![
        Check::at_least(
            "time of the load / of the metal next to the axis (region A)",
            "-",
            found[0].ratio(),
            1.0,
            "\"in region A the material characteristic time is lower than the loading characteristic time\"",
        ),
        Check::at_least(
            "largest time of the metal / of the load between axis and ring (region B)",
            "-",
            slowest,
            1.0,
            "\"the material characteristic time becomes marginally larger\"",
        ),
        Check::at_least(
            "time of the load / of the metal at the ring (region C)",
            "-",
            ring.ratio(),
            1.0,
            "\"in region C the material characteristic time is much lower\"",
        ),
        Check::shown(
            "strain next to the axis / at the ring",
            "-",
            found[0].strain / ring.strain,
            None,
            "the source gives no number",
        ),
    ];
    Ok(judged(session, &run, &found, checks))
}

fn judged(session: &Session, run: &Ran, found: &[Times], checks: Vec<Check>) -> Judged {
    Judged {
        finding: Finding {
            checks,
            figures: vec![figure(found)],
            notes: vec![
                note(session),
                "Time of the load: from the first 100 MPa until the pressure last falls below 508 MPa. Time of the metal: depth of the plastic zone over \
                 4883 m/s, as in the thesis; the longitudinal wave is 16 % faster."
                    .into(),
            ],
        },
        pictures: run.picture("plastic strain").into_iter().collect(),
    }
}
