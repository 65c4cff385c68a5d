use super::*;
use crate::cavity::{Window, fronts};
use crate::fluid::Start;
use crate::fluid::corrected::Settings;
use crate::fluid::far_field::FarField;
use crate::fluid::ghosts::Plane;
use crate::fluid::step::Sweep;
use crate::geometry::{Geometry, Vec2};
use crate::phases::Phases;
use crate::world::{Body, Named, World};
use erode_physics::eos::Tait;
use std::collections::BTreeSet;

const WATER: Tait = Tait {
    reference_density: 1000.0,
    sound_speed: 1500.0,
    gamma: 7.0,
};

/// A square lattice of 20 x 20 with spacing 1 mm between r = 0 and 20 mm, without what lies within `hole` of (0, 10 mm).
fn lattice(geometry: Geometry, pressure: f64, hole: f64) -> Fluid {
    let dx = 1e-3;
    let place = |k: i32| [f64::from(k % 20) + 0.5, f64::from(k / 20) + 0.5].map(|x| x * dx);
    let far = |x: &Vec2| x[0].hypot(x[1] - 0.01) > hole;
    let position: Vec<Vec2> = (0..400).map(place).filter(far).collect();
    Fluid::new(&Start {
        geometry,
        eos: WATER,
        area: &vec![dx * dx; position.len()],
        position: &position,
        pressure,
        velocity: [0.0; 2],
        formulation: Formulation::Corrected(Settings::default()),
    })
}

/// A cavity at a point that asks for `spacing` (m) everywhere.
fn cavity(spacing: f64) -> (Refinement, Vec<Front>) {
    let refinement = Refinement {
        per_radius: 10.0,
        growth: 0.0,
        smallest: 0.0,
    };
    let front = Front {
        radius: 10.0 * spacing,
        rim: vec![[0.0, 0.0]],
    };
    (refinement, vec![front])
}

fn refine(f: &mut Fluid, spacing: f64) {
    let (refinement, fronts) = cavity(spacing);
    f.refine(&refinement, &fronts, MERGE_EVERY);
}

/// Velocity gradients as a step would leave them.
fn with_gradients(f: &mut Fluid) {
    f.sweep = Sweep::find(f, &[], 0.0, &mut Phases::default());
}

fn totals(f: &Fluid) -> [f64; 4] {
    let momentum = |k: usize| (0..f.len()).map(|a| f.mass[a] * f.velocity[a][k]).sum();
    [
        f.mass.iter().sum(),
        f.volume.iter().sum(),
        momentum(0),
        momentum(1),
    ]
}

fn energy(f: &Fluid) -> f64 {
    f.kinetic_energy() + f.compression_energy() + f.account.dissipation
}

fn assert_complete(f: &Fluid) {
    let n = f.len();
    assert_eq!(
        [f.velocity.len(), f.acceleration.len(), f.mass.len()],
        [n; 3]
    );
    assert_eq!([f.volume.len(), f.pressure.len(), f.support.len()], [n; 3]);
    assert_eq!(
        [f.smoothing_length.len(), f.initial_smoothing_length.len()],
        [n; 2]
    );
    assert_eq!(
        [f.strain_rate.len(), f.far_field.len(), f.side_depth.len()],
        [n; 3]
    );
    assert_eq!(f.origin.len(), n);
    let ids: BTreeSet<u32> = f.origin.iter().map(|o| o.id).collect();
    assert_eq!(ids.len(), n, "numbers are unique");
    assert!(ids.iter().all(|id| *id < f.next_id));
    assert!(f.position.iter().all(|x| x[0] > 0.0));
}

#[test]
fn halving_and_merging_keep_mass_volume_and_momentum() {
    for geometry in [Geometry::Plane, Geometry::Axisymmetric] {
        let mut f = lattice(geometry, 5e7, 0.0);
        for (k, v) in f.velocity.iter_mut().enumerate() {
            let k = k as f64;
            *v = [(1.3 * k).sin() * 40.0, 30.0 + (0.7 * k).cos() * 50.0];
        }
        for (k, a) in f.acceleration.iter_mut().enumerate() {
            *a = [(0.3 * k as f64).cos() * 1e8, 2e8];
        }
        with_gradients(&mut f);
        let (before, at_start) = (totals(&f), energy(&f));
        // 13 mm fall to two thirds and thus to 2 x 400, then to 4 x 400; then all are small for a spacing of 3 mm.
        for (spacing, count) in [(0.7e-3, 800), (0.5e-3, 1600)] {
            refine(&mut f, spacing);
            assert_eq!(f.len(), count);
            assert_complete(&f);
        }
        let splits = f.account.refinement.splits;
        assert_eq!(splits, 1200);
        refine(&mut f, 3e-3);
        assert!(f.len() < 1000, "{} left", f.len());
        assert_eq!(f.account.refinement.merges as usize, 1600 - f.len());
        assert!(f.origin.iter().all(|o| o.level == 1 || o.level == 2));
        assert_complete(&f);
        let after = totals(&f);
        // Sums of 1600 numbers: rounding.
        for (a, b) in after.iter().zip(before) {
            assert!((a - b).abs() < 1e-12 * b.abs().max(before[0]), "{a} {b}");
        }
        assert!(
            (energy(&f) / at_start - 1.0).abs() < 1e-12,
            "the change is booked"
        );
        assert!(f.account.refinement.energy != 0.0);
    }
}

#[test]
fn a_uniform_flow_stays_uniform() {
    let mut f = lattice(Geometry::Axisymmetric, 5e7, 0.0);
    f.velocity.fill([0.0, -120.0]);
    with_gradients(&mut f);
    let density = f.density(0);
    refine(&mut f, 0.7e-3);
    assert_eq!(f.len(), 800);
    for a in 0..f.len() {
        // The divided momentum of a half: rounding.
        assert!(f.velocity[a][0].abs() < 1e-9 && (f.velocity[a][1] + 120.0).abs() < 1e-9);
        assert!((f.density(a) / density - 1.0).abs() < 1e-14);
        assert!((f.pressure[a] / 5e7 - 1.0).abs() < 1e-10);
    }
}

#[test]
fn linear_velocity_and_density_are_those_of_the_places() {
    let mut f = lattice(Geometry::Plane, 5e7, 0.0);
    let velocity = |x: Vec2| [3e3 * x[0] - 2e3 * x[1] + 5.0, 1e3 * x[0] + 4e3 * x[1]];
    let slope = [30.0, -20.0];
    let density = |x: Vec2| 1030.0 + slope[0] * x[0] + slope[1] * x[1];
    for a in 0..f.len() {
        let x = f.position[a];
        f.velocity[a] = velocity(x);
        f.mass[a] = density(x) * f.volume[a];
        let c = WATER.sound_speed_at(density(x));
        f.acceleration[a] = slope.map(|s| -s * c * c / density(x));
    }
    with_gradients(&mut f);
    refine(&mut f, 0.7e-3);
    assert_eq!(f.len(), 800);
    for a in 0..f.len() {
        let x = f.position[a];
        let [u, v] = velocity(x);
        // Velocities are linear about the centre of mass, which is not that of the area: d^2 grad rho/rho = 1e-9 m away.
        assert!(
            (f.velocity[a][0] - u).abs() < 3e-5,
            "{} {u}",
            f.velocity[a][0]
        );
        assert!((f.velocity[a][1] - v).abs() < 3e-5);
        assert!((f.density(a) / density(x) - 1.0).abs() < 1e-13);
    }
}

#[test]
fn only_what_is_too_large_near_a_cavity_is_halved() {
    let mut f = lattice(Geometry::Axisymmetric, 5e7, 0.0);
    let side = Plane {
        normal: [-1.0, 0.0],
        offset: -0.02,
        speed: 0.0,
    };
    f.open_side(
        &side,
        FarField {
            pressure: 5e7,
            step_pressure: 5e7,
            ..FarField::NONE
        },
    );
    let refinement = Refinement {
        per_radius: 10.0,
        growth: 0.1,
        smallest: 1e-3,
    };
    let at = |x: Vec2, radius: f64| {
        vec![Front {
            radius,
            rim: vec![x],
        }]
    };
    // Too small to be followed; far too large to ask for anything; not due.
    f.refine(&refinement, &at([0.0, 0.01], 0.9e-3), 2);
    f.refine(&refinement, &at([0.0, 0.01], 1.0), 2);
    f.refine(&refinement, &at([0.0, 0.01], 2e-3), 3);
    f.refine(&refinement, &[], 2);
    assert_eq!(f.len(), 400);
    // 0.2 mm + 0.1 d < 1/1.2 mm within 6.3 mm.
    f.refine(&refinement, &at([0.0, 0.01], 2e-3), 2);
    assert_complete(&f);
    for a in 0..f.len() {
        let d = f.position[a][0].hypot(f.position[a][1] - 0.01);
        let halved = f.origin[a].level == 1;
        assert!(
            (d > 6.3e-3 || halved) && (d < 6.7e-3 || !halved),
            "{d} {halved}"
        );
    }
    // The side with a far field is left alone.
    f.refine(&refinement, &at([0.02, 0.01], 2e-3), 2);
    let open = (0..f.len()).filter(|a| f.far_field[*a].is_some());
    assert!(open.into_iter().all(|a| f.origin[a].level == 0));
    assert_complete(&f);
}

/// A small collapse with refinement.
fn collapse(steps: u64) -> Fluid {
    let body = Body::Fluid(lattice(Geometry::Axisymmetric, 5e7, 6e-3));
    let name = "water".into();
    let mut world = World::new(vec![Named { name, body }], 0.3).unwrap();
    let refinement = Refinement {
        per_radius: 8.0,
        growth: 0.06,
        smallest: 0.5e-3,
    };
    let window = Window {
        lower: [0.0, 2e-3],
        upper: [8e-3, 18e-3],
        cell: 0.5e-3,
    };
    for _ in 0..steps {
        let dt = world.stable_time_step().0;
        world.advance(dt).unwrap();
        let Body::Fluid(f) = &mut world.bodies[0].body else {
            unreachable!()
        };
        let found = fronts(f, &[], window, refinement.smallest);
        f.refine(&refinement, &found, world.step);
    }
    let Some(Body::Fluid(f)) = world.bodies.pop().map(|b| b.body) else {
        unreachable!()
    };
    f
}

#[test]
fn a_collapse_is_the_same_bits_for_one_and_three_threads() {
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.unwrap().install(|| collapse(60))
    };
    let (one, three) = (on(1), on(3));
    assert!(one.account.refinement.splits > 30, "{:?}", one.account);
    assert_complete(&one);
    assert_eq!(one.position, three.position);
    assert_eq!(one.velocity, three.velocity);
    assert_eq!(one.volume, three.volume);
    assert_eq!(one.origin, three.origin);
    assert_eq!(one.account, three.account);
}

/// Every array follows its particle into a new order.
#[test]
fn a_new_order_takes_all_of_a_particle_along() {
    let mut f = lattice(Geometry::Axisymmetric, 50e6, 0.005);
    let n = f.len();
    for a in 0..n {
        let x = a as f64;
        f.velocity[a] = [x, -x];
        f.acceleration[a] = [2.0 * x, 0.0];
        f.mass[a] = 1.0 + x;
        f.volume[a] = 2.0 + x;
        f.pressure[a] = 3.0 + x;
        f.smoothing_length[a] = 4.0 + x;
        f.initial_smoothing_length[a] = 5.0 + x;
        f.support[a] = 6.0 + x;
        f.strain_rate[a] = 7.0 + x;
        f.far_field[a].pressure = 8.0 + x;
        f.side_depth[a] = 9.0 + x;
    }
    let before = f.clone();
    let order: Vec<u32> = (0..n as u32).rev().collect();
    f.arrange(&order);
    for (i, &a) in order.iter().enumerate() {
        let a = a as usize;
        let numbers = |f: &Fluid, a: usize| {
            let vectors = [f.position[a], f.velocity[a], f.acceleration[a]];
            let lengths = [f.smoothing_length[a], f.initial_smoothing_length[a]];
            let others = [f.mass[a], f.volume[a], f.pressure[a], f.support[a]];
            let side = [f.strain_rate[a], f.side_depth[a], f.far_field[a].pressure];
            (vectors, lengths, others, side)
        };
        assert_eq!(numbers(&f, i), numbers(&before, a));
        assert_eq!(f.origin[i].id, a as u32);
    }
}
