//! Deformation gradients and stresses of motions that are known exactly.

use crate::bodies::{FREE, Faces, build, graded, lattice};
use erode_physics::strength::Strength;
use erode_sph::Geometry::{Axisymmetric, Plane};
use erode_sph::solid::{Face, Solid};

const AXIS: Faces = [Face::Axis, Face::Traction, Face::Traction, Face::Traction];

fn place(solid: &mut Solid, map: impl Fn([f64; 2]) -> [f64; 2]) {
    for (x, &reference) in solid
        .state
        .position
        .iter_mut()
        .zip(&solid.reference.position)
    {
        *x = map(reference);
    }
}

fn largest_stress(solid: &Solid) -> f64 {
    (solid.state.stress.iter()).fold(0.0, |m: f64, s| {
        let parts = [s.xx, s.yy, s.zz, s.xy, s.xz, s.yz];
        parts.iter().fold(m, |m, x| m.max(x.abs()))
    })
}

/// Round-off of positions of 1 mm over spacings of 10 micrometres, times E, times the number of steps, is a few Pa.
const NO_STRESS: f64 = 30.0;

#[test]
fn rigid_motion_gives_no_stress() {
    let mut solid = build(graded(Plane, FREE, [12, 15], Strength::Elastic));
    for step in 1..=20 {
        let (sin, cos) = (0.3 * f64::from(step)).sin_cos();
        let shift = 1e-4 * f64::from(step);
        place(&mut solid, |x| {
            [
                cos * x[0] - sin * x[1] + shift,
                sin * x[0] + cos * x[1] - shift,
            ]
        });
        solid.update_stress(1e-9).unwrap();
    }
    assert!(
        largest_stress(&solid) < NO_STRESS,
        "{}",
        largest_stress(&solid)
    );
    let mut solid = build(graded(Axisymmetric, AXIS, [12, 15], Strength::Elastic));
    place(&mut solid, |x| [x[0], x[1] + 3e-4]);
    solid.update_stress(1e-9).unwrap();
    assert!(
        largest_stress(&solid) < NO_STRESS,
        "{}",
        largest_stress(&solid)
    );
}

#[test]
fn stress_turns_with_the_body() {
    let mut solid = build(graded(Plane, FREE, [12, 15], Strength::Elastic));
    place(&mut solid, |x| [1.001 * x[0], x[1]]);
    solid.update_stress(1e-9).unwrap();
    let before = solid.state.stress[50];
    for step in 1..=30 {
        let (sin, cos) = (std::f64::consts::PI / 60.0 * f64::from(step)).sin_cos();
        place(&mut solid, |x| {
            [
                cos * 1.001 * x[0] - sin * x[1],
                sin * 1.001 * x[0] + cos * x[1],
            ]
        });
        solid.update_stress(1e-9).unwrap();
    }
    let after = solid.state.stress[50];
    for (a, b) in [
        (after.yy, before.xx),
        (after.xx, before.yy),
        (after.zz, before.zz),
        (after.xy, 0.0),
    ] {
        assert!((a - b).abs() < 100.0, "{a} {b}");
    }
}

#[test]
fn linear_fields_are_exact() {
    let a = [[1.02, -0.03], [0.05, 0.97]];
    let mut solid = build(graded(Plane, FREE, [12, 15], Strength::Elastic));
    place(&mut solid, |x| {
        [
            a[0][0] * x[0] + a[0][1] * x[1],
            a[1][0] * x[0] + a[1][1] * x[1],
        ]
    });
    solid.update_stress(1e-9).unwrap();
    for f in &solid.state.deformation {
        for i in 0..2 {
            for j in 0..2 {
                assert!((f[i][j] - a[i][j]).abs() < 1e-12);
            }
        }
    }
    // Mirrors at the axis and at a symmetry face allow stretch only.
    let faces = [Face::Axis, Face::Traction, Face::Symmetry, Face::Traction];
    let mut solid = build(graded(Axisymmetric, faces, [12, 15], Strength::Elastic));
    place(&mut solid, |x| [1.01 * x[0], 0.98 * x[1]]);
    solid.update_stress(1e-9).unwrap();
    for (f, hoop) in solid
        .state
        .deformation
        .iter()
        .zip(&solid.state.hoop_stretch)
    {
        assert!((f[0][0] - 1.01).abs() < 1e-12 && (f[1][1] - 0.98).abs() < 1e-12);
        assert!(f[0][1].abs() < 1e-12 && f[1][0].abs() < 1e-12 && (hoop - 1.01).abs() < 1e-12);
    }
}

#[test]
fn small_uniaxial_strain_has_hookes_stress() {
    let faces = [
        Face::Symmetry,
        Face::Symmetry,
        Face::Symmetry,
        Face::Traction,
    ];
    let mut solid = build(lattice(Plane, faces, [8, 10], Strength::Elastic));
    place(&mut solid, |x| [x[0], (1.0 - 1e-7) * x[1]]);
    solid.update_stress(1e-9).unwrap();
    let e = solid.material.elastic;
    let (lambda, mu) = (e.lame_lambda(), e.shear_modulus());
    for s in &solid.state.stress {
        // Relative to second order in the strain of 1e-7.
        assert!((s.yy / (-1e-7 * (lambda + 2.0 * mu)) - 1.0).abs() < 1e-5);
        assert!((s.xx / (-1e-7 * lambda) - 1.0).abs() < 1e-5);
        assert!((s.zz / (-1e-7 * lambda) - 1.0).abs() < 1e-5);
    }
}
