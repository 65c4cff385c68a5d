//! Gas in the bubble of a case.

use super::RunError;
use crate::case::{Body, Bubble, BubbleGas, Simulation};
use erode_sph::fluid::Fluid;
use erode_sph::fluid::gas::{Gas, GasLaw};
use erode_sph::fluid::ghosts::{Ghosts, Plane, Wall};

/// Cavities hold gas within this many radii of the bubble's centre: it may grow to that.
const REACH: f64 = 2.5;

/// Fills the bubble in a liquid, made of the body `asked`, with its gas.
///
/// # Errors
/// If there is no cavity where the bubble should be.
pub(super) fn fill(f: &mut Fluid, simulation: &Simulation, asked: &Body) -> Result<(), RunError> {
    let Some((bubble, gas)) = simulation.bubble.and_then(|b| Some((b, b.gas?))) else {
        return Ok(());
    };
    let law = law(&bubble, gas, asked);
    let mut planes: Vec<Plane> = f.sides.clone();
    if bubble.wall_distance.is_some() {
        // The surface of a solid, which lies at the lower limit.
        planes.push(Plane {
            normal: [0.0, 1.0],
            offset: law.limits[0][1],
            speed: 0.0,
        });
    }
    let walls: Vec<&dyn Wall> = planes.iter().map(|p| p as &dyn Wall).collect();
    let ghosts = Ghosts::find(f, &walls);
    f.gas = Gas::fill(law, f, &ghosts);
    if f.gas.is_none() {
        return Err(RunError::Unsupported {
            body: asked.name.clone(),
            what: "gas in a bubble that is no cavity of it (give the body a hole there)".to_owned(),
        });
    }
    Ok(())
}

/// The gas, and where cavities hold it: near the bubble, inside the liquid.
fn law(bubble: &Bubble, gas: BubbleGas, body: &Body) -> GasLaw {
    let (lower, upper) = body.shape.bounding_box();
    let reach = REACH * bubble.radius;
    let low = |k: usize| (bubble.centre[k] - reach).max(lower[k]);
    let high = |k: usize| (bubble.centre[k] + reach).min(upper[k]);
    GasLaw {
        pressure: gas.pressure,
        polytropic_exponent: gas.polytropic_exponent,
        limits: [[low(0), low(1)], [high(0), high(1)]],
        cell: 0.5 * body.spacing.finest,
    }
}
