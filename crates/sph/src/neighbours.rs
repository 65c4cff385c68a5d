//! Neighbour lists of single particles for smoothing lengths that vary in space.
//!
//! Particles a and b are neighbours when |x_a - x_b| < SUPPORT (h_a + h_b)/2 (1 + skin). The search goes through the same tree
//! of boxes as that of the clusters ([`boxes`]); a liquid in the corrected form and a total Lagrangian solid use clusters
//! instead ([`clusters`]).

pub(crate) mod boxes;
pub(crate) mod clusters;
pub(crate) mod order;
pub(crate) mod pair_sum;

use crate::kernel::SUPPORT;
use crate::simd::{self, LANES, Simd, Task};
use boxes::{Extent, Points, Tree};
pub use order::compact_order;
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
    pub fn build<const D: usize>(
        position: &[[f64; D]],
        smoothing_length: &[f64],
        n_real: usize,
        skin: f64,
    ) -> Self {
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
        let cloud = Cloud::new(position, smoothing_length, factor);
        let chunks: Vec<Chunk> = (0..n_real.div_ceil(CHUNK))
            .into_par_iter()
            .map(|c| {
                let rows = c * CHUNK..n_real.min((c + 1) * CHUNK);
                simd::run(Search {
                    cloud: &cloud,
                    position,
                    smoothing_length,
                    rows,
                    factor,
                })
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

/// All particles in compact groups of eight, and the tree over the groups.
struct Cloud<const D: usize> {
    order: Vec<u32>,
    groups: Vec<Points<D>>,
    tree: Tree<D>,
}

impl<const D: usize> Cloud<D> {
    fn new(position: &[[f64; D]], smoothing_length: &[f64], factor: f64) -> Self {
        let order = compact_order(position);
        let group = |members: &[u32]| {
            let mut points = Points::NONE;
            for (i, &a) in members.iter().enumerate() {
                let a = a as usize;
                points.set(i, position[a], factor * smoothing_length[a]);
            }
            points
        };
        let groups: Vec<_> = order.par_chunks(LANES).map(group).collect();
        let mut tree = Tree::default();
        tree.rebuild(&groups);
        Self {
            order,
            groups,
            tree,
        }
    }
}

/// Lists of consecutive particles.
struct Chunk {
    count: Vec<usize>,
    index: Vec<u32>,
}

/// Finds the lists of some consecutive particles.
struct Search<'a, const D: usize> {
    cloud: &'a Cloud<D>,
    position: &'a [[f64; D]],
    smoothing_length: &'a [f64],
    rows: std::ops::Range<usize>,
    factor: f64,
}

impl<const D: usize> Task for Search<'_, D> {
    type Output = Chunk;

    #[inline(always)]
    fn run<S: Simd>(self) -> Chunk {
        let Cloud {
            order,
            groups,
            tree,
        } = self.cloud;
        let mut chunk = Chunk {
            count: Vec::with_capacity(self.rows.len()),
            index: Vec::with_capacity(self.rows.len() * 28),
        };
        let mut stack = Vec::with_capacity(64);
        for a in self.rows {
            let before = chunk.index.len();
            let (x, reach) = (self.position[a], self.factor * self.smoothing_length[a]);
            tree.search::<S>(&Extent::at(x, reach), &mut stack, |group| {
                let mut bits = boxes::near::<S, D>(x, reach, &groups[group]);
                while bits != 0 {
                    let b = order[group * LANES + bits.trailing_zeros() as usize];
                    bits &= bits - 1;
                    if b as usize != a {
                        chunk.index.push(b);
                    }
                }
            });
            chunk.index[before..].sort_unstable();
            chunk.count.push(chunk.index.len() - before);
        }
        chunk
    }
}

#[cfg(test)]
mod tests;
