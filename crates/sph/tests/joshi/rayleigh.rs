//! Collapse of an empty sphere in compressible water under 60 MPa against an independent solution of the same equations
//! in one dimension (provenance: validation/rayleigh-collapse/README.md).

use erode_physics::eos::Tait;
use erode_sph::Geometry;
use erode_sph::cavity::{Colour, Window};
use erode_sph::fluid::far_field::FarField;
use erode_sph::fluid::ghosts::{Ghosts, Plane};
use erode_sph::fluid::{Fluid, Formulation, Start, joshi};
use erode_sph::world::{Body, Named, World};
use std::f64::consts::PI;

const R0: f64 = 0.095e-3;
const P: f64 = 60e6;
const WATER: Tait = Tait {
    reference_density: 1000.0,
    sound_speed: 1500.0,
    gamma: 7.0,
};

/// A square lattice with `n` particles per radius around the cavity, open on three sides at `reach` radii.
fn liquid(n: f64, reach: f64, settings: joshi::Settings) -> Fluid {
    let dx = R0 / n;
    let m = (reach * n).round();
    let mut position = Vec::new();
    for i in 0..m as i32 {
        for j in -m as i32..m as i32 {
            let x = [(f64::from(i) + 0.5) * dx, (f64::from(j) + 0.5) * dx];
            if x[0].hypot(x[1]) > R0 {
                position.push(x);
            }
        }
    }
    let mut fluid = Fluid::new(&Start {
        geometry: Geometry::Axisymmetric,
        eos: WATER,
        position: &position,
        area: &vec![dx * dx; position.len()],
        pressure: P,
        velocity: [0.0; 2],
        formulation: Formulation::Joshi(settings),
    });
    let far = FarField {
        pressure: P,
        step_pressure: P,
        ..FarField::NONE
    };
    for normal in [[-1.0, 0.0], [0.0, -1.0], [0.0, 1.0]] {
        let side = Plane {
            normal,
            offset: -m * dx,
            speed: 0.0,
        };
        fluid.open_side(&side, far);
    }
    fluid
}

/// Radius of the cavity: mean over its volume, and largest less smallest of sixteen directions, in units of R0.
fn radius(fluid: &Fluid, dx: f64) -> (f64, f64) {
    let window = Window {
        lower: [0.0, -1.3 * R0],
        upper: [1.3 * R0, 1.3 * R0],
        cell: 0.5 * dx,
    };
    let colour = Colour::new(fluid, &Ghosts::find(fluid, &[]), window);
    let volume = colour.cavities(2).first().map_or(0.0, |c| c.volume);
    let rays = colour.radii([0.0; 2], 16);
    let spread = rays.iter().fold(0.0, |m: f64, r| m.max(*r))
        - rays.iter().fold(f64::INFINITY, |m: f64, r| m.min(*r));
    ((0.75 * volume / PI).cbrt() / R0, spread / R0)
}

struct Mark {
    radius: f64,
    time_error: f64,
    speed_error: f64,
    roundness: f64,
    energy_error: f64,
}

/// R/R0, t (s), dR/dt (m/s).
fn reference() -> Vec<[f64; 3]> {
    include_str!("../../../../validation/rayleigh-collapse/radius_of_time.csv")
        .lines()
        .skip(1)
        .map(|line| {
            let v: Vec<f64> = line.split(',').map(|s| s.parse().unwrap_or(0.0)).collect();
            [v[0], v[5], v[7]]
        })
        .collect()
}

/// Slope of R^2.5 (nearly linear in time) over the last part of the way, as wall speed (m/s), and the radius it holds for.
fn speed(history: &[(f64, f64)]) -> (f64, f64) {
    let end = history.len() - 1;
    let from = history
        .iter()
        .rposition(|h| h.1 > 1.08 * history[end].1)
        .unwrap_or(0);
    let points = &history[from..];
    let n = points.len() as f64;
    let mean = |f: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(f).sum::<f64>() / n;
    let (t, y) = (mean(&|p| p.0), mean(&|p| p.1.powf(2.5)));
    let slope = mean(&|p| (p.0 - t) * (p.1.powf(2.5) - y)) / mean(&|p| (p.0 - t).powi(2));
    (slope * R0 / (2.5 * y.powf(0.6)), y.powf(0.4))
}

fn collapse(n: f64, reach: f64, settings: joshi::Settings, marks: &[f64]) -> Vec<Mark> {
    let fluid = liquid(n, reach, settings);
    let start = fluid.kinetic_energy() + fluid.compression_energy();
    let bodies = vec![Named {
        name: "water".to_owned(),
        body: Body::Fluid(fluid),
    }];
    let mut world = World::new(bodies, 0.3).unwrap();
    let reference = reference();
    let (mut history, mut found) = (vec![(0.0, 1.0)], Vec::new());
    while found.len() < marks.len() && world.time < 4e-7 {
        for _ in 0..4 {
            let dt = world.stable_time_step().0;
            world.advance(dt).unwrap();
        }
        let Body::Fluid(fluid) = &world.bodies[0].body else {
            panic!("a liquid")
        };
        let (mean, spread) = radius(fluid, R0 / n);
        let last = history[history.len() - 1];
        history.push((world.time, mean));
        while found.len() < marks.len() && mean <= marks[found.len()] {
            let mark = marks[found.len()];
            let share = (last.1 - mark) / (last.1 - mean);
            let time = last.0 + share * (world.time - last.0);
            let (v, at) = speed(&history);
            let k = reference.iter().position(|r| r[0] <= at).unwrap();
            let (q, p) = (reference[k - 1], reference[k]);
            let v_reference = q[2] + (p[2] - q[2]) * (q[0] - at) / (q[0] - p[0]);
            let t_reference = (reference.iter())
                .find(|r| (r[0] - mark).abs() < 1e-9)
                .unwrap()[1];
            let energy = fluid.kinetic_energy() + fluid.compression_energy();
            let balance = energy - start + fluid.account.dissipation - fluid.account.far_field_work;
            let mark = Mark {
                radius: mark,
                time_error: time / t_reference - 1.0,
                speed_error: v / v_reference - 1.0,
                roundness: spread / mean,
                energy_error: balance / (P * 4.0 / 3.0 * PI * R0.powi(3)),
            };
            println!(
                "n {n} {settings:?} R {:.2}: time {:+.2} %, speed {:+.1} %, round {:.3}, energy {:+.4} pV0, step {}",
                mark.radius,
                100.0 * mark.time_error,
                100.0 * mark.speed_error,
                mark.roundness,
                mark.energy_error,
                world.step
            );
            found.push(mark);
        }
    }
    if let Body::Fluid(f) = &world.bodies[0].body {
        println!("{:?}", f.account);
    }
    found
}

fn viscous(alpha: f64) -> joshi::Settings {
    joshi::Settings {
        alpha,
        ..joshi::Settings::default()
    }
}

fn check(marks: &[Mark], time: f64, speed: f64) {
    for m in marks {
        assert!(m.time_error.abs() < time, "time at {}", m.radius);
        // Later the cavity is no longer round, and its mean radius has no one speed.
        assert!(
            m.radius < 0.5 || m.speed_error.abs() < speed,
            "speed at {}",
            m.radius
        );
        assert!(m.energy_error.abs() < 0.015, "energy at {}", m.radius);
    }
}

/// Fifteen particles per radius: what is lost is the start, one spacing late at the first row (2.3 % in time), and 3.6 %
/// in speed at half the radius.
#[test]
fn collapse_in_time_at_low_resolution() {
    for alpha in [1.0, 0.2] {
        let marks = collapse(15.0, 4.5, viscous(alpha), &[0.8, 0.7, 0.5]);
        assert!(marks.len() == 3);
        check(&marks, 0.035, 0.05);
    }
}

/// Thirty: within 0.7 % in time down to 0.3 R0 and 1.3 % in speed down to 0.5 R0. Not round: 0.1 to 0.2 at 0.5 R0.
#[test]
#[ignore = "takes two minutes"]
fn collapse_in_time() {
    for alpha in [1.0, 0.2] {
        let marks = collapse(30.0, 5.0, viscous(alpha), &[0.9, 0.8, 0.7, 0.5, 0.3]);
        assert!(marks.len() == 5);
        check(&marks, 0.01, 0.025);
    }
}
