//! A Johnson-Cook material point along uniaxial paths against the scalar equations, solved without time.

mod truth;

use super::check::Check;
use super::materials::steel;
use super::{Curve, Failure, Figure, Finding, Style, Validation};
use erode_physics::material_point::{
    Material, Path, PathPoint, uniaxial_strain_path, uniaxial_stress_path,
};
use erode_physics::strength::{JohnsonCook, Strength, Thermal};
use rayon::prelude::*;
use truth::{Loading, Scalar};

pub(super) const VALIDATION: Validation = Validation {
    name: "johnson-cook-point",
    description: "stress of a material point in uniaxial strain and stress at rates from 1e-4 to 1e6 1/s",
    reference: "the scalar equations of Joshi 2018 (B.3, law of Johnson and Cook), integrated over the plastic strain \
                instead of time (validation/johnson-cook-point)",
    run,
};

/// Axial strains at which is compared: after first yield, where the plastic rate jumps and a step of time is felt most.
const STRAINS: [f64; 6] = [0.01, 0.015, 0.02, 0.03, 0.04, 0.05];

/// Law with thermal softening: constants of the usual size, the source gives none for A-2205.
const SOFTENING: Thermal = Thermal {
    m: 1.03,
    reference_temperature: 293.0,
    melting_temperature: 1800.0,
    heat_capacity: 480.0,
    taylor_quinney: 0.9,
};

const REASON: &str =
    "issue 2; the step of the point is first order: 1e-7 of the path with 50 000 steps";
const QUASI_STATIC: &str =
    "issue 2; below the reference rate the law has no rate and the return is exact for any step";

const STEPS: u32 = 50_000;

/// One path.
#[derive(Debug, Clone, Copy)]
struct Run {
    stress: bool,
    thermal: bool,
    rate: f64,
    steps: u32,
}

impl Run {
    fn title(&self) -> String {
        format!(
            "uniaxial {}, {:.0e} 1/s{}",
            if self.stress { "stress" } else { "strain" },
            self.rate,
            if self.thermal {
                ", thermal softening"
            } else {
                ""
            }
        )
    }
}

fn run(quick: bool, say: &mut dyn FnMut(&str)) -> Result<Finding, Failure> {
    let (density, elastic, strength) = steel()?;
    let Strength::JohnsonCook(law) = strength else {
        return Err(Failure::Absent(
            "steel_a2205 has no Johnson-Cook law".into(),
        ));
    };
    let base = Material {
        elastic,
        strength,
        density,
        temperature: SOFTENING.reference_temperature,
    };
    let mut finding = Finding::default();
    let mut figure = Figure::new(
        "johnson-cook-point",
        "Von Mises stress in uniaxial strain",
        ("axial strain", "-"),
        ("von Mises stress", "Pa"),
    );
    say("paths");
    let answers: Vec<_> = runs(quick)
        .into_par_iter()
        .map(|run| both(&base, &law, run).map(|(points, truth)| (run, points, truth)))
        .collect::<Result<_, Failure>>()?;
    for (run, points, truth) in &answers {
        finding.checks.extend(compare(*run, &law, points, truth));
        if !run.stress && !run.thermal {
            draw(&mut figure, *run, points, truth);
        }
    }
    say("order of the time step");
    finding.checks.push(order(&base, &law)?);
    finding.figures.push(figure);
    Ok(finding)
}

fn runs(quick: bool) -> Vec<Run> {
    let rates: &[f64] = if quick {
        &[1e-4, 1.0, 1e6]
    } else {
        &[1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6]
    };
    let mut runs = Vec::new();
    for stress in [false, true] {
        for thermal in [false, true] {
            runs.extend(rates.iter().map(|&rate| Run {
                stress,
                thermal,
                rate,
                steps: STEPS,
            }));
        }
    }
    runs
}

/// The program's answer and the truth at [`STRAINS`].
fn both(
    base: &Material,
    law: &JohnsonCook,
    run: Run,
) -> Result<(Vec<PathPoint>, Vec<Scalar>), Failure> {
    let law = JohnsonCook {
        thermal: run.thermal.then_some(SOFTENING),
        ..*law
    };
    let material = Material {
        strength: Strength::JohnsonCook(law),
        ..*base
    };
    let last = STRAINS[STRAINS.len() - 1];
    let path = Path {
        // Compression in uniaxial strain, as under a shock; tension in uniaxial stress.
        final_strain: if run.stress { last } else { -last },
        rate: run.rate,
        steps: run.steps,
    };
    let walk = if run.stress {
        uniaxial_stress_path(&material, path)?
    } else {
        uniaxial_strain_path(&material, path)?
    };
    let index = |strain: f64| (strain / last * f64::from(run.steps)).round() as usize - 1;
    let points = STRAINS.iter().map(|s| walk[index(*s)]).collect();
    let loading = Loading::new(&material, law, run.stress, run.rate);
    Ok((points, loading.at(&STRAINS)))
}

/// Largest relative differences over the path.
fn compare(run: Run, law: &JohnsonCook, points: &[PathPoint], truth: &[Scalar]) -> Vec<Check> {
    let reason = if run.rate < law.reference_rate && !run.thermal {
        QUASI_STATIC
    } else {
        REASON
    };
    let worst = |f: &dyn Fn(&PathPoint, &Scalar) -> f64| {
        let pairs = points.iter().zip(truth).map(|(p, t)| f(p, t).abs());
        pairs.fold(0.0, f64::max)
    };
    let mut rows = vec![
        (
            "axial stress",
            worst(&|p, t| p.stress.abs() / t.stress - 1.0),
        ),
        (
            "von Mises stress",
            worst(&|p, t| p.von_mises / t.von_mises - 1.0),
        ),
        (
            "plastic strain",
            worst(&|p, t| p.plastic_strain / t.plastic_strain - 1.0),
        ),
    ];
    if run.thermal {
        let worst = worst(&|p, t| p.temperature / t.temperature - 1.0);
        rows.push(("temperature", worst));
    }
    let check = |(what, error): (&str, f64)| {
        let quantity = format!("{}: largest relative error of the {what}", run.title());
        Check::absolute(quantity, "-", (error, 0.0), 1e-6, reason)
    };
    rows.into_iter().map(check).collect()
}

fn draw(figure: &mut Figure, run: Run, points: &[PathPoint], truth: &[Scalar]) {
    let size = |p: &PathPoint| [p.strain.abs(), p.von_mises];
    let dots = points.iter().map(size).collect();
    figure.add(&format!("{:.0e} 1/s", run.rate), Style::Points, dots);
    let points = STRAINS
        .iter()
        .zip(truth)
        .map(|(s, t)| [*s, t.von_mises])
        .collect();
    figure.curves.push(Curve {
        label: String::new(),
        points,
        style: Style::Dashed,
    });
}

/// Order of the step with thermal softening at 1e5 1/s, from 1000 and 8000 steps.
fn order(base: &Material, law: &JohnsonCook) -> Result<Check, Failure> {
    let error = |steps| -> Result<f64, Failure> {
        let run = Run {
            stress: false,
            thermal: true,
            rate: 1e5,
            steps,
        };
        let (points, truth) = both(base, law, run)?;
        let last = STRAINS.len() - 1;
        Ok((points[last].von_mises / truth[last].von_mises - 1.0).abs())
    };
    let order = (error(1000)? / error(8000)?).log2() / 3.0;
    Ok(Check::at_least(
        "order of the step, 1000 to 8000 steps",
        "-",
        order,
        0.9,
        "the return is an implicit Euler step: first order",
    ))
}
