//! Figures 7.5 and 7.6: the effect of the driving pressure.

use super::super::Options;
use super::super::session::{Judged, Need, Ran, Session};
use super::near_wall::{Collapse, at, exceeds, note};
use crate::validate::{Check, Failure, Figure, Finding, Style};

const PRESSURES: [f64; 3] = [25.0, 50.0, 75.0];
/// Detached and attached.
const PAIR: [(f64, &str); 2] = [(1.33, "detached"), (0.66, "attached")];

fn of_pressure(standoff: f64, pressure: f64) -> Collapse {
    Collapse {
        pressure,
        ..at(standoff)
    }
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
            (runs[high].of_yielded(name), runs[low].of_yielded(name)),
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
    let words = "\"For detached as well as attached cavities, the maximum plastic strain increases with increase in driving pressure\"";
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
    let words = "\"a higher driving pressure leads to a higher absorbed energy density and therefore a higher total absorbed energy\"";
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
            (a.of_yielded(density), d.of_yielded(density)),
            "\"The absorbed energy density is higher for attached cavity for all driving pressures\"",
        ));
        checks.push(exceeds(
            &format!("absorbed energy at {p} MPa, detached / attached"),
            (d.of_yielded(energy), a.of_yielded(energy)),
            "\"a higher total absorbed energy compared to an attached cavity\"",
        ));
        share.push(d.of_yielded(energy) - a.of_yielded(energy));
    }
    let words = "\"The difference in total absorbed energy and hence erosion rate for detached and attached cavity seems to be more prominent as the \
                 driving pressure increases\"";
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
