//! Neighbours of clusters: of eight particles each half shares one list, and a sum takes the four of it and two neighbours side
//! by side ([`crate::simd`]). (One list for all eight would be longer by a third: more of its pairs are none.)
//!
//! Places are numbered through all points: those of the clusters first, then those that are neighbours only. A place is in
//! the list of a half when its point lies within reach of at least one of the four: |x_a - x_b| < reach_a + reach_b. For
//! the others it is a pair outside the support of the kernel, which adds exactly nothing. A list of an odd number of places
//! is filled up with a place behind all others, where nobody stands.

use crate::neighbours::boxes::{Extent, Points, Tree, near};
use crate::neighbours::pair_sum::{PairSum, SumBlock};
use crate::simd::{self, LANES, Simd, Task};
use rayon::prelude::*;

/// Clusters handled by one task; results do not depend on it.
const BLOCK: usize = 16;

/// Lists of all clusters.
#[derive(Debug, Clone)]
pub(crate) struct ClusterLists<const D: usize> {
    tree: Tree<D>,
    blocks: Vec<Block>,
    clusters: usize,
    places: usize,
}

/// Lists of the clusters of one task, behind each other.
#[derive(Debug, Clone, Default)]
pub(crate) struct Block {
    pub(crate) neighbour: Vec<u32>,
    /// For each cluster the ends of the neighbours of its lower half below the dividing place and of all of them; the same of its
    /// upper half.
    pub(crate) ends: Vec<[u32; 4]>,
}

impl<const D: usize> Default for ClusterLists<D> {
    fn default() -> Self {
        Self {
            tree: Tree::default(),
            blocks: Vec::new(),
            clusters: 0,
            places: 0,
        }
    }
}

impl<const D: usize> ClusterLists<D> {
    /// Finds lists for the first `clusters` of the groups of points. In each list the places from `divide` on come last, as a
    /// part of its own; both parts have an even number of places.
    pub(crate) fn rebuild(&mut self, groups: &[Points<D>], clusters: usize, divide: usize) {
        self.tree.rebuild(groups);
        self.clusters = clusters;
        self.places = groups.len() * LANES;
        self.blocks
            .resize_with(clusters.div_ceil(BLOCK), Block::default);
        let tree = &self.tree;
        (self.blocks.par_iter_mut().enumerate()).for_each(|(b, block)| {
            let end = clusters.min((b + 1) * BLOCK);
            simd::run(Search {
                tree,
                groups,
                clusters: b * BLOCK..end,
                divide,
                block,
            });
        });
    }

    /// Entries of all lists: what a sweep costs.
    pub(crate) fn len(&self) -> usize {
        self.blocks.iter().map(|b| b.neighbour.len()).sum()
    }

    /// The sums of every particle of the clusters, over the places of all `records`; behind them come eight places where nobody
    /// stands.
    ///
    /// # Panics
    /// If there is not one record per place.
    pub(crate) fn sum<L: PairSum>(
        &self,
        law: &L,
        records: &[L::Particle],
        results: &mut Vec<L::Result>,
    ) {
        results.resize(self.clusters * LANES, L::Result::default());
        self.sum_where(law, records, results, None);
    }

    /// The same for the clusters that hold one of the `marked` places or have one for a neighbour; the other results stay what
    /// they are.
    ///
    /// # Panics
    /// As [`Self::sum`].
    pub(crate) fn sum_near<L: PairSum>(
        &self,
        law: &L,
        records: &[L::Particle],
        results: &mut [L::Result],
        marked: &[bool],
    ) {
        self.sum_where(law, records, results, Some(marked));
    }

    fn sum_where<L: PairSum>(
        &self,
        law: &L,
        records: &[L::Particle],
        results: &mut [L::Result],
        marked: Option<&[bool]>,
    ) {
        assert_eq!(records.len(), self.places + LANES, "one record per place");
        let (records, _) = records.as_chunks::<LANES>();
        (results.as_chunks_mut::<LANES>().0.par_chunks_mut(BLOCK))
            .zip(&self.blocks)
            .enumerate()
            .for_each(|(b, (results, block))| {
                simd::run(SumBlock {
                    law,
                    records,
                    first: b * BLOCK,
                    block,
                    results,
                    marked,
                });
            });
    }
}

/// Finds the lists of some clusters.
struct Search<'a, const D: usize> {
    tree: &'a Tree<D>,
    groups: &'a [Points<D>],
    clusters: std::ops::Range<usize>,
    divide: usize,
    block: &'a mut Block,
}

impl<const D: usize> Task for Search<'_, D> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let block = self.block;
        block.neighbour.clear();
        block.ends.clear();
        let nobody = (self.groups.len() * LANES) as u32;
        let (mut stack, mut high) = (Vec::with_capacity(64), Vec::new());
        for cluster in self.clusters {
            let own = &self.groups[cluster];
            let mut divided = None;
            high.clear();
            self.tree
                .search::<S>(&Extent::of(own), &mut stack, |group| {
                    let first = group * LANES;
                    if first >= self.divide && divided.is_none() {
                        even(&mut block.neighbour, nobody);
                        even(&mut high, nobody);
                        divided = Some([block.neighbour.len(), high.len()]);
                    }
                    let [of_low, of_high] = within_reach::<S, D>(own, &self.groups[group]);
                    push(&mut block.neighbour, first as u32, of_low);
                    push(&mut high, first as u32, of_high);
                });
            even(&mut block.neighbour, nobody);
            even(&mut high, nobody);
            let end = block.neighbour.len();
            let [divided_low, divided_high] = divided.unwrap_or([end, high.len()]);
            block.neighbour.extend_from_slice(&high);
            let all = [divided_low, end, end + divided_high, end + high.len()];
            block.ends.push(all.map(|e| e as u32));
        }
    }
}

/// Which bits are set, in ascending order and filled up with zeros, and how many, for every eight bits.
const SET: [([u8; LANES], u8); 256] = {
    let mut table = [([0; LANES], 0); 256];
    let mut bits = 0;
    while bits < 256 {
        let mut i = 0;
        while i < LANES {
            if bits >> i & 1 == 1 {
                table[bits].0[table[bits].1 as usize] = i as u8;
                table[bits].1 += 1;
            }
            i += 1;
        }
        bits += 1;
    }
    table
};

/// Appends places of the group that begins at `first`: always eight, of which those too many are taken off again. A loop over the bits
/// would end where the processor does not expect it.
#[inline(always)]
fn push(list: &mut Vec<u32>, first: u32, bits: u8) {
    let (set, count) = &SET[bits as usize];
    let end = list.len() + *count as usize;
    let mut places = [first; LANES];
    for i in 0..LANES {
        places[i] += u32::from(set[i]);
    }
    list.extend_from_slice(&places);
    list.truncate(end);
}

/// Fills a list up to an even length.
#[inline(always)]
fn even(list: &mut Vec<u32>, nobody: u32) {
    if !list.len().is_multiple_of(2) {
        list.push(nobody);
    }
}

/// Which of the points `other` lie within reach of one of the lower four of the points `own`, and of one of the upper four.
#[inline(always)]
fn within_reach<S: Simd, const D: usize>(own: &Points<D>, other: &Points<D>) -> [u8; 2] {
    let mut bits = [0; 2];
    for i in 0..LANES {
        let mut x = [0.0; D];
        for k in 0..D {
            x[k] = own.position[k][i];
        }
        bits[i / (LANES / 2)] |= near::<S, D>(x, own.reach[i], other);
    }
    bits
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::neighbours::order::compact_order;

    /// Random points with reaches in a ratio of 1:8, in compact order, the last places of the groups empty.
    fn groups(n: usize) -> Vec<Points<2>> {
        let mut state = n as u64;
        let mut next = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        let x: Vec<[f64; 2]> = (0..n).map(|_| [next(), 2.0 * next()]).collect();
        let reach: Vec<f64> = x.iter().map(|x| 0.01 * (1.0 + 7.0 * x[0])).collect();
        let group = |members: &[u32]| {
            let mut points = Points::NONE;
            for (i, &a) in members.iter().enumerate() {
                points.set(i, x[a as usize], reach[a as usize]);
            }
            points
        };
        compact_order(&x).chunks(LANES).map(group).collect()
    }

    #[test]
    fn lists_hold_what_brute_force_finds() {
        let mut lists = ClusterLists::default();
        // Down to nothing again, with the memory of before.
        for n in [3, 700, 5000, 64, 9, 0] {
            let groups = groups(n);
            let clusters = groups.len() / 2;
            let divide = (groups.len() * 3 / 4) * LANES;
            lists.rebuild(&groups, clusters, divide);
            let near = |own: &Points<2>, half: usize, b: usize| {
                let other = &groups[b / LANES];
                (4 * half..4 * half + 4).any(|i| {
                    let d = [0, 1].map(|k| own.position[k][i] - other.position[k][b % LANES]);
                    d[0].hypot(d[1]) < own.reach[i] + other.reach[b % LANES]
                })
            };
            let mut begin = 0;
            for c in 0..clusters {
                let block = &lists.blocks[c / BLOCK];
                if c % BLOCK == 0 {
                    begin = 0;
                }
                let ends = block.ends[c % BLOCK].map(|e| e as usize);
                for (half, [divided, end]) in [[ends[0], ends[1]], [ends[2], ends[3]]]
                    .into_iter()
                    .enumerate()
                {
                    let places = groups.len() * LANES;
                    let part = |range: std::ops::Range<usize>| {
                        let mut expected: Vec<u32> = range
                            .filter(|b| near(&groups[c], half, *b))
                            .map(|b| b as u32)
                            .collect();
                        even(&mut expected, places as u32);
                        expected
                    };
                    let [first, second] = [part(0..divide), part(divide..places)];
                    let message = format!("{n} points, cluster {c}, half {half}");
                    assert_eq!(block.neighbour[begin..divided], first, "{message}");
                    assert_eq!(block.neighbour[divided..end], second, "{message}");
                    begin = end;
                }
            }
        }
    }
}
