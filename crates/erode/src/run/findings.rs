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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::Case;

    /// A spacing of 2.5 um fits a coating of 20 um; one of 8.3 um makes two rows of it.
    #[test]
    fn gas_that_was_cut_and_layers_of_other_thickness_are_told() {
        let text = include_str!("../../../../cases/coated-steel/case.toml");
        let told = |particles: u32, cut: f64| {
            let set = format!("setup.pressure_pulse.particles_per_radius={particles}");
            let simulation = Case::parse("case.toml", text, &[set]).unwrap();
            let world = crate::run::world(&simulation).unwrap();
            let mut summary = Summary::default();
            summary.set_ledger("gas_steps_cut", "-", cut);
            of(&summary, &world, &simulation).join("\n")
        };
        assert_eq!(told(20, 0.0), "");
        let coarse = told(6, 3.0);
        assert!(
            coarse.starts_with("in 3 steps the gas reached beyond 2.5 initial radii"),
            "{coarse}"
        );
        assert!(
            coarse.contains("layer 1 (copper_ofhc) is ")
                && coarse.contains(" of the 20 um asked for"),
            "{coarse}"
        );
    }
}
