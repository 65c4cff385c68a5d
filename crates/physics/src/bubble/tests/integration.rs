//! Time: accuracy, events, restart, many bubbles, and what is refused.

use super::*;
use crate::bubble::advance::Progress;

const RAYLEIGH: f64 = 0.914_681_356_501_954_5;

/// Rayleigh 1917: an empty cavity closes after 0.9146813565 R0 sqrt(rho/p); the rest of the way from the closure radius
/// takes 0.4 (2/3)^(-1/2) x^(5/2) of that unit.
#[test]
fn rayleigh_collapse_time() {
    let mut state = BubbleState::at_rest(1e-3, 0.0).unwrap();
    let mut seen: Vec<Event> = Vec::new();
    let driving = Constant { pressure: 1e5 };
    let model = RayleighPlesset;
    let done = advance(
        &model,
        &BARE,
        &EMPTY,
        &driving,
        &fine(),
        &mut state,
        1.0,
        &mut seen,
    );
    assert_eq!(done, Ok(Progress::Closed));
    assert_eq!(seen[0].kind, EventKind::CollapseBegins);
    assert_eq!(seen[1].kind, EventKind::Closed);
    assert_eq!(seen.len(), 2);
    let rest = 0.4 * 1.5_f64.sqrt() * (state.radius / 1e-3).powf(2.5);
    let time = state.time / (1e-3 * (1000.0_f64 / 1e5).sqrt()) + rest;
    assert!((time / RAYLEIGH - 1.0).abs() < 1e-11, "{time}");
    let again = advance(
        &model,
        &BARE,
        &EMPTY,
        &driving,
        &fine(),
        &mut state,
        1.0,
        &mut seen,
    );
    assert_eq!((again, seen.len()), (Ok(Progress::Closed), 2));
}

/// Lossless: the smallest radius follows from the energy alone, and the bubble comes back to where it was.
#[test]
fn smallest_radius_from_the_energy() {
    let gas = Gas {
        pressure: 2e3,
        radius: 1e-3,
        polytropic_exponent: 1.4,
    };
    let driving = Constant { pressure: 1e5 };
    let mut state = BubbleState::at_rest(1e-3, 0.0).unwrap();
    let model = Model::RayleighPlesset(RayleighPlesset);
    let seen = events(&model, &BARE, &gas, &driving, &mut state, 5e-4);
    let volume = |r: f64| 4.0 / 3.0 * std::f64::consts::PI * r.powi(3);
    let balance = |r: f64| gas.energy(r) - 1e5 * (volume(1e-3) - volume(r));
    let (mut low, mut high) = (1e-5, 5e-4);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if balance(middle) > 0.0 {
            low = middle
        } else {
            high = middle
        }
    }
    assert!(
        (seen[1].radius / low - 1.0).abs() < 1e-9,
        "{} {low}",
        seen[1].radius
    );
    assert!((seen[2].radius / 1e-3 - 1.0).abs() < 1e-9);
    let collapse = seen[1].collapse.unwrap();
    assert_eq!(collapse.begin.radius, 1e-3);
    assert_eq!(collapse.end_time, seen[1].time);
    assert!(
        (seen[2].time / (2.0 * seen[1].time) - 1.0).abs() < 1e-9,
        "not symmetric in time"
    );
}

/// Largest and smallest radii take turns, and the error of the radii falls with the tolerance.
#[test]
fn events_alternate_and_converge() {
    let gas = equilibrium_gas(&Liquid::WATER, 8e-6, 1e5, 4.0 / 3.0).unwrap();
    for model in all_models() {
        let run = |tolerance: f64| {
            let mut state = BubbleState::at_rest(8e-6, 0.0).unwrap();
            let mut seen: Vec<Event> = Vec::new();
            let controls = Controls {
                tolerance,
                ..Controls::default()
            };
            advance(
                &model,
                &Liquid::WATER,
                &gas,
                &ACOUSTIC,
                &controls,
                &mut state,
                4e-5,
                &mut seen,
            )
            .unwrap();
            seen
        };
        let (truth, close) = (run(1e-13), run(1e-9));
        for (i, event) in truth.iter().enumerate() {
            let largest = event.kind == EventKind::CollapseBegins;
            assert_eq!(largest, i % 2 == 0, "{} event {i}", model.name());
            assert!((close[i].radius / event.radius - 1.0).abs() < 1e-6);
        }
    }
}

/// A carrier that hands over values step by step, with the state written down and read back in between.
#[test]
fn restart_has_the_same_bits() {
    let gas = equilibrium_gas(&Liquid::WATER, 8e-6, 1e5, 4.0 / 3.0).unwrap();
    let piece = |i: i32| {
        let (start_time, end_time) = (f64::from(i) * 1e-7, f64::from(i + 1) * 1e-7);
        Linear {
            start_time,
            end_time,
            start: ACOUSTIC.at(start_time),
            end: ACOUSTIC.at(end_time),
        }
    };
    for model in all_models() {
        let mut straight = BubbleState::at_rest(8e-6, 0.0).unwrap();
        let mut written = straight;
        for i in 0..400 {
            let until = f64::from(i + 1) * 1e-7;
            events(
                &model,
                &Liquid::WATER,
                &gas,
                &piece(i),
                &mut straight,
                until,
            );
            let text = serde_json::to_string(&written).unwrap();
            written = serde_json::from_str(&text).unwrap();
            events(&model, &Liquid::WATER, &gas, &piece(i), &mut written, until);
        }
        assert_eq!(straight, written, "{}", model.name());
        assert!(straight.counters.collapses > 1);
        let mut smooth = BubbleState::at_rest(8e-6, 0.0).unwrap();
        let seen = events(&model, &Liquid::WATER, &gas, &ACOUSTIC, &mut smooth, 4e-5);
        // Straight lines instead of the sine: the largest radius differs by about (omega dt)^2/12.
        let largest = straight.largest.unwrap().radius;
        let last = seen
            .iter()
            .rev()
            .find(|e| e.kind == EventKind::CollapseBegins)
            .unwrap();
        assert!(
            (largest / last.radius - 1.0).abs() < 1e-2,
            "{}",
            model.name()
        );
    }
}

/// Late in a long run the clock's last digit is longer than the steps of a collapse; the bubble does not notice.
#[test]
fn long_runs_keep_their_accuracy() {
    let gas = equilibrium_gas(&Liquid::WATER, 8e-6, 1e5, 4.0 / 3.0).unwrap();
    let driving = Constant { pressure: 1e5 };
    let smallest = |time: f64| {
        let mut state = BubbleState::at_rest(6e-5, time).unwrap();
        let model = Model::KellerMiksis(KellerMiksis);
        events(
            &model,
            &Liquid::WATER,
            &gas,
            &driving,
            &mut state,
            time + 1e-5,
        )[1]
        .radius
    };
    assert!((smallest(1e4) / smallest(0.0) - 1.0).abs() < 1e-10);
}

/// In a very viscous liquid R' = R (p_v - p)/(4 mu), reached within rho R^2/(4 mu) (Keller-Miksis: its viscous term adds
/// R/c); what is left out is of order 1e-7. The implicit method takes over and needs hundreds of steps where explicit
/// ones, of h = 6 rho R^2/(4 mu), would be millions.
#[test]
fn stiff_walls_take_few_steps() {
    let liquid = Liquid {
        viscosity: 10.0,
        ..BARE
    };
    let driving = Constant { pressure: 1e5 };
    let gas = Gas {
        radius: 1e-6,
        ..EMPTY
    };
    let (end, rate) = (4e-4, 1e5 / 40.0);
    let start_up = 1000.0 * 1e-12 / 40.0;
    for (model, start_up) in [
        (Model::RayleighPlesset(RayleighPlesset), start_up),
        (Model::KellerMiksis(KellerMiksis), start_up + 1e-6 / 1500.0),
    ] {
        let mut state = BubbleState::at_rest(1e-6, 0.0).unwrap();
        let controls = Controls::default();
        advance(
            &model,
            &liquid,
            &gas,
            &driving,
            &controls,
            &mut state,
            end,
            &mut (),
        )
        .unwrap();
        let exact = 1e-6 * (-rate * (end - start_up)).exp();
        assert!((state.radius / exact - 1.0).abs() < 2e-7);
        let steps = state.counters.steps + state.counters.rejected;
        assert!(steps < 500, "{:?}", state.counters);
        assert!(state.counters.implicit_steps > 10);
    }
}

/// Many bubbles at once have the bits of each alone, for any number of threads.
#[test]
fn batches_do_not_depend_on_threads() {
    let driving = ACOUSTIC;
    let model = Model::KellerMiksis(KellerMiksis);
    let make = || {
        (0..64_i32)
            .map(|i| {
                let radius = 3e-6 + 2e-7 * f64::from(i);
                let gas = equilibrium_gas(&Liquid::WATER, radius, 1e5, 1.4).unwrap();
                let state = BubbleState::at_rest(radius, 0.0).unwrap();
                Member {
                    gas,
                    state,
                    driving,
                    watch: Vec::<Event>::new(),
                }
            })
            .collect::<Vec<_>>()
    };
    let mut alone = make();
    for m in &mut alone {
        events(&model, &Liquid::WATER, &m.gas, &driving, &mut m.state, 4e-5);
    }
    for threads in [1, 3] {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        let mut members = make();
        pool.install(|| advance_all(&model, &Liquid::WATER, &fine(), &mut members, 4e-5))
            .unwrap();
        for (a, b) in alone.iter().zip(&members) {
            assert_eq!(a.state, b.state);
            assert!(b.watch.len() > 3);
        }
    }
}

#[test]
fn what_is_refused() {
    let gas = equilibrium_gas(&Liquid::WATER, 8e-6, 1e5, 4.0 / 3.0).unwrap();
    let run = |controls: &Controls, until: f64| {
        let mut state = BubbleState::at_rest(8e-6, 1e-6).unwrap();
        let model = KellerMiksis;
        advance(
            &model,
            &Liquid::WATER,
            &gas,
            &ACOUSTIC,
            controls,
            &mut state,
            until,
            &mut (),
        )
    };
    let few = Controls {
        max_steps: 10,
        ..Controls::default()
    };
    let error = run(&few, 1e-4).unwrap_err();
    assert!(
        matches!(error, BubbleError::StepLimit { max_steps: 10, .. }),
        "{error}"
    );
    let error = run(&Controls::default(), 0.0).unwrap_err();
    assert!(matches!(error, BubbleError::Backwards { .. }), "{error}");
    assert!(BubbleState::at_rest(-1e-6, 0.0).is_err());
    assert!(BubbleState::moving(1e-6, f64::NAN, 0.0).is_err());
    let broken = |time: f64| {
        Constant {
            pressure: if time > 2e-6 { f64::NAN } else { 1e5 },
        }
        .at(time)
    };
    let mut state = BubbleState::at_rest(9e-6, 0.0).unwrap();
    let error = advance(
        &KellerMiksis,
        &Liquid::WATER,
        &gas,
        &broken,
        &Controls::default(),
        &mut state,
        1e-5,
        &mut (),
    )
    .unwrap_err();
    assert!(matches!(error, BubbleError::StepTooSmall { .. }), "{error}");
    assert!(
        (state.time - 2e-6).abs() < 1e-12,
        "stops where the trouble is: {}",
        state.time
    );
}

/// A bubble in equilibrium stays there without events.
#[test]
fn rest_is_rest() {
    for model in all_models() {
        let gas = equilibrium_gas(&Liquid::WATER, 8e-6, 1e5, 1.4).unwrap();
        let mut state = BubbleState::at_rest(8e-6, 0.0).unwrap();
        let driving = Constant { pressure: 1e5 };
        let seen = events(&model, &Liquid::WATER, &gas, &driving, &mut state, 1e-3);
        assert!(seen.is_empty(), "{} {:?}", model.name(), seen);
        assert!((state.radius / 8e-6 - 1.0).abs() < 1e-9);
    }
}
