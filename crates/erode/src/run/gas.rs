//! Gas in the bubble of a case.

use super::RunError;
use super::bubble_state::wetted;
use crate::case::{Body as Asked, BodyKind, Bubble, BubbleGas, Side, Simulation};
use erode_sph::fluid::gas::{Gas, GasLaw};
use erode_sph::fluid::ghosts::{Ghosts, Wall};
use erode_sph::world::{Body, World};

/// Fills the bubble of a case with its gas.
///
/// # Errors
/// If there is no cavity where the bubble should be.
pub(super) fn fill(world: &mut World, simulation: &Simulation) -> Result<(), RunError> {
    let Some((bubble, gas)) = simulation.bubble.and_then(|b| Some((b, b.gas?))) else {
        return Ok(());
    };
    // The walls of the liquid as in its steps: its rigid sides and the surface of the solid.
    let lines = wetted(world);
    let filled = simulation.bodies.iter().zip(&mut world.bodies);
    for (asked, named) in filled {
        let (BodyKind::Fluid(_), Body::Fluid(f)) = (&asked.kind, &mut named.body) else {
            continue;
        };
        let sides = f.sides.iter().map(|p| p as &dyn Wall);
        let walls: Vec<&dyn Wall> = sides.chain(lines.iter().map(|l| l as &dyn Wall)).collect();
        let ghosts = Ghosts::find(f, &walls);
        f.gas = Gas::fill(law(&bubble, gas, asked), f, &ghosts);
        if f.gas.is_none() {
            return Err(RunError::Unsupported {
                body: named.name.clone(),
                what: "gas in a bubble that is no cavity of it (give the body a hole there)"
                    .to_owned(),
            });
        }
    }
    Ok(())
}

/// The gas, and where cavities hold it: near the bubble, inside the liquid.
fn law(bubble: &Bubble, gas: BubbleGas, body: &Asked) -> GasLaw {
    let (lower, upper) = body.shape.bounding_box();
    let reach = BubbleGas::REACH * bubble.radius;
    let near = |sign: f64| bubble.centre.map(|x| x + sign * reach);
    let (from, to) = (near(-1.0), near(1.0));
    let (sides, solid) = (&body.sides, |s: &Side| {
        matches!(s, Side::Axis | Side::Rigid | Side::Interface { .. })
    });
    let first = [solid(&sides.left), solid(&sides.bottom)];
    let last = [solid(&sides.right), solid(&sides.top)];
    GasLaw {
        pressure: gas.pressure,
        polytropic_exponent: gas.polytropic_exponent,
        limits: [
            [0, 1].map(|k| from[k].max(lower[k])),
            [0, 1].map(|k| to[k].min(upper[k])),
        ],
        ends: [
            [0, 1].map(|k| first[k] && lower[k] >= from[k]),
            [0, 1].map(|k| last[k] && upper[k] <= to[k]),
        ],
        cell: 0.5 * body.spacing.finest,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::Case;
    use crate::run::ledger::Ledger;
    use std::f64::consts::PI;

    const RADIUS: f64 = 0.15e-3;

    const GAS: &str = "setup.bubble_near_wall.gas={pressure=\"1 MPa\"}";

    /// A bubble next to steel, and its volume.
    fn near_wall(standoff: f64, per_radius: u32, more: &[&str]) -> (World, f64) {
        let text = include_str!("../../../../cases/bubble-near-steel/case.toml");
        let mut set = vec![
            format!("setup.bubble_near_wall.standoff={standoff}"),
            format!("setup.bubble_near_wall.particles_per_radius={per_radius}"),
        ];
        set.extend(more.iter().map(|s| (*s).to_owned()));
        let simulation = Case::parse("case.toml", text, &set).unwrap();
        let world = crate::run::world(&simulation).unwrap();
        let h = (standoff * RADIUS).min(RADIUS);
        // The part of the ball above the wall.
        let volume = PI * (2.0 / 3.0 * RADIUS.powi(3) + RADIUS * RADIUS * h - h.powi(3) / 3.0);
        (world, volume)
    }

    fn gas(world: &World) -> &Gas {
        let found = world.bodies.iter().find_map(|b| match &b.body {
            Body::Fluid(f) => f.gas.as_ref(),
            Body::Solid(_) => None,
        });
        found.unwrap()
    }

    #[test]
    fn a_bubble_has_its_volume_at_any_distance_from_the_wall() {
        for standoff in [0.3, 0.6, 1.1, 2.6, 5.0, 6.0] {
            let (world, exact) = near_wall(standoff, 12, &[GAS]);
            let gas = gas(&world);
            let volume = gas.pockets[0].volume;
            // The surface lies between particles to a fifth of a spacing, a sixtieth of the radius.
            assert!(
                (volume / exact - 1.0).abs() < 0.05,
                "{standoff}: {volume} {exact}"
            );
            assert_eq!((gas.pockets.len(), gas.cut), (1, 0), "{standoff}");
        }
    }

    #[test]
    fn gas_pushes_on_the_wall_that_it_touches() {
        let (mut world, _) = near_wall(0.6, 12, &[GAS]);
        let dt = world.stable_time_step().0;
        world.advance(dt).unwrap();
        let solid = crate::run::monitor::solid(&world).unwrap();
        let surface = solid.surface(erode_sph::solid::Side::Top).unwrap();
        let edge = 0.8 * RADIUS;
        let (mut force, mut area) = (0.0, 0.0);
        for (x, (p, a)) in surface
            .position
            .iter()
            .zip(surface.pressure.iter().zip(&surface.area))
        {
            // Liquid and gas have 1 MPa; at the edge of the bubble the push of the liquid is spread over the kernel.
            if (x[0] - edge).abs() > 0.25 * RADIUS && x[0] < 2.0 * RADIUS {
                assert!((p / 1e6 - 1.0).abs() < 0.03, "{p} at {}", x[0] / RADIUS);
            }
            if x[0] < 2.0 * RADIUS {
                force += p * a;
                area += a;
            }
        }
        assert!(
            (force / (1e6 * area) - 1.0).abs() < 0.03,
            "{}",
            force / area
        );
    }

    /// Runs while `go` says so; largest defect of the ledger, J.
    fn defect(world: &mut World, go: impl Fn(&World) -> bool) -> f64 {
        let first = Ledger::of(world).balance();
        let mut worst = 0.0_f64;
        while go(world) {
            let dt = world.stable_time_step().0;
            world.advance(dt).unwrap();
            worst = worst.max((Ledger::of(world).balance() - first).abs());
        }
        worst
    }

    #[test]
    fn gas_takes_nothing_from_the_ledger_of_a_bubble_that_collapses_onto_a_wall() {
        let low = "setup.bubble_near_wall.height=1.5";
        let (mut filled, volume) = near_wall(0.6, 8, &[GAS, low]);
        let (mut empty, _) = near_wall(0.6, 8, &[low]);
        let full = defect(&mut filled, |w| gas(w).volume() > 0.4 * volume);
        assert!(gas(&filled).pockets.len() == 1 && gas(&filled).lost.abs() < 1e-3 * 50e6 * volume);
        let none = defect(&mut empty, |w| w.time < filled.time);
        // What the jet leaves over with eight particles per radius it does without gas too; the gas holds 5 % of p V at first.
        let defects = [full, none].map(|d| d / (50e6 * volume));
        assert!(defects[0] < defects[1] + 0.01, "{defects:?}");
    }
}
