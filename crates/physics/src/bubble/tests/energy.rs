//! The ledger: it closes, and what it calls radiated is the sound.

use super::*;
use std::f64::consts::PI;

fn drift(model: &Model, liquid: &Liquid, driving: &impl Driving, until: f64, unit: f64) -> f64 {
    let gas = equilibrium_gas(liquid, 8e-6, 1e5, 4.0 / 3.0).unwrap();
    let mut state = BubbleState::at_rest(1.2e-5, 0.0).unwrap();
    let total = |state: &BubbleState| state.energy(liquid, &gas, &driving.at(state.time)).total();
    let before = total(&state);
    let mut worst: f64 = 0.0;
    for i in 1..=50 {
        events(
            model,
            liquid,
            &gas,
            driving,
            &mut state,
            until * f64::from(i) / 50.0,
        );
        worst = worst.max((total(&state) - before).abs());
    }
    worst / unit
}

/// Lossless Rayleigh-Plesset at constant pressure: no integral takes part, the state alone keeps its energy.
#[test]
fn lossless_bubble_keeps_its_energy() {
    let liquid = Liquid {
        viscosity: 0.0,
        ..Liquid::WATER
    };
    let unit = 1e5 * 4.0 / 3.0 * PI * 1.2e-5_f64.powi(3);
    let constant = Constant { pressure: 1e5 };
    let model = Model::RayleighPlesset(RayleighPlesset);
    let drift = drift(&model, &liquid, &constant, 2e-5, unit);
    assert!(drift < 1e-9, "{drift:e}");
}

/// Driven, viscous, compressible: everything that leaves or enters is in the ledger.
#[test]
fn the_ledger_closes_in_every_model() {
    let unit = 1e5 * 4.0 / 3.0 * PI * 5e-5_f64.powi(3);
    for model in all_models() {
        let drift = drift(&model, &Liquid::WATER, &ACOUSTIC, 9e-5, unit);
        assert!(drift < 1e-9, "{} {drift:e}", model.name());
    }
}

/// Watches a bubble and adds up the power of the sound it sends out, rho V''^2/(4 pi c).
struct Sound<'a> {
    driving: &'a Constant,
    gas: Gas,
    energy: f64,
}

impl Watch for Sound<'_> {
    const STEPS: bool = true;

    fn step(&mut self, step: &DenseStep) {
        // Gauss quadrature with three points in each step.
        let q = 0.5 * 0.6_f64.sqrt();
        for (x, w) in [
            (0.5 - q, 5.0 / 18.0),
            (0.5, 8.0 / 18.0),
            (0.5 + q, 5.0 / 18.0),
        ] {
            let [radius, velocity, ..] = step.at_fraction(x);
            let wall = Wall {
                radius,
                velocity,
                phase: Phase::Growth,
            };
            let a = KellerMiksis.acceleration(&BARE, &self.gas, &wall, &self.driving.at(0.0));
            let bend = 4.0 * PI * radius * (radius * a + 2.0 * velocity * velocity);
            let power = BARE.density * bend * bend / (4.0 * PI * BARE.sound_speed);
            self.energy += w * (step.end_time() - step.start_time()) * power;
        }
    }
}

/// Between two rests of a gentle bubble, `radiated` is the sound radiated, to the order of the Mach number.
#[test]
fn radiated_is_the_sound() {
    let driving = Constant { pressure: 1e5 };
    let gas = equilibrium_gas(&BARE, 1e-4, 1e5, 1.4).unwrap();
    let mut sound = Sound {
        driving: &driving,
        gas,
        energy: 0.0,
    };
    let mut state = BubbleState::at_rest(1.1e-4, 0.0).unwrap();
    let model = KellerMiksis;
    let mut scout = state;
    let mut seen: Vec<Event> = Vec::new();
    advance(
        &model,
        &BARE,
        &gas,
        &driving,
        &fine(),
        &mut scout,
        1e-4,
        &mut seen,
    )
    .unwrap();
    // From the first largest radius, at the start, to the next one.
    let cycle = seen[2].time;
    advance(
        &model,
        &BARE,
        &gas,
        &driving,
        &fine(),
        &mut state,
        cycle,
        &mut sound,
    )
    .unwrap();
    let ratio = state.ledger.radiated / sound.energy;
    assert!((ratio - 1.0).abs() < 0.01, "{ratio}");
    assert!(state.ledger.viscous == 0.0 && state.ledger.driven == 0.0);
}
