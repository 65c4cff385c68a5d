//! Boxes around groups of eight points, around eight such groups, and so on: a tree that needs no cells.

use crate::simd::{LANES, Simd};
use rayon::prelude::*;

/// Eight points side by side: first coordinates, second coordinates, reaches (m). A place without a point has reach 0 and lies
/// infinitely far away.
pub(crate) type Points = [[f64; LANES]; 3];

/// Eight places without points.
pub(crate) const NO_POINTS: Points = [[f64::INFINITY; LANES], [f64::INFINITY; LANES], [0.0; LANES]];

/// A box and the largest reach of the points in it, m.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Extent {
    lower: [f64; 2],
    upper: [f64; 2],
    reach: f64,
}

impl Extent {
    const EMPTY: Self = Self {
        lower: [f64::INFINITY; 2],
        upper: [f64::NEG_INFINITY; 2],
        reach: 0.0,
    };

    /// Around points.
    pub(crate) fn of(points: &Points) -> Self {
        let mut extent = Self::EMPTY;
        for i in (0..LANES).filter(|i| points[2][*i] > 0.0) {
            for k in [0, 1] {
                extent.lower[k] = extent.lower[k].min(points[k][i]);
                extent.upper[k] = extent.upper[k].max(points[k][i]);
            }
            extent.reach = extent.reach.max(points[2][i]);
        }
        extent
    }
}

/// Eight boxes side by side.
#[derive(Debug, Clone, Copy)]
struct Eight {
    lower: [[f64; LANES]; 2],
    upper: [[f64; LANES]; 2],
    reach: [f64; LANES],
}

impl Eight {
    /// Of up to eight.
    fn of(mut extents: impl Iterator<Item = Extent>) -> Self {
        let all: [Extent; LANES] = std::array::from_fn(|_| extents.next().unwrap_or(Extent::EMPTY));
        Self {
            lower: [0, 1].map(|k| all.map(|e| e.lower[k])),
            upper: [0, 1].map(|k| all.map(|e| e.upper[k])),
            reach: all.map(|e| e.reach),
        }
    }

    /// Around all eight.
    fn extent(&self) -> Extent {
        let least = |x: &[f64; LANES]| x.iter().copied().fold(f64::INFINITY, f64::min);
        let most = |x: &[f64; LANES]| x.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        Extent {
            lower: self.lower.each_ref().map(least),
            upper: self.upper.each_ref().map(most),
            reach: most(&self.reach),
        }
    }

    /// Which of the boxes may hold a point within reach of a point of `other`.
    #[inline(always)]
    fn near<S: Simd>(&self, other: &Extent) -> u8 {
        let gap = |k: usize| {
            let below = S::splat(other.lower[k]) - S::load(&self.upper[k]);
            let above = S::load(&self.lower[k]) - S::splat(other.upper[k]);
            below.max(above).max(S::splat(0.0))
        };
        let (x, y) = (gap(0), gap(1));
        let reach = S::splat(other.reach) + S::load(&self.reach);
        S::bits(x.mul_add(x, y * y).lt(reach * reach))
    }
}

/// The tree over groups of points; level 0 holds the boxes of the groups.
#[derive(Debug, Clone, Default)]
pub(crate) struct Tree {
    levels: Vec<Vec<Eight>>,
}

impl Tree {
    /// Over groups that are compact in their order.
    pub(crate) fn rebuild(&mut self, groups: &[Points]) {
        let lowest = |eight: &[Points]| Eight::of(eight.iter().map(Extent::of));
        let mut depth = 0;
        let mut below = groups.len().div_ceil(LANES);
        self.levels.resize_with(1, Vec::new);
        (groups.par_chunks(LANES).with_min_len(16).map(lowest))
            .collect_into_vec(&mut self.levels[0]);
        while below > 1 {
            let upper = |eight: &[Eight]| Eight::of(eight.iter().map(Eight::extent));
            let level = self.levels[depth].chunks(LANES).map(upper).collect();
            self.levels.push(level);
            depth += 1;
            below = below.div_ceil(LANES);
        }
    }

    /// Calls `see` with each group that may hold a point within reach of one in `extent`, in ascending order. `stack` is
    /// scratch space.
    #[inline(always)]
    pub(crate) fn search<S: Simd>(
        &self,
        extent: &Extent,
        stack: &mut Vec<(usize, usize)>,
        mut see: impl FnMut(usize),
    ) {
        stack.clear();
        stack.push((self.levels.len() - 1, 0));
        while let Some((level, node)) = stack.pop() {
            let Some(eight) = self.levels[level].get(node) else {
                continue;
            };
            let mut bits = eight.near::<S>(extent);
            while bits != 0 {
                if level == 0 {
                    see(node * LANES + bits.trailing_zeros() as usize);
                    bits &= bits - 1;
                } else {
                    // The last one goes on the stack first.
                    let last = 7 - bits.leading_zeros() as usize;
                    stack.push((level - 1, node * LANES + last));
                    bits ^= 1 << last;
                }
            }
        }
    }
}
