//! The liquid's step: the same bits by all widths and any number of threads, nothing lost.
#![allow(clippy::unwrap_used)] // a failed test may panic

use erode_physics::eos::Tait;
use erode_sph::Geometry;
use erode_sph::fluid::corrected::Settings;
use erode_sph::fluid::ghosts::Plane;
use erode_sph::fluid::{Fluid, Formulation, Start};
use erode_sph::simd::{self, Width};
use erode_sph::world::{Body, Named, World};

const DX: f64 = 1e-5;

/// Water with a cavity on the axis above a rigid wall, spacing graded 1:4 along z.
fn water() -> Fluid {
    let (mut position, mut area) = (Vec::new(), Vec::new());
    let mut z = 0.0;
    while z < 80.0 * DX {
        let dx = DX * (1.0 + 3.0 * (z / (80.0 * DX)));
        let mut r = 0.5 * dx;
        while r < 40.0 * DX {
            if r.hypot(z + 0.5 * dx - 20.0 * DX) > 12.0 * DX {
                position.push([r, z + 0.5 * dx]);
                area.push(dx * dx);
            }
            r += dx;
        }
        z += dx;
    }
    let mut fluid = Fluid::new(&Start {
        geometry: Geometry::Axisymmetric,
        eos: Tait {
            reference_density: 1000.0,
            sound_speed: 1500.0,
            gamma: 7.0,
        },
        position: &position,
        area: &area,
        pressure: 60e6,
        velocity: [0.0; 2],
        formulation: Formulation::Corrected(Settings::default()),
    });
    fluid.sides.push(Plane {
        normal: [0.0, 1.0],
        offset: 0.0,
        speed: 0.0,
    });
    fluid
}

fn world() -> World {
    let name = "water".to_owned();
    let body = Body::Fluid(water());
    World::new(vec![Named { name, body }], 0.3).unwrap()
}

fn liquid(world: &World) -> &Fluid {
    match &world.bodies[0].body {
        Body::Fluid(f) => f,
        Body::Solid(_) => unreachable!("it is water"),
    }
}

fn advance(world: &mut World, steps: usize) {
    for _ in 0..steps {
        let dt = world.stable_time_step().0;
        world.advance(dt).unwrap();
    }
}

/// Volumes in the order in which the particles were made.
fn volumes(f: &Fluid) -> Vec<f64> {
    let mut volumes: Vec<_> = f.origin.iter().map(|o| o.id).zip(&f.volume).collect();
    volumes.sort_by_key(|v| v.0);
    volumes.iter().map(|v| *v.1).collect()
}

/// All that the next step depends on, as bits.
fn bits(world: &World) -> Vec<u64> {
    let f = liquid(world);
    let vectors = [&f.position, &f.velocity, &f.acceleration];
    let scalars = [
        &f.mass,
        &f.volume,
        &f.pressure,
        &f.smoothing_length,
        &f.support,
    ];
    let vectors = vectors.into_iter().flatten().flatten();
    let numbers = vectors.chain(scalars.into_iter().flatten());
    numbers
        .chain([&world.time, &f.account.dissipation])
        .map(|x| x.to_bits())
        .collect()
}

fn in_pool(threads: usize, work: impl FnOnce() + Send) {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
    pool.build().unwrap().install(work);
}

#[test]
fn widths_and_threads_do_not_change_a_bit() {
    let steps = 40;
    let mut reference = world();
    advance(&mut reference, steps);
    for (width, threads) in [(Width::Avx512, 1), (Width::Avx2, 2), (Width::Scalar, 3)] {
        let mut other = world();
        // A width that this processor does not have falls back to another: nothing to compare then.
        simd::set_width(Some(width));
        in_pool(threads, || advance(&mut other, steps));
        simd::set_width(None);
        assert!(
            bits(&other) == bits(&reference),
            "{} with {threads} threads",
            width.name()
        );
    }
}

#[test]
fn a_world_goes_on_from_its_fields_and_clusters() {
    let mut whole = world();
    advance(&mut whole, 30);
    let mut resumed = world();
    let (Body::Fluid(new), old) = (&mut resumed.bodies[0].body, liquid(&whole)) else {
        unreachable!("it is water")
    };
    let h = &old.initial_smoothing_length;
    new.take_origins(old.origin.clone(), h, old.next_id);
    new.position.clone_from(&old.position);
    new.velocity.clone_from(&old.velocity);
    new.acceleration.clone_from(&old.acceleration);
    new.mass.clone_from(&old.mass);
    new.volume.clone_from(&old.volume);
    new.pressure.clone_from(&old.pressure);
    new.smoothing_length.clone_from(&old.smoothing_length);
    new.support.clone_from(&old.support);
    new.strain_rate.clone_from(&old.strain_rate);
    new.clustering = old.clustering;
    new.account = old.account;
    resumed.time = whole.time;
    advance(&mut whole, 30);
    advance(&mut resumed, 30);
    assert!(bits(&whole) == bits(&resumed));
}

#[test]
fn the_order_of_the_clusters_matters_by_rounding_only() {
    let (mut one, mut other) = (world(), world());
    advance(&mut one, 20);
    for _ in 0..20 {
        if let Body::Fluid(f) = &mut other.bodies[0].body {
            // New clusters in every step.
            f.clustering.stale = true;
        }
        advance(&mut other, 1);
    }
    let (a, b) = (liquid(&one), liquid(&other));
    assert_ne!(a.origin, b.origin, "the orders differ");
    for (x, y) in volumes(a).iter().zip(volumes(b)) {
        assert!((x / y - 1.0).abs() < 1e-10);
    }
}

#[test]
fn shifting_keeps_the_mass_to_rounding() {
    let mut world = world();
    let before: f64 = liquid(&world).mass.iter().sum();
    advance(&mut world, 100);
    let f = liquid(&world);
    let moved = f
        .mass
        .iter()
        .zip(&water().mass)
        .any(|(new, old)| (new / old - 1.0).abs() > 1e-6);
    assert!(moved, "something was exchanged");
    // 2000 particles, 100 steps of some 40 exchanges each that cancel in pairs.
    assert!((f.mass.iter().sum::<f64>() / before - 1.0).abs() < 1e-12);
}

#[test]
fn exchanges_that_are_cut_keep_the_mass_too() {
    let mut world = world();
    if let Body::Fluid(f) = &mut world.bodies[0].body {
        // Strain rates of the order of the inverse time step.
        for (a, v) in f.velocity.iter_mut().enumerate() {
            let phase = a as f64;
            *v = [800.0 * (2.3 * phase).sin(), 800.0 * (1.7 * phase).cos()];
        }
    }
    let before: f64 = liquid(&world).mass.iter().sum();
    advance(&mut world, 2);
    let f = liquid(&world);
    assert!(f.account.limited_exchanges > 0);
    assert!(f.volume.iter().all(|v| *v > 0.0));
    assert!((f.mass.iter().sum::<f64>() / before - 1.0).abs() < 1e-12);
}

/// Water under shear without shifting: two halves of spacings `DX` and `DX`/2, which side by side are meant to differ.
fn two_sizes() -> World {
    let (mut position, mut area) = (Vec::new(), Vec::new());
    for (lower, dx) in [(-12.0 * DX, DX), (0.0, 0.5 * DX)] {
        let n = (12.0 * DX / dx).round() as usize;
        for k in 0..2 * n * n {
            let [i, j] = [k % n, k / n].map(|i| (i as f64 + 0.5) * dx);
            position.push([lower + i, j - 12.0 * DX]);
            area.push(dx * dx);
        }
    }
    let mut fluid = Fluid::new(&Start {
        geometry: Geometry::Plane,
        eos: Tait {
            reference_density: 1000.0,
            sound_speed: 1500.0,
            gamma: 7.0,
        },
        area: &area,
        position: &position,
        pressure: 0.0,
        velocity: [0.0; 2],
        formulation: Formulation::Corrected(Settings {
            shifting: 0.0,
            ..Settings::default()
        }),
    });
    for (v, x) in fluid.velocity.iter_mut().zip(&position) {
        v[1] = 1e5 * x[0];
    }
    let name = "water".to_owned();
    let body = Body::Fluid(fluid);
    World::new(vec![Named { name, body }], 0.3).unwrap()
}

/// Shear keeps every volume, and levelling has nothing to level.
#[test]
fn sizes_that_are_meant_to_differ_are_not_levelled() {
    let mut world = two_sizes();
    let before = volumes(liquid(&world));
    advance(&mut world, 5);
    for (a, b) in volumes(liquid(&world)).iter().zip(&before) {
        assert!((a / b - 1.0).abs() < 1e-9, "{a} m2 of {b} m2");
    }
}

/// The same with one particle that has a tenth too much, far from the other size.
#[test]
fn a_size_that_drifted_off_is_levelled() {
    let mut world = two_sizes();
    let odd = 8 * 12 + 4;
    if let Body::Fluid(f) = &mut world.bodies[0].body {
        f.volume[odd] *= 1.1;
        f.mass[odd] *= 1.1;
    }
    advance(&mut world, 5);
    let excess = volumes(liquid(&world))[odd] / (DX * DX) - 1.0;
    // Ten times the rate of strain, 1e5/s, over five steps of some 1e-9 s: a part of a percent of the excess.
    assert!(excess < 0.0999 && excess > 0.0, "{excess}");
}
