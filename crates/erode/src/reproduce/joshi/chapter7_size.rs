//! Figures 7.7 to 7.9: the effect of the size of the bubble.

use super::super::Options;
use super::super::session::{Judged, Need, Ran, Session};
use super::near_wall::{Collapse, at, exceeds, largest, mean, note, smallest};
use crate::analysis::power_law;
use crate::validate::{Check, Failure, Figure, Finding, Style};
use std::f64::consts::PI;

const RADII: [f64; 3] = [0.1, 0.15, 0.2];

fn of_radius(radius: f64) -> Collapse {
    Collapse { radius, ..at(1.33) }
}

pub(super) fn size_needs(options: &Options) -> Vec<Need> {
    RADII.iter().map(|r| of_radius(*r).need(options)).collect()
}

fn over_size(session: &Session) -> Result<Vec<Ran>, Failure> {
    RADII
        .iter()
        .map(|r| of_radius(*r).results(session))
        .collect()
}

/// (largest - smallest) / mean.
fn spread(values: &[f64]) -> f64 {
    (largest(values) - smallest(values)) / mean(values)
}

/// Exponent of the power law through all points; not a number where one of them is not positive.
fn exponent(points: &[[f64; 2]]) -> f64 {
    let all = points.iter().all(|p| p[1] > 0.0);
    let law = power_law(points).filter(|_| all);
    law.map_or(f64::NAN, |law| law[0])
}

/// Not a number where the metal did not yield: all statements compare.
fn all(runs: &[Ran], name: &str) -> Vec<f64> {
    runs.iter().map(|r| r.of_yielded(name)).collect()
}

/// How far values may spread that are "almost the same": the text gives no number.
const ALMOST: f64 = 0.15;

fn against_radius(name: &str, quantity: (&str, &str), values: &[f64]) -> Figure {
    let mut figure = Figure::new(name, "Size of the bubble", ("bubble radius", "m"), quantity);
    figure.add(
        "",
        Style::Line,
        RADII
            .iter()
            .zip(values)
            .map(|(r, v)| [r * 1e-3, *v])
            .collect(),
    );
    figure
}

pub(super) fn strain_of_size(session: &Session) -> Result<Judged, Failure> {
    let runs = over_size(session)?;
    let strain = all(&runs, "max_plastic_strain");
    let mut near = Vec::new();
    for run in &runs {
        let metal = run.metal()?;
        let close = metal.position.iter().zip(&metal.plastic_strain);
        let close = close.filter(|(x, _)| x[0] < 1.5 * metal.spacing);
        near.push(largest(&close.map(|(_, e)| *e).collect::<Vec<f64>>()));
    }
    let mut checks = vec![Check::absolute(
        "largest strain: (largest - smallest) / mean over the radii",
        "-",
        (spread(&strain), 0.0),
        ALMOST,
        "\"the maximum plastic strain remains almost the same for different bubble radii\": no number is given, 15 % is taken",
    )];
    let words = "\"the plastic strain close to the symmetry axis decreases as the bubble radius increases\"";
    for (small, large) in [(0, 1), (1, 2)] {
        let quantity = format!(
            "strain next to the axis, {} mm / {} mm",
            RADII[small], RADII[large]
        );
        checks.push(exceeds(&quantity, (near[small], near[large]), words));
    }
    let pictures = RADII.iter().zip(&runs);
    Ok(Judged {
        finding: Finding {
            checks,
            figures: vec![against_radius(
                "strain",
                ("largest plastic strain", "-"),
                &strain,
            )],
            notes: vec![note(session)],
        },
        pictures: pictures
            .filter_map(|(r, run)| run.picture(&format!("radius {r} mm")))
            .collect(),
    })
}

pub(super) fn energy_of_size(session: &Session) -> Result<Judged, Failure> {
    let runs = over_size(session)?;
    let energy = all(&runs, "plastic_work");
    let density = all(&runs, "absorbed_energy_density");
    let points: Vec<[f64; 2]> = RADII.iter().zip(&energy).map(|(r, e)| [*r, *e]).collect();
    let exponent = exponent(&points);
    let words =
        "\"the total absorbed energy increases significantly with increasing bubble radius\"";
    let mut checks = vec![Check::absolute(
        "energy density: (largest - smallest) / mean over the radii",
        "-",
        (spread(&density), 0.0),
        ALMOST,
        "\"exhibits almost similar values for all bubble radii\": no number is given, 15 % is taken",
    )];
    for (small, large) in [(0, 1), (1, 2)] {
        let quantity = format!("absorbed energy, {} mm / {} mm", RADII[large], RADII[small]);
        checks.push(exceeds(&quantity, (energy[large], energy[small]), words));
    }
    checks.push(Check::shown(
        "exponent of the absorbed energy in the radius",
        "-",
        exponent,
        Some(3.0),
        "3 where everything scales with the bubble; the strain rate does not",
    ));
    Ok(Finding {
        checks,
        figures: vec![
            against_radius("density", ("absorbed energy density", "J/m3"), &density),
            against_radius("energy", ("absorbed energy", "J"), &energy),
        ],
        notes: vec![note(session)],
    }
    .into())
}

pub(super) fn volume_of_size(session: &Session) -> Result<Judged, Failure> {
    let runs = over_size(session)?;
    let volume = all(&runs, "plastic_volume");
    let bubble = RADII.map(|r| 4.0 / 3.0 * PI * (r * 1e-3).powi(3));
    let points: Vec<[f64; 2]> = bubble.iter().zip(&volume).map(|(b, v)| [*b, *v]).collect();
    let exponent = exponent(&points);
    let mut figure = Figure::new(
        "volume",
        "Plastic volume",
        ("volume of the bubble", "m3"),
        ("plastic volume", "m3"),
    );
    figure.add("", Style::Line, points);
    let words = "\"as the bubble volume increases the plastic zone volume increases linearly\": exponent 1 within 10 %";
    Ok(Finding {
        checks: vec![Check::absolute(
            "exponent of the plastic volume in the volume of the bubble",
            "-",
            (exponent, 1.0),
            0.1,
            words,
        )],
        figures: vec![figure],
        notes: vec![note(session)],
    }
    .into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_law_through_what_is_left_is_no_law() {
        let points =
            |y: [f64; 3]| -> Vec<[f64; 2]> { RADII.iter().zip(y).map(|(r, y)| [*r, y]).collect() };
        let cubes = RADII.map(|r| 5.0 * r.powi(3));
        assert!((exponent(&points(cubes)) - 3.0).abs() < 1e-12);
        assert!(exponent(&points([cubes[0], f64::NAN, cubes[2]])).is_nan());
        assert!(exponent(&points([0.0, cubes[1], cubes[2]])).is_nan());
        assert!(spread(&[1.0, f64::NAN]).is_nan() && spread(&[0.0, 0.0]).is_nan());
        assert!((spread(&[1.0, 2.0, 3.0]) - 1.0).abs() < 1e-15);
    }
}
