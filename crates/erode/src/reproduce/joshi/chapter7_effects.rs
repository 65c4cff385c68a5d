//! Figures 7.5 to 7.10: the effects of driving pressure, bubble size and strain rate.

use super::super::Options;
use super::super::session::{Judged, Need, Ran, Session};
use super::near_wall::{Collapse, at, exceeds, note};
use crate::analysis::power_law;
use crate::validate::{Check, Failure, Figure, Finding, Style};
use std::f64::consts::PI;

const PRESSURES: [f64; 3] = [25.0, 50.0, 75.0];
const RADII: [f64; 3] = [0.1, 0.15, 0.2];
/// Detached and attached.
const PAIR: [(f64, &str); 2] = [(1.33, "detached"), (0.66, "attached")];

fn of_pressure(standoff: f64, pressure: f64) -> Collapse {
    Collapse {
        pressure,
        ..at(standoff)
    }
}

fn of_radius(radius: f64) -> Collapse {
    Collapse { radius, ..at(1.33) }
}

pub(super) fn pressure_needs(options: &Options) -> Vec<Need> {
    let all = PAIR
        .iter()
        .flat_map(|(s, _)| PRESSURES.map(|p| of_pressure(*s, p)));
    all.map(|c| c.need(options)).collect()
}

/// Runs of one stand-off over the pressures.
fn over_pressure(session: &Session, standoff: f64) -> Result<Vec<Ran>, Failure> {
    let all = PRESSURES.iter();
    all.map(|p| of_pressure(standoff, *p).results(session))
        .collect()
}

/// A value at 50 over that at 25 MPa, and at 75 over that at 50 MPa, must exceed one.
fn rising(runs: &[Ran], name: &str, words: &str, statement: &str) -> Vec<Check> {
    let pairs = [(1, 0), (2, 1)];
    let check = |(high, low): (usize, usize)| {
        let quantity = format!("{words}: {} MPa / {} MPa", PRESSURES[high], PRESSURES[low]);
        exceeds(
            &quantity,
            (runs[high].get(name), runs[low].get(name)),
            statement,
        )
    };
    pairs.into_iter().map(check).collect()
}

pub(super) fn strain_of_pressure(session: &Session) -> Result<Judged, Failure> {
    let mut judged = Judged::default();
    let mut figure = Figure::new(
        "strain",
        "Largest plastic strain",
        ("driving pressure", "Pa"),
        ("plastic strain", "-"),
    );
    let words = "\"for detached as well as attached cavities, the maximum plastic strain increases with driving pressure\"";
    for (standoff, name) in PAIR {
        let runs = over_pressure(session, standoff)?;
        let quantity = format!("largest strain, {name}");
        judged
            .finding
            .checks
            .extend(rising(&runs, "max_plastic_strain", &quantity, words));
        figure.add(name, Style::Line, curve(&runs, "max_plastic_strain"));
        for (p, run) in PRESSURES.iter().zip(&runs) {
            judged
                .pictures
                .extend(run.picture(&format!("{name}, {p} MPa")));
        }
    }
    judged.finding.figures.push(figure);
    judged.finding.notes.push(note(session));
    Ok(judged)
}

fn curve(runs: &[Ran], name: &str) -> Vec<[f64; 2]> {
    let all = PRESSURES.iter().zip(runs);
    all.map(|(p, r)| [p * 1e6, r.get(name)]).collect()
}

pub(super) fn energy_of_pressure(session: &Session) -> Result<Judged, Failure> {
    let [detached, attached] = [PAIR[0].0, PAIR[1].0].map(|s| over_pressure(session, s));
    let (detached, attached) = (detached?, attached?);
    let words = "\"a higher driving pressure leads to a higher absorbed energy density and a higher total absorbed energy\"";
    let (energy, density) = ("plastic_work", "absorbed_energy_density");
    let mut checks = Vec::new();
    for (runs, name) in [(&detached, "detached"), (&attached, "attached")] {
        checks.extend(rising(
            runs,
            density,
            &format!("energy density, {name}"),
            words,
        ));
        checks.extend(rising(
            runs,
            energy,
            &format!("absorbed energy, {name}"),
            words,
        ));
    }
    let mut share = Vec::new();
    for (k, p) in PRESSURES.iter().enumerate() {
        let (d, a) = (&detached[k], &attached[k]);
        checks.push(exceeds(
            &format!("energy density at {p} MPa, attached / detached"),
            (a.get(density), d.get(density)),
            "\"the absorbed energy density is higher for attached cavity for all driving pressures\"",
        ));
        checks.push(exceeds(
            &format!("absorbed energy at {p} MPa, detached / attached"),
            (d.get(energy), a.get(energy)),
            "\"a higher total absorbed energy compared to an attached cavity\"",
        ));
        share.push(d.get(energy) - a.get(energy));
    }
    let words = "\"the difference seems to be more prominent as the driving pressure increases\"";
    for (high, low) in [(1, 0), (2, 1)] {
        let quantity = format!(
            "difference of the energies, {} MPa / {} MPa",
            PRESSURES[high], PRESSURES[low]
        );
        checks.push(exceeds(&quantity, (share[high], share[low]), words));
    }
    let figure = |name: &str, title: &str, unit: &str, scalar: &str| {
        let mut figure = Figure::new(name, title, ("driving pressure", "Pa"), (title, unit));
        figure.add("detached", Style::Line, curve(&detached, scalar));
        figure.add("attached", Style::Line, curve(&attached, scalar));
        figure
    };
    Ok(Finding {
        checks,
        figures: vec![
            figure("density", "absorbed energy density", "J/m3", density),
            figure("energy", "absorbed energy", "J", energy),
        ],
        notes: vec![note(session)],
    }
    .into())
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
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let [low, high] = values
        .iter()
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], v| {
            [l.min(*v), h.max(*v)]
        });
    (high - low) / mean
}

fn all(runs: &[Ran], name: &str) -> Vec<f64> {
    runs.iter().map(|r| r.get(name)).collect()
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
        near.push(close.map(|(_, e)| *e).fold(0.0, f64::max));
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
    let exponent = power_law(&points).map_or(f64::NAN, |p| p[0]);
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
    let exponent = power_law(&points).map_or(f64::NAN, |p| p[0]);
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

/// Stand-off, strain without over strain with strain-rate effect.
const RATES: [(f64, f64, &str); 3] = [
    (1.33, 1.6, "\"60 % higher maximum plastic strain\""),
    (1.0, 2.8, "\"almost 180 % more\""),
    (0.33, 3.2, "\"220 % more\""),
];

pub(super) fn rate_needs(options: &Options) -> Vec<Need> {
    let both = |(s, _, _): &(f64, f64, &str)| [at(*s), at(*s).without_rate()];
    RATES
        .iter()
        .flat_map(both)
        .map(|c| c.need(options))
        .collect()
}

pub(super) fn rate(session: &Session) -> Result<Judged, Failure> {
    let mut judged = Judged::default();
    for (standoff, stated, words) in RATES {
        let with = at(standoff).results(session)?;
        let without = at(standoff).without_rate().results(session)?;
        let ratio = |name: &str| without.get(name) / with.get(name);
        let quantity = format!("largest strain at {standoff}, without / with strain-rate effect");
        let why = format!("{words}: 15 % of the ratio, as one published run");
        judged.finding.checks.push(Check::relative(
            quantity,
            "-",
            (ratio("max_plastic_strain"), stated),
            0.15,
            &why,
        ));
        let quantity = format!("plastic volume at {standoff}, without / with strain-rate effect");
        let volume = ratio("plastic_volume");
        judged.finding.checks.push(if standoff == 1.33 {
            Check::relative(
                quantity,
                "-",
                (volume, 1.4),
                0.15,
                "\"40 % higher volume of plastically deformed zone\": 15 % of the ratio",
            )
        } else {
            Check::shown(quantity, "-", volume, None, "the source gives no number")
        });
        judged
            .pictures
            .extend(with.picture(&format!("stand-off {standoff}, with strain-rate effect")));
        judged
            .pictures
            .extend(without.picture(&format!("stand-off {standoff}, without")));
        if standoff == 0.33 {
            let zones = |r: &Ran| r.get("max_plastic_strain") / r.get("off_axis_plastic_strain");
            judged.finding.checks.push(exceeds(
                "stand-off 0.33: strain of the primary zone / of the secondary one, with / without strain-rate effect",
                (zones(&with), zones(&without)),
                "both zones are alike without strain-rate effect, the primary one is higher with it",
            ));
        }
    }
    judged.finding.notes.push(note(session));
    Ok(judged)
}
