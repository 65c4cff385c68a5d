//! The square lattice of the core.

use super::domain::{Domain, Wall};
use super::{PackingError, Spacing};
use crate::geometry::Vec2;
use crate::shapes::Shape;

/// Rows next to the inner edge of the core that may move: they take up the misfit between lattice and layers (the
/// worst force falls from 0.011 to 0.008 of the pressure per spacing, more rows gain nothing).
const LOOSE_ROWS: f64 = 2.0;

/// Lattice with points at `origin + (i + 1/2) pitch`.
pub(super) struct Lattice {
    origin: Vec2,
    pitch: Vec2,
    /// First and one past the last cell in each direction.
    cells: [(i64, i64); 2],
    /// The core, its rectangle moved to the nearest cell edges.
    pub(super) core: Shape,
}

impl Lattice {
    /// The lattice starts from the side of the region that the core touches or is nearest to (the lower one if
    /// equal). If the core spans the region, the pitch is changed slightly so that a whole number of cells fits.
    pub(super) fn new(domain: &Domain, spacing: &Spacing) -> Result<Self, PackingError> {
        let (lower, upper) = domain.bounding_box();
        let core = spacing.core.as_ref().unwrap_or(&domain.region.shape);
        let (core_lower, core_upper) = core.bounding_box();
        let mut lattice = Self {
            origin: lower,
            pitch: [spacing.finest; 2],
            cells: [(0, 0); 2],
            core: core.clone(),
        };
        let (mut snapped_lower, mut snapped_upper) = (lower, upper);
        for k in 0..2 {
            let (from, to) = (core_lower[k].max(lower[k]), core_upper[k].min(upper[k]));
            if from >= to {
                return Err(PackingError::CoreOutside);
            }
            lattice.anchor(k, (from, to), (lower[k], upper[k]));
            let cell = |x: f64| ((x - lattice.origin[k]) / lattice.pitch[k]).round() as i64;
            lattice.cells[k] = (cell(from), cell(to));
            let edge = |i: i64| lattice.origin[k] + i as f64 * lattice.pitch[k];
            snapped_lower[k] = edge(lattice.cells[k].0).max(lower[k]);
            snapped_upper[k] = edge(lattice.cells[k].1).min(upper[k]);
        }
        if let Shape::Rectangle { .. } = core {
            lattice.core = Shape::Rectangle {
                lower: snapped_lower,
                upper: snapped_upper,
            };
        }
        Ok(lattice)
    }

    fn anchor(&mut self, k: usize, core: (f64, f64), region: (f64, f64)) {
        let (below, above) = (core.0 - region.0, region.1 - core.1);
        let near = 0.5 * self.pitch[k];
        if below < near && above < near {
            let extent = region.1 - region.0;
            self.pitch[k] = extent / (extent / self.pitch[k]).round();
            self.origin[k] = region.0;
        } else {
            self.origin[k] = if below <= above { region.0 } else { region.1 };
        }
    }

    /// All points inside the core and the outer walls, row by row; holes do not count.
    pub(super) fn points(&self, domain: &Domain) -> Vec<Vec2> {
        let at = |k: usize, i: i64| self.origin[k] + (i as f64 + 0.5) * self.pitch[k];
        let [columns, rows] = self.cells;
        (rows.0..rows.1)
            .flat_map(|j| (columns.0..columns.1).map(move |i| [at(0, i), at(1, j)]))
            .filter(|&x| self.core.contains(x) && domain.depth(x) >= 0.0)
            .collect()
    }

    /// Area of a cell, m2.
    pub(super) fn cell_area(&self) -> f64 {
        self.pitch[0] * self.pitch[1]
    }

    /// Whether a lattice point stays where it is: everywhere but near the edge of the core inside the domain and near
    /// curved walls, which cut the lattice.
    pub(super) fn undisturbed(&self, domain: &Domain, x: Vec2) -> bool {
        let margin = LOOSE_ROWS * self.pitch[0].max(self.pitch[1]);
        let rim = |wall: &Wall| matches!(wall, Wall::Rim(_)) && wall.depth(x) < margin;
        -self.inner_edge_distance(domain, x) >= margin && !domain.walls.iter().any(rim)
    }

    /// Signed distance to the edge of the core, leaving out the sides that lie on sides of the domain.
    fn inner_edge_distance(&self, domain: &Domain, x: Vec2) -> f64 {
        let Shape::Rectangle {
            mut lower,
            mut upper,
        } = self.core
        else {
            return self.core.signed_distance(x);
        };
        let (domain_lower, domain_upper) = domain.bounding_box();
        for k in 0..2 {
            let far = domain_upper[k] - domain_lower[k];
            if lower[k] <= domain_lower[k] {
                lower[k] -= far;
            }
            if upper[k] >= domain_upper[k] {
                upper[k] += far;
            }
        }
        Shape::Rectangle { lower, upper }.signed_distance(x)
    }
}
