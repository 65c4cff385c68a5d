//! What must be exact, and how fast the rest gets exact, with a symmetry axis: liquid and solid.

mod liquid;
mod liquid_order;
mod solid;
mod solid_order;

use super::check::Check;
use super::{Failure, Finding, Validation};
use erode_sph::geometry::Vec2;

pub(super) const VALIDATION: Validation = Validation {
    name: "axis-consistency",
    description: "uniform pressure, linear velocity and rigid motion near the axis; order of the operators elsewhere",
    reference: "exact: no acceleration, the rates of the field, no stress; manufactured smooth fields for the order \
                (validation/axis-consistency)",
    run,
};

/// Spacing of the coarsest lattice, m.
const DX: f64 = 1e-5;

/// Spacings for the order, in units of [`DX`].
const REFINEMENT: [f64; 3] = [1.0, 0.5, 0.25];

const ROUND_OFF: &str = "issue 2; the sums cancel exactly on a lattice, so round-off alone is left";
const EXACT: &str =
    "issue 2; the corrected operator is exact for linear fields, so round-off alone is left";

fn run(_quick: bool, say: &mut dyn FnMut(&str)) -> Result<Finding, Failure> {
    let mut checks = Vec::new();
    say("liquid");
    checks.extend(liquid::checks()?);
    checks.extend(liquid_order::checks()?);
    say("solid");
    checks.extend(solid::checks()?);
    checks.extend(solid_order::checks()?);
    Ok(Finding {
        checks,
        ..Finding::default()
    })
}

/// Points of a square lattice, half a spacing away from the corner at the origin.
fn lattice(n: [usize; 2], dx: f64) -> Vec<Vec2> {
    let at = |k: usize| [(k % n[0]) as f64 + 0.5, (k / n[0]) as f64 + 0.5];
    (0..n[0] * n[1]).map(|k| at(k).map(|c| c * dx)).collect()
}

/// Largest component.
fn largest(vectors: &[Vec2]) -> f64 {
    vectors
        .iter()
        .flatten()
        .fold(0.0, |m, c| f64::max(m, c.abs()))
}

/// Check of the order over [`REFINEMENT`], from the errors at each; it is the smaller of the two steps.
fn order(quantity: &str, errors: &[f64], least: f64, reason: &str) -> Check {
    let steps = errors.windows(2).map(|e| (e[0] / e[1]).log2());
    let order = steps.fold(f64::INFINITY, f64::min);
    let finest = errors.last().copied().unwrap_or(f64::NAN);
    let quantity = format!("order of the {quantity} (error {finest:.1e} at the finest)");
    Check::at_least(quantity, "-", order, least, reason)
}
