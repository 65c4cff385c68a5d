//! Deformation gradients and stresses of given motions.

use crate::bodies::{DX, build, disordered, johnson_cook, lattice};
use erode_physics::strength::Strength;
use erode_sph::solid::space::SpaceSolid;

/// Moves particles to A X.
fn place(solid: &mut SpaceSolid, map: &[[f64; 3]; 3]) {
    for a in 0..solid.len() {
        let x = solid.reference_position(a);
        let y = map.map(|row| row[0] * x[0] + row[1] * x[1] + row[2] * x[2]);
        solid.state.position.set(a, y);
    }
}

/// Rotation about an axis by an angle (Rodrigues).
fn rotation(axis: [f64; 3], angle: f64) -> [[f64; 3]; 3] {
    let (s, c) = angle.sin_cos();
    let skew = [
        [0.0, -axis[2], axis[1]],
        [axis[2], 0.0, -axis[0]],
        [-axis[1], axis[0], 0.0],
    ];
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let unit = f64::from(u8::from(i == j));
            c * unit + s * skew[i][j] + (1.0 - c) * axis[i] * axis[j]
        })
    })
}

const AXIS: [f64; 3] = [0.6, -0.48, 0.64];

#[test]
fn linear_fields_are_exact_on_disordered_particles() {
    let map = [[1.1, 0.2, -0.3], [0.05, 0.9, 0.1], [-0.2, 0.15, 1.2]];
    let mut solid = build(&disordered([9, 8, 7], Strength::Elastic));
    place(&mut solid, &map);
    solid.update_stress(1e-9).unwrap();
    for f in solid.state.deformation.iter() {
        for (k, f) in f.into_iter().enumerate() {
            assert!((f - map[k / 3][k % 3]).abs() < 1e-13, "{k} {f}");
        }
    }
}

#[test]
fn turning_leaves_no_stress_and_turns_the_stress_there_is() {
    let mut solid = build(&disordered([6, 6, 6], Strength::Elastic));
    let stretch = [[1.001, 0.0, 0.0], [0.0, 0.9995, 0.0], [0.0, 0.0, 1.0]];
    for (start, steps) in [(false, 50), (true, 400)] {
        if start {
            place(&mut solid, &stretch);
            solid.update_stress(1e-9).unwrap();
        }
        let before = solid.stress(7);
        for k in 1..=steps {
            let q = rotation(
                AXIS,
                2.0 * std::f64::consts::PI * f64::from(k) / f64::from(steps),
            );
            let map = if start {
                q.map(|row| std::array::from_fn(|j| row[j] * stretch[j][j]))
            } else {
                q
            };
            place(&mut solid, &map);
            solid.update_stress(1e-9).unwrap();
        }
        let after = solid.stress(7);
        if start {
            // A full turn: the same stress, but for the second order of the midpoint rule in the angle of a step.
            assert!((after - before).von_mises() < 1e-3 * before.von_mises());
            assert!((after.trace() / before.trace() - 1.0).abs() < 1e-3);
        } else {
            // Round-off of F in the strain of every step.
            assert!(after.von_mises() < 1e-12 * 186e9, "{after:?}");
        }
    }
}

#[test]
fn an_eighth_of_a_turn_carries_the_stress_along() {
    let mut solid = build(&lattice([6, 6, 6], Strength::Elastic));
    let stretch = [[1.001, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    place(&mut solid, &stretch);
    solid.update_stress(1e-9).unwrap();
    let before = solid.stress(0);
    let steps = 400;
    for k in 1..=steps {
        let angle = 0.5 * std::f64::consts::FRAC_PI_2 * f64::from(k) / f64::from(steps);
        let q = rotation([0.0, 0.0, 1.0], angle);
        place(&mut solid, &q.map(|row| [row[0] * 1.001, row[1], row[2]]));
        solid.update_stress(1e-9).unwrap();
    }
    let after = solid.stress(0);
    let (mean, half) = (0.5 * (before.xx + before.yy), 0.5 * (before.xx - before.yy));
    let small = 1e-3 * before.von_mises();
    assert!((after.xx - mean).abs() < small && (after.yy - mean).abs() < small);
    assert!((after.xy - half).abs() < small && (after.zz - before.zz).abs() < small);
}

#[test]
fn a_body_turned_inside_out_is_an_error() {
    let mut solid = build(&lattice([6, 6, 6], johnson_cook()));
    place(
        &mut solid,
        &[[-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
    );
    let why = solid.update_stress(1e-9).unwrap_err().to_string();
    assert!(
        why.contains("particle 0") && why.contains("inside out"),
        "{why}"
    );
    let mut solid = build(&lattice([6, 6, 6], johnson_cook()));
    solid.state.position.set(30, [f64::NAN, DX, DX]);
    assert!(solid.update_stress(1e-9).is_err());
}
