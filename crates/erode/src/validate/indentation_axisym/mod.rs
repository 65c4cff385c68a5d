//! A Gaussian pit pressed into an axisymmetric block, against independent finite elements.

mod indent;
mod reference;

use super::check::Check;
use super::columns::{CurveError, interpolate};
use super::{Failure, Figure, Finding, Style, Validation};
use erode_sph::solid::{Formulation, updated};
use indent::{Case, Indented};
use rayon::prelude::*;
use reference::{COMPONENTS, Reference, Top, read};

pub(super) const VALIDATION: Validation = Validation {
    name: "indentation-axisym",
    description: "stress, plastic strain, force and work under a Gaussian pit 6 um deep in an axisymmetric steel block",
    reference: "independent finite elements, CalculiX (validation/indentation-axisym)",
    run,
};

/// Spacing (m) with the largest mean and the largest error of a curve in units of its peak.
const ASKED: [(f64, f64, f64); 3] = [
    (20e-6, 0.015, 0.03),
    (10e-6, 0.007, 0.015),
    (5e-6, 0.003, 0.01),
];

const WHY_LINE: &str = "issue 3; in units of the peak along the line. The finite elements are converged to 0.75 % of the peak \
                        at worst and 0.05 % on average; at 20 um, the quick form, twice the error of 10 um";
const WHY_SUM: &str =
    "issue 3; the finite elements are converged to 0.4 % in peak strain, 0.01 % in force and work";

fn run(quick: bool, say: &mut dyn FnMut(&str)) -> Result<Finding, Failure> {
    let mut finding = Finding::default();
    let tops = [Top::Bonded, Top::Free];
    let of = |radius, spacing| tops.map(|top| Case::new(radius, top, spacing));
    let sets = if quick {
        vec![of(400, 20e-6)]
    } else {
        vec![of(400, 10e-6), of(200, 10e-6), of(400, 5e-6), of(200, 5e-6)]
    };
    for cases in sets {
        say(&format!("{} and the other top", cases[0].title()));
        let runs: Vec<Indented> = cases.par_iter().map(Case::run).collect::<Result<_, _>>()?;
        for (case, found) in cases.iter().zip(&runs) {
            let reference = read(case.radius_um, case.top)?;
            finding.checks.extend(compare(case, found, &reference));
            finding.figures.extend(figures(case, found, &reference));
        }
    }
    let spacing = if quick { 20e-6 } else { 10e-6 };
    say("pulled instead of pushed, and the published form");
    finding.checks.extend(others(spacing)?);
    Ok(finding)
}

fn tolerances(spacing: f64) -> (f64, f64) {
    let found = ASKED
        .iter()
        .find(|a| spacing <= 1.01 * a.0 && spacing >= 0.99 * a.0);
    found.map_or((f64::NAN, f64::NAN), |a| (a.1, a.2))
}

fn errors(found: &Indented, reference: &Reference) -> Vec<CurveError> {
    (found.line.iter().zip(&reference.line))
        .map(|(curve, reference)| CurveError::of(curve, reference))
        .collect()
}

/// Name and error of the worst curve.
fn worst(errors: &[CurveError]) -> (&'static str, CurveError) {
    let mut worst = (COMPONENTS[0].0, errors[0]);
    for (component, error) in COMPONENTS.iter().zip(errors).skip(1) {
        if error.largest.is_nan() || error.largest > worst.1.largest {
            worst = (component.0, *error);
        }
    }
    worst
}

fn compare(case: &Case, found: &Indented, reference: &Reference) -> Vec<Check> {
    let title = case.title();
    let (mean, largest) = tolerances(case.spacing);
    let errors = errors(found, reference);
    let mut checks: Vec<Check> = (COMPONENTS.iter().zip(&errors))
        .map(|((name, ..), e)| {
            let quantity = format!("{title}: {name} along the line, mean error / peak");
            Check::absolute(quantity, "-", (e.mean, 0.0), mean, WHY_LINE)
        })
        .collect();
    let (name, e) = worst(&errors);
    checks.push(Check::absolute(
        format!(
            "{title}: largest error / peak of all curves ({name} at r = {:.0} um)",
            e.place * 1e6
        ),
        "-",
        (e.largest, 0.0),
        largest,
        WHY_LINE,
    ));
    checks.extend(sums(case, found, reference));
    checks
}

/// Numbers of the whole block.
fn sums(case: &Case, found: &Indented, reference: &Reference) -> Vec<Check> {
    let title = case.title();
    // Twice the asked where the quick form has the double spacing.
    let tolerance = if case.spacing > 15e-6 { 0.02 } else { 0.01 };
    let force = force_error(found, reference);
    let relative = |what: &str, unit: &str, value: f64, reference: f64| {
        let quantity = format!("{title}: {what}");
        Check::relative(quantity, unit, (value, reference), tolerance, WHY_SUM)
    };
    vec![
        relative(
            "peak plastic strain",
            "-",
            found.peak_strain,
            reference.peak_strain,
        ),
        relative(
            "plastic work",
            "J",
            found.plastic_work,
            reference.plastic_work,
        ),
        Check::absolute(
            format!("{title}: largest error of the force over depth / largest force"),
            "-",
            (force, 0.0),
            tolerance,
            WHY_SUM,
        ),
        Check::absolute(
            format!("{title}: kinetic / internal energy at the end"),
            "-",
            (found.inertia, 0.0),
            1e-5,
            "inertia must be negligible for a comparison with statics",
        ),
        Check::shown(
            format!("{title}: energy the ledger misses / work done"),
            "-",
            found.defect,
            None,
            "force and strain are not exactly adjoint at driven faces",
        ),
        Check::shown(
            format!("{title}: speed while the other top ran beside it"),
            "particle-steps/s",
            found.particles as f64 * found.steps as f64 / found.seconds,
            None,
            "depends on the machine",
        ),
    ]
}

fn force_error(found: &Indented, reference: &Reference) -> f64 {
    let curve: Vec<[f64; 2]> = (reference.force.iter())
        .map(|p| [p[0], interpolate(&found.force, p[0])])
        .collect();
    CurveError::of(&curve, &reference.force).largest
}

/// The block pulled, and the published form with and without its axis correction.
fn others(spacing: f64) -> Result<Vec<Check>, Failure> {
    let published = |axis_correction| {
        Formulation::Joshi(updated::Settings {
            axis_correction,
            ..updated::Settings::default()
        })
    };
    let plain = Case::new(400, Top::Bonded, spacing);
    let cases = [
        plain,
        Case {
            sign: -1.0,
            ..plain
        },
        Case {
            formulation: published(true),
            ..plain
        },
        Case {
            formulation: published(false),
            ..plain
        },
    ];
    let runs: Vec<Indented> = cases.par_iter().map(Case::run).collect::<Result<_, _>>()?;
    let reference = read(400, Top::Bonded)?;
    let mut checks = vec![mirrored(&plain, &runs[0], &runs[1])];
    let forms = ["with", "without"].iter().zip(&runs[2..]);
    for (form, found) in forms {
        checks.extend(shown(
            &format!("{}, published form {form} axis correction", plain.title()),
            found,
            &reference,
        ));
    }
    Ok(checks)
}

fn mirrored(case: &Case, pushed: &Indented, pulled: &Indented) -> Check {
    let error = (pushed.line.iter().zip(&pulled.line))
        .map(|(a, b)| CurveError::of(b, a).largest)
        .fold(0.0, f64::max);
    Check::absolute(
        format!(
            "{}: pulled instead of pushed, largest change of a curve / peak",
            case.title()
        ),
        "-",
        (error, 0.0),
        0.05,
        "issue 3: the mirrored answer. Slopes of 3 % and strains of 2 % change sides under a finite pit, so some percent differ \
         in truth; a form that fails in tension keeps a few percent of the stress",
    )
}

fn shown(title: &str, found: &Indented, reference: &Reference) -> Vec<Check> {
    let errors = errors(found, reference);
    let (name, e) = worst(&errors);
    let mean = errors.iter().map(|e| e.mean).fold(0.0, f64::max);
    let row = |what: String, value: f64| {
        let why =
            "the source claims below 1 % on average with the correction, 60 % in strain without";
        Check::shown(format!("{title}: {what}"), "-", value, None, why)
    };
    vec![
        row("largest mean error of a curve / peak".into(), mean),
        row(
            format!(
                "largest error / peak ({name} at r = {:.0} um)",
                e.place * 1e6
            ),
            e.largest,
        ),
        row(
            "largest error of the plastic strain / peak".into(),
            errors[5].largest,
        ),
        row(
            "error of the plastic work".into(),
            found.plastic_work / reference.plastic_work - 1.0,
        ),
    ]
}

fn figures(case: &Case, found: &Indented, reference: &Reference) -> Vec<Figure> {
    let (title, tag) = (case.title(), tag(case));
    let mut stress = Figure::new(
        &format!("{tag}-stress"),
        &format!("{title}: stress 0.12 mm below the surface (dashed: finite elements)"),
        ("radius", "m"),
        ("stress", "Pa"),
    );
    for (i, (name, ..)) in COMPONENTS.iter().enumerate().take(4) {
        stress.add(name, Style::Line, found.line[i].clone());
        stress.add("", Style::Dashed, reference.line[i].clone());
    }
    let mut strain = Figure::new(
        &format!("{tag}-strain"),
        &format!("{title}: plastic strain 0.12 mm below the surface"),
        ("radius", "m"),
        ("plastic strain", "-"),
    );
    strain.add("Erode", Style::Line, found.line[5].clone());
    strain.add("finite elements", Style::Dashed, reference.line[5].clone());
    let mut force = Figure::new(
        &format!("{tag}-force"),
        &format!("{title}: force over depth"),
        ("depth", "m"),
        ("force", "N"),
    );
    // Some hundred points are enough for a picture.
    let every = (found.force.len() / 200).max(1);
    force.add(
        "Erode",
        Style::Line,
        found.force.iter().step_by(every).copied().collect(),
    );
    force.add("finite elements", Style::Dashed, reference.force.clone());
    vec![stress, strain, force]
}

fn tag(case: &Case) -> String {
    let top = match case.top {
        Top::Bonded => "bonded",
        Top::Free => "free",
    };
    let spacing = (case.spacing * 1e6).round();
    format!("indentation-axisym-R{}-{top}-{spacing}um", case.radius_um)
}
