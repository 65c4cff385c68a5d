use super::*;
use crate::fluid::ghosts::{Plane, Wall};
use crate::fluid::{Formulation, Start};
use crate::geometry::Vec2;
use crate::phases::Phases;
use erode_physics::eos::Tait;

const WATER: Tait = Tait {
    reference_density: 1000.0,
    sound_speed: 1500.0,
    gamma: 7.0,
};
const P: f64 = 60e6;

/// A block of `n` by `n` particles of spacing `dx` from radius `inner` on, between rigid walls.
fn block(geometry: Geometry, inner: f64, n: usize, dx: f64) -> Fluid {
    let position: Vec<Vec2> = (0..n * n)
        .map(|k| {
            [
                inner + ((k % n) as f64 + 0.5) * dx,
                ((k / n) as f64 + 0.5) * dx,
            ]
        })
        .collect();
    let mut fluid = Fluid::new(&Start {
        geometry,
        eos: WATER,
        position: &position,
        area: &vec![dx * dx; n * n],
        pressure: P,
        velocity: [0.0; 2],
        formulation: Formulation::Joshi(Settings::default()),
    });
    // The particles stay in the rows by which the tests know them.
    fluid.clustering.stale = false;
    let size = n as f64 * dx;
    let mut side = |normal: Vec2, offset: f64| {
        fluid.sides.push(Plane {
            normal,
            offset,
            speed: 0.0,
        });
    };
    side([0.0, 1.0], 0.0);
    side([0.0, -1.0], -size);
    side([-1.0, 0.0], -(inner + size));
    if inner > 0.0 || geometry == Geometry::Plane {
        side([1.0, 0.0], inner);
    }
    fluid
}

fn sweep_of(fluid: &Fluid) -> Sweep {
    let walls: Vec<&dyn Wall> = fluid.sides.iter().map(|p| p as &dyn Wall).collect();
    Sweep::find(&mut fluid.clone(), &walls, 0.0, &mut Phases::default())
}

fn forces_in(fluid: &Fluid, outside: f64, s: &Settings) -> Vec<Forces> {
    let sweep = sweep_of(fluid);
    let x = Extended::new(fluid, &sweep.ghosts, &fluid.velocity);
    forces(fluid, &x, &vec![outside; fluid.len()], &sweep, s)
}

/// Largest radial acceleration in the middle row of a column on the axis under uniform pressure, in units of p/(rho h).
fn axis_defect(ratio: f64) -> f64 {
    let h = 1.3e-5;
    let dx = h / ratio;
    let n = (10.0 * ratio) as usize;
    let mut fluid = block(Geometry::Axisymmetric, 0.0, n, dx);
    fluid.smoothing_length.fill(h);
    let a = forces_in(&fluid, 0.0, &Settings::default());
    let row = n / 2 * n;
    let unit = P / (fluid.density(0) * h);
    (row..row + n / 2).fold(0.0, |m: f64, k| m.max(a[k].acceleration[0].abs() / unit))
}

/// The terms of (6.7) cancel for uniform pressure (the identity of 5.46) up to two errors: sums over few neighbours, which
/// fall with h/dx, and f1, which belongs to another kernel and leaves 2 %.
#[test]
fn uniform_pressure_leaves_little_acceleration_at_the_axis() {
    let defect = [1.3, 2.6, 5.2].map(axis_defect);
    println!("acceleration in p/(rho h) at h/dx = 1.3, 2.6, 5.2: {defect:?}");
    assert!(defect[0] < 0.06 && defect[1] < 0.2 * defect[0] && defect[2] < 0.02);
}

#[test]
fn outside_pressure_takes_the_rest_away() {
    let fluid = block(Geometry::Axisymmetric, 0.0, 16, 1e-5);
    for f in forces_in(&fluid, P, &Settings::default()) {
        assert!(f.acceleration[0].abs() + f.acceleration[1].abs() < 1e-6 * P / (1000.0 * 1e-5));
    }
}

/// Inside a lattice the sum is low by 5e-5; in the row on the axis it is high by 3.4 %: 5 % by the kink of |r| between two
/// rows, less the 1.7 % of f1.
#[test]
fn density_of_a_lattice_at_rest() {
    for (geometry, axis) in [(Geometry::Plane, 0.0), (Geometry::Axisymmetric, 0.0345)] {
        let mut fluid = block(geometry, 0.0, 20, 1e-5);
        let expected = fluid.density(0);
        let sweep = sweep_of(&fluid);
        fluid.sum_density(&sweep.ghosts, &sweep);
        for a in 0..fluid.len() {
            let error = fluid.density(a) / expected - 1.0;
            let known = if a % 20 == 0 { axis } else { 0.0 };
            assert!((error - known).abs() < 3e-4, "{geometry:?} {a}: {error}");
        }
    }
}

/// A rigid plane that counts as the surface of a body.
struct Lid(Plane);

impl Wall for Lid {
    fn plane(&self, x: Vec2, reach: f64) -> Option<Plane> {
        self.0.plane(x, reach)
    }

    fn is_surface(&self) -> bool {
        true
    }
}

#[test]
fn a_wall_feels_pressure_times_area() {
    let n = 30;
    let mut fluid = block(Geometry::Axisymmetric, 0.0, n, 1e-5);
    let lid = Lid(fluid.sides.remove(0));
    let sides = fluid.sides.clone();
    let mut walls: Vec<&dyn Wall> = sides.iter().map(|p| p as &dyn Wall).collect();
    walls.push(&lid);
    let sweep = fluid.advance_positions(&walls, 1e-12, &mut Phases::default());
    fluid.volume = (fluid.mass.iter()).map(|m| m / WATER.density(P)).collect();
    fluid.pressure.fill(P);
    let x = Extended::new(&fluid, &sweep.ghosts, &fluid.velocity);
    let outside = vec![0.0; fluid.len()];
    let forces = forces(&fluid, &x, &outside, &sweep, &Settings::default());
    let felt: f64 = (forces.iter().zip(&fluid.mass))
        .map(|(f, m)| m * f.wall[1])
        .sum();
    let share = felt / (P * std::f64::consts::PI * (n as f64 * 1e-5).powi(2));
    println!("share of the pressure on the wall: {share}");
    // The sum of -A x dW/dx over a lattice is 1.0105 at h = 1.3 dx.
    assert!((share - 1.0105).abs() < 0.005);
}

#[test]
fn viscosity_does_not_depend_on_the_radius() {
    let dx = 1e-5;
    let n = 16;
    let friction = |geometry: Geometry, inner: f64| -> Vec<Vec2> {
        let mut fluid = block(geometry, inner, n, dx);
        for k in 0..n * n {
            let (x, z) = (fluid.position[k][0] - inner, fluid.position[k][1]);
            let wave = (z / (3.0 * dx)).sin();
            fluid.velocity[k] = [30.0 * wave + 1e6 * z, -2e6 * z * wave - 1e6 * x];
        }
        let f = forces_in(&fluid, 0.0, &Settings::default());
        f.iter().map(|f| f.dissipation).collect()
    };
    let plane = friction(Geometry::Plane, 0.0);
    let size = plane
        .iter()
        .fold(0.0, |m: f64, v| m.max(v[0].abs()).max(v[1].abs()));
    let gap = |radius: f64| {
        let rings = friction(Geometry::Axisymmetric, radius * dx);
        (rings.iter().zip(&plane)).fold(0.0, |m: f64, (v, w)| {
            m.max((v[0] - w[0]).abs()).max((v[1] - w[1]).abs())
        }) / size
    };
    let (near, far) = (gap(100.0), gap(1000.0));
    println!("viscosity of rings less plane: {near} at 100 dx, {far} at 1000 dx");
    // The weights of the neighbours differ by dx/r: the gap is of first order in it and must vanish.
    assert!(size > 0.0 && near < 0.03 && far < 0.12 * near);
}

#[test]
fn viscosity_resists_approach_by_its_formula() {
    let h = 1.3e-5;
    let mut fluid = block(Geometry::Plane, 0.0, 16, 1e-5);
    let (a, b) = (8 * 16 + 7, 8 * 16 + 8);
    fluid.velocity[b] = [-10.0, 0.0];
    let x = Extended::new(&fluid, &Ghosts::default(), &fluid.velocity);
    let s = Settings::default();
    let found = viscosity(&x, a, b, [-1e-5, 0.0], h, &s);
    let mu = h * -10.0 * 1e-5 / (1e-10 * (1.0 + 0.01 * 1.69));
    let c = WATER.sound_speed_at(WATER.density(P));
    assert!((found / (-c * mu + 2.0 * mu * mu) - 1.0).abs() < 1e-9 && found > 0.0);
    fluid.velocity[b] = [10.0, 0.0];
    let x = Extended::new(&fluid, &Ghosts::default(), &fluid.velocity);
    assert!(viscosity(&x, a, b, [-1e-5, 0.0], h, &s) == 0.0);
}

#[test]
fn plane_pair_forces_conserve_momentum() {
    let mut fluid = block(Geometry::Plane, 0.0, 12, 1e-5);
    fluid.sides.clear();
    for k in 0..fluid.len() {
        let s = (k as f64 * 1.7).sin();
        fluid.pressure[k] *= 1.0 + 0.3 * s;
        fluid.velocity[k] = [40.0 * s, -25.0 * (k as f64).cos()];
    }
    let forces = forces_in(&fluid, 0.0, &Settings::default());
    for i in 0..2 {
        let terms: Vec<f64> = (forces.iter().zip(&fluid.mass))
            .map(|(f, m)| m * f.acceleration[i])
            .collect();
        let size: f64 = terms.iter().map(|t| t.abs()).sum();
        assert!(terms.iter().sum::<f64>().abs() < 1e-12 * size);
    }
}
