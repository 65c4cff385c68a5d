use super::*;
use crate::strength::{JohnsonCook, Thermal};
use proptest::prelude::*;

const G: f64 = 186e9 / 2.6;

fn johnson_cook(c: f64, thermal: Option<Thermal>) -> Strength {
    Strength::JohnsonCook(JohnsonCook {
        a: 508e6,
        b: 832e6,
        n: 0.29,
        c,
        reference_rate: 4e-4,
        thermal,
    })
}

const SOFTENING: Thermal = Thermal {
    m: 1.03,
    reference_temperature: 293.0,
    melting_temperature: 1800.0,
    heat_capacity: 480.0,
    taylor_quinney: 0.9,
};

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]
    #[test]
    fn residual_vanishes_and_bracket_holds(
        overstress in -12.0_f64..1.0, strain in -12.0_f64..0.5, virgin in any::<bool>(),
        dt in -12.0_f64..-3.0, c in 0.0_f64..0.1, temperature in 200.0_f64..2000.0,
    ) {
        let law = johnson_cook(c, Some(SOFTENING));
        let e = if virgin { 0.0 } else { 10_f64.powf(strain) };
        let dt = 10_f64.powf(dt);
        let start = law.yield_stress(e, 0.0, temperature);
        let trial = start * (1.0 + 10_f64.powf(overstress)) + 1.0;
        let r = radial_return(trial, e, dt, temperature, G, &law).unwrap();
        let y = law.yield_stress(e + r.increment, r.increment / dt, temperature);
        let residual = trial - 3.0 * G * r.increment - y;
        prop_assert!(residual.abs() < 1e-9 * trial, "{residual}");
        prop_assert!(r.increment >= 0.0 && r.increment <= (trial - start) / (3.0 * G) * (1.0 + 1e-14));
        prop_assert!(r.iterations < 100, "{}", r.iterations);
    }
}

#[test]
fn closed_forms_of_constant_and_linear_yield() {
    let trial = 900e6;
    let constant = Strength::PerfectlyPlastic {
        yield_stress: 500e6,
    };
    let r = radial_return(trial, 0.2, 1e-9, 300.0, G, &constant).unwrap();
    assert!((r.increment / (400e6 / (3.0 * G)) - 1.0).abs() < 1e-12);
    let linear = Strength::LinearHardening {
        yield_stress: 500e6,
        hardening_modulus: 2e9,
    };
    let r = radial_return(trial, 0.05, 1e-9, 300.0, G, &linear).unwrap();
    assert!((r.increment / (300e6 / (3.0 * G + 2e9)) - 1.0).abs() < 1e-10);
    let r = radial_return(1e15, 0.05, 1e-9, 300.0, G, &Strength::Elastic).unwrap();
    assert_eq!((r.increment, r.yield_stress), (0.0, 1e15));
}

#[test]
fn slow_or_rate_free_return_is_quasi_static_for_any_dt() {
    let find = |c, dt| {
        let law = johnson_cook(c, None);
        radial_return(700e6, 1e-3, dt, 300.0, G, &law)
            .unwrap()
            .increment
    };
    assert_eq!(find(0.0, 1e-9), find(0.0, 1e3));
    assert_eq!(find(0.031, 1e9), find(0.0, 1.0));
    assert!(find(0.031, 1e-9) < 0.8 * find(0.0, 1.0));
}

#[test]
fn melt_carries_no_deviator_and_heat_comes_from_work() {
    let law = johnson_cook(0.031, Some(SOFTENING));
    let trial = Sym3 {
        xx: -3e9,
        yy: -1e9,
        xy: 4e8,
        ..Sym3::ZERO
    };
    let mut point = PointState {
        plastic_strain: 0.1,
        temperature: 1900.0,
        density: 7800.0,
    };
    let melt = return_stress(trial, point, 1e-9, G, &law).unwrap();
    assert!(melt.stress.von_mises() < 1e-9 * trial.von_mises());
    assert!((melt.stress.mean() - trial.mean()).abs() < 1e-3);
    point.temperature = 293.0;
    let p = return_stress(trial, point, 1e-9, G, &law).unwrap();
    assert!((p.stress.von_mises() * p.increment / p.work - 1.0).abs() < 1e-9);
    assert!((p.heating / (0.9 * p.work / (7800.0 * 480.0)) - 1.0).abs() < 1e-12);
}

#[test]
fn softening_and_nonsense_are_errors() {
    let soft = Strength::LinearHardening {
        yield_stress: 500e6,
        hardening_modulus: -4.0 * G,
    };
    let e = radial_return(900e6, 0.0, 1e-9, 300.0, G, &soft);
    assert!(matches!(e, Err(ReturnError::NotConverged { .. })));
    let e = radial_return(f64::NAN, 0.0, 1e-9, 300.0, G, &soft);
    assert!(matches!(e, Err(ReturnError::BadInput { .. })));
}
