use super::super::carrier::{Acoustic, Bounded, NearPlane, Stagnation, Still, Wave};
use super::super::forces::{DragLaw, Forces, LiftLaw, PressureForce, terminal_speed, volume};
use super::super::{Averaging, Settings, deposit};
use super::*;
use erode_physics::bubble::{Liquid, Model, RayleighPlesset, Sine, equilibrium_gas};
use erode_physics::erosion::{Assessment, PotentialMap, WallElement};
use erode_physics::nuclei::{NucleiDistribution, Stream};

const LIQUID: Liquid = Liquid::WATER;
const MODEL: Option<Model> = Some(Model::RayleighPlesset(RayleighPlesset));

fn still(pressure: f64) -> Still {
    Still {
        pressure,
        density: LIQUID.density,
        viscosity: LIQUID.viscosity,
        gravity: [0.0; 3],
    }
}

fn bubble(radius: f64, position: Vector, velocity: Vector) -> NewBubble {
    NewBubble {
        position,
        velocity,
        radius,
        wall_velocity: 0.0,
        gas: equilibrium_gas(&LIQUID, radius, 1e5, 1.4).unwrap(),
        mass: 1.2 * volume(radius),
    }
}

/// A sound field near a wall with thirty nuclei of different sizes.
fn noisy() -> (NearPlane<Acoustic>, Settings, Cloud) {
    let flow = Acoustic {
        wave: Wave::Travelling([0.0, 0.6, 0.8]),
        mean: 1e5,
        amplitude: 1.5e5,
        frequency: 2e4,
        density: LIQUID.density,
        sound_speed: LIQUID.sound_speed,
        viscosity: LIQUID.viscosity,
    };
    let near = NearPlane {
        flow,
        point: [0.0; 3],
        normal: [0.0, 0.0, 1.0],
    };
    let mut cloud = Cloud::new(0.0);
    let (place, size) = (Stream { seed: 1 }, Stream { seed: 2 });
    for k in 0..30 {
        let radius = NucleiDistribution::Measured.sample(size, k);
        let [x, y, z] = [0, 1, 2].map(|j| place.uniform(3 * k + j) * 2e-4);
        cloud
            .inject(&bubble(radius, [x, y, z + 1e-5], [0.1, 0.0, 0.0]))
            .unwrap();
    }
    (near, Settings::new(LIQUID, MODEL), cloud)
}

fn on_threads<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .unwrap();
    pool.install(work)
}

#[test]
fn same_bits_for_any_number_of_threads_and_after_a_restart() {
    let (flow, settings, cloud) = noisy();
    let run = |mut cloud: Cloud, restart: bool| {
        let mut records = cloud.advance(&flow, &settings, 2e-5).unwrap();
        if restart {
            let text = serde_json::to_string(&cloud).unwrap();
            cloud = serde_json::from_str(&text).unwrap();
        }
        records.extend(cloud.advance(&flow, &settings, 1e-4).unwrap());
        (cloud, records)
    };
    let one = on_threads(1, || run(cloud.clone(), false));
    assert!(one.0.ledger.collapses > 10, "{:?}", one.0.ledger);
    assert_eq!(one, on_threads(2, || run(cloud.clone(), false)));
    assert_eq!(one, on_threads(3, || run(cloud.clone(), true)));
}

/// Every bubble and every collapse is in one counter.
#[test]
fn the_ledger_closes() {
    let (flow, settings, mut cloud) = noisy();
    let boxed = Bounded {
        flow,
        lower: [0.0; 3],
        upper: [2.02e-4; 3],
    };
    let records = cloud.advance(&boxed, &settings, 2e-4).unwrap();
    let l = cloud.ledger;
    assert!(l.left_domain > 0);
    assert_eq!(
        l.injected,
        cloud.len() as u64 + l.left_domain + l.closed + l.failed
    );
    assert_eq!(cloud.lost.len() as u64, l.left_domain + l.closed + l.failed);
    assert_eq!(
        l.collapses,
        l.impacts + l.too_near + l.too_far + l.no_wall + l.not_assessed
    );
    assert_eq!(records.len() as u64 + l.not_assessed, l.collapses);
    let totals = cloud.totals(&boxed, &settings).unwrap();
    let put_in: f64 = 1.2 * noisy().2.state.iter().map(|s| s.volume()).sum::<f64>();
    assert!(((totals.mass + totals.lost_mass) / put_in - 1.0).abs() < 1e-12);
}

/// In a uniform sound field the cloud is the single bubble; the error of the straight lines falls with the square.
#[test]
fn radii_follow_the_sound_to_second_order() {
    let flow = Acoustic {
        wave: Wave::Uniform,
        mean: 1e5,
        amplitude: 3e4,
        frequency: 2e4,
        density: LIQUID.density,
        sound_speed: LIQUID.sound_speed,
        viscosity: LIQUID.viscosity,
    };
    let new = bubble(2e-5, [0.0; 3], [0.0; 3]);
    let end = 7e-5;
    let mut exact = BubbleState::at_rest(2e-5, 0.0).unwrap();
    let sine = Sine {
        mean: 1e5,
        amplitude: 3e4,
        frequency: 2e4,
    };
    let controls = Settings::new(LIQUID, MODEL).controls;
    erode_physics::bubble::advance(
        &RayleighPlesset,
        &LIQUID,
        &new.gas,
        &sine,
        &controls,
        &mut exact,
        end,
        &mut (),
    )
    .unwrap();
    let error = |time_share: f64| {
        let settings = Settings {
            time_share,
            ..Settings::new(LIQUID, MODEL)
        };
        let mut cloud = Cloud::new(0.0);
        cloud.inject(&new).unwrap();
        cloud.advance(&flow, &settings, end).unwrap();
        (cloud.state[0].radius / exact.radius - 1.0).abs()
    };
    let (coarse, fine) = (error(0.04), error(0.02));
    assert!(fine < 1e-4, "{fine}");
    let order = (coarse / fine).log2();
    assert!((1.7..2.3).contains(&order), "{coarse} {fine} {order}");
}

/// A bubble that slips through inviscid liquid while it swings: what the slip loses the radius gains.
#[test]
fn slip_and_radius_exchange_energy() {
    let liquid = Liquid {
        viscosity: 0.0,
        ..LIQUID
    };
    let forces = Forces {
        pressure: PressureForce::Off,
        drag: DragLaw::Off,
        lift: LiftLaw::Off,
        ..Forces::IN_FLOW
    };
    let drift = |radius_share: f64| {
        let settings = Settings {
            slip: true,
            forces,
            radius_share,
            ..Settings::new(liquid, MODEL)
        };
        let flow = still(1e5);
        let mut cloud = Cloud::new(0.0);
        let mut new = bubble(1e-4, [0.0; 3], [3.0, 0.0, 0.0]);
        (new.radius, new.mass) = (1.5e-4, 0.0);
        cloud.inject(&new).unwrap();
        let energy = |cloud: &Cloud| {
            let t = cloud.totals(&flow, &settings).unwrap();
            // The potential is lower by rho w^2 V/4, which without mass is the energy of the slip.
            let radial = t.radial_kinetic + t.potential + t.slip_energy + t.gas;
            (radial + t.slip_energy, t.slip_energy)
        };
        let before = energy(&cloud);
        let mut exchanged = 0.0f64;
        for k in 1..=20 {
            cloud
                .advance(&flow, &settings, 2e-6 * f64::from(k))
                .unwrap();
            exchanged = exchanged.max((energy(&cloud).1 - before.1).abs());
        }
        assert!(exchanged > 0.5 * before.1, "the radius swings: {exchanged}");
        (energy(&cloud).0 - before.0).abs() / exchanged
    };
    let (coarse, fine) = (drift(0.04), drift(0.02));
    assert!(fine < 2e-3 && coarse / fine > 3.0, "{coarse} {fine}");
}

#[test]
fn a_bubble_rises_at_its_terminal_speed() {
    let gravity = [0.0, 0.0, -9.81];
    let flow = Still {
        gravity,
        density: 1000.0,
        ..still(1e5)
    };
    let forces = Forces {
        gravity,
        drag: DragLaw::Gravity {
            gravity: 9.81,
            surface_tension: 0.073,
            bubble_density: 1.0,
        },
        ..Forces::IN_FLOW
    };
    let settings = Settings {
        forces,
        averaging: Averaging::Surface,
        ..Settings::new(LIQUID, None)
    };
    let mut cloud = Cloud::new(0.0);
    let new = NewBubble {
        mass: volume(2e-3),
        ..bubble(2e-3, [0.0; 3], [0.0; 3])
    };
    cloud.inject(&new).unwrap();
    for k in 1..=400 {
        cloud
            .advance(&flow, &settings, 5e-4 * f64::from(k))
            .unwrap();
    }
    let u = terminal_speed(2e-3, (1000.0, 1.0), 9.81, 0.073);
    assert!((cloud.velocity[0][2] / u - 1.0).abs() < 1e-9);
}

/// A stagnation flow presses a bubble on the wall, where it is held and counted, not lost.
#[test]
fn walls_hold_bubbles() {
    let flow = Stagnation {
        strain_rate: 100.0,
        pressure: 1e5,
        density: 998.2,
        viscosity: 1e-3,
    };
    let settings = Settings::new(LIQUID, None);
    let mut cloud = Cloud::new(0.0);
    cloud
        .inject(&bubble(1e-4, [0.0, 0.0, 1e-3], [0.0, 0.0, -0.2]))
        .unwrap();
    cloud.advance(&flow, &settings, 0.1).unwrap();
    assert_eq!(cloud.len(), 1);
    assert!(cloud.position[0][2] >= 1e-4 * (1.0 - 1e-12));
    // At the wall the bubble drifts off or rests; it must never have gone through.
    assert!(cloud.ledger.left_domain == 0);
}

/// Rayleigh-like collapse at 1.5 radii from a wall: one assessed impact with the pressure of the bubble.
#[test]
fn a_collapse_near_a_wall_is_an_impact() {
    let flow = NearPlane {
        flow: still(1e5),
        point: [0.0; 3],
        normal: [0.0, 0.0, 1.0],
    };
    let settings = Settings::new(LIQUID, MODEL);
    let mut cloud = Cloud::new(0.0);
    let mut new = bubble(1e-5, [0.0, 0.0, 1.5e-4], [0.0; 3]);
    new.radius = 1e-4;
    cloud.inject(&new).unwrap();
    let records = cloud.advance(&flow, &settings, 1.2e-5).unwrap();
    assert_eq!((records.len(), cloud.ledger.impacts), (1, 1));
    let Some(Assessment::Impact(impact)) = records[0].assessment else {
        panic!("{records:?}");
    };
    assert!((impact.standoff - 1.5).abs() < 1e-12);
    assert!(impact.impact_pressure < records[0].peak_pressure);
    assert_eq!(records[0].begin.wall_point, Some([0.0, 0.0, 0.0]));
}

#[test]
fn bad_input_is_refused_and_leaves_the_cloud_alone() {
    let mut cloud = Cloud::new(0.0);
    let good = bubble(1e-4, [0.0; 3], [0.0; 3]);
    assert!(
        cloud
            .inject(&NewBubble {
                radius: -1e-4,
                ..good
            })
            .is_err()
    );
    assert!(cloud.inject(&NewBubble { mass: -1.0, ..good }).is_err());
    assert!(
        cloud
            .inject(&NewBubble {
                velocity: [f64::NAN; 3],
                ..good
            })
            .is_err()
    );
    assert!(cloud.is_empty() && cloud.ledger.injected == 0);
    cloud.inject(&good).unwrap();
    let settings = Settings::new(LIQUID, MODEL);
    assert!(cloud.advance(&still(1e5), &settings, -1.0).is_err());
    let stuck = Settings {
        courant: 0.0,
        ..settings
    };
    let message = cloud
        .advance(&still(1e5), &stuck, 1e-5)
        .unwrap_err()
        .to_string();
    assert!(message.contains("courant"), "{message}");
    let before = cloud.clone();
    let broken = still(f64::NAN);
    let message = cloud
        .advance(&broken, &settings, 1e-5)
        .unwrap_err()
        .to_string();
    assert!(message.contains("not finite"), "{message}");
    assert_eq!(cloud, before);
}

/// Collapses of a cloud over a wall of two elements: each impact lies on the element under its bubble.
#[test]
fn impacts_lie_under_their_bubbles() {
    let (flow, settings, mut cloud) = noisy();
    let records = cloud.advance(&flow, &settings, 1e-4).unwrap();
    let element = |x: f64| WallElement {
        centre: [x, 1e-4, 0.0],
        normal: [0.0, 0.0, 1.0],
        area: 2e-8,
    };
    let mut map = PotentialMap::new(vec![element(0.5e-4), element(1.5e-4)]).unwrap();
    deposit(&mut map, &records).unwrap();
    assert_eq!(map.impacts().iter().sum::<u64>(), cloud.ledger.impacts);
    assert!(cloud.ledger.impacts > 0);
    let mut right = 0.0;
    let mut all = 0.0;
    for record in &records {
        if let Some(Assessment::Impact(impact)) = record.assessment {
            all += impact.impact_pressure;
            if record.begin.position[0] > 1e-4 {
                right += impact.impact_pressure;
            }
        }
    }
    let share = map.linear().unwrap()[1];
    assert!((share - right / all).abs() < 1e-12 && map.squared().unwrap()[1] <= 1.0);
}
