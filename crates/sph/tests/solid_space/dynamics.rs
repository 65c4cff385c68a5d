//! Waves, vibrations, and what has to be kept.

use crate::bodies::{DX, YOUNG, build, disordered, johnson_cook, lattice, set_velocity};
use erode_physics::strength::Strength;
use erode_sph::solid::space::{Setup, SpaceSolid};
use std::f64::consts::PI;

/// The body with its stabilisers: viscosity, hourglass.
fn stabilised(mut setup: Setup, viscosity: f64, hourglass: f64) -> SpaceSolid {
    setup.numerics.viscosity = viscosity;
    setup.numerics.hourglass = hourglass;
    build(&setup)
}

fn advance(solid: &mut SpaceSolid, steps: usize) {
    let dt = solid.stable_time_step().dt;
    solid.accelerations(0.0);
    for _ in 0..steps {
        solid.step(dt).unwrap();
    }
}

/// Speed from a quarter of the period of the first mode along x of a free column of this many spacings.
fn speed_of_first_mode(solid: &mut SpaceSolid, count: usize) -> f64 {
    let length = count as f64 * DX;
    let shape = |x: f64| (PI * x / length).cos();
    set_velocity(solid, |x| [shape(x[0]), 0.0, 0.0]);
    solid.accelerations(0.0);
    let dt = solid.stable_time_step().dt;
    let amplitude = |solid: &SpaceSolid| -> f64 {
        let each =
            |a: usize| solid.state.velocity.get(a)[0] * shape(solid.reference_position(a)[0]);
        (0..solid.len()).map(each).sum()
    };
    let (mut before, mut time) = (amplitude(solid), 0.0);
    loop {
        solid.step(dt).unwrap();
        let now = amplitude(solid);
        if now <= 0.0 {
            return 0.5 * length / (time + dt * before / (before - now));
        }
        (before, time) = (now, time + dt);
    }
}

#[test]
fn a_pressure_wave_in_a_column_has_the_longitudinal_speed() {
    let count = [60, 4, 4];
    let mut solid = stabilised(lattice(count, Strength::Elastic), 0.0, 0.1);
    for a in 0..solid.len() {
        solid.hold(a, [false, true, true]);
    }
    let speed = speed_of_first_mode(&mut solid, count[0]);
    let exact = (1.3462 * YOUNG / 7800.0_f64).sqrt();
    println!("longitudinal wave {speed}, exact {exact}");
    assert!((speed / exact - 1.0).abs() < 0.01, "{speed} {exact}");
}

#[test]
fn a_wave_in_a_thin_bar_has_the_speed_of_bars() {
    let count = [80, 6, 6];
    let mut solid = stabilised(lattice(count, Strength::Elastic), 0.0, 0.1);
    let speed = speed_of_first_mode(&mut solid, count[0]);
    let exact = (YOUNG / 7800.0_f64).sqrt();
    println!("bar wave {speed}, exact {exact}");
    // A layer of one spacing is too soft on every free face; the bar has six spacings.
    assert!((speed / exact - 1.0).abs() < 0.03, "{speed} {exact}");
}

/// A smooth motion with all kinds of strain, a drift and a turn.
fn shake(solid: &mut SpaceSolid, speed: f64) {
    let k = PI / (8.0 * DX);
    set_velocity(solid, |x| {
        let [a, b, c] = x.map(|x| k * x);
        let turn = 0.3 * speed / (8.0 * DX);
        [
            speed * (a.cos() + 0.5 * b.sin()) - turn * x[1],
            speed * (0.7 * b.cos() * c.cos() + 0.3) + turn * x[0],
            speed * (c.sin() - 0.4 * a.cos()),
        ]
    });
}

#[test]
fn a_body_that_vibrates_freely_keeps_its_energy() {
    for hourglass in [0.0, 0.1] {
        let mut solid = stabilised(disordered([8, 7, 6], Strength::Elastic), 0.0, hourglass);
        shake(&mut solid, 30.0);
        let start = solid.energy_defect();
        for _ in 0..4 {
            advance(&mut solid, 500);
            let change = solid.energy_defect() / start - 1.0;
            let stored = solid.energy();
            println!(
                "{hourglass}: {change:e}, {stored:?}, {:?}",
                solid.state.work
            );
            // Kick and drift keep energy to the second order of the step.
            assert!(change.abs() < 3e-3, "{change}");
            assert!(stored.elastic > 0.05 * start);
        }
    }
}

#[test]
fn momentum_is_kept_and_without_hourglass_forces_its_moment() {
    for hourglass in [0.0, 0.1] {
        let mut solid = stabilised(disordered([7, 6, 6], johnson_cook()), 0.2, hourglass);
        shake(&mut solid, 100.0);
        let before = solid.momentum();
        advance(&mut solid, 300);
        let after = solid.momentum();
        println!("{before:?} {after:?}");
        for k in 0..3 {
            let scale = before[0].iter().fold(0.0, |m: f64, x| m.max(x.abs()));
            assert!((after[0][k] - before[0][k]).abs() < 1e-11 * scale);
            let scale = before[1].iter().fold(0.0, |m: f64, x| m.max(x.abs()));
            let kept = if hourglass == 0.0 { 1e-10 } else { 0.02 };
            assert!((after[1][k] - before[1][k]).abs() < kept * scale);
        }
        assert!(solid.energy().plastic_work > 0.0 && solid.state.work.viscous > 0.0);
    }
}

#[test]
fn the_ledger_closes_in_an_impact_and_under_a_driven_face() {
    let mut solid = build(&lattice([10, 10, 12], johnson_cook()));
    // The lower layer is clamped, the upper one is driven down to a strain of 4 %.
    let height = 12.0 * DX;
    let speed = 100.0;
    for a in 0..solid.len() {
        let z = solid.reference_position(a)[2];
        if z < DX || z > height - DX {
            solid.hold(a, [true; 3]);
        }
        if z > height - DX {
            solid.state.velocity.set(a, [0.0, 0.0, -speed]);
        }
    }
    let start = solid.energy_defect();
    let steps = (0.04 * height / speed / solid.stable_time_step().dt) as usize;
    advance(&mut solid, steps);
    let (energy, work) = (solid.energy(), solid.state.work);
    let defect = (solid.energy_defect() - start) / work.driving;
    println!("{steps} steps: {energy:?} {work:?} defect {defect:e}");
    assert!(
        energy.plastic_work > 0.3 * work.driving && defect.abs() < 0.01,
        "{defect}"
    );
    let [shift] =
        [solid.state.position.get(0)].map(|x| (x[2] - solid.reference_position(0)[2]).abs());
    assert!(shift < 1e-20 || solid.reference_position(0)[2] > DX);
}
