//! How every scalar of the detached cavity depends on the resolution: observed order and error bar.

use super::super::Options;
use super::super::session::{Judged, Need, Ran, Session};
use super::near_wall::at;
use crate::analysis::{error_bar, extrapolate};
use crate::validate::{Check, Failure, Figure, Finding, Style};

const QUICK: [u32; 3] = [8, 12, 18];
const FULL: [u32; 4] = [15, 30, 45, 60];

/// Scalars with an error bar; counts, times of computing and places on a lattice have none.
const SCALARS: [&str; 14] = [
    "collapse_time",
    "jet_speed",
    "jet_time",
    "max_pressure",
    "peak_wall_pressure",
    "peak_wall_pressure_time",
    "max_plastic_strain",
    "off_axis_plastic_strain",
    "plastic_work",
    "plastic_volume",
    "absorbed_energy_density",
    "plastic_deformation_potential_share",
    "pit_depth",
    "shock_front_speed",
];

fn resolutions(options: &Options) -> &'static [u32] {
    if options.quick { &QUICK } else { &FULL }
}

pub(super) fn needs(options: &Options) -> Vec<Need> {
    let all = resolutions(options).iter();
    all.map(|n| at(1.33).need_with(*n)).collect()
}

pub(super) fn judge(session: &Session) -> Result<Judged, Failure> {
    let all = resolutions(&session.options);
    let runs = all.iter().map(|n| session.run(&at(1.33).need_with(*n)));
    let runs: Vec<Ran> = runs.collect::<Result<_, _>>()?;
    let mut finding = Finding::default();
    let mut figure = Figure::new(
        "scalars",
        "Against the spacing, in units of the finest one",
        ("spacing / radius", "-"),
        ("value / value at the finest spacing", "-"),
    );
    for name in SCALARS {
        // Coarsest first in the list of runs, finest first for the extrapolation.
        let points: Vec<[f64; 2]> = all
            .iter()
            .zip(&runs)
            .rev()
            .map(|(n, run)| [1.0 / f64::from(*n), run.get(name)])
            .collect();
        let known: Vec<[f64; 2]> = points.into_iter().filter(|p| p[1].is_finite()).collect();
        let Some(finest) = known.first().map(|p| p[1]) else {
            let words = "not known at any resolution";
            let check = Check::shown(name.replace('_', " "), "-", f64::NAN, None, words);
            finding.checks.push(check);
            continue;
        };
        let relative = known.iter().map(|p| [p[0], p[1] / finest]);
        figure.add(&name.replace('_', " "), Style::Line, relative.collect());
        let unit = runs.last().map_or("-", |run| run.unit(name));
        finding.checks.push(row(name, unit, &known));
    }
    finding.figures.push(figure);
    finding.notes.push(
        "Not judged: orders and error bars are what this is for. The error bar of the finest value is 1.25 times its distance from that \
         extrapolated to spacing zero where the order is between 0.5 and 3, and three times the range of the three finest values \
         otherwise. A scalar without an order does not converge in one direction through the three finest resolutions."
            .into(),
    );
    Ok(finding.into())
}

/// The finest value with its order and error bar.
fn row(name: &str, unit: &str, known: &[[f64; 2]]) -> Check {
    let three = <[[f64; 2]; 3]>::try_from(&known[..known.len().min(3)]).ok();
    let found = three.and_then(extrapolate);
    let bar = match error_bar(known) {
        Some(bar) => format!(
            "error bar {bar:.1e} ({:.0} %)",
            100.0 * (bar / known[0][1]).abs()
        ),
        None => "no error bar from fewer than three values".into(),
    };
    let order = match &found {
        Some(f) => format!("order {:.2}", f.order),
        None => "no order: not converging in one direction".into(),
    };
    let words = format!("{order}; {bar}");
    Check::shown(
        format!(
            "{}; reference: extrapolated to spacing zero",
            name.replace('_', " ")
        ),
        unit,
        known[0][1],
        found.map(|f| f.value),
        &words,
    )
}
