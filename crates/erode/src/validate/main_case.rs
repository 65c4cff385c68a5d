//! The main case beside its source: plastic strain of A-2205 after the collapse of a bubble of 0.15 mm, 50 MPa.
//!
//! One published run of another method, without error bars: its values stand beside ours; judged is where plastic strain
//! is largest, and the ledger. The quick form runs at low resolution and judges the ledger alone. What the liquid does to the
//! wall below the attached cavity stands beside an independent calculation on a grid, too.

use super::check::Check;
use super::{Failure, Finding, Validation};
use crate::analysis::published::{ATTACHED_STRAIN, DETACHED_STRAIN};
use crate::analysis::{WallLoad, WallPressure};
use crate::output::{RunPaths, Summary, Table};
use crate::run::{self, Observer, Progress, Start};
use std::fs;
use std::path::Path;
use std::sync::atomic::AtomicBool;

pub(super) const DETACHED: Validation = Validation {
    name: "detached-cavity",
    description: "plastic strain in A-2205 steel after the collapse of a bubble of 0.15 mm at standoff 1.33, 50 MPa",
    reference: "Joshi 2018, section 6.4.1 and figure 6.7: 0.23 %, off the axis (validation/detached-cavity)",
    run: |quick, say| finding(&Source::DETACHED, quick, say),
};

pub(super) const ATTACHED: Validation = Validation {
    name: "attached-cavity",
    description: "plastic strain in A-2205 steel after the collapse of a bubble of 0.15 mm at standoff 0.66, 50 MPa",
    reference: "Joshi 2018, section 6.4.1 and figure 6.8: 0.83 %, on the axis (validation/attached-cavity)",
    run: |quick, say| finding(&Source::ATTACHED, quick, say),
};

/// Particles per radius: quick, full.
const RESOLUTION: (u32, u32) = (8, 30);

/// Radius of the bubble, m.
const RADIUS: f64 = 0.15e-3;

/// The wall is looked at to this distance from the axis (m), in this time (s): jet and ring fall on it there and then.
const LOADED: (f64, [f64; 2]) = (0.1e-3, [0.7e-6, 1.2e-6]);

/// Density times speed of longitudinal waves of the wall, kg/(m2 s).
const IMPEDANCE: f64 = 7800.0 * 5666.0;

/// What an independent calculation on a grid finds at stand-off 0.66 (validation/attached-cavity).
const ON_A_GRID: WallLoad = WallLoad {
    impulse: 2.925e-6,
    work: 6.99e-5,
};

/// What the source says about one standoff.
struct Source {
    /// The case file that users start from.
    case: &'static str,
    max_plastic_strain: f64,
    off_axis: bool,
}

impl Source {
    const DETACHED: Self = Self {
        case: include_str!("../../../../cases/bubble-near-steel/case.toml"),
        max_plastic_strain: DETACHED_STRAIN,
        off_axis: true,
    };
    const ATTACHED: Self = Self {
        case: include_str!("../../../../cases/bubble-attached/case.toml"),
        max_plastic_strain: ATTACHED_STRAIN,
        off_axis: false,
    };
}

/// Hands the progress of a run on.
struct Listener<'a>(&'a mut dyn FnMut(&str));

impl Observer for Listener<'_> {
    fn say(&mut self, text: &str) {
        (self.0)(text);
    }

    fn progress(&mut self, p: &Progress) {
        let share = 100.0 * p.time / p.end_time;
        (self.0)(&format!(
            "{share:.0} % of the simulated time, step {}",
            p.step
        ));
    }
}

fn finding(source: &Source, quick: bool, say: &mut dyn FnMut(&str)) -> Result<Finding, Failure> {
    let n = if quick { RESOLUTION.0 } else { RESOLUTION.1 };
    let problem = |e: &dyn std::fmt::Display| Failure::Run(e.to_string());
    let folder = tempfile::tempdir().map_err(|e| problem(&e))?;
    let case = folder.path().join("case.toml");
    fs::write(&case, source.case).map_err(|e| problem(&e))?;
    let (summary, load) = simulate(&case, folder.path(), n, say)?;
    let get = |name: &str| summary.get(name).unwrap_or(f64::NAN);
    let counts = format!(
        "n = {n}: {} particles, {} steps",
        get("particles"),
        get("steps")
    );
    let mut checks = checks(source, &summary, n, quick);
    if !source.off_axis {
        checks.extend(loads(load, n, quick));
    }
    Ok(Finding {
        checks,
        notes: vec![counts],
        ..Finding::default()
    })
}

fn simulate(
    case: &Path,
    folder: &Path,
    n: u32,
    say: &mut dyn FnMut(&str),
) -> Result<(Summary, WallLoad), Failure> {
    let problem = |e: &dyn std::fmt::Display| Failure::Run(e.to_string());
    let output = folder.join("run");
    let start = Start {
        case: case.into(),
        overrides: vec![format!("setup.bubble_near_wall.particles_per_radius={n}")],
        output: output.clone(),
        threads: None,
    };
    let never = AtomicBool::new(false);
    run::start(&start, &never, &mut Listener(say)).map_err(|e| problem(&e))?;
    let summary = Summary::read(&output.join("summary.json")).map_err(|e| problem(&e))?;
    let paths = RunPaths::new(&output);
    let table = Table::read(&paths.surface("wall_pressure")).map_err(|e| problem(&e))?;
    let wall = WallPressure::of(&table);
    let wall = wall.ok_or_else(|| Failure::Absent("no wall pressure was recorded".into()))?;
    Ok((summary, wall.load(LOADED.0, IMPEDANCE, LOADED.1)))
}

/// Impulse and acoustic work on the wall beside those on a grid.
fn loads(load: WallLoad, n: u32, quick: bool) -> [Check; 2] {
    let why = "two methods that share nothing but the equations; it settles whether the load is right or wrong by a factor, so a fifth is \
               enough (8 % and 6 % were known at 30 per radius)";
    let check = |what: &str, unit: &str, value: f64, reference: f64| {
        let quantity = format!("n = {n}: {what} on the wall within 0.1 mm of the axis");
        if quick {
            Check::shown(quantity, unit, value, Some(reference), COARSE)
        } else {
            Check::relative(quantity, unit, (value, reference), 0.2, why)
        }
    };
    [
        check("impulse", "N s", load.impulse, ON_A_GRID.impulse),
        check("acoustic work", "J", load.work, ON_A_GRID.work),
    ]
}

const SIDE_BY_SIDE: &str = "not judged: one published run of another method, without error bars";
const COARSE: &str = "not judged in the quick form: the jet is one or two particles wide";

fn checks(source: &Source, summary: &Summary, n: u32, quick: bool) -> Vec<Check> {
    let get = |name: &str| summary.get(name).unwrap_or(f64::NAN);
    let title = |what: &str| format!("n = {n}: {what}");
    let shown = |name: &str, what: &str| {
        let unit = summary.unit(name).unwrap_or("-");
        Check::shown(
            title(what),
            unit,
            get(name),
            None,
            "not judged: the source gives no number",
        )
    };
    let strain = Check::shown(
        title("largest plastic strain"),
        "-",
        get("max_plastic_strain"),
        Some(source.max_plastic_strain),
        SIDE_BY_SIDE,
    );
    let mut checks = vec![
        strain,
        place(source, get("max_plastic_strain_r"), n, quick),
        shown("max_plastic_strain_depth", "its depth"),
        shown("jet_speed", "jet speed"),
        shown("collapse_time", "collapse time"),
        shown("peak_wall_pressure", "largest pressure on the wall"),
        shown("pit_depth", "depth of the pit"),
        shown("plastic_work", "plastic work"),
        Check::absolute(
            title("defect of the energy ledger"),
            "-",
            (get("energy_drift"), 0.0),
            0.01,
            "issue 2: the ledger closes to 1 % of the energy put in, at any spacing",
        ),
    ];
    if source.off_axis {
        checks.extend(ring(source, summary, n, quick));
    }
    checks
}

/// The maximum off the axis, which need not be the largest: our jet also strains the metal at the axis.
fn ring(source: &Source, summary: &Summary, n: u32, quick: bool) -> [Check; 2] {
    let get = |name: &str| summary.get(name).unwrap_or(f64::NAN);
    let strain = format!("n = {n}: maximum of plastic strain off the axis");
    let place = format!("n = {n}: its distance from the axis");
    let r = get("off_axis_plastic_strain_r");
    let why = "the source has it between 0.1 and 0.2 mm; half of that range again on each side, chosen after a first result \
               (0.105 mm) was known";
    [
        Check::shown(
            strain,
            "-",
            get("off_axis_plastic_strain"),
            Some(source.max_plastic_strain),
            if quick { COARSE } else { SIDE_BY_SIDE },
        ),
        if quick {
            Check::shown(place, "m", r, Some(0.15e-3), COARSE)
        } else {
            Check::absolute(place, "m", (r, 0.15e-3), 0.075e-3, why)
        },
    ]
}

/// Where the largest plastic strain lies.
fn place(source: &Source, r: f64, n: u32, quick: bool) -> Check {
    let quantity = format!("n = {n}: distance of the largest plastic strain from the axis");
    let apart = 2.0 * RADIUS / f64::from(n);
    match (quick, source.off_axis) {
        (true, _) => Check::shown(quantity, "m", r, None, COARSE),
        (false, true) => Check::at_least(
            quantity,
            "m",
            r,
            apart,
            "the source has it off the axis; two spacings tell it from the axis",
        ),
        (false, false) => Check::absolute(
            quantity,
            "m",
            (r, 0.0),
            apart,
            "the source has it on the axis; within two spacings it cannot be told from the axis",
        ),
    }
}
