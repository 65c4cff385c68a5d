//! Filling a region with particles of graded spacing, at rest under uniform pressure.
//!
//! Inside the core of the spacing: a square lattice half a spacing away from the sides (or shells about a hole).
//! Outside: layers around the core, then relaxed by shifting until the pressure force of a uniform pressure,
//! sum_b A_b grad W_ab, nearly vanishes everywhere.

mod cloud;
mod domain;
mod error;
mod estimate;
mod lattice;
mod layers;
mod measure;
mod relax;
mod spacing;

pub use error::PackingError;
pub use estimate::estimate_count;
pub use spacing::Spacing;

use crate::geometry::Vec2;
use crate::shapes::{Region, Shape};
use domain::Domain;
use lattice::Lattice;
use measure::area_without;

/// Smoothing length in units of the spacing that the packing is relaxed for.
pub const SMOOTHING: f64 = 1.3;

/// How the core is filled.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Arrangement {
    /// Square lattice, half a spacing away from the sides of the region that the core touches.
    #[default]
    Lattice,
    /// Concentric shells about the first hole, which must be a disc; the first one half a spacing outside of it.
    Shells,
}

/// Choices of [`pack`].
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// How the core is filled.
    pub arrangement: Arrangement,
    /// Whether the first coordinate is a radius: then no particle lies at r < 0 and r = 0 is a mirror.
    pub axis: bool,
    /// Particles nearer to a hole than this fraction of the spacing are dropped.
    pub hole_margin: f64,
    /// Number of relaxation steps.
    pub steps: usize,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            arrangement: Arrangement::Lattice,
            axis: true,
            hole_margin: 0.0,
            steps: 150,
        }
    }
}

/// Unbalanced force of a uniform pressure, |sum_b A_b grad W_ab| times spacing, away from holes.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Residual {
    /// Largest.
    pub max: f64,
    /// Mean.
    pub mean: f64,
}

/// A filled region.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Packing {
    /// Places, m.
    pub position: Vec<Vec2>,
    /// Area of each particle, m2.
    pub area: Vec<f64>,
    /// Spacing at each particle, m; the packing is balanced for the smoothing length [`SMOOTHING`] times it.
    pub spacing: Vec<f64>,
    /// The first so many particles lie in the undisturbed lattice or shells of the core.
    pub undisturbed: usize,
    /// What is left of the force of a uniform pressure.
    pub residual: Residual,
    /// Relaxation steps done.
    pub steps: usize,
}

/// Fills a region with particles.
///
/// The core comes first; the caller may reorder. Deterministic: the same bits for any number of threads.
///
/// # Errors
/// [`PackingError`] when the spacing is not usable, the region is narrower than two of the finest or one
/// of the coarsest spacings in it, the core lies outside of
/// the region, shells are asked for without a disc hole, or the count exceeds 2^32.
pub fn pack(
    region: &Region,
    spacing: &Spacing,
    options: &Options,
) -> Result<Packing, PackingError> {
    spacing.check()?;
    let domain = Domain::new(region, options)?;
    domain.check_size(spacing)?;
    estimate::check_count(region, spacing, options.axis)?;
    let filled = match options.arrangement {
        Arrangement::Lattice => fill_lattice(&domain, spacing)?,
        Arrangement::Shells => fill_shells(&domain, spacing)?,
    };
    Ok(relax::relax(&domain, filled, options.steps))
}

/// A particle before the relaxation.
#[derive(Debug, Clone, Copy)]
struct Seed {
    position: Vec2,
    area: f64,
}

/// Particles before the relaxation.
struct Filled {
    /// With the core as it was filled.
    spacing: Spacing,
    /// Stay where they are.
    fixed: Vec<Seed>,
    /// Will be relaxed.
    loose: Vec<Seed>,
    /// Area of the core that its lattice does not cover (negative: covers twice), m2.
    left_over: f64,
}

fn fill_lattice(domain: &Domain, spacing: &Spacing) -> Result<Filled, PackingError> {
    let lattice = Lattice::new(domain, spacing)?;
    let core = &lattice.core;
    let spacing = Spacing {
        core: Some(core.clone()),
        ..spacing.clone()
    };
    let points = lattice.points(domain);
    let area = lattice.cell_area();
    let core_area = area_without(domain, &[]) - area_without(domain, &[core]);
    let left_over = match core {
        Shape::Rectangle { .. } => 0.0,
        Shape::Disc { .. } => core_area - area * points.len() as f64,
    };
    let (fixed, mut loose): (Vec<Seed>, Vec<Seed>) = points
        .into_iter()
        .filter(|&x| domain.admits(x, spacing.finest))
        .map(|position| Seed { position, area })
        .partition(|seed| lattice.undisturbed(domain, seed.position));
    let profile = layers::Profile::new(&spacing, 0.0);
    loose.extend(layers::fill(domain, core, &profile, &spacing));
    Ok(Filled {
        spacing,
        fixed,
        loose,
        left_over,
    })
}

fn fill_shells(domain: &Domain, spacing: &Spacing) -> Result<Filled, PackingError> {
    let Some(hole @ &Shape::Disc { centre, radius }) = domain.region.holes.first() else {
        return Err(PackingError::NoDisc);
    };
    // A whole number of shells in the core, so that their areas add up to it.
    let thickness = (layers::core_radius(domain, spacing, centre) - radius).max(0.0);
    let core_radius = radius + (thickness / spacing.finest).round() * spacing.finest;
    let spacing = Spacing {
        core: Some(Shape::Disc {
            centre,
            radius: core_radius,
        }),
        ..spacing.clone()
    };
    let profile = layers::Profile::new(&spacing, core_radius - radius);
    let (fixed, loose) = layers::fill(domain, hole, &profile, &spacing)
        .into_iter()
        .partition(|seed| spacing.at(seed.position) <= spacing.finest);
    Ok(Filled {
        spacing,
        fixed,
        loose,
        left_over: 0.0,
    })
}

#[cfg(test)]
mod tests;
