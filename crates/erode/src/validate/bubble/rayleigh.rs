//! Collapse of an empty cavity against the exact solution of Rayleigh 1917.

use super::rows;
use super::sampler::Sampler;
use crate::validate::{Check, Failure, Figure, Finding, Style, Validation};
use erode_physics::bubble::{
    BubbleState, Constant, Controls, EventKind, Gas, Liquid, RayleighPlesset, advance,
};

pub(in crate::validate) const VALIDATION: Validation = Validation {
    name: "bubble-rayleigh",
    description: "radius of an empty spherical cavity that closes in incompressible liquid",
    reference: "the exact solution of Rayleigh 1917 in 40-digit arithmetic (validation/bubble-rayleigh)",
    run,
};

const OF_TIME: &str = include_str!("../../../../../validation/bubble-rayleigh/radius_of_time.csv");
const OF_RADIUS: &str =
    include_str!("../../../../../validation/bubble-rayleigh/time_of_radius.csv");
const COLLAPSE_TIME: f64 = 0.914_681_356_501_954_5;
const REASON: &str =
    "issue 6; steps at a tolerance of 1e-12, errors grow by up to 4000 towards the end";

const LIQUID: Liquid = Liquid {
    density: 1000.0,
    sound_speed: 1500.0,
    viscosity: 0.0,
    surface_tension: 0.0,
    vapour_pressure: 0.0,
};
const RADIUS: f64 = 1e-3;
const PRESSURE: f64 = 1e5;
/// R0 sqrt(rho/p), s, and sqrt(p/rho), m/s.
const TIME_UNIT: f64 = 1e-4;
const SPEED_UNIT: f64 = 10.0;

fn run(_quick: bool, say: &mut dyn FnMut(&str)) -> Result<Finding, Failure> {
    say("collapse");
    let of_time = rows::<3>(OF_TIME)?;
    let of_radius = rows::<3>(OF_RADIUS)?;
    let (samples, closed) = collapse(of_time.iter().map(|r| r[0] * TIME_UNIT).collect())?;
    let worst = |f: &dyn Fn(usize) -> f64| {
        (0..of_time.len()).fold(0.0_f64, |worst, i| worst.max(f(i).abs()))
    };
    let radius = worst(&|i| samples[i][0] / RADIUS / of_time[i][1] - 1.0);
    let speed = worst(&|i| {
        // At rest the error is absolute, in units of the reference speed.
        (samples[i][1] / SPEED_UNIT - of_time[i][2]) / of_time[i][2].abs().max(1e-3)
    });
    // The time at a radius: the table's times are sampled and the difference in radius is carried to time.
    let (at_radius, _) = collapse(of_radius.iter().map(|r| r[1] * TIME_UNIT).collect())?;
    let time = of_radius
        .iter()
        .zip(&at_radius)
        .skip(1)
        .fold(0.0_f64, |worst, (row, got)| {
            let off = (got[0] / RADIUS - row[0]) / row[2];
            worst.max((off / row[1]).abs())
        });
    let mut finding = Finding::default();
    let mut check = |what: &str, error: f64| {
        let quantity = format!("largest relative error of the {what}");
        finding
            .checks
            .push(Check::absolute(quantity, "-", (error, 0.0), 1e-8, REASON));
    };
    check("radius at a time, 0 to 0.9999 collapse times", radius);
    check("wall speed at a time, 0 to 0.9999 collapse times", speed);
    check("time at a radius, 1 to 0.001 R0", time);
    finding.checks.push(Check::relative(
        "collapse time / (R0 sqrt(rho/p))",
        "-",
        (closed, COLLAPSE_TIME),
        1e-8,
        "issue 6; the rest of the way from R0/10000 is added in closed form",
    ));
    finding.figures.push(figure(&of_time, &samples));
    Ok(finding)
}

/// Radius and speed at times, and the collapse time over its unit.
fn collapse(times: Vec<f64>) -> Result<(Vec<[f64; 2]>, f64), Failure> {
    let gas = Gas {
        pressure: 0.0,
        radius: RADIUS,
        polytropic_exponent: 1.4,
    };
    let controls = Controls {
        tolerance: 1e-12,
        ..Controls::default()
    };
    let driving = Constant { pressure: PRESSURE };
    let mut state = BubbleState::at_rest(RADIUS, 0.0)?;
    let wanted = times.len();
    let mut sampler = Sampler::new(times);
    let until = 2.0 * TIME_UNIT;
    advance(
        &RayleighPlesset,
        &LIQUID,
        &gas,
        &driving,
        &controls,
        &mut state,
        until,
        &mut sampler,
    )?;
    let closed = sampler.events.iter().any(|e| e.kind == EventKind::Closed);
    if !closed || sampler.values.len() < wanted {
        return Err(Failure::Absent("the cavity did not close".into()));
    }
    // Near the end R' = -sqrt(2/3) x^(-3/2): the rest takes 0.4 sqrt(3/2) x^(5/2).
    let rest = 0.4 * 1.5_f64.sqrt() * (state.radius / RADIUS).powf(2.5);
    Ok((sampler.values, state.time / TIME_UNIT + rest))
}

fn figure(reference: &[[f64; 3]], samples: &[[f64; 2]]) -> Figure {
    let mut figure = Figure::new(
        "bubble-rayleigh",
        "Collapse of an empty cavity",
        ("time / (R0 sqrt(rho/p))", "-"),
        ("radius / R0", "-"),
    );
    let line = reference
        .iter()
        .zip(samples)
        .map(|(r, s)| [r[0], s[0] / RADIUS]);
    figure.add("Erode", Style::Line, line.collect());
    let dots = reference.iter().step_by(10).map(|r| [r[0], r[1]]);
    figure.add("Rayleigh 1917", Style::Points, dots.collect());
    figure
}
