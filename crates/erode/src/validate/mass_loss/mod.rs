//! Mass lost under a Gaussian velocity of indentation that goes on: the parameter study of Joshi 2018, section 5.4.
//!
//! Failure at a plastic strain of 0.03, R = 0.1, 0.2 and 0.4 mm, C0 = 0 and 0.031. The source prints curves without a
//! table; what it says about them in words and percent is compared.

mod press;

use super::check::Check;
use super::{Failure, Figure, Finding, Style, Validation};
use crate::erosion::ErosionCurve;
use press::{Case, Pressed};
use rayon::prelude::*;

pub(super) const VALIDATION: Validation = Validation {
    name: "mass-loss",
    description: "curves of lost mass, incubation and rate under a growing Gaussian pit, rupture strain 0.03",
    reference: "trends printed in Joshi 2018, section 5.4 (validation/mass-loss)",
    run,
};

/// A pressed block with what its curve of lost mass says.
struct Eroded {
    case: Case,
    found: Pressed,
    curve: ErosionCurve,
}

fn run(quick: bool, say: &mut dyn FnMut(&str)) -> Result<Finding, Failure> {
    let (spacing, radii): (f64, &[u32]) = if quick {
        (20e-6, &[200, 400])
    } else {
        (10e-6, &[100, 200, 400])
    };
    let both = radii
        .iter()
        .flat_map(|&r| [false, true].map(|rate| Case::new(r, rate, spacing)));
    let cases: Vec<Case> = both.collect();
    say(&format!(
        "{} blocks at {:.0} um",
        cases.len(),
        spacing * 1e6
    ));
    let all: Vec<Eroded> = cases
        .par_iter()
        .map(Eroded::new)
        .collect::<Result<_, _>>()?;
    let mut finding = Finding::default();
    for e in &all {
        finding.checks.extend(e.checks());
    }
    for pair in all.chunks(2).collect::<Vec<_>>().windows(2) {
        finding
            .checks
            .extend(trend_of_radius(&pair[0][0], &pair[1][0]));
        finding
            .checks
            .extend(trend_of_radius(&pair[0][1], &pair[1][1]));
    }
    for pair in all.chunks(2) {
        let (checks, note) = trend_of_rate(&pair[0], &pair[1]);
        finding.checks.extend(checks);
        finding.notes.push(note);
    }
    finding.figures = figures(&all);
    Ok(finding)
}

impl Eroded {
    fn new(case: &Case) -> Result<Self, Failure> {
        let found = case.run()?;
        let window = press::DURATION / 6.0;
        let curve = ErosionCurve::of(&found.lost, window)
            .map_err(|e| Failure::Absent(format!("{}: {e}", case.title())))?;
        Ok(Self {
            case: *case,
            found,
            curve,
        })
    }

    fn checks(&self) -> Vec<Check> {
        let (title, c, f) = (self.case.title(), &self.curve, &self.found);
        let shown = |what: &str, unit: &str, value: f64| {
            let quantity = format!("{title}: {what}");
            Check::shown(quantity, unit, value, None, "the source prints curves only")
        };
        vec![
            shown("time of the first loss", "s", c.onset),
            shown("depth of the pit then", "m", press::motion(c.onset)[0]),
            shown("nominal incubation time", "s", c.nominal_incubation),
            shown("largest erosion rate", "kg/s", c.max_rate),
            shown(
                "mean erosion rate after the first loss",
                "kg/s",
                c.mean_rate,
            ),
            shown("mass lost at the end", "kg", c.final_loss),
            Check::shown(
                format!("{title}: largest strain rate before the first loss"),
                "1/s",
                f.strain_rate,
                None,
                "the source says of the order of 1e3",
            ),
            shown("particles that came loose / lost", "-", f.loose),
            Check::absolute(
                format!("{title}: mass in the body and lost, beside the first, less 1"),
                "-",
                (f.mass_error, 0.0),
                1e-12,
                "round-off of the sums",
            ),
            Check::absolute(
                format!("{title}: energy the ledger misses / work done"),
                "-",
                (f.missed, 0.0),
                0.05,
                "force and strain are not exactly adjoint at driven faces; measured below 3 % with failure",
            ),
        ]
    }
}

const PRINTED: &str = "trend printed in section 5.4.2";

/// A small radius beside a large one.
fn trend_of_radius(small: &Eroded, large: &Eroded) -> Vec<Check> {
    let title = format!("{} beside {}", large.case.title(), small.case.title());
    let ratio = |what: &str, of: fn(&ErosionCurve) -> f64| {
        let quantity = format!("{title}: ratio of {what}");
        Check::at_least(
            quantity,
            "-",
            of(&large.curve) / of(&small.curve),
            1.0,
            PRINTED,
        )
    };
    vec![
        ratio(
            "the times of the first loss (the smaller starts earlier)",
            |c| c.onset,
        ),
        ratio("the largest rates (the smaller erodes slower)", |c| {
            c.max_rate
        }),
        ratio("the masses lost at the end", |c| c.final_loss),
    ]
}

/// Without and with the growth of the yield stress with the rate.
fn trend_of_rate(without: &Eroded, with: &Eroded) -> (Vec<Check>, String) {
    let title = format!("{}, C0 = 0.031 beside 0", without.case.name());
    let (line, curve) = (|e: &Eroded| e.found.line_strain, |e: &Eroded| e.curve);
    let rows = [
        (
            "plastic strain on the line, excess without rate",
            [line(without), line(with)],
            // "10 %" is taken as 5 to 15 %.
            (0.05, 0.15, "10 %"),
        ),
        (
            "mass lost, excess without rate",
            [curve(without).final_loss, curve(with).final_loss],
            (0.08, 0.15, "8 to 15 %"),
        ),
        (
            "time of the first loss, excess with rate",
            [curve(with).onset, curve(without).onset],
            (0.03, 0.08, "3 to 8 %"),
        ),
    ];
    let (mut said, mut checks) = (Vec::new(), Vec::new());
    for (what, pair, printed) in rows {
        let (check, words) = excess(&title, what, pair, printed);
        checks.extend(check);
        said.push(words);
    }
    (checks, format!("{title}: {}", said.join("; ")))
}

/// By how much the first of a pair exceeds the second; no check where both are exactly 0.
fn excess(
    title: &str,
    what: &str,
    [more, less]: [f64; 2],
    (low, high, printed): (f64, f64, &str),
) -> (Option<Check>, String) {
    if more == 0.0 && less == 0.0 {
        return (None, format!("{what}: nothing yields there"));
    }
    let value = more / less - 1.0;
    let check = Check::at_least(
        format!("{title}: {what}"),
        "-",
        value,
        0.0,
        "sign printed in section 5.4.3; the size stands in the notes",
    );
    if !value.is_finite() {
        let check = check.without_data("one of both could not be determined, or is nothing");
        return (Some(check), format!("{what}: not determined"));
    }
    let met = (low..=high).contains(&value);
    let verdict = if met { "met" } else { "not met" };
    let words = format!(
        "{what} {:.1} % (printed {printed}: {verdict})",
        100.0 * value
    );
    (Some(check), words)
}

fn figures(all: &[Eroded]) -> Vec<Figure> {
    let mut loss = Figure::new("mass-loss", "Lost mass", ("time", "s"), ("lost mass", "kg"));
    let mut line = Figure::new(
        "mass-loss-strain",
        "Plastic strain 120 um under the surface at a pit of 6 um",
        ("r", "m"),
        ("plastic strain", "-"),
    );
    for e in all {
        loss.add(&e.case.title(), Style::Line, e.found.lost.clone());
        loss.add("", Style::Points, vec![[e.curve.nominal_incubation, 0.0]]);
        line.add(&e.case.title(), Style::Line, e.found.line.clone());
    }
    vec![loss, line]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_could_not_be_determined_is_not_passed_over() {
        let excess = |pair| excess("", "strain", pair, (0.05, 0.15, "10 %"));
        assert!(excess([1.1, 1.0]).0.unwrap().passed && !excess([0.9, 1.0]).0.unwrap().passed);
        // Where nothing yields there is nothing to compare.
        assert!(excess([0.0, 0.0]).0.is_none());
        for pair in [[f64::NAN, 1.0], [1.0, f64::NAN], [f64::NAN; 2], [1.0, 0.0]] {
            let check = excess(pair).0.unwrap();
            assert!(!check.passed && !check.is_judged(), "{pair:?}");
        }
    }
}
