//! Figure 7.10: the effect of the strain rate.

use super::super::Options;
use super::super::session::{Judged, Need, Ran, Session};
use super::near_wall::{QUARTER, at, exceeds, largest, note};
use crate::validate::{Check, Failure};

/// Stand-off, strain without over strain with strain-rate effect.
const RATES: [(f64, f64, &str); 3] = [
    (1.33, 1.6, "\"60% higher maximum plastic strain\""),
    (1.0, 2.8, "\"almost 180% and 220% more\", the first"),
    (0.33, 3.2, "\"almost 180% and 220% more\", the second"),
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
        let ratio = |name: &str| without.of_yielded(name) / with.of_yielded(name);
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
                "\"40% higher volume of plastically deformed zone\": 15 % of the ratio",
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
            judged.finding.checks.extend(zones(&with, &without)?);
        }
    }
    judged.finding.notes.push(note(session));
    Ok(judged)
}

/// What is said of the zone at the axis and of the one below the ring.
fn zones(with: &Ran, without: &Ran) -> Result<[Check; 2], Failure> {
    let (with, without) = (zones_of(with)?, zones_of(without)?);
    Ok([
        exceeds(
            "stand-off 0.33, with strain-rate effect: strain of the primary zone / of the secondary one",
            (with[0], with[1]),
            "\"the strain rate sensitive case shows a higher magnitude of plastic strain in the primary plasticity zone compared to the secondary \
             plasticity zone\"",
        ),
        Check::relative(
            "stand-off 0.33, without: strain of the primary zone / of the secondary one",
            "-",
            (without[0] / without[1], 1.0),
            QUARTER,
            "\"show similar magnitude of plastic strain for the strain rate insensitive case\": no number is given, a quarter is taken",
        ),
    ])
}

/// Largest strain in the primary zone, within half the distance of the ring from the axis, and in the secondary one below it.
fn zones_of(run: &Ran) -> Result<[f64; 2], Failure> {
    let metal = run.metal()?;
    let half = 0.5 * run.get("off_axis_plastic_strain_r");
    let all = metal.position.iter().zip(&metal.plastic_strain);
    let inner: Vec<f64> = all.filter(|(x, _)| x[0] < half).map(|(_, e)| *e).collect();
    Ok([largest(&inner), run.get("off_axis_plastic_strain")])
}
