//! Refinement that follows the bubble of a run, and its part of a checkpoint.

use super::RunError;
use super::bubble_state::{wetted, window};
use crate::case::{BodyKind, Simulation};
use crate::output::Checkpoint;
use erode_sph::cavity::fronts;
use erode_sph::fluid::Fluid;
use erode_sph::fluid::ghosts::Wall;
use erode_sph::fluid::refinement::{Origin, Refinement};
use erode_sph::world::{Body, World, WorldError};

/// Halves and merges liquid particles after a step, where the case asks for it. `cell` is half of the finest spacing, m.
///
/// # Errors
/// If a number of the particles that this made is not finite.
pub(super) fn follow(
    world: &mut World,
    simulation: &Simulation,
    cell: f64,
) -> Result<(), WorldError> {
    let Some(bubble) = &simulation.bubble else {
        return Ok(());
    };
    let asked = simulation.bodies.iter().map(|b| match &b.kind {
        BodyKind::Fluid(f) => f.refinement(),
        BodyKind::Solid(_) => None,
    });
    let asked: Vec<_> = asked.collect();
    if asked.iter().all(Option::is_none) || !Refinement::is_due(world.step) {
        return Ok(());
    }
    let lines = wetted(world);
    let walls: Vec<&dyn Wall> = lines.iter().map(|l| l as &dyn Wall).collect();
    for (named, asked) in world.bodies.iter_mut().zip(asked) {
        if let (Body::Fluid(f), Some(r)) = (&mut named.body, asked) {
            let refinement = Refinement {
                per_radius: r.per_radius,
                growth: r.growth,
                smallest: r.smallest * bubble.radius,
            };
            let cavities = fronts(f, &walls, window(bubble, cell), refinement.smallest);
            f.refine(&refinement, &cavities, world.step);
        }
    }
    world.check_finite()
}

/// Stores where the particles of a liquid come from: it changes their order, and refinement their number.
pub(super) fn store(f: &Fluid, name: &str, checkpoint: &mut Checkpoint) -> Result<(), RunError> {
    let of = |value: fn(&Origin) -> u32| -> Vec<f64> {
        f.origin.iter().map(|o| f64::from(value(o))).collect()
    };
    checkpoint.push(&format!("{name}/origin"), of(|o| o.id))?;
    checkpoint.push(&format!("{name}/refinement_level"), of(|o| o.level))?;
    let h = f.initial_smoothing_length.clone();
    checkpoint.push(&format!("{name}/initial_smoothing_length"), h)?;
    checkpoint.push(&format!("{name}/next_id"), vec![f64::from(f.next_id)])?;
    Ok(())
}

/// Gives a liquid freshly built from the case the particles of the checkpoint; their fields are still to be set.
pub(super) fn restore(f: &mut Fluid, name: &str, checkpoint: &Checkpoint) -> Result<(), RunError> {
    let numbers = |field: &str| checkpoint.f64(&format!("{name}/{field}"));
    let (id, level) = (numbers("origin")?, numbers("refinement_level")?);
    let h = numbers("initial_smoothing_length")?;
    let next = numbers("next_id")?;
    if id.len() != level.len() || id.len() != h.len() || next.len() != 1 {
        return Err(RunError::Checkpoint(format!(
            "the origins of the particles of body `{name}` do not fit together"
        )));
    }
    let origin = id.iter().zip(level).map(|(id, level)| Origin {
        id: *id as u32,
        level: *level as u32,
    });
    f.take_origins(origin.collect(), h, next[0] as u32);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::Case;

    #[test]
    fn what_refinement_leaves_must_be_finite() {
        let text = include_str!("../cli/templates/bubble-in-liquid.toml");
        let set = [
            "particles_per_radius=6",
            "domain=4",
            "liquid_formulation.corrected.refinement={per_radius=6}",
        ];
        let set = set.map(|s| format!("setup.bubble_in_liquid.{s}"));
        let simulation = Case::parse("case.toml", text, &set).unwrap();
        let mut world = crate::run::world(&simulation).unwrap();
        let cell = 0.5 * simulation.bodies[0].spacing.finest;
        follow(&mut world, &simulation, cell).unwrap();
        if let Body::Fluid(f) = &mut world.bodies[0].body {
            f.velocity[7] = [f64::NAN; 2];
        }
        let error = follow(&mut world, &simulation, cell).unwrap_err();
        assert!(
            matches!(
                error,
                WorldError::NotFinite {
                    field: "velocity",
                    ..
                }
            ),
            "{error}"
        );
    }
}
