//! Driven, clamped and partly driven faces.

use crate::bodies::{DX, FREE, Faces, OPEN, build, johnson_cook, lattice};
use erode_physics::strength::Strength;
use erode_sph::Geometry::{Axisymmetric, Plane};
use erode_sph::solid::{
    Driven, Face, LoadResolution, QuasiStatic, Side, Solid, SolidError, Tangential,
};

fn driven(tangential: Tangential, part: Option<[f64; 2]>) -> Face {
    Face::Driven(Driven { tangential, part })
}

const BONDED: Tangential = Tangential::Bonded;
const FREE_SLIP: Tangential = Tangential::Free;

/// Moves the body by the linear field x + g x, with its driven top along.
fn deform(solid: &mut Solid, g: [[f64; 2]; 2]) {
    let u = |x: [f64; 2]| [0, 1].map(|i| g[i][0] * x[0] + g[i][1] * x[1]);
    for (x, start) in (solid.state.position.iter_mut()).zip(&solid.reference.position) {
        let u = u(*start);
        *x = [start[0] + u[0], start[1] + u[1]];
    }
    solid
        .surface_mut(Side::Top)
        .unwrap()
        .drive(|x| [u(x), [0.0; 2]]);
    solid.update_stress(1e-9).unwrap();
    solid.follow_surfaces();
    solid.accelerations();
}

#[test]
fn linear_fields_are_exact_at_a_bonded_face() {
    let faces = [
        Face::Traction,
        Face::Traction,
        Face::Traction,
        driven(BONDED, None),
    ];
    let mut solid = build(lattice(Plane, faces, [14, 12], Strength::Elastic));
    let g = [[0.02, -0.03], [0.015, -0.04]];
    deform(&mut solid, g);
    for f in &solid.state.deformation {
        for i in 0..2 {
            for j in 0..2 {
                let unit = if i == j { 1.0 } else { 0.0 };
                assert!((f[i][j] - unit - g[i][j]).abs() < 1e-11);
            }
        }
    }
}

/// Simple shear between a clamped bottom and a bonded top: traction G gamma, and no force inside.
#[test]
fn a_sheared_strip_pulls_with_its_shear_stress() {
    let faces = [
        Face::Traction,
        Face::Traction,
        Face::Clamped,
        driven(BONDED, None),
    ];
    let mut solid = build(lattice(Plane, faces, [30, 12], Strength::Elastic));
    let shear = 1e-4;
    deform(&mut solid, [[0.0, shear], [0.0, 0.0]]);
    let expected = 186e9 / 2.6 * shear;
    let top = solid.surface(Side::Top).unwrap();
    for j in 6..24 {
        assert!(
            (top.traction[j][0] / expected - 1.0).abs() < 1e-3,
            "{:?}",
            top.traction[j]
        );
        assert!(top.traction[j][1].abs() < 1e-3 * expected);
    }
    let scale = expected / (7800.0 * DX);
    for k in (0..solid.len()).filter(|k| (6..24).contains(&(k % 30))) {
        let a = solid.state.acceleration[k];
        assert!(a[0].hypot(a[1]) < 1e-3 * scale);
    }
}

/// A face that is tilted with the body puts no stress into it.
#[test]
fn a_body_that_turns_with_its_slipping_face_feels_nothing() {
    let faces = [
        Face::Traction,
        Face::Traction,
        Face::Traction,
        driven(FREE_SLIP, None),
    ];
    let mut solid = build(lattice(Plane, faces, [14, 12], Strength::Elastic));
    let (sin, cos) = 0.02_f64.sin_cos();
    deform(&mut solid, [[cos - 1.0, -sin], [sin, cos - 1.0]]);
    let largest = (solid.state.von_mises.iter()).fold(0.0, |m: f64, s| m.max(*s));
    println!("largest stress {} of E", largest / 186e9);
    // Mirrored in the undeformed plane, the face would shear the first rows by 0.02. What is left is of third order.
    assert!(largest < 2e-5 * 186e9);
}

/// Pressed evenly between rollers: sigma = (lambda + 2 mu) strain, and the force of the face is sigma times its area.
#[test]
fn even_compression_has_hookes_force() {
    let strain = 1e-4;
    let expected = 186e9 * 0.7 / (1.3 * 0.4) * strain;
    for (geometry, left, tangential) in [
        (Plane, Face::Symmetry, FREE_SLIP),
        (Axisymmetric, Face::Axis, FREE_SLIP),
        (Axisymmetric, Face::Axis, BONDED),
    ] {
        let faces = [
            left,
            Face::Symmetry,
            Face::Symmetry,
            driven(tangential, None),
        ];
        let mut solid = build(lattice(geometry, faces, [10, 12], Strength::Elastic));
        let depth = strain * solid.block.upper[1];
        press(&mut solid, |_| depth);
        let top = solid.surface(Side::Top).unwrap();
        let area: f64 = top.area.iter().sum();
        let force = -top.force()[1] / area / expected;
        let inside = -solid.state.stress[10 * 6 + 4].yy / expected;
        println!(
            "{geometry:?} {tangential:?}: force {force}, stress {inside}, {:e}",
            solid.inertia_share()
        );
        // Finite strain, and the rest of the motion.
        assert!((force - 1.0).abs() < 2e-3 && (inside - 1.0).abs() < 2e-3);
        assert!(solid.inertia_share() < 1e-6);
    }
}

/// Pushes the top down by `depth` and holds it.
fn press(solid: &mut Solid, depth: impl Fn(f64) -> f64) {
    let transit = solid.block.upper[1] / 5666.0;
    let loading = QuasiStatic {
        ramp: 12.0 * transit,
        hold: 12.0 * transit,
        damping: 0.5 / transit,
    };
    let push = |solid: &mut Solid, value: f64, rate: f64| {
        let top = solid.surface_mut(Side::Top).unwrap();
        top.drive(|x| [value, rate].map(|s| [0.0, -s * depth(x[0])]));
    };
    loading
        .run(
            solid,
            |solid, share| push(solid, share.value, share.rate),
            |_, _| (),
        )
        .unwrap();
}

/// A punch on part of the top: its force is carried by every section below, the rest of the top stays free.
#[test]
fn a_punch_on_part_of_a_face_is_in_balance() {
    let radius = 10.0 * DX;
    let top = driven(FREE_SLIP, Some([0.0, radius]));
    let faces = [Face::Axis, Face::Symmetry, Face::Symmetry, top];
    let mut solid = build(lattice(Axisymmetric, faces, [30, 30], Strength::Elastic));
    assert_eq!(solid.surface(Side::Top).unwrap().driven_points(), 10);
    press(&mut solid, |_| 1e-3 * 30.0 * DX);
    let top = solid.surface(Side::Top).unwrap();
    assert!(
        top.traction[11..]
            .iter()
            .all(|t| t[0] == 0.0 && t[1] == 0.0)
    );
    let section = |row: usize| -> f64 {
        (0..30)
            .map(|i| (30 * row + i, (i as f64 + 0.5) * DX))
            .map(|(k, r)| solid.state.stress[k].yy * 2.0 * std::f64::consts::PI * r * DX)
            .sum()
    };
    let force = top.force()[1];
    println!(
        "punch {force} N, section {} N, {} N",
        section(15),
        section(4)
    );
    assert!(force < 0.0);
    // The shear of the punch's edge is spread by the kernel; a sum over a row is good to a percent.
    assert!((section(15) / force - 1.0).abs() < 0.02 && (section(4) / force - 1.0).abs() < 0.02);
    // A rigid frictionless punch on a half-space: F = 2 a d E/(1 - nu^2); a body three radii wide between walls is stiffer.
    let half_space = 2.0 * radius * 30e-3 * DX * 186e9 / 0.91;
    println!("over half-space {}", -force / half_space);
    assert!((1.0..2.0).contains(&(-force / half_space)));
}

fn pit(threads: usize, steps: std::ops::Range<u32>, state: Option<Solid>) -> Solid {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .unwrap();
    pool.install(|| {
        let faces = [
            Face::Axis,
            Face::Symmetry,
            Face::Symmetry,
            driven(BONDED, None),
        ];
        let mut solid = build(lattice(Axisymmetric, faces, [40, 30], johnson_cook()));
        let dt = solid.stable_time_step().dt;
        let at = |solid: &mut Solid, step: u32| {
            let (speed, time) = (20.0, f64::from(step) * dt);
            let shape = |x: f64| (-(x / (10.0 * DX)).powi(2)).exp();
            let top = solid.surface_mut(Side::Top).unwrap();
            top.drive(|x| {
                [
                    [0.0, -speed * time * shape(x[0])],
                    [0.0, -speed * shape(x[0])],
                ]
            });
        };
        if let Some(old) = state {
            solid.state = old.state;
            at(&mut solid, steps.start);
            solid.follow_surfaces();
        }
        for step in steps {
            at(&mut solid, step + 1);
            solid.step(dt).unwrap();
        }
        solid
    })
}

#[test]
fn threads_and_a_restart_do_not_change_a_bit() {
    let (one, two) = (pit(1, 0..120, None), pit(2, 0..120, None));
    assert!(one.state.plastic_strain.iter().any(|&e| e > 1e-3));
    assert!(one.state == two.state);
    let first = pit(2, 0..60, None);
    let resumed = pit(1, 60..120, Some(first));
    assert!(one.state == resumed.state);
}

#[test]
fn the_ledger_knows_the_work_of_the_face() {
    let solid = pit(2, 0..400, None);
    let (work, defect) = (solid.state.work, solid.energy_defect());
    println!("{work:?} defect {}", defect / work.driving);
    assert!(work.driving > 0.0 && work.pressure == 0.0);
    assert!((defect / work.driving).abs() < 0.02);
}

#[test]
fn the_ramp_is_smooth_and_ends_at_one() {
    let ramp = QuasiStatic {
        ramp: 2.0,
        hold: 1.0,
        damping: 1.0,
    };
    assert_eq!(ramp.share(0.0).value, 0.0);
    assert_eq!(ramp.share(2.5).value, 1.0);
    let n = 2000;
    let sum: f64 = (0..n)
        .map(|i| ramp.share((f64::from(i) + 0.5) * 2.0 / f64::from(n)).rate)
        .sum();
    assert!((sum * 2.0 / f64::from(n) - 1.0).abs() < 1e-6);
    assert!(ramp.share(1.999).rate < 1e-5);
}

fn refused(faces: Faces) -> String {
    match Solid::new(lattice(Axisymmetric, faces, [20, 20], Strength::Elastic)) {
        Err(e @ SolidError::BadBlock { .. }) => e.to_string(),
        Err(e) => e.to_string(),
        Ok(_) => String::new(),
    }
}

#[test]
fn contradictions_are_refused_in_sentences() {
    let size = 20.0 * DX;
    let off = driven(BONDED, Some([0.0, 1.1 * size]));
    let message = refused([Face::Axis, Face::Symmetry, Face::Symmetry, off]);
    assert!(message.contains("driven part of its Top face"), "{message}");
    let all = driven(BONDED, None);
    let message = refused([Face::Axis, all, Face::Symmetry, all]);
    assert!(message.contains("both driven"), "{message}");
    let narrow = driven(BONDED, Some([0.1 * DX, 0.2 * DX]));
    let message = refused([Face::Axis, Face::Symmetry, Face::Symmetry, narrow]);
    assert!(message.contains("at least one particle"), "{message}");
}

#[test]
fn loads_beside_the_body_or_too_narrow_are_named() {
    let faces = [Face::Axis, Face::Symmetry, Face::Symmetry, Face::Traction];
    let solid = build(lattice(Axisymmetric, faces, [20, 20], Strength::Elastic));
    let on = |centre, half| solid.load_resolution(Side::Top, centre, half);
    let message = on(30.0 * DX, DX).unwrap_err().to_string();
    assert!(message.contains("does not act on the body"), "{message}");
    let message = solid
        .load_resolution(Side::Right, DX, DX)
        .unwrap_err()
        .to_string();
    assert!(message.contains("no load can act"), "{message}");
    let coarse = on(0.0, 4.0 * DX).unwrap();
    assert_eq!(
        coarse,
        LoadResolution {
            side: Side::Top,
            particles: 8
        }
    );
    assert!(!coarse.is_enough() && coarse.to_string().contains("8 particles"));
    assert!(on(0.0, 10.0 * DX).unwrap().is_enough());
    assert!(
        build(lattice(Plane, OPEN, [20, 20], Strength::Elastic))
            .load_resolution(Side::Top, 10.0 * DX, 5.0 * DX)
            .is_ok_and(|r| r.particles == 10)
    );
}

#[test]
fn a_pressure_on_a_free_face_is_refused() {
    let mut solid = build(lattice(Plane, FREE, [20, 20], Strength::Elastic));
    let dt = solid.stable_time_step().dt;
    solid.step(dt).unwrap();
    solid.surface_mut(Side::Top).unwrap().pressure[3] = 1e6;
    let message = solid.step(dt).unwrap_err().to_string();
    assert!(message.contains("Top face, which is free"), "{message}");
}
