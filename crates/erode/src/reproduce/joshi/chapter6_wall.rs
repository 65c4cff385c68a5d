//! Figures 6.9, 6.14 and 6.16: pressure and shock front along the wall beside the plastic strain below it.

use super::super::Options;
use super::super::session::{Judged, Metal, Need, Ran, Session};
use super::chapter6::{DETACHED, followed, off_axis, shock_front};
use super::near_wall::{Collapse, at, exceeds, largest, mean, note, within};
use crate::analysis::published::DETACHED_OFFSET;
use crate::analysis::{
    FALL, Front, WallPressure, YIELDED, along_level, effective_pressure, front_speed, zone_depth,
};
use crate::validate::{Check, Failure, Figure, Finding, Style};

/// Instants of figure 6.9 in units of the collapse time.
const TAU: [f64; 6] = [1.053, 1.106, 1.16, 1.2, 1.24, 1.28];
/// Density of A-2205, kg/m3 (table 7.1).
const STEEL: f64 = 7800.0;
/// Speed of sound in water, m/s, and the height from which the shock comes, m (section 6.4.4.2).
const SOUND: f64 = 1500.0;
const HEIGHT: f64 = 0.09e-3;

const ALONG: (&str, &str) = ("distance from the axis", "m");

/// Plastic strain "plotted along a line located just below the interface and parallel to it", which "passes through the
/// point of maximum plastic strain in the material"; nothing where the metal did not yield.
fn strain_along(metal: &Metal, radii: &[f64]) -> Vec<[f64; 2]> {
    let level = metal.level();
    if level.is_nan() {
        return Vec::new();
    }
    along_level(&metal.position, &metal.plastic_strain, level, radii)
}

fn strain_figure(points: Vec<[f64; 2]>) -> Figure {
    let mut figure = Figure::new(
        "strain",
        "Plastic strain",
        ALONG,
        ("plastic strain at the depth of the largest", "-"),
    );
    figure.add("", Style::Line, points);
    figure
}

/// The largest pressure along the wall at a time; not a number outside the record.
fn highest(wall: &WallPressure, time: f64) -> f64 {
    let ends = wall.time.first().zip(wall.time.last());
    let inside = ends.is_some_and(|(first, last)| (*first..=*last).contains(&time));
    let profile: Vec<f64> = wall.profile(time).iter().map(|p| p[1]).collect();
    if inside { largest(&profile) } else { f64::NAN }
}

pub(super) fn profiles(session: &Session) -> Result<Judged, Failure> {
    let run = DETACHED.results(session)?;
    let (wall, metal) = (run.wall()?, run.metal()?);
    let collapse = run.get("collapse_instant");
    let first = shock_front(&wall);
    let arrival = first.first().map_or(f64::NAN, |f| f.time);
    let mut figure = Figure::new(
        "pressure",
        "Pressure at the wall",
        ALONG,
        ("pressure", "Pa"),
    );
    let times = TAU.map(|tau| arrival + (tau - TAU[0]) * collapse);
    for (tau, time) in TAU.iter().zip(times).filter(|(_, t)| t.is_finite()) {
        figure.add(&format!("tau = {tau}"), Style::Line, wall.profile(time));
    }
    let highest = times.map(|time| highest(&wall, time));
    let words = "\"the maximum pressure decreases as we move ahead in time (time 1 to time 6)\"";
    let mut checks: Vec<Check> = (1..TAU.len())
        .map(|k| {
            let quantity = format!("largest pressure at time {k} / at time {}", k + 1);
            exceeds(&quantity, (highest[k - 1], highest[k]), words)
        })
        .collect();
    checks.push(off_axis(
        &run,
        &metal,
        "\"the maximum plastic strain occurs at an offset\": more than two spacings",
    ));
    let strain = strain_figure(strain_along(&metal, &wall.radius));
    Ok(Finding {
        checks,
        figures: vec![figure, strain],
        notes: vec![
            note(session),
            "Time 1 is set to the instant of the largest pressure on the axis, where the shock has reached the wall; the others are as much later as in \
             the thesis."
                .into(),
        ],
    }
    .into())
}

pub(super) fn front_along_wall(session: &Session) -> Result<Judged, Failure> {
    let run = DETACHED.results(session)?;
    let (wall, metal) = (run.wall()?, run.metal()?);
    let found = shock_front(&wall);
    let known: Vec<&Front> = found.iter().filter(|f| f.speed.is_finite()).collect();
    let points = |y: fn(&Front) -> f64| -> Vec<[f64; 2]> {
        known.iter().map(|f| [f.radius, y(f)]).collect()
    };
    let mut speed = Figure::new(
        "speed",
        "Shock front along the wall",
        ALONG,
        ("speed", "m/s"),
    );
    speed.add("this program", Style::Line, points(|f| f.speed));
    let exact: Vec<[f64; 2]> = known
        .iter()
        .filter(|f| f.radius > 2e-5)
        .map(|f| [f.radius, front_speed(SOUND, HEIGHT, f.radius)])
        .collect();
    speed.add("eq. 6.20, 1500 m/s from 0.09 mm", Style::Dashed, exact);
    let mut pressure = Figure::new(
        "pressure",
        "Pressure at the shock front",
        ALONG,
        ("pressure", "Pa"),
    );
    pressure.add("", Style::Line, points(|f| f.pressure));
    let strain = strain_along(&metal, &wall.radius);
    Ok(Finding {
        checks: front_checks(&run, &metal, &wall.radius, &found),
        figures: vec![speed, pressure, strain_figure(strain)],
        notes: vec![
            note(session),
            format!(
                "The front is followed while the pressure exceeds {:.0} MPa.",
                followed() / 1e6
            ),
        ],
    }
    .into())
}

/// Radii between which the speeds are compared, m: farther in, the speed has no bound; farther out the pressure is small.
const COMPARED: [f64; 2] = [0.05e-3, 0.3e-3];

/// The front at a radius, to the next column of the wall; none where it is not followed so far.
fn front_at(found: &[Front], radii: &[f64], r: f64) -> Option<Front> {
    let pitch = radii.windows(2).map(|p| p[1] - p[0]).fold(0.0, f64::max);
    let gap = |f: &&Front| (f.radius - r).abs();
    let nearest = found.iter().min_by(|a, b| gap(a).total_cmp(&gap(b)));
    nearest.filter(|f| gap(f) <= pitch).copied()
}

/// Mean deviation of the speed from eq. 6.20 over all of [`COMPARED`]; not a number where the front is not known in all of it.
fn deviation(found: &[Front], radii: &[f64]) -> f64 {
    if COMPARED
        .iter()
        .any(|r| front_at(found, radii, *r).is_none())
    {
        return f64::NAN;
    }
    let inside = found
        .iter()
        .filter(|f| (COMPARED[0]..=COMPARED[1]).contains(&f.radius));
    let errors = inside.map(|f| (f.speed / front_speed(SOUND, HEIGHT, f.radius) - 1.0).abs());
    mean(&errors.collect::<Vec<f64>>())
}

fn front_checks(run: &Ran, metal: &Metal, radii: &[f64], found: &[Front]) -> Vec<Check> {
    let mean = deviation(found, radii);
    let speed = |r: f64| front_at(found, radii, r).map_or(f64::NAN, |f| f.speed);
    let ends = found
        .iter()
        .find(|f| f.pressure < FALL)
        .map_or(f64::NAN, |f| f.radius);
    let depth = zone_depth(
        &metal.position,
        &metal.plastic_strain,
        metal.top,
        radii,
        YIELDED,
    );
    let zone = depth.iter().zip(radii).rev().find(|(d, _)| **d > 0.0);
    let zone = zone.map_or(f64::NAN, |(_, r)| *r);
    vec![
        Check::absolute(
            "mean deviation of the speed from eq. 6.20 between 0.05 and 0.3 mm",
            "-",
            (mean, 0.0),
            0.2,
            "\"compares well with the analytical solution\": no number is given, 20 % is taken",
        ),
        exceeds(
            "speed at 0.05 mm / at 0.3 mm",
            (speed(0.05e-3), speed(0.3e-3)),
            "\"high close to the symmetry axis and goes down\"",
        ),
        Check::shown(
            "speed at 0.3 mm",
            "m/s",
            speed(0.3e-3),
            Some(front_speed(SOUND, HEIGHT, 0.3e-3)),
            "beside eq. 6.20",
        ),
        Check::relative(
            "where the pressure of the front falls below 508 MPa / end of the plastic zone",
            "-",
            (ends / zone, 1.0),
            0.2,
            "\"corresponds well to the end of the plastic zone\": no number is given, 20 % is taken",
        ),
        within(
            "distance of the largest plastic strain from the axis",
            "m",
            run.get("max_plastic_strain_r"),
            DETACHED_OFFSET,
            "\"somewhere between 0.1 mm to 0.2 mm\"",
        ),
        Check::shown(
            "the same of the largest strain apart from the axis",
            "m",
            run.get("off_axis_plastic_strain_r"),
            Some(0.15e-3),
            "beside the middle of the same range",
        ),
    ]
}

const THREE: [Collapse; 3] = [at(1.2), at(1.33), at(1.5)];

pub(super) fn effective_needs(options: &Options) -> Vec<Need> {
    THREE.iter().map(|c| c.need(options)).collect()
}

pub(super) fn effective(session: &Session) -> Result<Judged, Failure> {
    let mut judged = Judged::default();
    let mut alike = Vec::new();
    for case in THREE {
        let run = case.results(session)?;
        let (wall, metal) = (run.wall()?, run.metal()?);
        let found = shock_front(&wall);
        let strain = strain_along(&metal, &wall.radius);
        let effective: Vec<[f64; 2]> = found.iter().map(effective_at).collect();
        alike.push(correlation(&effective, &strain));
        let name = format!("standoff-{}", case.standoff);
        let title = format!("Stand-off {}", case.standoff);
        let mut figure = Figure::new(&name, &title, ALONG, ("value / largest value", "-"));
        figure.add("effective pressure", Style::Line, normalised(&effective));
        figure.add("plastic strain", Style::Dashed, normalised(&strain));
        judged.finding.figures.push(figure);
        judged
            .pictures
            .extend(run.picture(&format!("stand-off {}", case.standoff)));
    }
    for (k, standoff) in [(1, "1.33"), (2, "1.5")] {
        let quantity =
            format!("correlation of effective pressure and plastic strain at {standoff}");
        let words = "\"qualitatively matches well with plastic strain in the material\": no number is given, half of the variance explained (0.71) is \
                     taken";
        judged
            .finding
            .checks
            .push(Check::at_least(quantity, "-", alike[k], ALIKE, words));
        let quantity = format!("that at {standoff} less that at 1.2");
        let words = "at 1.2 it \"does not match equally well with effective pressure close to the symmetry axis\": larger by any margin";
        let check = Check::more_than(quantity, "-", alike[k] - alike[0], 0.0, words);
        judged.finding.checks.push(check);
    }
    for (case, value) in THREE.iter().zip(&alike) {
        let quantity = format!("correlation at stand-off {}", case.standoff);
        let check = Check::shown(quantity, "-", *value, None, "the source gives no number");
        judged.finding.checks.push(check);
    }
    judged.finding.notes = vec![
        note(session),
        "The effective pressure has no bound where the front has slowed down to 1500 m/s; it is taken where the front is faster and the pressure above \
         the yield stress."
            .into(),
    ];
    Ok(judged)
}

/// Correlation from which on two curves are called alike: one explains half of the variance of the other.
const ALIKE: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// Radius and effective pressure of the front; zero below the yield stress, not a number where it is not known.
fn effective_at(f: &Front) -> [f64; 2] {
    let p = effective_pressure(f.pressure, FALL, STEEL, f.speed, SOUND);
    [f.radius, if p < 0.0 { 0.0 } else { p }]
}

fn normalised(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let largest = points.iter().map(|p| p[1]).fold(0.0, f64::max);
    points.iter().map(|p| [p[0], p[1] / largest]).collect()
}

/// Pearson's correlation over the radii at which both are known; NaN where one of them does not vary.
fn correlation(a: &[[f64; 2]], b: &[[f64; 2]]) -> f64 {
    let pairs: Vec<[f64; 2]> = a
        .iter()
        .zip(b)
        .map(|(a, b)| [a[1], b[1]])
        .filter(|p| p[0].is_finite() && p[1].is_finite())
        .collect();
    let n = pairs.len() as f64;
    let mean = |k: usize| pairs.iter().map(|p| p[k]).sum::<f64>() / n;
    let (ma, mb) = (mean(0), mean(1));
    let sum =
        |f: &dyn Fn(f64, f64) -> f64| pairs.iter().map(|p| f(p[0] - ma, p[1] - mb)).sum::<f64>();
    sum(&|x, y| x * y) / (sum(&|x, _| x * x) * sum(&|_, y| y * y)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn front(radius: f64, speed: f64) -> Front {
        Front {
            radius,
            time: 0.0,
            pressure: 1e9,
            speed,
        }
    }

    #[test]
    fn an_effective_pressure_that_is_not_known_is_not_zero() {
        assert!(effective_at(&front(1e-4, f64::NAN))[1].is_nan());
        assert!(effective_at(&front(1e-4, SOUND))[1].is_nan());
        assert!(effective_at(&front(1e-4, 2000.0))[1] > 0.0);
        let weak = Front {
            pressure: 1e8,
            ..front(1e-4, 2000.0)
        };
        assert_eq!(effective_at(&weak)[1], 0.0);
    }

    /// A front that is lost on the way, or has no speed somewhere, is not judged by what is left of it.
    #[test]
    fn the_speed_is_judged_over_all_of_its_range_or_not_at_all() {
        let radii: Vec<f64> = (0..80).map(|i| (f64::from(i) + 0.5) * 5e-6).collect();
        let exact = |r: &f64| front(*r, front_speed(SOUND, HEIGHT, *r));
        let whole: Vec<Front> = radii.iter().map(exact).collect();
        assert!(deviation(&whole, &radii) < 1e-12);
        assert!(deviation(&whole[..40], &radii).is_nan());
        assert!(deviation(&[], &radii).is_nan());
        let mut gap = whole.clone();
        gap[30].speed = f64::NAN;
        assert!(deviation(&gap, &radii).is_nan());
        assert!(front_at(&whole[..40], &radii, 0.3e-3).is_none());
        assert_eq!(front_at(&whole, &radii, 0.3e-3).unwrap().radius, radii[59]);
    }

    #[test]
    fn outside_the_record_no_pressure_is_known() {
        let wall = WallPressure {
            time: vec![1.0, 2.0],
            radius: vec![1.0, 2.0],
            pressure: vec![vec![5.0, 6.0], vec![7.0, 8.0]],
        };
        assert_eq!(super::highest(&wall, 1.9), 8.0);
        assert!(super::highest(&wall, 2.1).is_nan() && super::highest(&wall, f64::NAN).is_nan());
    }

    #[test]
    fn correlation_of_known_pairs() {
        let line = |f: fn(f64) -> f64| -> Vec<[f64; 2]> {
            (0..9).map(f64::from).map(|x| [x, f(x)]).collect()
        };
        let x = line(|x| x);
        assert!((correlation(&x, &line(|x| 3.0 * x + 1.0)) - 1.0).abs() < 1e-12);
        assert!((correlation(&x, &line(|x| -x)) + 1.0).abs() < 1e-12);
        assert!(correlation(&x, &line(|x| (x - 4.0).powi(2))).abs() < 1e-12);
        assert!(correlation(&x, &line(|_| 1.0)).is_nan());
    }
}
