//! A bubble with gas collapses, comes back and swings, against compressible liquid in one dimension and the laws of spherical
//! bubbles.

mod run;
mod spherical;

use super::check::Check;
use super::{Failure, Figure, Finding, Style, Validation};
use erode_physics::bubble::{Gilmore, KellerMiksis};
use run::{Extremes, Particles, Setting, Swing};

pub(super) const VALIDATION: Validation = Validation {
    name: "gas-rebound",
    description: "a spherical bubble with gas of uniform pressure in water: collapse and first rebound at 1 and 50 MPa, \
                  and its own frequency",
    reference: "the equations of Euler between spheres with the same water and gas, in one dimension and converged \
                (crates/erode/src/validate/gas_rebound/spherical.rs); Keller and Miksis 1980, integrated to 1e-10 \
                (crates/physics/src/bubble), which holds for walls slow beside sound",
    run,
};

/// The collapse of issue 5, beyond what Keller and Miksis were made for (Mach numbers of order one).
const HARD: Setting = Setting {
    name: "50 MPa",
    pressure: 50e6,
    gas_pressure: 1e5,
    extent: 14.0,
    end: 1.45,
    finest_shell: 0.002,
};

/// A collapse to 0.29 R0, which the particles resolve; sound leaves for 50 R0 and is not back before the end.
const GENTLE: Setting = Setting {
    name: "1 MPa",
    pressure: 1e6,
    gas_pressure: 1e5,
    extent: 50.0,
    end: 2.3,
    finest_shell: 0.008,
};

/// Gas a fifth above the liquid: a swing about equilibrium with nearly the frequency of Minnaert.
const SWING: Setting = Setting {
    name: "swing at 10 MPa",
    pressure: 10e6,
    gas_pressure: 12e6,
    extent: 40.0,
    end: 3.9,
    finest_shell: 0.02,
};

const fn plain(n: f64) -> Particles {
    Particles { n, kept: None }
}

/// Eight per radius are kept: with ten and more the surface of the rebound breaks up.
const fn refined(n: f64) -> Particles {
    Particles { n, kept: Some(8.0) }
}

/// What is run in the quick form and in full.
type Runs = (&'static [Particles], &'static [Particles]);

const GENTLE_RUNS: Runs = (&[plain(15.0)], &[plain(15.0), plain(30.0)]);

const HARD_RUNS: Runs = (
    &[plain(30.0), refined(30.0)],
    &[
        plain(30.0),
        plain(45.0),
        plain(60.0),
        refined(30.0),
        refined(45.0),
    ],
);

/// Tolerances and their reasons.
struct Judgement {
    smallest: (fn(f64) -> f64, &'static str),
    rebound: (fn(f64) -> f64, &'static str),
}

const HARD_JUDGEMENT: Judgement = Judgement {
    smallest: (
        |_| 0.10,
        "issue 5; without refinement the bubble is two spacings across at its smallest radius at 30 per radius",
    ),
    rebound: (
        |_| 0.15,
        "issue 5; the smallest radius decides how much energy the liquid radiates as a shock",
    ),
};

const GENTLE_JUDGEMENT: Judgement = Judgement {
    smallest: (
        |n| 0.7 / n,
        "0.7/n: the surface lies between particles to a fifth of a spacing, and 0.29 n spacings are left of the radius",
    ),
    rebound: (
        |n| 1.5 / n,
        "1.5/n: the dissipation at the surface is of first order in the spacing; 10 % at 15 per radius is half of what issue 5 \
         allows with two spacings left, and here four are",
    ),
};

const TIME_REASON: &str = "1 to 2 %: what `rayleigh-collapse` asks of an empty cavity";
const LEDGER_REASON: &str = "1 % of p V0: what `rayleigh-collapse` asks of an empty cavity";
const SWING_REASON: &str = "2 %: a quarter of the swing, a fifth of a spacing at 10 per radius: as well as the surface is known";

/// What the numbers do not say.
const NOTES: [&str; 5] = [
    "At 50 MPa the wall is as fast as sound: the law of Keller and Miksis is far from the compressible liquid in one dimension, that \
     of Gilmore in its rebound. With the spacing the smallest radius of the particles comes down towards that of the compressible liquid, past \
     that of Keller and Miksis: where it meets the latter it does so by coincidence.",
    "At 1 MPa the error of the smallest radius does not fall from 15 to 30 particles per radius: it has not been shown to \
     converge.",
    "The swing and the work of the far field before sound reaches it: in the graded spacing around the bubble the sums A_b grad W are not zero, \
     and uniform pressure p drives the particles there with 2 p/rho times them. A bubble in equilibrium with its liquid (gas and \
     liquid at 10 MPa, 10 per radius) grows by 0.9 % of its radius and misses 6 % of p V0 by the end of the swing. Where the particles inside \
     the liquid felt the difference of pressures alone, it stayed at rest to 1e-4, no work came from the far field, and the swing \
     took 0.1 % too short instead of 2.2 % too long; but the ledger at 50 MPa then missed 2.6 % with refinement: not taken over. (These numbers \
     are from before areas were levelled against those of the start, with which the swing is 3.2 % too long.)",
    "The ledger without refinement: a bubble of less than three spacings has a volume and a surface that are too coarse. In a given \
     incompressible flow the volume that is measured shrinks too slowly by 6 % at 9 spacings per radius, by 20 % at 3 and by 90 % at 1; the gas \
     pushes with 85 to 95 % of its surface down to 5 spacings. Most of the former is the colour of the liquid beside the bubble, which shifting \
     takes down to 0.96.",
    "With refinement the ledger is judged until the smallest radius; in the rebound, whose surface breaks up, it misses up to 5 % of p V0.",
];

fn run(quick: bool, say: &mut dyn FnMut(&str)) -> Result<Finding, Failure> {
    let mut finding = Finding::default();
    let mut figures = Vec::new();
    let gentle = if quick { GENTLE_RUNS.0 } else { GENTLE_RUNS.1 };
    let hard = if quick { HARD_RUNS.0 } else { HARD_RUNS.1 };
    for (setting, runs, judgement) in [
        (&GENTLE, gentle, GENTLE_JUDGEMENT),
        (&HARD, hard, HARD_JUDGEMENT),
    ] {
        say(&format!("{}, in one dimension", setting.name));
        let truth = setting.in_one_dimension(1.0)?;
        let law = setting.theory(&KellerMiksis)?;
        finding.checks.extend(theories(setting, &truth, &law)?);
        let mut figure = Figure::new(
            &format!("gas-rebound-{}", setting.name.replace(' ', "-")),
            &format!("Bubble with 100 kPa of gas in water at {}", setting.name),
            ("time", "s"),
            ("radius/initial radius", "-"),
        );
        for particles in runs {
            let name = particles.name();
            say(&format!("{}, {name}", setting.name));
            let swing = run::run(setting, *particles)?;
            let checks = collapse(setting, particles, &swing, [&truth, &law], &judgement)?;
            finding.checks.extend(checks);
            figure.add(&name, Style::Line, swing.curve);
        }
        figure.add("compressible liquid", Style::Dashed, truth.curve);
        figure.add("Keller and Miksis", Style::Dashed, law.curve);
        figures.push(figure);
    }
    say("swing, 10 particles per radius");
    finding.checks.extend(own_frequency()?);
    finding.figures = figures;
    finding.notes = NOTES.map(str::to_owned).to_vec();
    Ok(finding)
}

/// The calculation in one dimension: is it converged, and how far are the laws from it?
fn theories(setting: &Setting, truth: &Swing, law: &Swing) -> Result<Vec<Check>, Failure> {
    let of = |what: &str| format!("{}, {what}", setting.name);
    let extremes = |s: &Swing| Extremes::of_collapse(&s.curve);
    let (exact, finer) = (extremes(truth)?, extremes(&setting.in_one_dimension(2.0)?)?);
    let (law, gilmore) = (
        extremes(law)?,
        extremes(&setting.theory(&Gilmore::default())?)?,
    );
    let converged = "a twentieth of the smallest tolerance for particles";
    let mut checks = Vec::new();
    for (what, get) in [
        ("smallest radius", (|e| e.first[1]) as fn(&Extremes) -> f64),
        ("radius of the first rebound", |e| e.second[1]),
    ] {
        checks.push(Check::relative(
            of(&format!(
                "in one dimension: {what} beside shells half as thick"
            )),
            "R0",
            (get(&exact), get(&finer)),
            0.001,
            converged,
        ));
        let name = of(&format!("Keller and Miksis: {what}"));
        let (pair, shown) = ((get(&law), get(&exact)), "shown: Mach numbers of order one");
        checks.push(if setting.pressure < 2e6 {
            let why = "the law is of first order in the Mach number of the wall, 0.06 at most: its square";
            Check::relative(name, "R0", pair, 0.004, why)
        } else {
            Check::shown(name, "R0", pair.0, Some(pair.1), shown)
        });
        checks.push(Check::shown(
            of(&format!("Gilmore: {what}")),
            "R0",
            get(&gilmore),
            Some(get(&exact)),
            "shown: another law, with the enthalpy of the liquid at the wall",
        ));
    }
    Ok(checks)
}

/// Smallest and largest radius, with their times, beside compressible liquid and the law of Keller and Miksis.
fn collapse(
    setting: &Setting,
    particles: &Particles,
    swing: &Swing,
    [truth, law]: [&Swing; 2],
    judgement: &Judgement,
) -> Result<Vec<Check>, Failure> {
    let (n, name) = (particles.n, particles.name());
    let of = |what: &str| format!("{}, {name}: {what}", setting.name);
    let extremes = |s: &Swing| Extremes::of_collapse(&s.curve);
    let (found, exact, law) = (extremes(swing)?, extremes(truth)?, extremes(law)?);
    let ((smallest, why_smallest), (rebound, why_rebound)) =
        (judgement.smallest, judgement.rebound);
    let radius = |what: &str, pair: (f64, f64), tolerance: f64, why: &str| {
        Check::relative(of(what), "R0", pair, tolerance, why)
    };
    let both = [(&exact, ""), (&law, ", beside Keller and Miksis")];
    let mut checks = Vec::new();
    for (exact, beside) in both {
        checks.push(radius(
            &format!("smallest radius{beside}"),
            (found.first[1], exact.first[1]),
            smallest(n),
            why_smallest,
        ));
        checks.push(radius(
            &format!("radius of the first rebound{beside}"),
            (found.second[1], exact.second[1]),
            rebound(n),
            why_rebound,
        ));
    }
    checks.push(Check::relative(
        of("time of the smallest radius"),
        "s",
        (found.first[0], exact.first[0]),
        0.02,
        TIME_REASON,
    ));
    checks.push(Check::absolute(
        of("largest defect of the energy ledger until the smallest radius, in units of p V0"),
        "-",
        (swing.defect(found.first[0]), 0.0),
        0.01,
        LEDGER_REASON,
    ));
    checks.push(Check::absolute(
        of("radius before the bubble moves"),
        "R0",
        (swing.first_radius, 1.0),
        0.2 / n,
        "0.2/n: the surface lies between particles to a fifth of a spacing",
    ));
    checks.push(Check::absolute(
        of("pockets that closed"),
        "-",
        (swing.closed as f64, 0.0),
        0.0,
        "the bubble is seen at all times",
    ));
    Ok(checks)
}

/// The bubble grows from rest and comes back: its period.
fn own_frequency() -> Result<Vec<Check>, Failure> {
    let swing = run::run(&SWING, plain(10.0))?;
    let truth = SWING.in_one_dimension(1.0)?;
    let (found, exact) = (
        Extremes::of_growth(&swing.curve)?,
        Extremes::of_growth(&truth.curve)?,
    );
    let half = |e: &Extremes| e.second[0] - e.first[0];
    // Minnaert: 2 pi R sqrt(rho/(3 k p)) about the radius of equilibrium.
    let rest = (SWING.gas_pressure / SWING.pressure).powf(1.0 / 4.2);
    let minnaert = std::f64::consts::TAU
        * run::R0
        * rest
        * (run::DENSITY / (3.0 * 1.4 * SWING.pressure)).sqrt();
    let radius = |what: &str, found: [f64; 2], exact: [f64; 2]| {
        let name = format!("swing, n = 10: {what} radius");
        Check::relative(name, "R0", (found[1], exact[1]), 0.02, SWING_REASON)
    };
    Ok(vec![
        radius("largest", found.first, exact.first),
        radius("following smallest", found.second, exact.second),
        Check::relative(
            "swing, n = 10: time from the largest to the smallest radius",
            "s",
            (half(&found), half(&exact)),
            0.02,
            TIME_REASON,
        ),
        Check::shown(
            "swing, n = 10: the same beside half a period of Minnaert",
            "s",
            half(&found),
            Some(0.5 * minnaert),
            "shown: small swings in a liquid without compressibility",
        ),
        Check::absolute(
            "swing, n = 10: largest defect of the energy ledger until the smallest radius, in units of p V0",
            "-",
            (swing.defect(found.second[0]), 0.0),
            0.01,
            LEDGER_REASON,
        ),
    ])
}

#[cfg(test)]
mod tests {
    use super::*;
    use erode_physics::bubble::BubbleModel;

    #[test]
    fn theory_swings_as_minnaert_says_and_comes_back() {
        let small = Setting {
            gas_pressure: 10.1e6,
            ..SWING
        };
        let law: &dyn BubbleModel = &KellerMiksis;
        let minnaert =
            std::f64::consts::TAU * run::R0 * (run::DENSITY / (4.2 * SWING.pressure)).sqrt();
        for theory in [small.theory(law), small.in_one_dimension(1.0)] {
            let found = Extremes::of_growth(&theory.unwrap().curve).unwrap();
            // Sound that leaves slows it by a part in a hundred.
            let half = found.second[0] - found.first[0];
            assert!(
                (half / (0.5 * minnaert) - 1.0).abs() < 0.02,
                "{half} {minnaert}"
            );
        }
        let gentle = Extremes::of_collapse(&GENTLE.theory(law).unwrap().curve).unwrap();
        assert!((gentle.first[1] - 0.288).abs() < 0.002);
    }

    #[test]
    fn one_dimension_agrees_with_keller_and_miksis_where_the_wall_is_slow() {
        let law = GENTLE.theory(&KellerMiksis).unwrap();
        let truth = GENTLE.in_one_dimension(1.0).unwrap();
        let [a, b] = [&law, &truth].map(|s| Extremes::of_collapse(&s.curve).unwrap());
        for k in 0..2 {
            // The wall has a Mach number of 0.06 at most; its square.
            assert!((a.first[k] / b.first[k] - 1.0).abs() < 0.004, "{k}");
            assert!((a.second[k] / b.second[k] - 1.0).abs() < 0.004, "{k}");
        }
    }
}
