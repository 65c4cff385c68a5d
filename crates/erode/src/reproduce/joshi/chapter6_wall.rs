//! Figures 6.9, 6.14 and 6.16: pressure and shock front along the wall beside the plastic strain below it.

use super::super::Options;
use super::super::session::{Judged, Metal, Need, Ran, Session};
use super::chapter6::{DETACHED, FOLLOWED, off_axis};
use super::near_wall::{Collapse, at, exceeds, note, within};
use crate::analysis::{
    Front, effective_pressure, front, front_speed, largest_in_column, zone_depth,
};
use crate::validate::{Check, Failure, Figure, Finding, Style};

/// Instants of figure 6.9 in units of the collapse time.
const TAU: [f64; 6] = [1.053, 1.106, 1.16, 1.2, 1.24, 1.28];
/// Initial yield stress of A-2205, Pa, and its density, kg/m3 (table 7.1).
const YIELD: f64 = 508e6;
const STEEL: f64 = 7800.0;
/// Speed of sound in water, m/s, and the height from which the shock comes, m (section 6.4.4.2).
const SOUND: f64 = 1500.0;
const HEIGHT: f64 = 0.09e-3;
/// Radii on each side that the speed of the front is read from.
const REACH: usize = 3;
/// Plastic strain above which metal counts as yielded.
pub(super) const YIELDED: f64 = 1e-6;

const ALONG: (&str, &str) = ("distance from the axis", "m");

/// Largest plastic strain below each radius, drawn and judged with three neighbours each as in the report.
fn strain_along(metal: &Metal, radii: &[f64]) -> Vec<[f64; 2]> {
    let strain = largest_in_column(&metal.position, &metal.plastic_strain, radii);
    radii.iter().zip(&strain).map(|(r, e)| [*r, *e]).collect()
}

fn strain_figure(points: Vec<[f64; 2]>) -> Figure {
    let mut figure = Figure::new(
        "strain",
        "Plastic strain",
        ALONG,
        ("largest plastic strain below", "-"),
    );
    figure.add("", Style::Line, points);
    figure
}

pub(super) fn profiles(session: &Session) -> Result<Judged, Failure> {
    let run = DETACHED.results(session)?;
    let (wall, metal) = (run.wall()?, run.metal()?);
    let collapse = run.get("collapse_instant");
    let first = front(&wall, FOLLOWED, REACH);
    let arrival = first.first().map_or(f64::NAN, |f| f.time);
    let mut figure = Figure::new(
        "pressure",
        "Pressure at the wall",
        ALONG,
        ("pressure", "Pa"),
    );
    let mut highest = Vec::new();
    for tau in TAU {
        let profile = wall.profile(arrival + (tau - TAU[0]) * collapse);
        highest.push(
            profile
                .iter()
                .map(|p| p[1])
                .fold(f64::NEG_INFINITY, f64::max),
        );
        figure.add(&format!("tau = {tau}"), Style::Line, profile);
    }
    let words = "\"the maximum pressure decreases as we move ahead in time\"";
    // The first instant is that of half the first peak: it is still rising.
    let mut checks: Vec<Check> = (2..TAU.len())
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
            "Time 1 is set to the instant at which the shock reaches the wall on the axis, the others as much later as in the thesis.".into(),
        ],
    }
    .into())
}

pub(super) fn front_along_wall(session: &Session) -> Result<Judged, Failure> {
    let run = DETACHED.results(session)?;
    let (wall, metal) = (run.wall()?, run.metal()?);
    let found = front(&wall, FOLLOWED, REACH);
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
        checks: front_checks(&run, &metal, &wall.radius, &known),
        figures: vec![speed, pressure, strain_figure(strain)],
        notes: vec![
            note(session),
            format!(
                "The front is followed while the pressure exceeds {} MPa.",
                FOLLOWED / 1e6
            ),
        ],
    }
    .into())
}

/// Radii between which the speeds are compared, m: farther in, the speed has no bound; farther out the pressure is small.
const COMPARED: [f64; 2] = [0.05e-3, 0.3e-3];

fn front_checks(run: &Ran, metal: &Metal, radii: &[f64], known: &[&Front]) -> Vec<Check> {
    let inside = known
        .iter()
        .filter(|f| (COMPARED[0]..=COMPARED[1]).contains(&f.radius));
    let errors: Vec<f64> = inside
        .map(|f| (f.speed / front_speed(SOUND, HEIGHT, f.radius) - 1.0).abs())
        .collect();
    let mean = errors.iter().sum::<f64>() / errors.len() as f64;
    let nearest = |r: f64| {
        let gap = |f: &&&Front| (f.radius - r).abs();
        known.iter().min_by(|a, b| gap(a).total_cmp(&gap(b)))
    };
    let speed = |r: f64| nearest(r).map_or(f64::NAN, |f| f.speed);
    let ends = known
        .iter()
        .find(|f| f.pressure < YIELD)
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
            [0.1e-3, 0.2e-3],
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
        let found = front(&wall, FOLLOWED, REACH);
        let strain = strain_along(&metal, &wall.radius);
        let effective: Vec<[f64; 2]> = found
            .iter()
            .map(|f| {
                [
                    f.radius,
                    effective_pressure(f.pressure, YIELD, STEEL, f.speed, SOUND),
                ]
            })
            .map(|[r, p]| [r, p.max(0.0)])
            .collect();
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
    let words =
        "\"matches well\" for 1.33 and 1.5, \"not equally well\" for 1.2: larger by any margin";
    for (k, standoff) in [(1, "1.33"), (2, "1.5")] {
        let quantity = format!(
            "correlation of effective pressure and plastic strain at {standoff} less that at 1.2"
        );
        let check = Check::at_least(quantity, "-", alike[k] - alike[0], 0.0, words);
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
