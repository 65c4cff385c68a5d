//! Johnson-Cook at a point against the scalar equations solved by an unrelated method.
//!
//! Truth: de/dt = rate0 exp((q/(A + B e^n) - 1)/C) with q = k strain - m e, integrated with TR-BDF2 (second order,
//! L-stable) and bisection; k = 2G, m = 3G in uniaxial strain; k = m = E in uniaxial stress. Without rate the same by
//! bisection of q = A + B e^n alone.

use erode_physics::material_point::{
    Material, Path, PathPoint, uniaxial_strain_path, uniaxial_stress_path,
};
use erode_physics::strength::{JohnsonCook, Strength};
use erode_physics::{Elastic, material_point};

const E: f64 = 186e9;
const NU: f64 = 0.3;
const G: f64 = E / (2.0 * (1.0 + NU));
const K: f64 = E / (3.0 * (1.0 - 2.0 * NU));
const FINAL: f64 = 0.05;

fn law(c: f64) -> JohnsonCook {
    JohnsonCook {
        a: 508e6,
        b: 832e6,
        n: 0.29,
        c,
        reference_rate: 4e-4,
        thermal: None,
    }
}

fn material(c: f64) -> Material {
    Material {
        elastic: Elastic {
            young_modulus: E,
            poisson_ratio: NU,
        },
        strength: Strength::JohnsonCook(law(c)),
        density: 7800.0,
        temperature: 293.0,
    }
}

fn bisect(mut low: f64, mut high: f64, falling: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..70 {
        let mid = 0.5 * (low + high);
        if falling(mid) > 0.0 {
            low = mid;
        } else {
            high = mid;
        }
    }
    0.5 * (low + high)
}

/// Plastic strain at the end of loading to q = k FINAL - m e, by TR-BDF2 in `steps` steps from first yield.
fn scalar_truth(jc: &JohnsonCook, k: f64, m: f64, rate: f64, steps: u32) -> f64 {
    let static_yield = |e: f64| jc.a + jc.b * e.powf(jc.n);
    let top = k * FINAL / m;
    if jc.c == 0.0 {
        return bisect(0.0, top, |e| k * FINAL - m * e - static_yield(e));
    }
    let speed = |strain: f64, e: f64| {
        jc.reference_rate * (((k * strain - m * e) / static_yield(e) - 1.0) / jc.c).exp()
    };
    // Solves x = rhs + w speed(x).
    let implicit =
        |rhs: f64, w: f64, strain: f64| bisect(0.0, top, |x| rhs + w * speed(strain, x) - x);
    let start = jc.a / k;
    let dt = (FINAL - start) / rate / f64::from(steps);
    let g = 2.0 - 2.0_f64.sqrt();
    let mut e = 0.0;
    for i in 0..steps {
        let strain = |part: f64| start + rate * dt * (f64::from(i) + part);
        let first = implicit(
            e + 0.5 * g * dt * speed(strain(0.0), e),
            0.5 * g * dt,
            strain(g),
        );
        let rhs = (first - (1.0 - g).powi(2) * e) / (g * (2.0 - g));
        e = implicit(rhs, (1.0 - g) / (2.0 - g) * dt, strain(1.0));
    }
    e
}

fn last(points: Result<Vec<PathPoint>, material_point::PathError>) -> PathPoint {
    *points.expect("path").last().expect("point")
}

fn path(rate: f64, sign: f64) -> Path {
    Path {
        final_strain: sign * FINAL,
        rate,
        steps: 50_000,
    }
}

#[test]
fn uniaxial_strain_at_several_rates() {
    for (c, rate) in [(0.0, 1.0), (0.031, 1e-2), (0.031, 1e3), (0.031, 1e6)] {
        let p = last(uniaxial_strain_path(&material(c), path(rate, -1.0)));
        let e = scalar_truth(&law(c), 2.0 * G, 3.0 * G, rate, 20_000);
        let stress = -(K * FINAL + 2.0 / 3.0 * (2.0 * G * FINAL - 3.0 * G * e));
        println!(
            "{c} {rate}: {} {}",
            p.plastic_strain / e - 1.0,
            p.stress / stress - 1.0
        );
        assert!((p.plastic_strain / e - 1.0).abs() < 1e-6);
        assert!((p.stress / stress - 1.0).abs() < 1e-6);
    }
}

#[test]
fn uniaxial_stress_at_several_rates() {
    for (c, rate) in [(0.0, 1.0), (0.031, 1e-2), (0.031, 1e3), (0.031, 1e6)] {
        let p = last(uniaxial_stress_path(&material(c), path(rate, 1.0)));
        let e = scalar_truth(&law(c), E, E, rate, 20_000);
        let stress = E * (FINAL - e);
        println!(
            "{c} {rate}: {} {}",
            p.plastic_strain / e - 1.0,
            p.stress / stress - 1.0
        );
        assert!((p.plastic_strain / e - 1.0).abs() < 1e-6);
        assert!((p.stress / stress - 1.0).abs() < 1e-6);
    }
}

#[test]
fn answer_does_not_depend_on_the_step_and_the_truth_converges() {
    let coarse = scalar_truth(&law(0.031), 2.0 * G, 3.0 * G, 1e5, 5_000);
    let fine = scalar_truth(&law(0.031), 2.0 * G, 3.0 * G, 1e5, 20_000);
    assert!((coarse / fine - 1.0).abs() < 1e-7);
    let run = |steps| {
        let p = Path {
            steps,
            ..path(1e5, -1.0)
        };
        last(uniaxial_strain_path(&material(0.031), p)).plastic_strain
    };
    let errors: Vec<f64> = [100, 1000, 10_000]
        .map(|n| (run(n) / fine - 1.0).abs())
        .into();
    println!("{errors:?}");
    assert!(errors[0] < 1e-3 && errors[1] < errors[0] && errors[2] < errors[1]);
}
