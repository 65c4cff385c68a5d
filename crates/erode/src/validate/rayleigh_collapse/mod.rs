//! Collapse of an empty spherical cavity in water at 60 MPa.

mod collapse;
mod history;
mod reference;

use super::check::Check;
use super::{Failure, Figure, Finding, Style, Validation};
use collapse::{C0, Collapse, R0};
use reference::Reference;

pub(super) const VALIDATION: Validation = Validation {
    name: "rayleigh-collapse",
    description: "an empty spherical cavity of 0.095 mm collapses in water, 60 MPa everywhere at the start",
    reference: "compressible collapse by an independent moving-mesh Godunov solver, error 2e-6 in time \
                (validation/rayleigh-collapse); the incompressible curve of Rayleigh is shown beside it",
    run,
};

/// Particles per radius.
const QUICK: &[usize] = &[15, 30];
const FULL: &[usize] = &[15, 30, 60];

/// Radii between which times are judged, R/R0.
const RANGE: (f64, f64) = (0.3, 0.98);

/// Radii at which times are listed, R/R0.
const SHOWN: [f64; 5] = [0.9, 0.8, 0.7, 0.5, 0.3];

/// What is asked of a resolution.
struct Asked {
    n: usize,
    time: f64,
    speed: f64,
    roundness: f64,
}

const ASKED: [Asked; 2] = [
    Asked {
        n: 30,
        time: 0.02,
        speed: 0.10,
        roundness: 0.10,
    },
    Asked {
        n: 60,
        time: 0.015,
        speed: 0.06,
        roundness: 0.05,
    },
];

fn run(quick: bool, say: &mut dyn FnMut(&str)) -> Result<Finding, Failure> {
    let reference = reference::read()?;
    let mut runs = Vec::new();
    for &n in if quick { QUICK } else { FULL } {
        say(&format!("{n} particles per radius"));
        runs.push(collapse::run(n)?);
    }
    let mut finding = Finding::default();
    for run in &runs {
        if let Some(asked) = ASKED.iter().find(|a| a.n == run.n) {
            finding.checks.extend(judge(run, asked, &reference)?);
        }
        finding.checks.extend(common(run, &reference)?);
    }
    finding.checks.push(order(&runs, &reference)?);
    finding.figures.push(radius_figure(&runs, &reference));
    finding.figures.push(speed_figure(&runs, &reference)?);
    Ok(finding)
}

const TIME_REASON: &str = "issue 2; the start lags by about one spacing over the sound speed, then a first-order loss at \
                           the free surface";
const SPEED_REASON: &str =
    "issue 2; twice what was measured for this formulation at half the radius";
const ROUND_REASON: &str =
    "issue 2; a lattice loses the roundness of the start as parcels change their order";

/// What is asked of this resolution.
fn judge(run: &Collapse, asked: &Asked, reference: &Reference) -> Result<Vec<Check>, Failure> {
    let n = run.n;
    let mut checks = Vec::new();
    let (mut worst, mut place) = (0.0_f64, 1.0);
    for row in reference.between(RANGE.0, RANGE.1) {
        let error = run.time_at(row.radius)? / row.time - 1.0;
        if error.abs() > worst.abs() {
            (worst, place) = (error, row.radius);
        }
        if SHOWN.iter().any(|r| (r - row.radius).abs() < 1e-9) {
            checks.push(Check::relative(
                format!("n = {n}: time at R = {} R0", row.radius),
                "s",
                (run.time_at(row.radius)?, row.time),
                asked.time,
                TIME_REASON,
            ));
        }
    }
    checks.push(Check::absolute(
        format!(
            "n = {n}: largest relative error of the time at R from {} to {} R0 (at {place})",
            RANGE.1, RANGE.0
        ),
        "-",
        (worst, 0.0),
        asked.time,
        TIME_REASON,
    ));
    let half = reference.at(0.5)?;
    checks.push(Check::relative(
        format!("n = {n}: wall speed at R = 0.5 R0"),
        "m/s",
        (run.speed_at(0.5)?, half.speed),
        asked.speed,
        SPEED_REASON,
    ));
    checks.push(Check::absolute(
        format!("n = {n}: (largest - smallest radius)/mean at R = 0.5 R0"),
        "-",
        (run.at(0.5)?.roundness, 0.0),
        asked.roundness,
        ROUND_REASON,
    ));
    Ok(checks)
}

fn common(run: &Collapse, reference: &Reference) -> Result<Vec<Check>, Failure> {
    let _ = (run, reference);
    Ok(vec![])
}
fn order(_: &[Collapse], _: &Reference) -> Result<Check, Failure> {
    Err(Failure::Absent(String::new()))
}
fn radius_figure(_: &[Collapse], _: &Reference) -> Figure {
    let _ = Style::Line;
    Figure::new("", "", ("", ""), ("", ""))
}
fn speed_figure(_: &[Collapse], _: &Reference) -> Result<Figure, Failure> {
    Err(Failure::Absent(String::new()))
}
#[cfg(test)]
mod probe {
    use super::*;
    #[test]
    fn probe() {
        let reference = reference::read().unwrap();
        for n in [15, 20, 30, 40, 60] {
            let t0 = std::time::Instant::now();
            let run = collapse::run(n).unwrap();
            println!(
                "n {n} particles {} steps {} wall {:.1} R(0) {:.5} round0 {:.4}",
                run.particles,
                run.steps,
                t0.elapsed().as_secs_f64(),
                run.samples[0].radius,
                run.samples[0].roundness
            );
            let e0 = run.samples[0].energy;
            for row in reference
                .rows
                .iter()
                .filter(|r| r.radius < 0.99 && r.radius > 0.12)
            {
                let t = history::time_at(&run.samples, row.radius);
                let v = history::speed_at(&run.samples, row.radius);
                let Some(s) = history::sample_at(&run.samples, row.radius) else {
                    break;
                };
                println!(
                    "  R {:.2} dt {:+.4} R0/c0 rel {:+.2}% v {:+.1}% round {:.3} E {:+.5} of pV0 {:+.4}",
                    row.radius,
                    t.map_or(f64::NAN, |t| (t - row.time) * C0 / R0),
                    t.map_or(f64::NAN, |t| 100.0 * (t / row.time - 1.0)),
                    v.map_or(f64::NAN, |v| 100.0 * (v * R0 / row.speed - 1.0)),
                    s.roundness,
                    (s.energy + s.balance) / e0 - 1.0,
                    (s.energy + s.balance - e0) / (60e6 * 4.18879 * R0.powi(3))
                );
            }
        }
    }
}
