//! Figure 7.10: the effect of the strain rate.

use super::super::Options;
use super::super::session::{Judged, Need, Ran, Session};
use super::near_wall::{at, exceeds, note};
use crate::validate::{Check, Failure};

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
