//! A bubble that rises from rest against the closed form of its equation of motion.

use super::check::Check;
use super::rows::columns;
use super::{Failure, Figure, Finding, Style, Validation};
use erode_fv::bubbles::carrier::Still;
use erode_fv::bubbles::forces::{DragLaw, Forces, PressureForce, volume};
use erode_fv::bubbles::{Averaging, Cloud, NewBubble, Settings};
use erode_physics::bubble::{Gas, Liquid};

pub(super) const VALIDATION: Validation = Validation {
    name: "bubble-rise",
    description: "speed and way of a 2 mm bubble rising from rest in water",
    reference: "closed form with added mass and the drag of Darmana et al. (Peters and el Moctar 2020, section 4.3; \
                validation/bubble-rise)",
    run,
};

const DATA: &str = include_str!("../../../../validation/bubble-rise/rising_bubble.csv");

const RADIUS: f64 = 2e-3;
const WATER: f64 = 1000.0;
const AIR: f64 = 1.0;
const GRAVITY: f64 = 9.81;
const SURFACE_TENSION: f64 = 0.073;
/// Printed by the source, m/s.
const PRINTED: f64 = 0.23686;

const REASON: &str = "issue 6; the step is of second order";

/// Rows of the reference: time s, speed m/s, height m.
type Row = [f64; 3];

fn run(quick: bool, say: &mut dyn FnMut(&str)) -> Result<Finding, Failure> {
    let rows: Vec<Row> = columns(DATA, [0, 1, 2])?;
    let last = rows.last().copied().unwrap_or_default();
    let parts = if quick { 4 } else { 16 };
    say(&format!("rise with {parts} steps per row"));
    let fine = rise(&rows, parts)?;
    let coarse = rise(&rows, parts / 2)?;
    let (speed, way) = worst(&rows, &fine);
    let order = (worst(&rows, &coarse).0 / speed).log2();
    let end = fine.last().copied().unwrap_or_default();
    let checks = vec![
        Check::absolute(
            "largest error of the speed over the final speed",
            "-",
            (speed / last[1], 0.0),
            1e-3,
            REASON,
        ),
        Check::absolute(
            "largest error of the height over the final height",
            "-",
            (way / last[2], 0.0),
            1e-3,
            REASON,
        ),
        Check::relative(
            "final speed",
            "m/s",
            (end[1], last[1]),
            1e-6,
            "steady state of the scheme is exact",
        ),
        Check::relative(
            "final speed printed by the source (4.10)",
            "m/s",
            (end[1], PRINTED),
            3e-5,
            "five digits are printed",
        ),
        Check::at_least(
            "order of the step",
            "-",
            order,
            1.8,
            "the scheme is of second order",
        ),
    ];
    let mut figure = Figure::new(
        "bubble-rise",
        "Bubble rising from rest",
        ("time", "s"),
        ("speed", "m/s"),
    );
    figure.add(
        "this program",
        Style::Line,
        fine.iter().map(|r| [r[0], r[1]]).collect(),
    );
    figure.add(
        "closed form",
        Style::Dashed,
        rows.iter().map(|r| [r[0], r[1]]).collect(),
    );
    Ok(Finding {
        checks,
        figures: vec![figure],
        notes: Vec::new(),
    })
}

fn settings() -> Settings {
    let forces = Forces {
        gravity: [0.0, 0.0, -GRAVITY],
        pressure: PressureForce::Gradient,
        drag: DragLaw::Gravity {
            gravity: GRAVITY,
            surface_tension: SURFACE_TENSION,
            bubble_density: AIR,
        },
        ..Forces::IN_FLOW
    };
    Settings {
        forces,
        averaging: Averaging::Centre,
        ..Settings::new(Liquid::WATER, None)
    }
}

/// Time, speed and height at the times of the rows, with steps of the row over `parts`.
fn rise(rows: &[Row], parts: u32) -> Result<Vec<Row>, Failure> {
    let flow = Still {
        pressure: 1e5,
        density: WATER,
        viscosity: 1e-3,
        gravity: [0.0, 0.0, -GRAVITY],
    };
    let (settings, mut cloud) = (settings(), Cloud::new(0.0));
    cloud.inject(&NewBubble {
        position: [0.0; 3],
        velocity: [0.0; 3],
        radius: RADIUS,
        wall_velocity: 0.0,
        gas: Gas {
            pressure: 1e5,
            radius: RADIUS,
            polytropic_exponent: 4.0 / 3.0,
        },
        mass: AIR * volume(RADIUS),
    })?;
    let mut out = Vec::with_capacity(rows.len());
    for row in rows {
        let start = cloud.time;
        for k in 1..=parts {
            let x = f64::from(k) / f64::from(parts);
            cloud.advance(&flow, &settings, start + x * (row[0] - start))?;
        }
        out.push([row[0], cloud.velocity[0][2], cloud.position[0][2]]);
    }
    Ok(out)
}

/// Largest errors of speed (m/s) and height (m).
fn worst(rows: &[Row], found: &[Row]) -> (f64, f64) {
    let error = |k: usize| {
        let differences = rows.iter().zip(found).map(|(a, b)| (a[k] - b[k]).abs());
        differences.fold(0.0, f64::max)
    };
    (error(1), error(2))
}
