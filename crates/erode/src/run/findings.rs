//! What a run found that its reader must know: sentences for the end of the run, the summary and the report.

use super::layers;
use crate::case::{BubbleGas, Simulation};
use crate::output::Summary;
use erode_sph::world::World;

/// The findings of a run whose numbers are in the summary.
pub(super) fn of(summary: &Summary, world: &World, simulation: &Simulation) -> Vec<String> {
    let mut all: Vec<String> = gas_was_cut(summary).into_iter().collect();
    all.extend(layers::misfits(world, simulation));
    all
}

fn gas_was_cut(summary: &Summary) -> Option<String> {
    let cut = summary.ledger().find(|(name, _)| *name == "gas_steps_cut");
    let steps = cut?.1.filter(|n| *n > 0.0)?;
    Some(format!(
        "in {steps} steps the gas reached beyond {} initial radii of the bubble (or beyond the liquid), where it is no longer \
         followed: its volume is too small from then on, its pressure too high",
        BubbleGas::REACH
    ))
}
