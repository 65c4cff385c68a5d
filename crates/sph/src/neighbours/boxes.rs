//! Boxes around groups of eight points, around eight such groups, and so on: a tree that needs no cells.

use crate::simd::{LANES, Simd};
use rayon::prelude::*;

/// Eight points side by side. A place without a point has reach 0 and lies infinitely far away.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Points<const D: usize> {
    /// First coordinates, second coordinates, ..., m.
    pub(crate) position: [[f64; LANES]; D],
    /// Reaches, m.
    pub(crate) reach: [f64; LANES],
}

impl<const D: usize> Points<D> {
    /// Eight places without points.
    pub(crate) const NONE: Self = Self {
        position: [[f64::INFINITY; LANES]; D],
        reach: [0.0; LANES],
    };

    /// Puts a point at a place; one without reach or without a place in space is none.
    pub(crate) fn set(&mut self, lane: usize, position: [f64; D], reach: f64) {
        if reach > 0.0 && position.iter().all(|x| x.is_finite()) {
            for (x, own) in position.into_iter().zip(&mut self.position) {
                own[lane] = x;
            }
            self.reach[lane] = reach;
        }
    }

    /// The point at a place, and its reach.
    pub(crate) fn get(&self, lane: usize) -> ([f64; D], f64) {
        (self.position.map(|x| x[lane]), self.reach[lane])
    }
}

/// A box and the largest reach of the points in it, m.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Extent<const D: usize> {
    lower: [f64; D],
    upper: [f64; D],
    reach: f64,
}

impl<const D: usize> Extent<D> {
    const EMPTY: Self = Self {
        lower: [f64::INFINITY; D],
        upper: [f64::NEG_INFINITY; D],
        reach: 0.0,
    };

    /// Around points.
    pub(crate) fn of(points: &Points<D>) -> Self {
        let mut extent = Self::EMPTY;
        for i in (0..LANES).filter(|i| points.reach[*i] > 0.0) {
            for k in 0..D {
                extent.lower[k] = extent.lower[k].min(points.position[k][i]);
                extent.upper[k] = extent.upper[k].max(points.position[k][i]);
            }
            extent.reach = extent.reach.max(points.reach[i]);
        }
        extent
    }

    /// Around one point.
    pub(crate) fn at(position: [f64; D], reach: f64) -> Self {
        Self {
            lower: position,
            upper: position,
            reach,
        }
    }
}

/// Eight boxes side by side.
#[derive(Debug, Clone, Copy)]
struct Eight<const D: usize> {
    lower: [[f64; LANES]; D],
    upper: [[f64; LANES]; D],
    reach: [f64; LANES],
}

impl<const D: usize> Eight<D> {
    /// Of up to eight.
    fn of(mut extents: impl Iterator<Item = Extent<D>>) -> Self {
        let all: [Extent<D>; LANES] =
            std::array::from_fn(|_| extents.next().unwrap_or(Extent::EMPTY));
        Self {
            lower: std::array::from_fn(|k| all.map(|e| e.lower[k])),
            upper: std::array::from_fn(|k| all.map(|e| e.upper[k])),
            reach: all.map(|e| e.reach),
        }
    }

    /// Around all eight.
    fn extent(&self) -> Extent<D> {
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
    fn near<S: Simd>(&self, other: &Extent<D>) -> u8 {
        let mut square = S::splat(0.0);
        for k in (0..D).rev() {
            let below = S::splat(other.lower[k]) - S::load(&self.upper[k]);
            let above = S::load(&self.lower[k]) - S::splat(other.upper[k]);
            let gap = below.max(above).max(S::splat(0.0));
            square = gap.mul_add(gap, square);
        }
        let reach = S::splat(other.reach) + S::load(&self.reach);
        S::bits(square.lt(reach * reach))
    }
}

/// The tree over groups of points; level 0 holds the boxes of the groups.
#[derive(Debug, Clone)]
pub(crate) struct Tree<const D: usize> {
    levels: Vec<Vec<Eight<D>>>,
}

impl<const D: usize> Default for Tree<D> {
    fn default() -> Self {
        Self { levels: Vec::new() }
    }
}

impl<const D: usize> Tree<D> {
    /// Over groups that are compact in their order.
    pub(crate) fn rebuild(&mut self, groups: &[Points<D>]) {
        let lowest = |eight: &[Points<D>]| Eight::of(eight.iter().map(Extent::of));
        let mut depth = 0;
        let mut below = groups.len().div_ceil(LANES);
        self.levels.resize_with(1, Vec::new);
        (groups.par_chunks(LANES).with_min_len(16).map(lowest))
            .collect_into_vec(&mut self.levels[0]);
        while below > 1 {
            let upper = |eight: &[Eight<D>]| Eight::of(eight.iter().map(Eight::extent));
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
        extent: &Extent<D>,
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

/// Which of eight points lie within reach of a point.
#[inline(always)]
pub(crate) fn near<S: Simd, const D: usize>(x: [f64; D], reach: f64, points: &Points<D>) -> u8 {
    let mut square = S::splat(0.0);
    for k in (0..D).rev() {
        let d = S::load(&points.position[k]) - S::splat(x[k]);
        square = d.mul_add(d, square);
    }
    let r = S::load(&points.reach) + S::splat(reach);
    S::bits(square.lt(r * r))
}
