//! Collapse of an empty spherical cavity in water at 60 MPa.

mod collapse;
mod history;
mod reference;
mod refined;

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

/// Particles per radius at the start, and of the radius that the cavity has later.
const REFINED: (usize, usize) = (30, 20);
const REFINED_QUICK: (usize, usize) = (15, 15);

/// Radii between which times are judged, R/R0.
const RANGE: (f64, f64) = (0.3, 0.94);

/// Radii between which errors enter the order, R/R0.
const ORDER_RANGE: (f64, f64) = (0.3, 0.9);

/// Radii at which times are listed, R/R0.
const LISTED: [f64; 6] = [0.94, 0.9, 0.8, 0.7, 0.5, 0.3];

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
        runs.push(collapse::run(n, None)?);
    }
    let mut finding = Finding::default();
    for run in &runs {
        if let Some(asked) = ASKED.iter().find(|a| a.n == run.n) {
            finding.checks.extend(judge(run, asked, &reference)?);
        }
        finding.checks.extend(common(run, &reference));
        finding.notes.push(format!(
            "n = {}: {} particles, {} steps",
            run.n, run.particles[0], run.steps
        ));
    }
    finding.checks.extend(orders(&runs, &reference)?);
    let (n, kept) = if quick { REFINED_QUICK } else { REFINED };
    say(&format!("{n} particles per radius, refined to {kept}"));
    let run = collapse::run(n, Some(kept))?;
    finding.checks.extend(refined::judge(&run, &reference)?);
    finding.notes.push(refined::note(&run));
    finding.notes.push(refined::beside(&runs, &run, &reference));
    runs.push(run);
    finding.figures.push(radius_figure(&runs, &reference));
    finding.figures.push(speed_figure(&runs, &reference));
    Ok(finding)
}

const TIME_REASON: &str = "issue 2; first-order loss at the free surface, found to be 1.3 % at most with 60 and 2 % with 30 \
                           particles per radius in the experiments that chose the formulation";
const START_REASON: &str = "not judged: the void of a lattice cut by a circle has the radius R0 to 0.05 % at best, which \
                            alone is 2 % of the time to 0.98 R0 and 1 % of that to 0.96 R0";
const SPEED_REASON: &str = "issue 2; the same experiments found 6 to 10 % too slow";
const ROUND_REASON: &str =
    "issue 2; a lattice loses the roundness of the start as parcels change their order";

/// What is asked of this resolution.
fn judge(run: &Collapse, asked: &Asked, reference: &Reference) -> Result<Vec<Check>, Failure> {
    let n = run.n;
    let mut checks = times(run, asked.time, reference)?;
    checks.push(Check::relative(
        format!("n = {n}: wall speed at R = 0.5 R0"),
        "m/s",
        (run.speed_at(0.5)?, reference.at(0.5)?.speed),
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
    checks.push(Check::absolute(
        format!(
            "n = {n}: defect of the energy ledger at R = 0.3 R0 in units of the initial energy"
        ),
        "-",
        (run.ledger_defect()?, 0.0),
        0.01,
        "issue 2: the ledger closes to 1 %",
    ));
    Ok(checks)
}

/// Times at the radii of the reference.
fn times(run: &Collapse, tolerance: f64, reference: &Reference) -> Result<Vec<Check>, Failure> {
    let n = run.n;
    let mut checks = Vec::new();
    let (mut worst, mut place) = (0.0_f64, 1.0);
    for row in reference.between(RANGE.0, 0.98) {
        let (radius, time) = (row.radius, run.time_at(row.radius)?);
        let quantity = format!("n = {n}: time at R = {radius} R0");
        if radius > RANGE.1 + 1e-9 {
            checks.push(Check::shown(
                quantity,
                "s",
                time,
                Some(row.time),
                START_REASON,
            ));
            continue;
        }
        if (time / row.time - 1.0).abs() > worst.abs() {
            (worst, place) = (time / row.time - 1.0, radius);
        }
        if LISTED.iter().any(|r| (r - radius).abs() < 1e-9) {
            let pair = (time, row.time);
            checks.push(Check::relative(quantity, "s", pair, tolerance, TIME_REASON));
        }
    }
    let (low, high) = RANGE;
    checks.push(Check::absolute(
        format!("n = {n}: largest relative error of the time, R = {high} to {low} R0 (at {place})"),
        "-",
        (worst, 0.0),
        tolerance,
        TIME_REASON,
    ));
    Ok(checks)
}

/// What is reported of every resolution.
fn common(run: &Collapse, reference: &Reference) -> Vec<Check> {
    let n = run.n;
    let predicted = collapse::resolved_radius(n);
    let resolved = Check::shown(
        format!("n = {n}: radius where the wall speed is first wrong by 10 %"),
        "R0",
        reference.speed_lost(run, 0.1),
        Some(predicted),
        "reported; (4/n)^(2/3) is where a stretched lattice has four spacings per radius left",
    );
    let start = Check::shown(
        format!("n = {n}: radius of the void at the start"),
        "R0",
        run.samples[0].radius,
        Some(1.0),
        "reported; a lattice cut by a circle does not have the volume of the ball, times are not corrected for it",
    );
    vec![start, resolved]
}

/// Root mean square of the error of the time in units of R0/c0 over the table, for radii (R/R0) in [`ORDER_RANGE`].
///
/// `start` is the radius from which the collapse is taken to begin, R/R0: a collapse from there has times and radii
/// that are larger by this factor.
fn time_error(run: &Collapse, reference: &Reference, start: f64) -> Result<f64, Failure> {
    let (mut sum, mut count) = (0.0, 0.0);
    for row in reference.between(ORDER_RANGE.0, ORDER_RANGE.1) {
        let error = run.time_at(row.radius * start)? / start - row.time;
        sum += (error * C0 / R0).powi(2);
        count += 1.0;
    }
    Ok(f64::sqrt(sum / count))
}

/// Observed order over all resolutions, which double from one to the next.
fn orders(runs: &[Collapse], reference: &Reference) -> Result<Vec<Check>, Failure> {
    let errors = |corrected: bool| -> Result<Vec<f64>, Failure> {
        let start = |r: &Collapse| if corrected { r.samples[0].radius } else { 1.0 };
        runs.iter()
            .map(|r| time_error(r, reference, start(r)))
            .collect()
    };
    let order = |e: &[f64]| (e[0] / e[e.len() - 1]).log2() / (e.len() - 1) as f64;
    let (plain, corrected) = (errors(false)?, errors(true)?);
    let list = |e: &[f64]| {
        e.iter()
            .map(|e| format!("{e:.4}"))
            .collect::<Vec<_>>()
            .join(", ")
    };
    let n = runs
        .iter()
        .map(|r| r.n.to_string())
        .collect::<Vec<_>>()
        .join(", ");
    let (low, high) = ORDER_RANGE;
    let mut checks = vec![Check::at_least(
        format!(
            "order over n = {n} of the rms error of the time, R = {high} to {low} R0 ({} R0/c0)",
            list(&plain)
        ),
        "-",
        order(&plain),
        0.8,
        "issue 2; the scheme is first order at the free surface; least-squares slope over equal ratios of n",
    )];
    checks.push(Check::shown(
        format!(
            "the same with times and radii scaled to the void of the start ({} R0/c0)",
            list(&corrected)
        ),
        "-",
        order(&corrected),
        None,
        "shown to tell the error of the packing from that of the scheme",
    ));
    for (pair, two) in plain.windows(2).zip(runs.windows(2)) {
        checks.push(Check::shown(
            format!("the first from n = {} to {} alone", two[0].n, two[1].n),
            "-",
            order(pair),
            None,
            "shown: errors below 0.02 R0/c0 (0.4 % of the collapse time) hardly fall any more",
        ));
    }
    Ok(checks)
}

/// Name of a run in a figure.
fn curve(run: &Collapse) -> String {
    match run.refined {
        None => format!("{} per radius", run.n),
        Some(kept) => format!("{} per radius, refined to {kept}", run.n),
    }
}

fn radius_figure(runs: &[Collapse], reference: &Reference) -> Figure {
    let mut figure = Figure::new(
        "rayleigh-collapse-radius",
        "Radius of an empty cavity in water, 60 MPa",
        ("time", "s"),
        ("radius/initial radius", "-"),
    );
    for run in runs {
        let points = run.samples.iter().map(|s| [s.time, s.radius]).collect();
        figure.add(&curve(run), Style::Line, points);
    }
    let rows = &reference.rows;
    let compressible = rows.iter().map(|r| [r.time, r.radius]).collect();
    figure.add("reference, compressible", Style::Dashed, compressible);
    let rayleigh = rows.iter().map(|r| [r.rayleigh, r.radius]).collect();
    figure.add("Rayleigh, incompressible", Style::Dashed, rayleigh);
    figure
}

fn speed_figure(runs: &[Collapse], reference: &Reference) -> Figure {
    let mut figure = Figure::new(
        "rayleigh-collapse-speed",
        "Wall speed of an empty cavity in water, 60 MPa",
        ("radius/initial radius", "-"),
        ("speed", "m/s"),
    );
    let shown = || reference.between(0.1, 0.94);
    for run in runs {
        let at = |radius: f64| run.speed_at(radius).ok().map(|v| [radius, v]);
        let points = shown().filter_map(|r| at(r.radius)).collect();
        figure.add(&curve(run), Style::Line, points);
    }
    let points = shown().map(|r| [r.radius, r.speed]).collect();
    figure.add("reference, compressible", Style::Dashed, points);
    figure
}
