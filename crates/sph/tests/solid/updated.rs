//! The published form: equilibrium, rigid motion, waves, momentum.

use crate::bodies::{DX, Faces, OPEN, Random, build, johnson_cook, lattice};
use crate::dynamics::{WIDTH, peak, pulse, strip};
use erode_physics::Sym3;
use erode_physics::strength::Strength;
use erode_sph::Geometry::{self, Axisymmetric, Plane};
use erode_sph::solid::updated::Settings;
use erode_sph::solid::{Face, Formulation, Side, Solid};

const AXIS: Faces = [Face::Axis, Face::Traction, Face::Symmetry, Face::Traction];

/// Defect of the sum of -A x dW/dx on a square lattice at h = 1.3 dx: 1.0105 instead of 1.
const LATTICE: f64 = 0.0105;

fn body(geometry: Geometry, faces: Faces, n: [usize; 2], settings: Settings) -> Solid {
    let mut setup = lattice(geometry, faces, n, Strength::Elastic);
    setup.numerics.formulation = Formulation::Joshi(settings);
    build(setup)
}

fn largest_acceleration(solid: &Solid) -> f64 {
    (solid.state.acceleration.iter()).fold(0.0, |m: f64, a| m.max(a[0].abs()).max(a[1].abs()))
}

#[test]
fn uniform_pressure_is_an_equilibrium_but_for_the_axis() {
    let p = 1e9;
    let scale = p / (7800.0 * DX);
    // At the axis f1 and the sums over a lattice do not cancel: a known error of the form, as large as in the liquid.
    for (geometry, faces, tolerance) in [(Plane, OPEN, 1e-10), (Axisymmetric, AXIS, 0.05)] {
        let mut solid = body(geometry, faces, [14, 11], Settings::default());
        solid.state.stress.fill(Sym3::isotropic(-p));
        for surface in &mut solid.surfaces {
            surface.pressure.fill(p);
        }
        solid.accelerations();
        let a = largest_acceleration(&solid) / scale;
        println!("{geometry:?}: {a}");
        assert!(a < tolerance);
        let inside = (0..solid.len()).filter(|k| k % 14 > 4);
        let a = inside.fold(0.0, |m: f64, k| {
            let a = solid.state.acceleration[k];
            m.max(a[0].abs()).max(a[1].abs())
        }) / scale;
        println!("{geometry:?} away from the axis: {a}");
        // The defect of the lattice times p/(rho r) at r = 5.5 dx.
        assert!(a < 1.1 * LATTICE / 5.5);
    }
}

#[test]
fn rigid_motion_gives_no_stress() {
    let largest = |solid: &Solid| {
        (solid.state.stress.iter()).fold(0.0, |m: f64, s| m.max(s.double_dot(*s).sqrt()))
    };
    let faces = [Face::Axis, Face::Traction, Face::Traction, Face::Traction];
    let mut solid = body(Axisymmetric, faces, [12, 15], Settings::default());
    solid.state.velocity.fill([0.0, 100.0]);
    for _ in 0..10 {
        solid.step(1e-9).unwrap();
    }
    println!("shift: {} of E", largest(&solid) / 186e9);
    assert!(largest(&solid) < 1e-10 * 186e9);

    let mut solid = body(Plane, OPEN, [12, 15], Settings::default());
    let (rate, dt) = (1e6, 1e-8);
    let turned = |angle: f64, x: [f64; 2]| {
        let (sin, cos) = angle.sin_cos();
        [cos * x[0] - sin * x[1], sin * x[0] + cos * x[1]]
    };
    for step in 1..=60 {
        let angle = rate * dt * f64::from(step);
        for a in 0..solid.len() {
            let x = turned(angle, solid.reference.position[a]);
            solid.state.position[a] = x;
            solid.state.velocity[a] = [-rate * x[1], rate * x[0]];
        }
        solid.update_stress(dt).unwrap();
    }
    // A turned lattice and images in faces that are straight between points leave a little.
    println!("rotation by 0.6 rad: {} of E", largest(&solid) / 186e9);
    assert!(largest(&solid) < 5e-6 * 186e9);
}

#[test]
fn longitudinal_wave_has_the_right_speed_but_for_the_lattice() {
    for alpha in [0.0, 1.0] {
        let settings = Settings {
            alpha,
            ..Settings::default()
        };
        let mut solid = body(Plane, strip(Face::Traction), [6, 200], settings);
        let dt = solid.stable_time_step().dt;
        let mut record = [Vec::new(), Vec::new()];
        let end = 2.0 * WIDTH + 150.0 * DX / 5666.0;
        for step in 0..(end / dt) as u32 {
            let p = pulse(f64::from(step + 1) * dt);
            solid.surface_mut(Side::Top).unwrap().pressure.fill(p);
            solid.step(dt).unwrap();
            for (row, values) in [170, 50].iter().zip(&mut record) {
                values.push(-solid.state.stress[6 * row + 3].yy);
            }
        }
        let ((t0, p0), (t1, p1)) = (peak(&record[0], dt), peak(&record[1], dt));
        let speed = 120.0 * DX / (t1 - t0);
        println!("alpha {alpha}: speed {speed}, height {p0} after 30 dx, {p1} after 150 dx");
        // The lattice makes long waves 1 % fast, a pulse of 25 dx is 0.7 % slow by dispersion, and viscosity slows it.
        assert!((speed / 5666.0 - 1.0).abs() < 0.01);
        let height = if alpha == 0.0 { 0.98 } else { 0.85 };
        assert!(p0 > height * 1e6 && p0 < 1.02e6 && p1 < 1.01 * p0 && p1 > height * p0);
    }
}

#[test]
fn inner_forces_cancel_and_pressure_enters_whole() {
    let mut solid = body(Plane, OPEN, [24, 20], Settings::default());
    let mut random = Random(7);
    for k in 0..solid.len() {
        let (i, j) = (k % 24, k / 24);
        if (6..18).contains(&i) && (6..14).contains(&j) {
            let mut next = || 1e9 * (random.next() - 0.5);
            solid.state.stress[k] = Sym3 {
                xx: next(),
                yy: next(),
                zz: next(),
                xy: next(),
                ..Sym3::ZERO
            };
        }
    }
    let force = |solid: &Solid| {
        (solid.reference.mass.iter().zip(&solid.state.acceleration)).fold([0.0; 3], |f, (m, a)| {
            [f[0] + m * a[0], f[1] + m * a[1], f[2] + m * a[1].abs()]
        })
    };
    solid.accelerations();
    let [x, z, size] = force(&solid);
    println!("inner {x} {z} of {size}");
    assert!(x.abs() + z.abs() < 1e-11 * size);

    for (geometry, faces) in [(Plane, OPEN), (Axisymmetric, AXIS)] {
        let mut solid = body(geometry, faces, [40, 20], Settings::default());
        let top = solid.surface_mut(Side::Top).unwrap();
        let mut load = 0.0;
        for j in 0..top.pressure.len() {
            let x = top.reference_position[j][0] - if geometry == Plane { 20.0 * DX } else { 0.0 };
            top.pressure[j] = 1e9 * (-(x / (8.0 * DX)).powi(2)).exp();
            load += top.pressure[j] * top.area[j];
        }
        solid.accelerations();
        let found = -force(&solid)[1] / load;
        println!("{geometry:?}: {found} of the load");
        assert!((found - 1.0 - LATTICE).abs() < 0.01);
    }
}

fn hit(threads: usize, xsph: f64) -> Solid {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .unwrap();
    pool.install(|| {
        let faces = [Face::Axis, Face::Absorbing, Face::Absorbing, Face::Traction];
        let mut setup = lattice(Axisymmetric, faces, [40, 30], johnson_cook());
        setup.numerics.formulation = Formulation::Joshi(Settings {
            xsph,
            ..Settings::default()
        });
        let mut solid = build(setup);
        let top = solid.surface_mut(Side::Top).unwrap();
        for j in 0..top.pressure.len() {
            top.pressure[j] = 2.5e9 * (-(top.reference_position[j][0] / (5.0 * DX)).powi(2)).exp();
        }
        let dt = solid.stable_time_step().dt;
        solid.accelerations();
        for _ in 0..150 {
            solid.step(dt).unwrap();
        }
        solid
    })
}

#[test]
fn threads_do_not_change_a_bit() {
    let (one, two) = (hit(1, 0.2), hit(2, 0.2));
    assert!(one.state.plastic_strain.iter().any(|&e| e > 1e-4));
    assert!(one.state == two.state);
}

/// The sums for force and strain rate are not adjoint to each other: some percent of the energy are not accounted for.
#[test]
fn energy_closes_to_some_percent() {
    let solid = hit(2, 0.0);
    let share = solid.energy_defect() / solid.energy().total();
    println!("energy missing: {share}");
    assert!(share.abs() < 0.1);
}

/// A state put into a fresh body goes on as it would have.
#[test]
fn nothing_but_the_state_is_carried_on() {
    let faces = [Face::Axis, Face::Absorbing, Face::Absorbing, Face::Traction];
    let fresh = || body(Axisymmetric, faces, [20, 16], Settings::default());
    let mut one = fresh();
    let dt = one.stable_time_step().dt;
    let push = |solid: &mut Solid| solid.surface_mut(Side::Top).unwrap().pressure[..4].fill(1e9);
    push(&mut one);
    for _ in 0..60 {
        one.step(dt).unwrap();
    }
    let mut two = fresh();
    push(&mut two);
    two.state.clone_from(&one.state);
    two.follow_surfaces();
    for _ in 0..60 {
        one.step(dt).unwrap();
        two.step(dt).unwrap();
    }
    assert!(one.state.position == two.state.position && one.state.stress == two.state.stress);
}

/// s_zz (Pa) eight rows beneath a load of `p` (Pa) around the axis, after 1500 and after 5000 steps; it has its full size
/// from the 1000th on.
fn stress_below(p: f64) -> [f64; 2] {
    let faces = [Face::Axis, Face::Symmetry, Face::Symmetry, Face::Traction];
    let mut setup = lattice(Axisymmetric, faces, [24, 20], johnson_cook());
    setup.numerics.formulation = Formulation::Joshi(Settings::default());
    let mut solid = build(setup);
    let dt = solid.stable_time_step().dt;
    let mut found = [0.0; 2];
    for step in 1..=5000 {
        let rise = (f64::from(step) / 1000.0).min(1.0);
        let top = solid.surface_mut(Side::Top).unwrap();
        for j in 0..top.pressure.len() {
            let x = top.reference_position[j][0] / (8.0 * DX);
            top.pressure[j] = rise * p * (-x * x).exp();
        }
        solid.step(dt).unwrap();
        let stress = solid.state.stress[24 * 12].yy;
        match step {
            1500 => found[0] = stress,
            5000 => found[1] = stress,
            _ => {}
        }
    }
    found
}

/// The known failure of the form: under tension particles clump and the body parts where none should.
#[test]
fn pushed_it_holds_and_pulled_it_parts() {
    let (push, pull) = (stress_below(2.5e9), stress_below(-2.5e9));
    println!("stress beneath a load that stays: pushed {push:?}, pulled {pull:?}");
    assert!(push[0] < 0.0 && (push[1] / push[0] - 1.0).abs() < 0.03);
    assert!(pull[0] > 0.0 && pull[1] < 0.85 * pull[0]);
}
