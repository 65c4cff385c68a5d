//! Figures 13 to 16 of Peters and el Moctar 2020: bubbles in a vortex, with corrected forces, nothing tuned.

use super::{Kind, Reproduction, at_most};
use crate::validate::bubble_vortex::ride::{Ride, START, Setup};
use crate::validate::{Check, Failure, Figure, Finding, Style};
use erode_fv::bubbles::carrier::VortexForm;
use erode_fv::bubbles::forces::{DragLaw, Forces, PressureForce};
use rayon::prelude::*;

const SOURCE: &str = "Peters and el Moctar 2020, section 4.2, forces corrected";

pub(super) const ALL: [Reproduction; 4] = [
    Reproduction {
        id: "peters-fig-13",
        shows: "paths of bubbles of 0.8, 2 and 5 mm in a vortex",
        source: SOURCE,
        kind: Kind::Alone(figure_13),
    },
    Reproduction {
        id: "peters-fig-14",
        shows: "their distance from the axis and their radius over time",
        source: SOURCE,
        kind: Kind::Alone(figure_14),
    },
    Reproduction {
        id: "peters-fig-15",
        shows: "a bubble of 2 mm at three cavitation numbers: distance and radius over time",
        source: SOURCE,
        kind: Kind::Alone(figure_15),
    },
    Reproduction {
        id: "peters-fig-16",
        shows: "paths of a bubble of 2 mm with all forces, without drag, without pressure gradient",
        source: SOURCE,
        kind: Kind::Alone(figure_16),
    },
];

const RADII: [f64; 3] = [0.8e-3, 2e-3, 5e-3];
#[allow(clippy::approx_constant)] // not pi: a cavitation number of the source
const CAVITATION: [f64; 3] = [3.602, 3.142, 2.682];
/// Simulated time, s.
const DURATION: f64 = 40.0;
const DRAG: &str =
    "the source seems to use the drag of (3.27) as misprinted, which is not in use here";

const BASE: Setup = Setup {
    form: VortexForm::OuterSpeedCorrected,
    radius: RADII[1],
    cavitation_number: CAVITATION[0],
    forces: Forces::IN_FLOW,
    duration: DURATION,
    radius_share: 0.1,
};

fn rides(setups: &[Setup]) -> Result<Vec<Ride>, Failure> {
    setups.par_iter().map(Setup::ride).collect()
}

fn by_size() -> Result<Vec<Ride>, Failure> {
    rides(&RADII.map(|radius| Setup { radius, ..BASE }))
}

fn sizes() -> [String; 3] {
    RADII.map(|r| format!("{} mm", r * 1e3))
}

fn curves(
    name: &str,
    axes: [(&str, &str); 2],
    labels: &[String],
    rides: &[Ride],
    points: fn(&Ride) -> Vec<[f64; 2]>,
) -> Figure {
    let mut figure = Figure::new(name, "Bubble in a vortex", axes[0], axes[1]);
    for (label, ride) in labels.iter().zip(rides) {
        figure.add(label, Style::Line, points(ride));
    }
    figure
}

const PATH: [(&str, &str); 2] = [("x", "m"), ("y", "m")];
const DISTANCE: [(&str, &str); 2] = [("time", "s"), ("distance from the axis / core radius", "-")];
const RADIUS: [(&str, &str); 2] = [("time", "s"), ("radius", "m")];

fn figure_13(say: &mut dyn FnMut(&str)) -> Result<Finding, Failure> {
    say("three bubbles in the vortex");
    let rides = by_size()?;
    Ok(Finding {
        checks: vec![
            Check::at_least(
                "turns of 0.8 mm before the core",
                "-",
                rides[0].turns_to_core(),
                4.0,
                DRAG,
            ),
            Check::absolute(
                "turns of 5 mm before the core",
                "-",
                (rides[2].turns_to_core(), 1.0),
                0.25,
                DRAG,
            ),
        ],
        figures: vec![curves("paths", PATH, &sizes(), &rides, Ride::path)],
        notes: vec![
            "\"more than four rotations\" for 0.8 mm, \"just one rotation\" for 5 mm.".into(),
        ],
    })
}

fn figure_14(say: &mut dyn FnMut(&str)) -> Result<Finding, Failure> {
    say("three bubbles in the vortex");
    let rides = by_size()?;
    let words = "\"the attractive forces increased with increasing\" R0";
    let mut checks = Vec::new();
    for (a, b) in [(0, 1), (1, 2)] {
        let ratio = rides[a].time_to_core() / rides[b].time_to_core();
        let quantity = format!("time to the core, {} over {}", sizes()[a], sizes()[b]);
        checks.push(Check::more_than(quantity, "-", ratio, 1.0, words));
    }
    for (ride, size) in rides.iter().zip(sizes()) {
        let quantity = format!("radius at the end over the first, {size}");
        checks.push(Check::more_than(
            quantity,
            "-",
            ride.mean_radius(),
            1.0,
            "\"All three bubbles grew\"",
        ));
    }
    Ok(Finding {
        checks,
        figures: vec![
            curves("distance", DISTANCE, &sizes(), &rides, Ride::distances),
            curves("radius", RADIUS, &sizes(), &rides, Ride::radii),
        ],
        notes: Vec::new(),
    })
}

fn figure_15(say: &mut dyn FnMut(&str)) -> Result<Finding, Failure> {
    say("three cavitation numbers");
    let rides = rides(&CAVITATION.map(|cavitation_number| Setup {
        cavitation_number,
        ..BASE
    }))?;
    let labels = CAVITATION.map(|c| c.to_string());
    let mut checks = Vec::new();
    for (a, b) in [(1, 0), (2, 1)] {
        let pair = format!("cavitation number {} over {}", labels[a], labels[b]);
        let size = rides[a].max_radius() / rides[b].max_radius();
        let swing = rides[a].swing() / rides[b].swing();
        checks.push(Check::more_than(
            format!("largest radius, {pair}"),
            "-",
            size,
            1.0,
            "\"For smaller cavitation numbers, not only the size of the bubbles, but also the amplitudes of their size oscillations increased\"",
        ));
        checks.push(Check::more_than(
            format!("swing of the radius, {pair}"),
            "-",
            swing,
            1.0,
            "\"but also the amplitudes of their size oscillations increased\"",
        ));
    }
    for (ride, label) in rides.iter().zip(&labels) {
        checks.push(Check::shown(
            format!("largest radius over the first, cavitation number {label}"),
            "-",
            ride.max_radius(),
            None,
            "\"Averaging the liquid pressure at the bubbles’ walls prevented an unbounded growth\": no number is given",
        ));
    }
    Ok(Finding {
        checks,
        figures: vec![
            curves("distance", DISTANCE, &labels, &rides, Ride::distances),
            curves("radius", RADIUS, &labels, &rides, Ride::radii),
        ],
        notes: Vec::new(),
    })
}

fn figure_16(say: &mut dyn FnMut(&str)) -> Result<Finding, Failure> {
    say("forces switched off");
    let with = |forces| Setup { forces, ..BASE };
    let no_drag = Forces {
        drag: DragLaw::Off,
        ..BASE.forces
    };
    let no_gradient = Forces {
        pressure: PressureForce::Off,
        ..BASE.forces
    };
    let rides = rides(&[BASE, with(no_drag), with(no_gradient)])?;
    let labels = ["all forces", "without drag", "without pressure gradient"].map(str::to_owned);
    let drift = (rides[2].distance_after_turn() / START - 1.0).abs();
    Ok(Finding {
        checks: vec![
            Check::absolute(
                "without pressure gradient: drift from the streamline in one turn",
                "-",
                (drift, 0.0),
                0.02,
                "\"the bubble mostly followed streamlines\"",
            ),
            Check::at_least(
                "without drag: turns of the radial motion",
                "-",
                rides[1].radial_turns(),
                2.0,
                "\"oscillatory behaviour\"",
            ),
            at_most(
                "all forces: distance after one turn / first distance",
                "-",
                rides[0].distance_after_turn() / START,
                1.0,
                "\"approached the vortex centre following a spiral-shaped path\"",
            ),
        ],
        figures: vec![curves("paths", PATH, &labels, &rides, Ride::path)],
        notes: Vec::new(),
    })
}
