//! `detached-cavity`, `attached-cavity`: the main case and its sibling beside the source.

use super::main_case::{ATTACHED, DETACHED, MainCase, Source, checks};
use super::{Failure, Finding, Validation};
use crate::output::{RunPaths, Summary};
use crate::run::{Quiet, Start, start};
use std::sync::atomic::AtomicBool;

/// Stand-off 1.33.
pub(super) const DETACHED_CAVITY: Validation = Validation {
    name: "detached-cavity",
    description: "bubble at stand-off 1.33 next to A-2205: largest plastic strain and its place",
    reference: "Joshi 2018, section 6.4.1, figure 6.7",
    run: |quick, say| finding(include_str!("../../../../cases/bubble-near-steel/case.toml"), &DETACHED, quick, say),
};

/// Stand-off 0.66.
pub(super) const ATTACHED_CAVITY: Validation = Validation {
    name: "attached-cavity",
    description: "bubble at stand-off 0.66 next to A-2205: largest plastic strain and its place",
    reference: "Joshi 2018, section 6.4.1, figure 6.8",
    run: |quick, say| finding(include_str!("../../../../cases/bubble-attached/case.toml"), &ATTACHED, quick, say),
};

/// Particles per radius of the quick and the full form; the thesis has about 60.
const RESOLUTION: (f64, f64) = (12.0, 30.0);
const RADIUS: f64 = 0.15e-3;

fn finding(case: &str, source: &Source, quick: bool, say: &mut dyn FnMut(&str)) -> Result<Finding, Failure> {
    let particles_per_radius = if quick { RESOLUTION.0 } else { RESOLUTION.1 };
    say(&format!("{particles_per_radius} particles per radius"));
    let failure = |e: &dyn std::fmt::Display| Failure::Run(e.to_string());
    let folder = tempfile::tempdir().map_err(|e| failure(&e))?;
    let file = folder.path().join("case.toml");
    std::fs::write(&file, case).map_err(|e| failure(&e))?;
    let options = Start {
        case: file,
        overrides: vec![format!("setup.bubble_near_wall.particles_per_radius={particles_per_radius}")],
        output: folder.path().join("run"),
        threads: None,
    };
    start(&options, &AtomicBool::new(false), &mut Quiet).map_err(|e| failure(&e))?;
    let summary = Summary::read(&RunPaths::new(&options.output).summary()).map_err(|e| failure(&e))?;
    let number = |name: &str| summary.get(name).unwrap_or(f64::NAN);
    let run = MainCase {
        max_plastic_strain: number("max_plastic_strain"),
        max_plastic_strain_r: number("max_plastic_strain_r"),
        max_plastic_strain_depth: number("max_plastic_strain_depth"),
        jet_speed: number("jet_speed"),
        collapse_time: number("collapse_time"),
        energy_drift: number("energy_drift"),
        radius: RADIUS,
        particles_per_radius,
    };
    Ok(Finding { checks: checks(source, &run), ..Finding::default() })
}
