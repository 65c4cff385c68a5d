//! Every validation in its quick form: all tolerances are kept but for those named here.

#![allow(clippy::unwrap_used)]

use erode::validate::{names, run, text};

/// Tolerances that are known to be missed; a row that is repaired must be taken off the list.
const KNOWN_MISSES: [&str; 1] =
    // The jet that strikes the metal is one or two particles wide at any spacing tried; there the sums for force and volume,
    // which are not adjoint to each other at a free surface, miss 1.3 to 1.5 % of the energy put in.
    ["n = 8: defect of the energy ledger"];

/// Work of the gas on the particles and p dV of its measured volume differ, the sums for force and volume not being adjoint at
/// a free surface: 2 to 4 % of p V0 in the ledger. At 50 MPa the smallest radius is two spacings where nothing is refined; with
/// refinement it is that of compressible liquid. The law of Keller and Miksis, made for walls that are
/// slow beside sound, gives a smallest radius and a rebound 18 % above those of compressible liquid, which the particles meet. The
/// swing at 10 particles per radius is 3.2 % slow: uniform pressure drives particles of graded spacing.
const KNOWN_MISSES_OF_GAS: [&str; 9] = [
    "1 MPa, n = 15: largest defect of the energy ledger until the smallest radius, in units of p V0",
    "50 MPa, n = 30: smallest radius",
    "50 MPa, n = 30: radius of the first rebound, beside Keller and Miksis",
    "50 MPa, n = 30: largest defect of the energy ledger until the smallest radius, in units of p V0",
    "50 MPa, n = 30, refined to 8 per R: smallest radius, beside Keller and Miksis",
    "50 MPa, n = 30, refined to 8 per R: radius of the first rebound, beside Keller and Miksis",
    "50 MPa, n = 30, refined to 8 per R: largest defect of the energy ledger until the smallest radius, in units of p V0",
    "swing, n = 10: time from the largest to the smallest radius",
    "swing, n = 10: largest defect of the energy ledger until the smallest radius, in units of p V0",
];

/// Halves do not lie exactly where the surface was: whenever a layer is halved it moves by some hundredths of a spacing, in and
/// out in turn, 11 % of the speed at 15 particles per radius, 5 % at 30 (4 to 8 % with other spacings from 30 on).
const KNOWN_MISS_OF_REFINEMENT: [&str; 5] = [
    "n = 15, refined to 15 per R: wall speed at R = 0.3 R0",
    "n = 15, refined to 15 per R: wall speed at R = 0.2 R0",
    "n = 15, refined to 15 per R: wall speed at R = 0.14 R0",
    "n = 15, refined to 15 per R: wall speed at R = 0.1 R0",
    "n = 15, refined to 15 per R: largest relative error of the speed, R = 0.9 to 0.1 R0 (at 0.2)",
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
    quick("gas-rebound", &KNOWN_MISSES_OF_GAS);
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
