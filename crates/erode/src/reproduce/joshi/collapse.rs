//! Figure 6.3: a bubble of 0.095 mm collapses far from walls, 60 MPa.

use super::super::Options;
use super::super::session::{Judged, Need, Session};
use super::near_wall::resolution;
use crate::analysis::crossing;
use crate::report::{collapse_curve, collapse_time};
use crate::sweep::Setting;
use crate::validate::{Check, Failure, Figure, Finding, Style};

const CASE: (&str, &str) = (
    "bubble-in-liquid",
    "title = \"Empty bubble of 0.095 mm in water at 60 MPa: Joshi 2018, figure 6.2\"\n\
     [setup.bubble_in_liquid]\nradius = \"0.095 mm\"\npressure = \"60 MPa\"\nparticles_per_radius = 30\ndomain = 7\n\
     liquid = \"water\"\n[output]\nfields_every = \"100 ns\"\nhistory_every = \"1 ns\"\n[checkpoint]\nevery = \"100 ns\"\n",
);
const RADIUS: f64 = 0.095e-3;
const PRESSURE: f64 = 60e6;
const DENSITY: f64 = 1000.0;
/// Radii at which times are compared, R/R0: below, the bubble of Rayleigh has no bound to its speed.
const COMPARED: [f64; 4] = [0.9, 0.8, 0.6, 0.4];
/// Largest delay, in collapse times.
const TOLERANCE: f64 = 0.05;

fn need(options: &Options) -> Need {
    let n = resolution(options);
    Need {
        name: format!("free,60MPa,0.095mm,n={n}"),
        case: CASE,
        settings: vec![Setting::text(
            "setup.bubble_in_liquid.particles_per_radius",
            &n.to_string(),
        )],
    }
}

pub(super) fn needs(options: &Options) -> Vec<Need> {
    vec![need(options)]
}

pub(super) fn judge(session: &Session) -> Result<Judged, Failure> {
    let run = session.run(&need(&session.options))?;
    let history = run.history()?;
    let column = |name: &str| {
        let absent = || Failure::Absent(format!("the history has no column {name}"));
        history.column(name).ok_or_else(absent)
    };
    let ours: Vec<[f64; 2]> = column("time")?
        .iter()
        .zip(column("bubble_radius")?)
        .map(|(t, r)| [*t, *r])
        .collect();
    let exact = collapse_curve(RADIUS, PRESSURE, DENSITY, 400);
    let whole = collapse_time(RADIUS, PRESSURE, DENSITY);
    let start = ours.first().map_or(f64::NAN, |p| p[1]);
    let words = "\"good agreement\" with the analytical solution: no number is given, 5 % of the collapse time is taken";
    let checks = COMPARED.iter().map(|share| {
        let quantity = format!("delay at R = {share} R0, in collapse times");
        let delay = (time_at(&ours, share * start) - time_at(&exact, share * RADIUS)) / whole;
        Check::absolute(quantity, "-", (delay, 0.0), TOLERANCE, words)
    });
    let mut figure = Figure::new(
        "radius",
        "Collapse far from walls",
        ("time", "s"),
        ("bubble radius", "m"),
    );
    figure.add("this program", Style::Line, ours.clone());
    figure.add("Rayleigh", Style::Dashed, exact.clone());
    Ok(Finding {
        checks: checks.collect(),
        figures: vec![figure],
        notes: vec![
            super::near_wall::note(session),
            "60 MPa everywhere from the start, where the thesis lets a wave arrive; Rayleigh's liquid is not compressible. This program is ahead of \
             it, most at the beginning: in a compressible liquid the wall of the bubble moves at once with p/(rho c), in his it begins at rest. \
             The validation rayleigh-collapse compares with a compressible solution."
                .into(),
        ],
    }
    .into())
}

/// When the radius first falls to `radius`, between points by a straight line.
fn time_at(curve: &[[f64; 2]], radius: f64) -> f64 {
    let pair = curve
        .windows(2)
        .find(|p| p[0][1] > radius && p[1][1] <= radius);
    pair.map_or(f64::NAN, |p| crossing(p[0], p[1], radius))
}
