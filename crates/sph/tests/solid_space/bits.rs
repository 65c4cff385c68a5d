//! The same bits with any number of threads, any width and after a restart; errors of the setup; limits of the step.

use crate::bodies::{DX, build, disordered, johnson_cook, lattice, set_velocity, steel};
use erode_physics::strength::Strength;
use erode_sph::simd::{Width, set_width};
use erode_sph::solid::space::{Setup, SpaceError, SpaceSolid, State};
use rayon::ThreadPoolBuilder;

/// Some 1500 particles (six tasks and a cluster that is not full) that yield.
fn start() -> SpaceSolid {
    let mut solid = build(&disordered([13, 11, 11], johnson_cook()));
    set_velocity(&mut solid, |x| {
        [2e5 * x[1], 1e6 * (x[2] - 3.0 * DX), -8e5 * x[2]]
    });
    solid.accelerations(0.0);
    solid
}

fn advance(solid: &mut SpaceSolid, steps: usize) {
    for _ in 0..steps {
        let dt = solid.stable_time_step().dt;
        solid.step(dt).unwrap();
    }
}

fn after_twenty(threads: usize) -> State {
    let pool = ThreadPoolBuilder::new().num_threads(threads).build();
    pool.unwrap().install(|| {
        let mut solid = start();
        advance(&mut solid, 20);
        solid.state
    })
}

#[test]
fn threads_and_widths_change_no_bit() {
    let one = after_twenty(1);
    assert!(one.plastic_strain.iter().filter(|p| p[0] > 0.0).count() > 300);
    assert_eq!(one, after_twenty(2));
    assert_eq!(one, after_twenty(3));
    for width in Width::ALL {
        set_width(Some(width));
        assert_eq!(one, after_twenty(1), "{width:?}");
    }
    set_width(None);
}

#[test]
fn a_saved_state_goes_on_with_the_same_bits() {
    let mut whole = start();
    advance(&mut whole, 10);
    let saved = serde_json::to_string(&whole.state).unwrap();
    advance(&mut whole, 10);
    let mut resumed = start();
    resumed
        .resume(serde_json::from_str(&saved).unwrap())
        .unwrap();
    advance(&mut resumed, 10);
    assert_eq!(whole.state, resumed.state);
    let mut other = build(&lattice([4, 4, 4], Strength::Elastic));
    // Every field must have the right length, not only the first.
    let mut mixed = other.state.clone();
    mixed.flux = whole.state.flux.clone();
    assert!(matches!(
        other.resume(mixed),
        Err(SpaceError::OtherState { .. })
    ));
    assert!(matches!(
        other.resume(whole.state),
        Err(SpaceError::OtherState { .. })
    ));
}

#[test]
fn setups_that_make_no_body_are_refused() {
    let new = |setup: &Setup| SpaceSolid::new(setup).unwrap_err().to_string();
    let mut setup = lattice([4, 4, 4], Strength::Elastic);
    setup.volume[5] = 0.0;
    assert!(new(&setup).contains("particle 5"));
    setup.volume.pop();
    assert!(new(&setup).contains("64 and 63"));
    let sheet = lattice([6, 6, 1], Strength::Elastic);
    assert!(new(&sheet).contains("do not span a gradient"));
    assert!(new(&Setup::lattice(steel(Strength::Elastic), [0; 3], DX)).contains("at least one"));
}

#[test]
fn compression_shortens_the_step() {
    let mut solid = build(&lattice([6, 6, 6], Strength::Elastic));
    let free = solid.stable_time_step();
    let exact = 0.4 * DX / steel(Strength::Elastic).elastic.longitudinal_speed(7800.0);
    assert!((free.dt / exact - 1.0).abs() < 1e-12);
    for a in 0..solid.len() {
        let [x, y, z] = solid.reference_position(a);
        solid.state.position.set(a, [x, y + 0.5 * x, 0.4 * z]);
    }
    solid.update_stress(1e-9).unwrap();
    let pressed = solid.stable_time_step();
    assert!(
        (pressed.dt / free.dt - 0.5).abs() < 1e-6,
        "{}",
        pressed.dt / free.dt
    );
}

#[test]
fn memory_per_particle_is_below_350_bytes() {
    let solid = build(&lattice([40, 40, 40], Strength::Elastic));
    let bytes = solid.memory() as f64 / solid.len() as f64;
    println!(
        "{bytes} bytes per particle, {} neighbours",
        solid.pairs() / solid.len()
    );
    assert!(bytes < 350.0, "{bytes}");
}
