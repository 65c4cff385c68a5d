//! Figures 6.18 and 6.19: characteristic times of load and metal along the wall.

use super::super::Options;
use super::super::session::{Judged, Metal, Need, Ran, Session};
use super::chapter6::{DETACHED, rise};
use super::near_wall::{Collapse, MUCH, at, exceeds, exceeds_by, note};
use crate::analysis::{
    FALL, WallPressure, YIELDED, largest_in_column, loading_time, material_time, zone_depth,
};
use crate::validate::{Check, Failure, Figure, Finding, Style};

/// "Speed of sound in the solid" of the thesis, m/s (table 7.1): that of a bar.
const SOUND: f64 = 4883.33;
const NEAR: Collapse = at(1.2);

/// Both times at one radius, s, with the strain below; the time of a load that never reached the yield stress is none.
#[derive(Debug, Clone, Copy)]
struct Times {
    r: f64,
    load: f64,
    metal: f64,
    strain: f64,
}

impl Times {
    /// What is known of a place that there is not.
    const NONE: Self = Self {
        r: f64::NAN,
        load: f64::NAN,
        metal: f64::NAN,
        strain: f64::NAN,
    };

    /// The load lasts longer than the metal needs: (larger, smaller).
    fn slow_load(&self) -> (f64, f64) {
        (self.load, self.metal)
    }

    /// The metal needs longer than the load lasts: (larger, smaller).
    fn slow_metal(&self) -> (f64, f64) {
        (self.metal, self.load)
    }
}

fn times(wall: &WallPressure, metal: &Metal) -> Vec<Times> {
    let depth = zone_depth(
        &metal.position,
        &metal.plastic_strain,
        metal.top,
        &wall.radius,
        YIELDED,
    );
    let strain = largest_in_column(&metal.position, &metal.plastic_strain, &wall.radius);
    (0..wall.radius.len())
        .filter(|k| depth[*k] > 0.0)
        .map(|k| Times {
            r: wall.radius[k],
            load: loading_time(&wall.time, &wall.pressure[k], rise(), FALL).unwrap_or(f64::NAN),
            metal: material_time(depth[k], SOUND),
            strain: strain[k],
        })
        .collect()
}

fn figure(times: &[Times]) -> Figure {
    let mut figure = Figure::new(
        "times",
        "Characteristic times",
        ("distance from the axis", "m"),
        ("time", "s"),
    );
    let curve = |y: fn(&Times) -> f64| times.iter().map(|t| [t.r, y(t)]).collect();
    figure.add("load", Style::Line, curve(|t| t.load));
    figure.add("metal", Style::Dashed, curve(|t| t.metal));
    figure
}

fn of(run: &Ran) -> Result<Vec<Times>, Failure> {
    let found = times(&run.wall()?, &run.metal()?);
    if found.is_empty() {
        return Err(Failure::Absent(
            "the metal did not yield: there are no times to compare".into(),
        ));
    }
    Ok(found)
}

/// Entry nearest to a radius; nothing in it is a number where the radius is none.
fn nearest(times: &[Times], r: f64) -> Times {
    let gap = |t: &&Times| (t.r - r).abs();
    let found = times.iter().min_by(|a, b| gap(a).total_cmp(&gap(b)));
    found
        .filter(|_| r.is_finite())
        .copied()
        .unwrap_or(Times::NONE)
}

/// Between the axis and the ring, where the strain is lowest.
fn lowest_between(times: &[Times], ring: &Times) -> Times {
    let between = times.iter().filter(|t| t.r > times[0].r && t.r < ring.r);
    let lowest = between.min_by(|a, b| a.strain.total_cmp(&b.strain));
    lowest.copied().unwrap_or(Times::NONE)
}

pub(super) fn detached(session: &Session) -> Result<Judged, Failure> {
    let run = DETACHED.results(session)?;
    let found = of(&run)?;
    let ring = nearest(&found, run.get("off_axis_plastic_strain_r"));
    let checks = vec![
        exceeds(
            "time of the metal / of the load next to the axis (region A)",
            found[0].slow_metal(),
            "\"the loading characteristic time is lower than the material characteristic time\"",
        ),
        exceeds(
            "time of the load / of the metal at the largest strain apart from the axis (region B)",
            ring.slow_load(),
            "\"the material characteristic time is lower than the loading characteristic time\"",
        ),
    ];
    Ok(judged(session, &run, &found, checks))
}

pub(super) fn near_needs(options: &Options) -> Vec<Need> {
    vec![NEAR.need(options)]
}

pub(super) fn near(session: &Session) -> Result<Judged, Failure> {
    let run = NEAR.results(session)?;
    let found = of(&run)?;
    let ring = nearest(&found, run.get("off_axis_plastic_strain_r"));
    let between = lowest_between(&found, &ring);
    let checks = vec![
        exceeds(
            "time of the load / of the metal next to the axis (region A)",
            found[0].slow_load(),
            "\"in region A where the plastic strain is relatively high, the material characteristic time is lower than the loading characteristic \
             time\"",
        ),
        exceeds(
            "time of the metal / of the load where the strain between axis and ring is lowest (region B)",
            between.slow_metal(),
            "\"the material characteristic time becomes marginally larger than the loading characteristic time, thus leading to a slightly lower \
             plastic strain zone\"",
        ),
        exceeds_by(
            "time of the load / of the metal at the ring (region C)",
            ring.slow_load(),
            MUCH,
            "\"in region C the material characteristic time is much lower than the loading characteristic time\": no number is given, half is taken",
        ),
        Check::shown(
            "strain next to the axis / at the ring",
            "-",
            found[0].strain / ring.strain,
            None,
            "the source gives no number",
        ),
    ];
    Ok(judged(session, &run, &found, checks))
}

fn judged(session: &Session, run: &Ran, found: &[Times], checks: Vec<Check>) -> Judged {
    Judged {
        finding: Finding {
            checks,
            figures: vec![figure(found)],
            notes: vec![
                note(session),
                format!(
                    "Time of the load: from the last rise above {:.0} MPa before the yield stress is reached until the pressure last falls below 508 MPa. \
                     The thesis begins at 100 MPa, which the reflected driving step reaches by itself. Time of the metal: depth of the plastic zone \
                     over 4883 m/s, as in the thesis; the longitudinal wave is 16 % faster.",
                    rise() / 1e6
                ),
            ],
        },
        pictures: run.picture("plastic strain").into_iter().collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Columns 10 um apart; the metal yielded 50 um deep below all of them.
    fn columns(peaks: [f64; 4]) -> (WallPressure, Metal) {
        let radius: Vec<f64> = (0..4).map(|i| (f64::from(i) + 0.5) * 10e-6).collect();
        let wall = WallPressure {
            time: (0..5).map(|k| f64::from(k) * 10e-9).collect(),
            pressure: peaks.map(|p| vec![0.0, p, p, 0.0, 0.0]).to_vec(),
            radius: radius.clone(),
        };
        let metal = Metal {
            position: radius.iter().map(|r| [*r, -50e-6]).collect(),
            plastic_strain: vec![3e-3, 1e-3, 2e-3, 4e-3],
            top: 0.0,
            spacing: 10e-6,
        };
        (wall, metal)
    }

    #[test]
    fn a_column_that_was_never_loaded_says_nothing() {
        let (wall, metal) = columns([1e9, 1e8, 1e9, 1e9]);
        let found = times(&wall, &metal);
        assert_eq!(found.len(), 4);
        assert!(found[0].load > 20e-9 && found[1].load.is_nan());
        let unloaded = exceeds("x", found[1].slow_metal(), "");
        assert!(!unloaded.passed && unloaded.value.is_nan());
    }

    #[test]
    fn region_b_is_where_the_strain_is_lowest() {
        let (wall, metal) = columns([1e9; 4]);
        let found = times(&wall, &metal);
        let ring = nearest(&found, 35e-6);
        assert_eq!(ring.strain, 4e-3);
        assert_eq!(lowest_between(&found, &ring).strain, 1e-3);
        assert!(lowest_between(&found, &Times::NONE).strain.is_nan());
        assert!(nearest(&found, f64::NAN).load.is_nan());
    }
}
