//! Neighbours of clusters: eight particles share one list, and a sum takes all of them side by side ([`crate::simd`]).
//!
//! Places are numbered through all points: those of the clusters first, then those that are neighbours only. A place is in
//! the list of a cluster when its point lies within reach of at least one of the eight: |x_a - x_b| < reach_a + reach_b. For
//! the other particles of the cluster it is a pair outside the support of the kernel, which adds exactly nothing.

use crate::neighbours::boxes::{Extent, Points, Tree};
use crate::neighbours::pair_sum::{PairSum, SumBlock};
use crate::simd::{self, LANES, Simd, Task};
use rayon::prelude::*;

/// Clusters handled by one task; results do not depend on it.
const BLOCK: usize = 16;

/// Lists of all clusters.
#[derive(Debug, Clone, Default)]
pub(crate) struct ClusterLists {
    tree: Tree,
    blocks: Vec<Block>,
    clusters: usize,
    places: usize,
}

/// Lists of the clusters of one task, behind each other.
#[derive(Debug, Clone, Default)]
pub(crate) struct Block {
    pub(crate) neighbour: Vec<u32>,
    /// For each cluster the ends of its neighbours below the dividing place and of all its neighbours.
    pub(crate) ends: Vec<[u32; 2]>,
}

impl ClusterLists {
    /// Finds lists for the first `clusters` of the groups of points. In each list the places from `divide` on come last, as a
    /// part of its own.
    pub(crate) fn rebuild(&mut self, groups: &[Points], clusters: usize, divide: usize) {
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

    /// The sums of every particle of the clusters, over the places of all `records`.
    ///
    /// # Panics
    /// If there is not one record per place.
    pub(crate) fn sum<L: PairSum>(
        &self,
        law: &L,
        records: &[L::Particle],
        results: &mut Vec<L::Result>,
    ) {
        assert_eq!(records.len(), self.places, "one record per place");
        results.resize(self.clusters * LANES, L::Result::default());
        let (records, _) = records.as_chunks::<LANES>();
        (results.as_chunks_mut::<LANES>().0.par_chunks_mut(BLOCK))
            .zip(&self.blocks)
            .enumerate()
            .for_each(|(b, (results, block))| {
                simd::run(SumBlock {
                    law,
                    records,
                    own: &records[b * BLOCK..],
                    block,
                    results,
                });
            });
    }
}

/// Finds the lists of some clusters.
struct Search<'a> {
    tree: &'a Tree,
    groups: &'a [Points],
    clusters: std::ops::Range<usize>,
    divide: usize,
    block: &'a mut Block,
}

impl Task for Search<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let block = self.block;
        block.neighbour.clear();
        block.ends.clear();
        let mut stack = Vec::with_capacity(64);
        for cluster in self.clusters {
            let own = &self.groups[cluster];
            let mut divided = None;
            self.tree
                .search::<S>(&Extent::of(own), &mut stack, |group| {
                    let first = group * LANES;
                    if first >= self.divide && divided.is_none() {
                        divided = Some(block.neighbour.len());
                    }
                    let mut bits = within_reach::<S>(own, &self.groups[group]);
                    while bits != 0 {
                        block.neighbour.push((first as u32) + bits.trailing_zeros());
                        bits &= bits - 1;
                    }
                });
            let end = block.neighbour.len();
            block.ends.push([divided.unwrap_or(end) as u32, end as u32]);
        }
    }
}

/// Which of the points `other` lie within reach of one of the points `own`.
#[inline(always)]
fn within_reach<S: Simd>(own: &Points, other: &Points) -> u8 {
    let [x, y, reach] = other.each_ref().map(S::load);
    let mut bits = 0;
    for i in 0..LANES {
        let (dx, dy) = (x - S::splat(own[0][i]), y - S::splat(own[1][i]));
        let r = reach + S::splat(own[2][i]);
        bits |= S::bits(dx.mul_add(dx, dy * dy).lt(r * r));
    }
    bits
}
