//! Every validation in its quick form: all tolerances are kept but for those named here.

#![allow(clippy::unwrap_used)]

use erode::validate::{names, run, text};

/// Tolerances that are known to be missed; a row that is repaired must be taken off the list.
const KNOWN_MISSES: [&str; 1] =
    // The jet that strikes the metal is one or two particles wide at any spacing tried; there the sums for force and volume,
    // which are not adjoint to each other at a free surface, miss 1.3 to 1.5 % of the energy put in.
    ["n = 8: defect of the energy ledger"];

/// The bubble that comes back after a collapse to a fourteenth of its radius is no longer round: its surface, thrown back by the gas,
/// ripples, and some of the energy stays in the ripples. -14 to -17 % at 30 particles per radius, -13 % at 45 and 60.
const KNOWN_MISS_OF_GAS: [&str; 1] = ["50 MPa, n = 30: radius of the first rebound"];

/// The layer at the surface is halved all at once when it first becomes too coarse, which moves the surface by a tenth of a
/// spacing: a bump of the speed, 8.9 % at 15 particles per radius, 6.3 % at 30; elsewhere the speed keeps to 4.3 %.
const KNOWN_MISS_OF_REFINEMENT: [&str; 1] = [
    "n = 15, refined to 15 per R: largest relative error of the speed, R = 0.9 to 0.1 R0 (at 0.6)",
];

fn quick(name: &str, known: &[&str]) {
    let outcomes = run(&[name.to_owned()], false, true, &mut |_| ()).expect("the names are known");
    for outcome in outcomes {
        let table = text(&outcome);
        println!("{table}");
        assert!(outcome.failure.is_none() && !outcome.finding.checks.is_empty());
        let missed = outcome.finding.checks.iter().filter(|c| !c.passed);
        let missed: Vec<&str> = missed.map(|c| c.quantity.as_str()).collect();
        assert_eq!(missed, known, "{table}");
    }
}

#[test]
fn johnson_cook_point() {
    quick("johnson-cook-point", &[]);
}

#[test]
fn axis_consistency() {
    quick("axis-consistency", &[]);
}

#[test]
fn wave_in_bar() {
    quick("wave-in-bar", &[]);
}

#[test]
fn plate_impact() {
    quick("plate-impact", &[]);
}

#[test]
fn taylor_bar() {
    quick("taylor-bar", &[]);
}

#[test]
fn mass_loss() {
    quick("mass-loss", &[]);
}

#[test]
fn interface_wave() {
    quick("interface-wave", &[]);
}

#[test]
fn indentation_axisym() {
    quick("indentation-axisym", &[]);
}

#[test]
fn indentation_planestrain() {
    quick("indentation-planestrain", &[]);
}

#[test]
fn gaussian_pressure_static() {
    quick("gaussian-pressure-static", &[]);
}

#[test]
fn rayleigh_collapse() {
    quick("rayleigh-collapse", &KNOWN_MISS_OF_REFINEMENT);
}

#[test]
fn gas_rebound() {
    quick("gas-rebound", &KNOWN_MISS_OF_GAS);
}

#[test]
fn detached_cavity() {
    quick("detached-cavity", &[]);
}

#[test]
fn attached_cavity() {
    quick("attached-cavity", &KNOWN_MISSES);
}

#[test]
fn bubble_rayleigh() {
    quick("bubble-rayleigh", &[]);
}

#[test]
fn bubble_acoustic() {
    quick("bubble-acoustic", &[]);
}

#[test]
fn bubble_rise() {
    quick("bubble-rise", &[]);
}

#[test]
fn bubble_vortex() {
    quick("bubble-vortex", &[]);
}

#[test]
fn erosion_formulae() {
    quick("erosion-formulae", &[]);
}

#[test]
fn none_is_forgotten() {
    let tested = [
        "johnson-cook-point",
        "axis-consistency",
        "wave-in-bar",
        "plate-impact",
        "taylor-bar",
        "mass-loss",
        "interface-wave",
        "indentation-axisym",
        "indentation-planestrain",
        "gaussian-pressure-static",
        "rayleigh-collapse",
        "gas-rebound",
        "detached-cavity",
        "attached-cavity",
        "bubble-rayleigh",
        "bubble-acoustic",
        "bubble-rise",
        "bubble-vortex",
        "erosion-formulae",
    ];
    assert_eq!(names(), tested);
}
