//! Limits and small oscillations, which have closed answers.

use super::*;

const WALLS: [(f64, f64); 4] = [(8e-6, 0.0), (2e-6, -80.0), (3e-5, 5.0), (1e-6, 30.0)];

fn wall((radius, velocity): (f64, f64)) -> Wall {
    Wall {
        radius,
        velocity,
        phase: Phase::Collapse,
    }
}

/// With a sound speed that grows without bound, every law is Rayleigh-Plesset.
#[test]
fn incompressible_limit() {
    let liquid = Liquid {
        sound_speed: 1e12,
        ..Liquid::WATER
    };
    let gas = equilibrium_gas(&liquid, 8e-6, 1e5, 1.4).unwrap();
    let ambient = Ambient {
        pressure: 3e5,
        pressure_rate: 1e11,
        slip_squared: 4.0,
        slip_squared_rate: 1e5,
    };
    let models = [
        Model::KellerMiksis(KellerMiksis),
        Model::Gilmore(Gilmore::default()),
        Model::TomitaShima(TomitaShima {
            density_factor: 1.0,
        }),
    ];
    for place in WALLS {
        let exact = RayleighPlesset.acceleration(&liquid, &gas, &wall(place), &ambient);
        for model in models {
            let got = model.acceleration(&liquid, &gas, &wall(place), &ambient);
            assert!(
                (got / exact - 1.0).abs() < 1e-7,
                "{} {got} {exact}",
                model.name()
            );
        }
    }
}

/// For small Mach numbers the three compressible laws differ from Rayleigh-Plesset by O(M) and from each other by
/// O(M^2): ten times the sound speed brings them a hundred times closer. (The laws are equal to first order only on
/// solutions, so R'' in the terms of order M is replaced by a small residual.)
#[test]
fn keller_miksis_and_gilmore_agree_to_first_order() {
    let difference = |sound_speed: f64| {
        let liquid = Liquid {
            sound_speed,
            ..BARE
        };
        let gas = equilibrium_gas(&liquid, 8e-6, 1e5, 1.4).unwrap();
        let ambient = Constant { pressure: 2e5 }.at(0.0);
        let place = wall((6e-6, -10.0));
        let a = KellerMiksis.acceleration(&liquid, &gas, &place, &ambient);
        let b = Gilmore::default().acceleration(&liquid, &gas, &place, &ambient);
        let c = RayleighPlesset.acceleration(&liquid, &gas, &place, &ambient);
        ((a - b).abs(), (a - c).abs())
    };
    let (second, first) = difference(1500.0);
    let (second_fine, first_fine) = difference(15_000.0);
    let order = (second / second_fine).log10();
    assert!((order - 2.0).abs() < 0.1, "{order}");
    assert!(((first / first_fine).log10() - 1.0).abs() < 0.1);
}

/// Small oscillations: frequency of Minnaert with surface tension, damping 2 nu/R^2 by viscosity and omega^2 R/(2 c)
/// by sound. Signs and factors of every term of first order show here.
#[test]
fn small_oscillations_have_the_classical_frequency_and_damping() {
    let liquid = Liquid::WATER;
    let radius = 5e-5;
    let gas = equilibrium_gas(&liquid, radius, 1e5, 1.4).unwrap();
    let stiffness = 3.0 * 1.4 * gas.pressure - 2.0 * liquid.surface_tension / radius;
    let natural = (stiffness / liquid.density).sqrt() / radius;
    let viscous = 2.0 * liquid.viscosity / (liquid.density * radius * radius);
    let sound = 0.5 * natural * natural * radius / liquid.sound_speed;
    for model in all_models() {
        let damping = match model {
            Model::RayleighPlesset(_) => viscous,
            Model::Switching(_) => continue, // damped by sound in one half of the cycle only
            _ => viscous + sound,
        };
        let mut state = BubbleState::at_rest(radius * (1.0 + 1e-5), 0.0).unwrap();
        let driving = Constant { pressure: 1e5 };
        let seen = events(&model, &liquid, &gas, &driving, &mut state, 21.0 / natural);
        let (first, second) = (seen[1], seen[3]);
        let period = second.time - first.time;
        let decay = ((radius - first.radius) / (radius - second.radius)).ln() / period;
        let frequency = (std::f64::consts::TAU / period).hypot(decay);
        let name = model.name();
        assert!(
            (frequency / natural - 1.0).abs() < 3e-4,
            "{name} {frequency} {natural}"
        );
        assert!(
            (decay / damping - 1.0).abs() < 5e-3,
            "{name} {decay} {damping}"
        );
    }
}

/// A relative velocity lowers the mean pressure by rho u^2/4, in every law and with its rate.
#[test]
fn slip_acts_as_lower_pressure() {
    let liquid = Liquid::WATER;
    let gas = equilibrium_gas(&liquid, 8e-6, 1e5, 1.4).unwrap();
    let with_slip = Ambient {
        pressure: 1e5,
        pressure_rate: 1e10,
        slip_squared: 9.0,
        slip_squared_rate: 1e6,
    };
    let without = Ambient {
        pressure: 1e5 - 0.25 * 998.2 * 9.0,
        pressure_rate: 1e10 - 0.25 * 998.2 * 1e6,
        ..Ambient::default()
    };
    for model in all_models() {
        for place in WALLS {
            let a = model.acceleration(&liquid, &gas, &wall(place), &with_slip);
            let b = model.acceleration(&liquid, &gas, &wall(place), &without);
            assert!((a / b - 1.0).abs() < 1e-12, "{}", model.name());
        }
    }
}

/// Gilmore's enthalpy and sound speed against sums over small pressure steps.
#[test]
fn gilmore_enthalpy_is_the_integral_of_dp_over_rho() {
    let liquid = BARE;
    let law = Gilmore::default();
    // At rest, without rates: R R'' = H.
    let gas = Gas {
        pressure: 5e9,
        radius: 1e-5,
        polytropic_exponent: 1.4,
    };
    let ambient = Constant { pressure: 2e5 }.at(0.0);
    let got = 1e-5 * law.acceleration(&liquid, &gas, &wall((1e-5, 0.0)), &ambient);
    let stiffness = 1000.0 * 1500.0_f64.powi(2) / 7.0;
    let (n, mut sum) = (200_000, 0.0);
    let step = (5e9 - 2e5) / f64::from(n);
    for i in 0..n {
        let p = 2e5 + (f64::from(i) + 0.5) * step;
        sum += step / (1000.0 * ((p - 1e5) / stiffness + 1.0).powf(1.0 / 7.0));
    }
    assert!((got / sum - 1.0).abs() < 1e-7, "{got} {sum}");
}

/// A wall faster than the law allows gives no number, not a wrong one.
#[test]
fn supersonic_walls_have_no_answer() {
    let ambient = Constant { pressure: 1e5 }.at(0.0);
    let gas = Gas {
        pressure: 1e5,
        ..EMPTY
    };
    let fast = wall((1e-3, 3000.0));
    for model in all_models().into_iter().skip(1) {
        let got = model.acceleration(&BARE, &gas, &fast, &ambient);
        assert!(got.is_nan(), "{}", model.name());
    }
}
