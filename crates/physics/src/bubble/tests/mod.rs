//! Bubbles against known answers.

mod energy;
mod integration;
mod models;

use super::*;

/// Water without viscosity, surface tension and vapour.
const BARE: Liquid = Liquid {
    density: 1000.0,
    sound_speed: 1500.0,
    viscosity: 0.0,
    surface_tension: 0.0,
    vapour_pressure: 0.0,
};

const EMPTY: Gas = Gas {
    pressure: 0.0,
    radius: 1e-3,
    polytropic_exponent: 1.4,
};

const ACOUSTIC: Sine = Sine {
    mean: 1e5,
    amplitude: 132e3,
    frequency: 21.4e3,
};

fn all_models() -> [Model; 5] {
    [
        Model::RayleighPlesset(RayleighPlesset),
        Model::KellerMiksis(KellerMiksis),
        Model::Gilmore(Gilmore::default()),
        Model::TomitaShima(TomitaShima {
            density_factor: 1.0,
        }),
        Model::Switching(Switching::default()),
    ]
}

fn fine() -> Controls {
    Controls {
        tolerance: 1e-12,
        ..Controls::default()
    }
}

/// Advances and returns the events.
fn events(
    model: &Model,
    liquid: &Liquid,
    gas: &Gas,
    driving: &impl Driving,
    state: &mut BubbleState,
    until: f64,
) -> Vec<Event> {
    let mut events = Vec::new();
    advance(
        model,
        liquid,
        gas,
        driving,
        &fine(),
        state,
        until,
        &mut events,
    )
    .unwrap();
    events
}
