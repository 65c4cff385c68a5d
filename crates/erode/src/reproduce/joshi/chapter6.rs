//! Figures 6.7, 6.8 and 6.10: the detached and the attached cavity, and the effect of the strain rate.

use super::super::Options;
use super::super::session::{Judged, Metal, Need, Ran, Session};
use super::near_wall::{Collapse, QUARTER, at, note, stated};
use crate::analysis::published::{
    ATTACHED_STRAIN, ATTACHED_STRAIN_BELOW_RING, ATTACHED_STRAIN_BY_JET, DETACHED_STRAIN,
    DETACHED_STRAIN_WITHOUT_RATE,
};
use crate::analysis::{FALL, Front, RISE, WallPressure, above_step, followed_above, front};
use crate::validate::{Check, Failure, Finding};

pub(super) const DETACHED: Collapse = at(1.33);
const ATTACHED: Collapse = at(0.66);
/// Driving pressure of all runs of the chapter, Pa.
const DRIVING: f64 = 50e6;

/// Pressure above which the front on the wall is followed, Pa.
pub(super) fn followed() -> f64 {
    followed_above(FALL, DRIVING)
}

/// The shock front along the wall.
pub(super) fn shock_front(wall: &WallPressure) -> Vec<Front> {
    front(wall, followed())
}

/// The pressure from which on a load counts: that of the thesis is the one that the reflected step has by itself.
pub(super) fn rise() -> f64 {
    above_step(RISE, DRIVING)
}

pub(super) fn detached_needs(options: &Options) -> Vec<Need> {
    vec![DETACHED.need(options)]
}

pub(super) fn attached_needs(options: &Options) -> Vec<Need> {
    vec![ATTACHED.need(options), DETACHED.need(options)]
}

pub(super) fn rate_needs(options: &Options) -> Vec<Need> {
    vec![
        DETACHED.need(options),
        DETACHED.without_rate().need(options),
    ]
}

/// The largest strain lies farther from the axis than two spacings, which tell a place from the axis. Metal that did not
/// yield has no such place.
pub(super) fn off_axis(run: &Ran, metal: &Metal, words: &str) -> Check {
    let quantity = "distance of the largest plastic strain from the axis";
    let r = run.get("max_plastic_strain_r");
    Check::more_than(quantity, "m", r, 2.0 * metal.spacing, words)
}

pub(super) fn detached(session: &Session) -> Result<Judged, Failure> {
    let run = DETACHED.results(session)?;
    let metal = run.metal()?;
    let wall = run.wall()?;
    let first = shock_front(&wall).first().map(|f| f.time);
    let arrival = first.unwrap_or(f64::NAN) / run.get("collapse_instant");
    let strain = run.get("max_plastic_strain");
    let checks = vec![
        stated("largest plastic strain", "-", (strain, DETACHED_STRAIN)),
        off_axis(
            &run,
            &metal,
            "\"at an offset from the symmetry axis\": more than two spacings",
        ),
        Check::at_least(
            "depth of the largest plastic strain",
            "m",
            run.get("max_plastic_strain_depth"),
            metal.spacing,
            "\"just beneath the interface and not at the solid surface\": deeper than the first row",
        ),
        Check::shown(
            "largest strain apart from the axis",
            "-",
            run.get("off_axis_plastic_strain"),
            Some(DETACHED_STRAIN),
            "beside the same value: the jet of this program also strains the metal on the axis",
        ),
        Check::shown(
            "instant at which the shock reaches the wall / collapse instant",
            "-",
            arrival,
            Some(1.053),
            "depends on how long the step travels before it meets the bubble, which the text does not give",
        ),
    ];
    Ok(Judged {
        finding: Finding {
            checks,
            figures: Vec::new(),
            notes: vec![note(session)],
        },
        pictures: run.picture("stand-off 1.33").into_iter().collect(),
    })
}

/// Strain and plastic volume before the ring collapses: what the jet alone did.
fn by_jet(run: &Ran) -> Result<[f64; 2], Failure> {
    let history = run.history()?;
    let time = history.column("time").unwrap_or_default();
    let until = run.get("toroid_time");
    let row = time.partition_point(|t| *t <= until).saturating_sub(1);
    let value = |name: &str| {
        let column = history.column(name).filter(|_| until.is_finite());
        column.and_then(|c| c.get(row).copied()).unwrap_or(f64::NAN)
    };
    Ok([value("max_plastic_strain"), value("plastic_volume")])
}

pub(super) fn attached(session: &Session) -> Result<Judged, Failure> {
    let (run, detached) = (ATTACHED.results(session)?, DETACHED.results(session)?);
    let spacing = run.metal()?.spacing;
    let [strain, volume] = by_jet(&run)?;
    let ratio = strain / detached.of_yielded("max_plastic_strain");
    let volumes = detached.get("plastic_volume") / volume;
    let checks = vec![
        stated(
            "largest plastic strain",
            "-",
            (run.get("max_plastic_strain"), ATTACHED_STRAIN),
        ),
        Check::absolute(
            "distance of the largest plastic strain from the axis",
            "m",
            (run.get("max_plastic_strain_r"), 0.0),
            2.0 * spacing,
            "\"a final maximum plastic strain of 0.83% at the center\": within two spacings",
        ),
        stated(
            "largest plastic strain before the ring has collapsed",
            "-",
            (strain, ATTACHED_STRAIN_BY_JET),
        ),
        stated(
            "that / largest strain of the detached cavity",
            "-",
            (ratio, ATTACHED_STRAIN_BY_JET / DETACHED_STRAIN),
        ),
        stated(
            "largest strain apart from the axis, below the ring",
            "-",
            (
                run.get("off_axis_plastic_strain"),
                ATTACHED_STRAIN_BELOW_RING,
            ),
        ),
        Check::relative(
            "plastic volume of the detached cavity / that of the jet",
            "-",
            (volumes, 800.0),
            QUARTER,
            "\"almost 800 times smaller\": within a quarter, as all values of one published run",
        ),
        Check::shown(
            "distance of the ring from the axis at its collapse",
            "m",
            run.get("toroid_r"),
            None,
            "the source gives no number",
        ),
    ];
    Ok(Judged {
        finding: Finding {
            checks,
            figures: Vec::new(),
            notes: vec![
                note(session),
                "What the jet did is read where the ring is last seen with more than 2 % of the volume of the bubble.".into(),
            ],
        },
        pictures: run.picture("stand-off 0.66").into_iter().collect(),
    })
}

/// Two spacings tell an offset from none, and one from another.
fn same_offset(without: f64, with: f64, spacing: f64) -> Check {
    let check = Check::absolute(
        "its distance from the axis less that with strain-rate effect",
        "m",
        (without - with, 0.0),
        2.0 * spacing,
        "the offset \"still remains the same for the two cases\": within two spacings",
    );
    if with <= 2.0 * spacing {
        check.without_data(
            "with strain-rate effect there is no offset, the strain is largest at the axis",
        )
    } else {
        check
    }
}

pub(super) fn rate(session: &Session) -> Result<Judged, Failure> {
    let (with, without) = (
        DETACHED.results(session)?,
        DETACHED.without_rate().results(session)?,
    );
    let spacing = without.metal()?.spacing;
    let strain = |r: &Ran| r.of_yielded("max_plastic_strain");
    let place = |r: &Ran| r.get("max_plastic_strain_r");
    let checks = vec![
        stated(
            "largest plastic strain without strain-rate effect",
            "-",
            (
                without.get("max_plastic_strain"),
                DETACHED_STRAIN_WITHOUT_RATE,
            ),
        ),
        Check::relative(
            "that / largest strain with strain-rate effect",
            "-",
            (strain(&without) / strain(&with), 1.6),
            0.15,
            "\"60% higher\", \"around 61% higher\" in the conclusions: between 36 and 84 %",
        ),
        same_offset(place(&without), place(&with), spacing),
    ];
    let pictures = [
        (&with, "with strain-rate effect"),
        (&without, "without strain-rate effect"),
    ];
    Ok(Judged {
        finding: Finding {
            checks,
            figures: Vec::new(),
            notes: vec![note(session)],
        },
        pictures: pictures.iter().filter_map(|(r, t)| r.picture(t)).collect(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::validate::Kind;

    #[test]
    fn two_strains_at_the_axis_have_no_offset_in_common() {
        assert!(same_offset(1.2e-4, 1.25e-4, 5e-6).passed);
        assert!(!same_offset(5e-6, 1.25e-4, 5e-6).passed);
        assert_eq!(same_offset(5e-6, 5e-6, 5e-6).kind, Kind::NoData);
    }
}
