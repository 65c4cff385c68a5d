//! Neighbours in the reference configuration: for each cluster the clusters near it, and which of their particles are within
//! reach of any of its own.
//!
//! Five bytes for each near cluster: about 20 per particle, where the numbers of some 130 neighbours would take 65.

use super::blocks::{Block, Blocks};
use crate::simd::LANES;
use rayon::prelude::*;

/// Clusters per task of the search.
const TASK: usize = 32;

/// Lists of all clusters, one behind the other.
#[derive(Debug, Clone, Default)]
pub(super) struct List {
    /// Where the list of each cluster starts.
    start: Vec<usize>,
    cluster: Vec<u32>,
    /// Lanes of that cluster, lane 0 the lowest bit.
    lanes: Vec<u8>,
    /// Directed pairs within the support.
    pub(super) pairs: usize,
}

impl List {
    /// From positions, smoothing lengths and shares of particles in compact clusters.
    pub(super) fn new(place: &Blocks<5>) -> Self {
        let tree = Tree::new(place);
        let tasks = place.blocks.len().div_ceil(TASK);
        let search = |task: usize| {
            let mut part = Self::default();
            for c in task * TASK..place.blocks.len().min((task + 1) * TASK) {
                part.start.push(part.cluster.len());
                part.add(place, &tree, c);
            }
            part
        };
        let parts: Vec<Self> = (0..tasks).into_par_iter().map(search).collect();
        let entries = parts.iter().map(|p| p.cluster.len()).sum();
        let mut list = Self {
            start: Vec::with_capacity(place.blocks.len() + 1),
            cluster: Vec::with_capacity(entries),
            lanes: Vec::with_capacity(entries),
            pairs: parts.iter().map(|p| p.pairs).sum(),
        };
        for part in parts {
            let before = list.cluster.len();
            list.start.extend(part.start.iter().map(|s| before + s));
            list.cluster.extend(part.cluster);
            list.lanes.extend(part.lanes);
        }
        list.start.push(list.cluster.len());
        list
    }

    fn add(&mut self, place: &Blocks<5>, tree: &Tree, c: usize) {
        let own = &place.blocks[c];
        let count = |block: usize| LANES.min(place.len() - block * LANES);
        let mut near = Vec::new();
        tree.visit(&Extent::of(own), &mut near);
        for n in near {
            let other = &place.blocks[n];
            let mut lanes = 0;
            for l in 0..count(n) {
                let seen = (0..count(c)).filter(|&k| within(own, k, other, l)).count();
                lanes |= u8::from(seen > 0) << l;
                // The particle itself is no pair.
                self.pairs += seen - usize::from(n == c);
            }
            if lanes != 0 {
                self.cluster.push(n as u32);
                self.lanes.push(lanes);
            }
        }
    }

    /// Bytes taken.
    pub(super) fn memory(&self) -> usize {
        self.start.len() * size_of::<usize>()
            + self.cluster.len() * size_of::<u32>()
            + self.lanes.len()
    }

    /// Clusters near a cluster, with the lanes of theirs that are neighbours.
    #[inline(always)]
    pub(super) fn of(&self, cluster: usize) -> impl Iterator<Item = (usize, u8)> + '_ {
        let range = self.start[cluster]..self.start[cluster + 1];
        let (clusters, lanes) = (&self.cluster[range.clone()], &self.lanes[range]);
        (clusters.iter().zip(lanes)).map(|(&c, &lanes)| (c as usize, lanes))
    }

    /// Neighbours in the list of a cluster.
    pub(super) fn neighbours(&self, cluster: usize) -> usize {
        self.of(cluster).map(|(_, l)| l.count_ones() as usize).sum()
    }
}

fn within(a: &Block<5>, i: usize, b: &Block<5>, j: usize) -> bool {
    let [x, y, z] = [0, 1, 2].map(|k| a.0[k][i] - b.0[k][j]);
    let reach = a.0[3][i] + b.0[3][j];
    x * x + y * y + z * z < reach * reach
}

/// A box around positions, and the largest smoothing length in it.
#[derive(Debug, Clone, Copy)]
struct Extent {
    lower: [f64; 3],
    upper: [f64; 3],
    reach: f64,
}

impl Extent {
    fn of(place: &Block<5>) -> Self {
        let least = |k: usize| place.0[k].iter().copied().fold(f64::INFINITY, f64::min);
        let most = |k: usize| place.0[k].iter().copied().fold(f64::NEG_INFINITY, f64::max);
        Self {
            lower: [0, 1, 2].map(least),
            upper: [0, 1, 2].map(most),
            reach: most(3),
        }
    }

    fn around(self, other: Self) -> Self {
        Self {
            lower: std::array::from_fn(|k| self.lower[k].min(other.lower[k])),
            upper: std::array::from_fn(|k| self.upper[k].max(other.upper[k])),
            reach: self.reach.max(other.reach),
        }
    }

    fn is_near(&self, other: &Self) -> bool {
        let gap = |k: usize| {
            let gap = (other.lower[k] - self.upper[k]).max(self.lower[k] - other.upper[k]);
            gap.max(0.0).powi(2)
        };
        let reach = self.reach + other.reach;
        gap(0) + gap(1) + gap(2) < reach * reach
    }
}

/// Boxes around clusters, around two of these, and so on.
struct Tree {
    levels: Vec<Vec<Extent>>,
}

impl Tree {
    fn new(place: &Blocks<5>) -> Self {
        let mut levels: Vec<Vec<Extent>> = vec![place.blocks.iter().map(Extent::of).collect()];
        while levels[levels.len() - 1].len() > 1 {
            let pairs = levels[levels.len() - 1].chunks(2);
            let both = |two: &[Extent]| two.iter().copied().reduce(Extent::around);
            levels.push(pairs.filter_map(both).collect());
        }
        Self { levels }
    }

    /// Adds the clusters whose particles may be within reach of those in a box, ascending.
    fn visit(&self, extent: &Extent, near: &mut Vec<usize>) {
        let mut stack = vec![(self.levels.len() - 1, 0)];
        while let Some((level, node)) = stack.pop() {
            match self.levels[level].get(node) {
                Some(e) if !e.is_near(extent) => {}
                None => {}
                Some(_) if level == 0 => near.push(node),
                Some(_) => stack.extend([(level - 1, 2 * node + 1), (level - 1, 2 * node)]),
            }
        }
    }
}
