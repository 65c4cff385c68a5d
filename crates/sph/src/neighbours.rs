//! Neighbour lists for smoothing lengths that vary in space.
//!
//! Particles a and b are neighbours when |x_a - x_b| < SUPPORT (h_a + h_b)/2 (1 + skin). Particles are sorted into
//! one cell grid per factor of two in h; each particle searches every grid with the radius that grid needs.

pub(crate) mod boxes;
pub(crate) mod clusters;
mod grid;
pub(crate) mod order;
pub(crate) mod pair_sum;

use crate::geometry::Vec2;
use crate::kernel::SUPPORT;
use grid::Grid;
use rayon::prelude::*;

/// Rows handled by one task; results do not depend on it.
const CHUNK: usize = 256;

/// Neighbours of each real particle, in ascending order, without the particle itself.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Neighbours {
    start: Vec<usize>,
    index: Vec<u32>,
}

impl Neighbours {
    /// Lists the neighbours of the first `n_real` particles among all particles (ghosts come after the real ones).
    ///
    /// `position` (m) and `smoothing_length` (m, positive) have one entry per particle. `skin` widens the pair
    /// radius by that fraction. Particles at places that are not finite have no neighbours.
    ///
    /// # Panics
    /// When the two arrays differ in length or hold fewer than `n_real` or more than 2^32 - 1 particles.
    #[must_use]
    pub fn build(position: &[Vec2], smoothing_length: &[f64], n_real: usize, skin: f64) -> Self {
        assert_eq!(
            position.len(),
            smoothing_length.len(),
            "one smoothing length per particle"
        );
        assert!(
            n_real <= position.len(),
            "more real particles than particles"
        );
        assert!(u32::try_from(position.len()).is_ok(), "too many particles");
        let factor = 0.5 * SUPPORT * (1.0 + skin);
        let grids = Grid::levels(position, smoothing_length, factor);
        let chunks: Vec<Chunk> = (0..n_real.div_ceil(CHUNK))
            .into_par_iter()
            .map(|c| {
                let rows = c * CHUNK..n_real.min((c + 1) * CHUNK);
                Chunk::search(&grids, position, smoothing_length, rows, factor)
            })
            .collect();
        Self::join(n_real, &chunks)
    }

    fn join(n_real: usize, chunks: &[Chunk]) -> Self {
        let mut start = Vec::with_capacity(n_real + 1);
        start.push(0);
        let mut total = 0;
        for count in chunks.iter().flat_map(|chunk| &chunk.count) {
            total += count;
            start.push(total);
        }
        let mut index = Vec::with_capacity(total);
        for chunk in chunks {
            index.extend_from_slice(&chunk.index);
        }
        Self { start, index }
    }

    /// Neighbours of particle `a` in ascending order.
    #[must_use]
    pub fn of(&self, a: usize) -> &[u32] {
        &self.index[self.start[a]..self.start[a + 1]]
    }

    /// Number of particles that have a list.
    #[must_use]
    pub fn len(&self) -> usize {
        self.start.len().saturating_sub(1)
    }

    /// Whether there are no lists.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Number of directed pairs.
    #[must_use]
    pub fn pairs(&self) -> usize {
        self.index.len()
    }

    /// Offsets into `index`, one more than particles.
    #[must_use]
    pub fn start(&self) -> &[usize] {
        &self.start
    }

    /// All lists behind each other.
    #[must_use]
    pub fn index(&self) -> &[u32] {
        &self.index
    }
}

/// The order that sorts particles by cells: the new particle i is the old particle `order[i]`.
///
/// Stable within a cell; finest grid first, rows along the first coordinate. Keeping particles in this order makes
/// neighbours neighbours in memory.
///
/// # Panics
/// When the two arrays differ in length.
#[must_use]
pub fn cell_order(position: &[Vec2], smoothing_length: &[f64]) -> Vec<u32> {
    assert_eq!(
        position.len(),
        smoothing_length.len(),
        "one smoothing length per particle"
    );
    Grid::levels(position, smoothing_length, 0.5 * SUPPORT)
        .iter()
        .flat_map(|grid| grid.member.iter().map(|m| m.index))
        .collect()
}

/// Lists of consecutive particles.
struct Chunk {
    count: Vec<usize>,
    index: Vec<u32>,
}

impl Chunk {
    fn search(
        grids: &[Grid],
        position: &[Vec2],
        smoothing_length: &[f64],
        rows: std::ops::Range<usize>,
        factor: f64,
    ) -> Self {
        let mut chunk = Self {
            count: Vec::with_capacity(rows.len()),
            index: Vec::with_capacity(rows.len() * 28),
        };
        let mut found = vec![0; 64];
        for a in rows {
            let n = collect(grids, position[a], smoothing_length[a], factor, &mut found);
            let list = &mut found[..n];
            list.sort_unstable();
            let before = chunk.index.len();
            chunk
                .index
                .extend(list.iter().filter(|&&b| b as usize != a));
            chunk.count.push(chunk.index.len() - before);
        }
        chunk
    }
}

/// Writes all particles closer than the pair radius (the particle itself included) to `found` and returns their
/// number.
fn collect(grids: &[Grid], x: Vec2, h: f64, factor: f64, found: &mut Vec<u32>) -> usize {
    let mut n = 0;
    for grid in grids {
        let reach = factor * (h + grid.largest);
        if !grid.touches(x, reach) {
            continue;
        }
        for row in grid.row(x[1] - reach)..=grid.row(x[1] + reach) {
            let candidates = grid.range(row, x[0] - reach, x[0] + reach);
            if found.len() < n + candidates.len() {
                found.resize(2 * (n + candidates.len()), 0);
            }
            // Every candidate is written and kept by advancing: a branch here would be guessed wrong half the time.
            for b in candidates {
                let d = [x[0] - b.position[0], x[1] - b.position[1]];
                let radius = factor * (h + b.smoothing_length);
                found[n] = b.index;
                n += usize::from(d[0] * d[0] + d[1] * d[1] < radius * radius);
            }
        }
    }
    n
}

#[cfg(test)]
mod tests;
