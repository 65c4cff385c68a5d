//! The formulae of nuclei, near-wall collapse and erosion against independent evaluations.

use super::check::Check;
use super::rows::columns;
use super::{Failure, Figure, Finding, Style, Validation};
use erode_physics::erosion::{
    Assessment, LagrangianModel, NearWallCollapse, STANDOFF_RANGE, critical_speed, pressure_ratio,
    water_hammer,
};
use erode_physics::near_wall::{
    anisotropy_of_wall, displacement, prolongation, prolongation_first_order,
};
use erode_physics::nuclei::{NucleiDistribution, measured_as_printed};

pub(super) const VALIDATION: Validation = Validation {
    name: "erosion-formulae",
    description: "nuclei, asymmetric pressure, displacement, critical speed, prolongation near a wall",
    reference: "independent evaluation of Peters and el Moctar 2020, eqs 3.44 to 3.61, and of the image theory of a wall \
                (validation/erosion-formulae)",
    run,
};

const ASYMMETRY: &str =
    include_str!("../../../../validation/erosion-formulae/p_asym_over_p_spher.csv");
const CRITICAL: &str = include_str!("../../../../validation/erosion-formulae/v_crit.csv");
const NUCLEI: &str =
    include_str!("../../../../validation/erosion-formulae/nuclei_distribution.csv");
const PROLONGATION: &str = include_str!("../../../../validation/erosion-formulae/prolongation.csv");

const REASON: &str = "issue 6: formulae, not models; rounding and the digits of the table";
const SOUND_SPEED: f64 = 1450.0;

fn run(_quick: bool, say: &mut dyn FnMut(&str)) -> Result<Finding, Failure> {
    let mut finding = Finding::default();
    say("formulae");
    asymmetry(&mut finding)?;
    critical(&mut finding)?;
    nuclei(&mut finding)?;
    near_wall(&mut finding)?;
    Ok(finding)
}

fn largest(errors: impl Iterator<Item = f64>) -> f64 {
    // Not a number must not be passed over.
    errors.fold(0.0, |m: f64, e| if e.abs() <= m { m } else { e.abs() })
}

fn judged(finding: &mut Finding, quantity: &str, error: f64) {
    let check = Check::absolute(quantity, "-", (error, 0.0), 1e-10, REASON);
    finding.checks.push(check);
}

/// Distance after the displacement over the largest radius, as the erosion model has it.
fn corrected_distance(standoff: f64) -> f64 {
    let collapse = NearWallCollapse {
        max_radius: 1.0,
        min_radius: 1e-3,
        pressure: 1.0,
        wall_distance: standoff,
    };
    match LagrangianModel::default().assess(&collapse) {
        Assessment::Impact(impact) => impact.corrected_distance,
        _ => f64::NAN,
    }
}

fn asymmetry(finding: &mut Finding) -> Result<(), Failure> {
    let rows = columns(ASYMMETRY, [0, 1, 2, 3, 4, 5])?;
    let inside = || rows.iter().filter(|r| STANDOFF_RANGE.contains(&r[0]));
    let ratio =
        |g: f64| pressure_ratio(g).map_or([f64::NAN; 3], |p| [p.first, p.second, p.total()]);
    for (k, name) in [
        "first collapse (3.57)",
        "second collapse (3.58)",
        "both (3.59)",
    ]
    .iter()
    .enumerate()
    {
        let error = largest(inside().map(|r| ratio(r[0])[k] - r[k + 1]));
        judged(
            finding,
            &format!("pressure over spherical, {name}: largest error"),
            error,
        );
    }
    let moved = |g: f64| -displacement(anisotropy_of_wall(g)).over_max_radius;
    let error = largest(
        rows.iter()
            .filter(|r| r[0] > 0.0)
            .map(|r| moved(r[0]) - r[4]),
    );
    judged(
        finding,
        "displacement over largest radius (3.55): largest error",
        error,
    );
    let error = largest(inside().map(|r| corrected_distance(r[0]) - r[5]));
    judged(
        finding,
        "corrected wall distance (3.56): largest error",
        error,
    );
    let outside = rows.iter().filter(|r| !STANDOFF_RANGE.contains(&r[0]));
    let accepted = outside.filter(|r| pressure_ratio(r[0]).is_some()).count();
    finding.checks.push(Check::absolute(
        "stand-offs outside 0.2 to 3 that are not refused",
        "-",
        (accepted as f64, 0.0),
        0.0,
        "the fit does not hold there",
    ));
    let mut figure = Figure::new(
        "asymmetric-pressure",
        "Collapse pressure near a wall",
        ("stand-off", "-"),
        ("pressure over spherical", "-"),
    );
    figure.add(
        "this program",
        Style::Line,
        inside().map(|r| [r[0], ratio(r[0])[2]]).collect(),
    );
    figure.add(
        "independent evaluation",
        Style::Dashed,
        inside().map(|r| [r[0], r[3]]).collect(),
    );
    finding.figures.push(figure);
    Ok(())
}

fn critical(finding: &mut Finding) -> Result<(), Failure> {
    let rows = columns(CRITICAL, [0, 1, 2, 3, 4, 5])?;
    let speed = |r: &[f64; 6]| critical_speed(r[0], r[1], r[2], r[3]);
    judged(
        finding,
        "critical speed (3.47): largest relative error",
        largest(rows.iter().map(|r| speed(r) / r[4] - 1.0)),
    );
    // The table has nine digits.
    let hammer = largest(
        rows.iter()
            .map(|r| water_hammer(r[1], SOUND_SPEED, speed(r)) / r[5] - 1.0),
    );
    finding.checks.push(Check::absolute(
        "water hammer (3.45): largest relative error",
        "-",
        (hammer, 0.0),
        6e-9,
        "the table has nine digits",
    ));
    Ok(())
}

fn nuclei(finding: &mut Finding) -> Result<(), Failure> {
    let rows = both_sides(columns(NUCLEI, [0, 1, 2, 3])?);
    let measured = NucleiDistribution::Measured;
    let per_um = |r: f64| measured.density(r).unwrap_or(f64::NAN) * 1e-6;
    let at = |f: &dyn Fn(f64) -> f64, k: usize| {
        let positive = rows.iter().filter(|r| r[0] > 0.0);
        largest(positive.map(|r| f(r[0] * 1e-6) - r[k]))
    };
    judged(
        finding,
        "density of nuclei as printed (3.44): largest error, 1/um",
        at(&|r| measured_as_printed(r) * 1e-6, 1),
    );
    judged(
        finding,
        "density of nuclei, normalised: largest error, 1/um",
        at(&per_um, 2),
    );
    judged(
        finding,
        "distribution function of nuclei: largest error",
        at(&|r| measured.cumulative(r), 3),
    );
    let mut figure = Figure::new(
        "nuclei",
        "Measured nuclei, normalised",
        ("radius", "m"),
        ("probability density", "1/m"),
    );
    let points = |k: usize| rows.iter().map(|r| [r[0] * 1e-6, r[k] * 1e6]).collect();
    figure.add(
        "this program",
        Style::Line,
        rows.iter()
            .map(|r| [r[0] * 1e-6, per_um(r[0] * 1e-6) * 1e6])
            .collect(),
    );
    figure.add("independent evaluation", Style::Dashed, points(2));
    finding.figures.push(figure);
    Ok(())
}

/// The table has two rows for the joint of both parts, one for each side; the second stands for a radius 1e-7 um beyond.
fn both_sides(mut rows: Vec<[f64; 4]>) -> Vec<[f64; 4]> {
    for k in 1..rows.len() {
        if rows[k][0] == rows[k - 1][0] {
            rows[k][0] += 1e-7;
        }
    }
    rows
}

fn near_wall(finding: &mut Finding) -> Result<(), Failure> {
    let rows: Vec<[f64; 4]> = columns(PROLONGATION, [0, 1, 2, 3])?;
    let value = |x: Option<f64>| x.unwrap_or(f64::NAN);
    let full = largest(rows.iter().map(|r| value(prolongation(r[0])) - r[1]));
    let first = largest(
        rows.iter()
            .map(|r| value(prolongation_first_order(r[0])) - r[2]),
    );
    for (name, error) in [("image theory", full), ("first order", first)] {
        finding.checks.push(Check::absolute(
            format!("prolongation near a wall, {name}: largest error"),
            "-",
            (error, 0.0),
            1e-5,
            "the table has five decimals",
        ));
    }
    Ok(())
}
