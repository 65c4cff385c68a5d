//! A bubble in an acoustic field, with four laws, against an independent program.

use super::rows;
use super::sampler::Sampler;
use crate::validate::{Check, Failure, Figure, Finding, Style, Validation};
use erode_physics::bubble::{
    BubbleState, Controls, Driving, Energy, Event, EventKind, Gas, Gilmore, KellerMiksis, Liquid,
    Model, RayleighPlesset, Sine, Switching, advance, equilibrium_gas,
};

pub(in crate::validate) const VALIDATION: Validation = Validation {
    name: "bubble-acoustic",
    description: "radius of a bubble in an acoustic field over two periods: Rayleigh-Plesset, Keller-Miksis, Gilmore, \
                  switching",
    reference: "an independent program of order 8 at a tolerance of 1e-12 (validation/bubble-acoustic); case of Peters \
                and el Moctar 2020, section 4.1",
    run,
};

/// A law with its reference tables.
struct Case {
    model: Model,
    title: &'static str,
    curve: &'static str,
    extremes: &'static str,
}

macro_rules! data {
    ($name:literal) => {
        include_str!(concat!(
            "../../../../../validation/bubble-acoustic/",
            $name,
            ".csv"
        ))
    };
}

fn cases() -> [Case; 4] {
    let case = |model, title, curve, extremes| Case {
        model,
        title,
        curve,
        extremes,
    };
    [
        case(
            Model::RayleighPlesset(RayleighPlesset),
            "Rayleigh-Plesset",
            data!("rayleigh_plesset"),
            data!("rayleigh_plesset_extremes"),
        ),
        case(
            Model::KellerMiksis(KellerMiksis),
            "Keller-Miksis",
            data!("keller_miksis"),
            data!("keller_miksis_extremes"),
        ),
        case(
            Model::Gilmore(Gilmore::default()),
            "Gilmore",
            data!("gilmore"),
            data!("gilmore_extremes"),
        ),
        case(
            Model::Switching(Switching::default()),
            "switching",
            data!("switching"),
            data!("switching_extremes"),
        ),
    ]
}

const LIQUID: Liquid = Liquid::WATER;
const RADIUS: f64 = 8e-6;
const FREQUENCY: f64 = 21.4e3;
const DRIVING: Sine = Sine {
    mean: 1e5,
    amplitude: 132e3,
    frequency: FREQUENCY,
};
/// Radii above this are away from the smallest radius, m.
const AWAY: f64 = 2e-6;
/// Full and quick tolerance of the integrator.
const TOLERANCES: [f64; 2] = [1e-12, 1e-10];

fn run(quick: bool, say: &mut dyn FnMut(&str)) -> Result<Finding, Failure> {
    let mut finding = Finding::default();
    let mut figure = Figure::new(
        "bubble-acoustic",
        "Bubble in an acoustic field",
        ("time", "s"),
        ("radius", "m"),
    );
    for case in cases() {
        say(case.title);
        let curve = rows::<3>(case.curve)?;
        let extremes = rows::<4>(case.extremes)?;
        let (samples, events, drift) =
            integrate(&case.model, &curve, TOLERANCES[usize::from(quick)])?;
        let radius = curve
            .iter()
            .zip(&samples)
            .filter(|(row, _)| row[1] > AWAY)
            .fold(0.0_f64, |worst, (row, got)| {
                worst.max((got[0] / row[1] - 1.0).abs())
            });
        let mut check = |what: &str, error: f64, tolerance: f64, reason: &str| {
            let quantity = format!("{}: {what}", case.title);
            finding.checks.push(Check::absolute(
                quantity,
                "-",
                (error, 0.0),
                tolerance,
                reason,
            ));
        };
        let worst = |what: Reading, largest: bool| worst(&events, &extremes, what, largest);
        check(
            "largest relative error of R(t) above 2 um",
            radius,
            1e-6,
            "issue 6",
        );
        check(
            "largest relative error of all largest radii",
            worst(Reading::Radius, true),
            1e-6,
            "issue 6",
        );
        check(
            "largest relative error of all smallest radii",
            worst(Reading::Radius, false),
            1e-4,
            "issue 6",
        );
        check(
            "largest error of the times of all extremes / period",
            worst(Reading::Time, true).max(worst(Reading::Time, false)),
            1e-8,
            "a collapse lasts 1e-1 periods and its last part, in which the radius halves, 1e-4",
        );
        check(
            "energy that the ledger misses / energy put in",
            drift,
            1e-6,
            "issue 6",
        );
        draw(&mut figure, case.title, &curve, &samples);
    }
    finding.figures.push(figure);
    Ok(finding)
}

/// Samples at the times of the reference, events, and the largest drift of the ledger over the largest energy put in.
#[allow(clippy::type_complexity)]
fn integrate(
    model: &Model,
    curve: &[[f64; 3]],
    tolerance: f64,
) -> Result<(Vec<[f64; 2]>, Vec<Event>, f64), Failure> {
    let gas: Gas = equilibrium_gas(&LIQUID, RADIUS, DRIVING.mean, 4.0 / 3.0)?;
    let mut state = BubbleState::at_rest(RADIUS, 0.0)?;
    let controls = Controls {
        tolerance,
        ..Controls::default()
    };
    let mut sampler = Sampler::new(curve.iter().map(|r| r[0]).collect());
    let energy =
        |state: &BubbleState| -> Energy { state.energy(&LIQUID, &gas, &DRIVING.at(state.time)) };
    let begin = energy(&state).total();
    let (mut drift, mut put_in) = (0.0_f64, 0.0_f64);
    let last = curve.last().map_or(0.0, |row| row[0]);
    for i in 1..=100 {
        let until = last * f64::from(i) / 100.0;
        advance(
            model,
            &LIQUID,
            &gas,
            &DRIVING,
            &controls,
            &mut state,
            until,
            &mut sampler,
        )?;
        let now = energy(&state);
        drift = drift.max((now.total() - begin).abs());
        put_in = put_in.max(now.driven.abs());
    }
    if sampler.values.len() < curve.len() {
        return Err(Failure::Absent("the run ended before the reference".into()));
    }
    Ok((sampler.values, sampler.events, drift / put_in))
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Reading {
    Radius,
    Time,
}

/// Largest error over all extremes of a kind; not a number if there are not as many as in the reference.
fn worst(events: &[Event], extremes: &[[f64; 4]], what: Reading, largest: bool) -> f64 {
    let ours: Vec<&Event> = events
        .iter()
        .filter(|e| (e.kind == EventKind::CollapseBegins) == largest)
        .collect();
    let theirs: Vec<&[f64; 4]> = extremes
        .iter()
        .filter(|r| (r[0] == 1.0) == largest)
        .collect();
    if ours.len() != theirs.len() {
        return f64::NAN;
    }
    let error = |e: &Event, r: &[f64; 4]| match what {
        Reading::Radius => e.radius / r[2] - 1.0,
        Reading::Time => (e.time - r[1]) * FREQUENCY,
    };
    let errors = ours.iter().zip(theirs).map(|(e, r)| error(e, r).abs());
    errors.fold(0.0, f64::max)
}

fn draw(figure: &mut Figure, title: &str, curve: &[[f64; 3]], samples: &[[f64; 2]]) {
    let line = curve.iter().zip(samples).map(|(r, s)| [r[0], s[0]]);
    figure.add(title, Style::Line, line.collect());
    let dots = curve.iter().step_by(8).map(|r| [r[0], r[1]]);
    figure.add(
        &format!("{title}, reference"),
        Style::Points,
        dots.collect(),
    );
}
