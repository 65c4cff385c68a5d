//! Energy ledger of a plastic impact.

use crate::bodies::{DX, build, graded, johnson_cook, lattice};
use erode_sph::Geometry::Axisymmetric;
use erode_sph::solid::{Face, Setup, Side};

/// Defect relative to the work of the pressure, after a pulse of 3 GPa.
fn defect(setup: Setup, width: f64) -> f64 {
    let mut solid = build(setup);
    let dt = solid.stable_time_step().dt;
    let duration = 6.0 * width / 5666.0;
    solid.accelerations();
    let mut time = 0.0;
    while time < 2.0 * duration {
        time += dt;
        let shape = if time < duration {
            (std::f64::consts::PI * time / duration).sin().powi(2)
        } else {
            0.0
        };
        let top = solid.surface_mut(Side::Top).unwrap();
        for j in 0..top.pressure.len() {
            let x = top.reference_position[j][0] / width;
            top.pressure[j] = 3e9 * shape * (-x * x).exp();
        }
        solid.step(dt).unwrap();
    }
    let (e, w) = (solid.energy(), solid.state.work);
    println!("{e:?} {w:?} defect {}", solid.energy_defect() / w.pressure);
    assert!(e.plastic_work > 0.1 * w.pressure && w.absorbing < 0.0 && w.viscous > 0.0);
    solid.energy_defect() / w.pressure
}

#[test]
fn ledger_closes_to_one_percent() {
    let faces = [Face::Axis, Face::Absorbing, Face::Absorbing, Face::Traction];
    let d = defect(
        lattice(Axisymmetric, faces, [60, 60], johnson_cook()),
        10.0 * DX,
    );
    assert!(d.abs() < 0.01, "{d}");
    let d = defect(
        graded(Axisymmetric, faces, [45, 45], johnson_cook()),
        10.0 * DX,
    );
    assert!(d.abs() < 0.01, "{d}");
}
