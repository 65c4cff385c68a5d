//! Pit and plastic strain under a static Gaussian pressure, against independent finite elements.

use super::check::Check;
use super::columns::{Columns, CurveError};
use super::steel_lattice::Lattice;
use super::{Failure, Figure, Finding, Style, Validation};
use erode_physics::load::GaussianPressure;
use erode_sph::Geometry;
use erode_sph::solid::{Face, Formulation, QuasiStatic, Side, Solid, SolidError};
use rayon::prelude::*;

pub(super) const VALIDATION: Validation = Validation {
    name: "gaussian-pressure-static",
    description: "pit and plastic strain left by a Gaussian pressure of 1.5 and 2.5 GPa on an axisymmetric steel block",
    reference: "independent finite elements, CalculiX (validation/gaussian-pressure-static)",
    run,
};

/// Extent of the load, m.
const DIAMETER: f64 = 1e-4;
/// Depth of the line, and how far it is compared: there the strain has fallen to nothing.
const DEPTH: f64 = 20e-6;
const LINE_END: f64 = 0.15e-3;

/// One load and what the finite elements say of it.
struct Load {
    amplitude: f64,
    line: &'static str,
    /// Largest plastic strain at a Gauss point; pit after unloading, m; plastic work, J (finest mesh).
    peak_strain: f64,
    pit: f64,
    plastic_work: f64,
}

const LOADS: [Load; 2] = [
    Load {
        amplitude: 1.5e9,
        line: include_str!(
            "../../../../validation/gaussian-pressure-static/depth20um_sH1p5GPa.csv"
        ),
        peak_strain: 0.003_493_253,
        pit: 0.079_807_8e-6,
        plastic_work: 0.000_163_277_5e-3,
    },
    Load {
        amplitude: 2.5e9,
        line: include_str!(
            "../../../../validation/gaussian-pressure-static/depth20um_sH2p5GPa.csv"
        ),
        peak_strain: 0.027_475_43,
        pit: 1.100_99e-6,
        plastic_work: 0.004_640_604e-3,
    },
];

const WHY: &str = "issue 3; the kernel smooths the load over one spacing, which takes about 1 % off a load ten spacings wide \
                   and several times that off the strain";
const SHOWN: &str =
    "not asked; the pit at 1.5 GPa is a difference of 11 % between loaded and elastic depth";

/// Ten spacings per load radius.
const SPACING: f64 = 5e-6;
/// A ramp of six passages of a wave through the large block, and a hold of seven through this one.
fn loading(solid: &Solid, size: f64) -> QuasiStatic {
    let m = &solid.material;
    QuasiStatic {
        ramp: 1e-6,
        // The slowest mode of the block must have rung out: its energy falls by e per 0.2 us.
        hold: 7.0 * size / m.elastic.longitudinal_speed(m.density),
        damping: 5e6,
    }
}

/// Size of the block (m) and the loads. A small block is stiff between its rollers: that of the quick form adds 2 % to the pit
/// at 2.5 GPa and 7 % to the strain at 1.5 GPa, which is hardly above the yield point.
fn form(quick: bool) -> (f64, &'static [Load]) {
    if quick {
        (0.3e-3, &LOADS[1..])
    } else {
        (1e-3, &LOADS)
    }
}

fn run(quick: bool, say: &mut dyn FnMut(&str)) -> Result<Finding, Failure> {
    let (size, loads) = form(quick);
    let lattice = Lattice {
        geometry: Geometry::Axisymmetric,
        size: [size; 2],
        spacing: SPACING,
        faces: [Face::Axis, Face::Symmetry, Face::Symmetry, Face::Traction],
        formulation: Formulation::TotalLagrangian,
    };
    say(&format!("block of {} mm", size * 1e3));
    let runs: Vec<Solid> = loads
        .par_iter()
        .map(|load| press(&lattice, load))
        .collect::<Result<_, _>>()?;
    let mut finding = Finding::default();
    for (load, solid) in loads.iter().zip(&runs) {
        compare(&lattice, load, solid, &mut finding)?;
    }
    Ok(finding)
}

/// Loads and unloads.
fn press(lattice: &Lattice, load: &Load) -> Result<Solid, Failure> {
    let mut solid = lattice.build()?;
    let gaussian = GaussianPressure {
        amplitude: load.amplitude,
        diameter: DIAMETER,
        pulse: None,
    };
    let loading = loading(&solid, lattice.size[0]);
    let mut apply = |from: f64, to: f64| -> Result<(), SolidError> {
        loading.run(
            &mut solid,
            |solid, share| {
                let part = from + (to - from) * share.value;
                if let Some(top) = solid.surface_mut(Side::Top) {
                    top.push(|x| part * gaussian.at(x[0], 0.0));
                }
            },
            |_, _| (),
        )
    };
    apply(0.0, 1.0)?;
    apply(1.0, 0.0)?;
    Ok(solid)
}

fn compare(
    lattice: &Lattice,
    load: &Load,
    solid: &Solid,
    finding: &mut Finding,
) -> Result<(), Failure> {
    let title = format!(
        "{} GPa, {} spacings per load radius",
        load.amplitude * 1e-9,
        (0.5 * DIAMETER / lattice.spacing).round()
    );
    let reference = Columns::parse(load.line)?.curve("eq_plastic_strain_unloaded_1", 1e-3, 1.0)?;
    let top = lattice.size[1];
    let line = lattice.line(top - DEPTH, LINE_END, |k| solid.state.plastic_strain[k]);
    let error = CurveError::of(&line, &reference);
    let pit = top
        - solid
            .surface(Side::Top)
            .map_or(f64::NAN, |s| s.position[0][1]);
    if let Ok(resolution) = solid.load_resolution(Side::Top, 0.0, 0.5 * DIAMETER)
        && !resolution.is_enough()
    {
        finding.notes.push(resolution.to_string());
    }
    let row = |what: &str, value: f64, tolerance: f64| {
        Check::absolute(
            format!("{title}: {what}"),
            "-",
            (value, 0.0),
            tolerance,
            WHY,
        )
    };
    let shown = |what: &str, unit: &str, value: f64, reference: f64| {
        Check::shown(
            format!("{title}: {what}"),
            unit,
            value,
            Some(reference),
            SHOWN,
        )
    };
    finding.checks.extend([
        row(
            "plastic strain 20 um deep, mean error / peak",
            error.mean,
            0.02,
        ),
        row(
            "plastic strain 20 um deep, largest error / peak",
            error.largest,
            0.05,
        ),
        if load.amplitude > 2e9 {
            let quantity = format!("{title}: depth of the pit after unloading");
            Check::relative(quantity, "m", (pit, load.pit), 0.03, WHY)
        } else {
            shown("depth of the pit after unloading", "m", pit, load.pit)
        },
        shown(
            "peak plastic strain",
            "-",
            lattice.peak_strain(solid),
            load.peak_strain,
        ),
        shown(
            "plastic work",
            "J",
            solid.energy().plastic_work,
            load.plastic_work,
        ),
        Check::absolute(
            format!("{title}: kinetic / internal energy at the end"),
            "-",
            (solid.inertia_share(), 0.0),
            1e-4,
            "inertia must be negligible for a comparison with statics",
        ),
    ]);
    let mut figure = Figure::new(
        &format!("gaussian-pressure-static-{:.1}GPa", load.amplitude * 1e-9),
        &format!("{title}: plastic strain 20 um deep after unloading"),
        ("radius", "m"),
        ("plastic strain", "-"),
    );
    figure.add("Erode", Style::Line, line);
    let near = reference.into_iter().filter(|p| p[0] <= LINE_END);
    figure.add("finite elements", Style::Dashed, near.collect());
    finding.figures.push(figure);
    Ok(())
}
