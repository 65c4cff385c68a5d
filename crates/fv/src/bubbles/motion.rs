//! The velocity of a bubble over a short time (Peters and el Moctar 2020, eqs 3.33 and 3.34).
//!
//! With w = u_b - u_c, M = m_b + rho V/2 and a = du_c/dt along the path of the bubble:
//!
//! d(M w)/dt = -k w + E - M a,   E = forces that do not hold the bubble's velocity (pressure gradient, Du/Dt of the added
//!                                   mass, lift, weight less buoyancy)
//!
//! The force of the change of volume is in the derivative of M, so the momentum of the added mass is kept exactly however fast
//! a bubble collapses. Drag is integrated exactly with k frozen at the middle: stable for any size of the step as (3.34) is,
//! but of second order. Units SI.

use super::carrier::CarrierPoint;
use super::forces::{Forces, added_mass, added_mass_of_flow, buoyancy, pressure_gradient, volume};
use crate::vector::{Vector, add, along, dot, mix, norm, scale, sub};
use serde::{Deserialize, Serialize};

/// What a bubble is exposed to during a short time.
#[derive(Debug, Clone, Copy)]
pub(super) struct Leg {
    /// Flow at start and end.
    pub(super) flow: [CarrierPoint; 2],
    /// Radius at start and end, m.
    pub(super) radius: [f64; 2],
    /// Length, s.
    pub(super) duration: f64,
}

/// What came of it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Kick {
    /// Velocity of the bubble at the end, m/s.
    pub(super) velocity: Vector,
    /// What its slip gained and lost.
    pub(super) energy: SlipLedger,
}

/// Energy of the slip, J: M w^2/2 changes by `drive_work` - `drag_loss` - `exchange`, to rounding.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct SlipLedger {
    /// Taken by drag.
    pub drag_loss: f64,
    /// Put in by the other forces, in the frame that moves with the liquid.
    pub drive_work: f64,
    /// Given to the change of volume: integral of w^2/2 dM. With the slip term of (3.36) the radius receives it; without
    /// that term it is energy from nowhere where negative, as in collapses.
    pub exchange: f64,
}

impl SlipLedger {
    /// Adds a part.
    pub(super) fn add(&mut self, part: &Self) {
        self.drag_loss += part.drag_loss;
        self.drive_work += part.drive_work;
        self.exchange += part.exchange;
    }
}

/// Effective mass m_b + m_a, kg.
pub(super) fn effective_mass(forces: &Forces, mass: f64, radius: f64, density: f64) -> f64 {
    if forces.added_mass {
        mass + added_mass(radius, density)
    } else {
        mass
    }
}

/// The flow at a fraction of a leg.
pub(super) fn between(a: &CarrierPoint, b: &CarrierPoint, x: f64) -> CarrierPoint {
    let line = |p: f64, q: f64| (1.0 - x) * p + x * q;
    let rows = [0, 1, 2].map(|i| mix(a.velocity_gradient[i], b.velocity_gradient[i], x));
    CarrierPoint {
        velocity: mix(a.velocity, b.velocity, x),
        pressure: line(a.pressure, b.pressure),
        pressure_gradient: mix(a.pressure_gradient, b.pressure_gradient, x),
        velocity_gradient: rows,
        acceleration: mix(a.acceleration, b.acceleration, x),
        density: line(a.density, b.density),
        viscosity: line(a.viscosity, b.viscosity),
    }
}

/// (1 - e^-x)/x.
fn phi(x: f64) -> f64 {
    if x.abs() < 1e-12 {
        1.0
    } else {
        -(-x).exp_m1() / x
    }
}

/// Velocity after a leg; `mass` of the bubble in kg.
pub(super) fn kick(forces: &Forces, mass: f64, velocity: Vector, leg: &Leg) -> Kick {
    let slip = sub(velocity, leg.flow[0].velocity);
    // Drag and lift of the slip at the start, then of the mean slip.
    let first = relax(forces, mass, slip, slip, leg);
    let second = relax(forces, mass, slip, mix(slip, first.slip, 0.5), leg);
    let (end, mean) = (second.slip, mix(slip, second.slip, 0.5));
    Kick {
        velocity: add(leg.flow[1].velocity, end),
        energy: SlipLedger {
            drag_loss: -dot(second.drag, mean),
            drive_work: dot(second.drive, mean),
            exchange: 0.5 * second.heavier * dot(slip, end),
        },
    }
}

/// A leg with given resistance.
struct Relaxed {
    /// Slip at the end, m/s.
    slip: Vector,
    /// Impulse of the drag, N s.
    drag: Vector,
    /// Impulse of the other forces in the frame of the liquid, N s.
    drive: Vector,
    /// Growth of the effective mass that carries the slip, kg.
    heavier: f64,
}

/// A leg with resistance and lift taken at the slip `at`.
fn relax(forces: &Forces, mass: f64, slip: Vector, at: Vector, leg: &Leg) -> Relaxed {
    let h = leg.duration;
    let flow = between(&leg.flow[0], &leg.flow[1], 0.5);
    let radius = 0.5 * (leg.radius[0] + leg.radius[1]);
    let ball = volume(radius);
    let heavy = |r: f64| effective_mass(forces, mass, r, flow.density);
    let inertia = heavy(radius);
    // Without the force (3.26) the slip, with it the momentum of the slip is kept.
    let kept = if forces.volume_change {
        (heavy(leg.radius[0]), heavy(leg.radius[1]))
    } else {
        (inertia, inertia)
    };
    let mut force = pressure_gradient(forces.pressure, ball, &flow);
    if forces.added_mass {
        force = add(force, added_mass_of_flow(ball, &flow));
    }
    force = add(force, forces.lift.force(ball, scale(-1.0, at), &flow));
    force = add(force, buoyancy(mass, ball, flow.density, forces.gravity));
    let along_path = scale(1.0 / h, sub(leg.flow[1].velocity, leg.flow[0].velocity));
    let drive = along(force, -inertia, along_path);
    let k = forces
        .drag
        .resistance(radius, norm(at), flow.density, flow.viscosity);
    let decay = k / inertia * h;
    let before = scale(kept.0, slip);
    let after = along(scale((-decay).exp(), before), h * phi(decay), drive);
    let drive = scale(h, drive);
    Relaxed {
        slip: scale(1.0 / kept.1, after),
        drag: sub(sub(after, before), drive),
        drive,
        heavier: kept.1 - kept.0,
    }
}

#[cfg(test)]
mod tests {
    use super::super::forces::{DragLaw, LiftLaw, PressureForce};
    use super::*;

    const STILL: Forces = Forces {
        pressure: PressureForce::Off,
        lift: LiftLaw::Off,
        drag: DragLaw::Stokes,
        ..Forces::IN_FLOW
    };

    fn leg(duration: f64) -> Leg {
        let flow = CarrierPoint::at_rest(1e5, 1000.0, 1e-3);
        Leg {
            flow: [flow; 2],
            radius: [1e-4; 2],
            duration,
        }
    }

    /// Stokes' drag alone: u = u0 exp(-k t/M); exact for any step.
    #[test]
    fn decay_is_exact_and_stable_at_large_steps() {
        let mass = 1e-12;
        let m = mass + 0.5 * 1000.0 * volume(1e-4);
        let k = 6.0 * std::f64::consts::PI * 1e-3 * 1e-4;
        for h in [1e-6, 1e-3, 10.0] {
            let u = kick(&STILL, mass, [0.3, 0.0, -0.1], &leg(h)).velocity;
            let factor = (-k * h / m).exp();
            assert!((u[0] - 0.3 * factor).abs() < 1e-15 && (u[2] + 0.1 * factor).abs() < 1e-15);
        }
    }

    /// A force much larger than inertia, a step of 10^6 relaxation times: the slip is force/k, nothing rings.
    #[test]
    fn large_drag_gives_the_steady_slip() {
        let forces = Forces {
            gravity: [0.0, 0.0, -9.81],
            ..STILL
        };
        let mut stiff = leg(1.0);
        for flow in &mut stiff.flow {
            flow.viscosity = 1e3;
        }
        let u = kick(&forces, 0.0, [5.0, 0.0, 0.0], &stiff).velocity;
        let k = 6.0 * std::f64::consts::PI * 1e3 * 1e-4;
        let rise = 1000.0 * volume(1e-4) * 9.81 / k;
        assert!((u[2] / rise - 1.0).abs() < 1e-12 && u[0].abs() < 1e-12);
    }

    /// A massless bubble in accelerating liquid without drag: du_b/dt = 3 Du_c/Dt.
    #[test]
    fn added_mass_triples_the_acceleration() {
        let forces = Forces {
            drag: DragLaw::Off,
            pressure: PressureForce::Acceleration,
            ..STILL
        };
        let (h, a) = (1e-3, 7.0);
        let mut moving = leg(h);
        for (flow, t) in moving.flow.iter_mut().zip([0.0, h]) {
            flow.velocity = [a * t, 0.0, 0.0];
            flow.acceleration = [a, 0.0, 0.0];
        }
        let u = kick(&forces, 0.0, [0.0; 3], &moving).velocity;
        assert!((u[0] / (3.0 * a * h) - 1.0).abs() < 1e-12);
        // With mass: 1.5 rho V/(m + 0.5 rho V).
        let rho_v = 1000.0 * volume(1e-4);
        let u = kick(&forces, rho_v, [0.0; 3], &moving).velocity;
        assert!(
            (u[0] / (a * h) - 1.0).abs() < 1e-12,
            "a bubble as heavy as liquid follows it"
        );
    }

    /// Collapse to a tenth without drag: the slip grows with the inverse of the volume, in one step.
    #[test]
    fn momentum_of_the_added_mass_is_kept() {
        let forces = Forces {
            drag: DragLaw::Off,
            ..STILL
        };
        let mut shrinking = leg(1e-6);
        shrinking.radius = [1e-4, 1e-5];
        let u = kick(&forces, 0.0, [0.01, 0.0, 0.0], &shrinking).velocity;
        assert!((u[0] / 10.0 - 1.0).abs() < 1e-12, "{u:?}");
    }

    /// What drag takes is what the bubble and its added mass lose.
    #[test]
    fn drag_loss_closes_the_energy() {
        let forces = Forces {
            drag: DragLaw::HabermanMorton,
            ..STILL
        };
        let (mass, u0) = (1e-11, [0.2, 0.1, 0.0]);
        let k = kick(&forces, mass, u0, &leg(1e-3));
        let m = mass + 0.5 * 1000.0 * volume(1e-4);
        let lost = 0.5 * m * (dot(u0, u0) - dot(k.velocity, k.velocity));
        assert!(lost > 0.0 && (k.energy.drag_loss / lost - 1.0).abs() < 1e-12);
    }

    /// The ledger of the slip closes to rounding with all forces and a radius that changes.
    #[test]
    fn the_ledger_of_the_slip_closes() {
        let forces = Forces {
            gravity: [0.0, 1.0, -9.81],
            ..Forces::IN_FLOW
        };
        let (mass, mut wild) = (1e-9, leg(1e-4));
        wild.radius = [1e-4, 0.7e-4];
        wild.flow[1].velocity = [0.05, -0.02, 0.01];
        wild.flow[0].acceleration = [500.0, -200.0, 100.0];
        wild.flow[1].velocity_gradient[0] = [0.0, 40.0, 0.0];
        let u0 = [0.3, 0.1, -0.2];
        let k = kick(&forces, mass, u0, &wild);
        let energy = |u: Vector, end: usize| {
            let w = sub(u, wild.flow[end].velocity);
            let m = effective_mass(&forces, mass, wild.radius[end], 1000.0);
            0.5 * m * dot(w, w)
        };
        let change = energy(k.velocity, 1) - energy(u0, 0);
        let e = k.energy;
        let balance = e.drive_work - e.drag_loss - e.exchange;
        assert!((change / balance - 1.0).abs() < 1e-10, "{change} {balance}");
        assert!(e.exchange < 0.0 && e.drag_loss > 0.0);
    }

    /// Halving the step quarters the error where drag is not linear.
    #[test]
    fn second_order() {
        let forces = Forces {
            drag: DragLaw::HabermanMorton,
            gravity: [0.0, 0.0, -9.81],
            ..STILL
        };
        let end = |n: u32| {
            let h = 2e-3 / f64::from(n);
            (0..n).fold([0.3, 0.0, 0.0], |u, _| {
                kick(&forces, 1e-11, u, &leg(h)).velocity
            })
        };
        let exact = end(4096);
        let error = |n: u32| norm(sub(end(n), exact));
        let order = (error(64) / error(128)).log2();
        assert!((1.8..2.3).contains(&order), "{order}");
    }
}
