//! Numbers of particles in clusters: eight particles side by side, each component in a cache line of its own.
//!
//! Lanes are read as they lie; a neighbour is a lane of its cluster. The last cluster is filled up with copies of the last
//! particle.

use crate::simd::{LANES, Simd};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// `N` numbers of each particle of a cluster.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C, align(64))]
pub(super) struct Block<const N: usize>(pub(super) [[f64; LANES]; N]);

impl<const N: usize> Block<N> {
    /// The numbers of all eight.
    #[inline(always)]
    pub(super) fn load<S: Simd>(&self) -> [S; N] {
        let mut lanes = [S::splat(0.0); N];
        for (lanes, numbers) in lanes.iter_mut().zip(&self.0) {
            *lanes = S::load(numbers);
        }
        lanes
    }

    #[inline(always)]
    pub(super) fn store<S: Simd>(&mut self, lanes: [S; N]) {
        for (numbers, lanes) in self.0.iter_mut().zip(lanes) {
            *numbers = lanes.store();
        }
    }

    /// Number `i` of one of them, for all lanes.
    #[inline(always)]
    pub(super) fn broadcast<S: Simd>(&self, i: usize, lane: usize) -> S {
        S::splat(self.0[i][lane])
    }
}

/// `N` numbers of each particle of a body.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Blocks<const N: usize> {
    pub(super) blocks: Vec<Block<N>>,
    len: usize,
}

impl<const N: usize> Blocks<N> {
    /// From the numbers of each particle.
    pub(super) fn collect(len: usize, of: impl Fn(usize) -> [f64; N]) -> Self {
        let mut all = Self::splat(len, [0.0; N]);
        for a in 0..len {
            all.set(a, of(a));
        }
        all
    }

    /// The same numbers for all particles.
    pub(super) fn splat(len: usize, numbers: [f64; N]) -> Self {
        let block = Block(numbers.map(|x| [x; LANES]));
        Self {
            blocks: vec![block; len.div_ceil(LANES)],
            len,
        }
    }

    /// Number of particles.
    #[must_use]
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Numbers of a particle.
    #[must_use]
    pub fn get(&self, particle: usize) -> [f64; N] {
        let block = &self.blocks[particle / LANES];
        block.0.map(|lanes| lanes[particle % LANES])
    }

    /// Replaces the numbers of a particle.
    pub fn set(&mut self, particle: usize, numbers: [f64; N]) {
        let lane = particle % LANES;
        // Whoever fills up the last cluster does as the last particle.
        let last = if particle + 1 == self.len {
            LANES
        } else {
            lane + 1
        };
        let block = &mut self.blocks[particle / LANES];
        for (lanes, x) in block.0.iter_mut().zip(numbers) {
            lanes[lane..last].fill(x);
        }
    }

    /// Bytes taken.
    pub(super) fn memory(&self) -> usize {
        self.blocks.len() * size_of::<Block<N>>()
    }

    /// Numbers of all particles in their order.
    pub fn iter(&self) -> impl Iterator<Item = [f64; N]> + '_ {
        (0..self.len).map(|a| self.get(a))
    }
}

impl<const N: usize> Serialize for Blocks<N> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.iter().flatten())
    }
}

impl<'de, const N: usize> Deserialize<'de> for Blocks<N> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let numbers = Vec::<f64>::deserialize(deserializer)?;
        let (particles, rest) = numbers.as_chunks::<N>();
        if rest.is_empty() {
            Ok(Self::collect(particles.len(), |a| particles[a]))
        } else {
            let why = format!("{} numbers are not {N} for each particle", numbers.len());
            Err(D::Error::custom(why))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_cluster_is_filled_up_with_the_last_particle() {
        let mut blocks = Blocks::collect(11, |a| [a as f64, -1.0]);
        blocks.set(10, [7.0, 8.0]);
        assert_eq!(
            blocks.blocks[1].0[0],
            [8.0, 9.0, 7.0, 7.0, 7.0, 7.0, 7.0, 7.0]
        );
        assert_eq!(blocks.blocks[1].0[1][7], 8.0);
        assert_eq!((blocks.get(3), blocks.iter().count()), ([3.0, -1.0], 11));
    }

    #[test]
    fn written_and_read_again_they_are_the_same() {
        let blocks = Blocks::collect(9, |a| [1.0 / (1.0 + a as f64), a as f64]);
        let text = serde_json::to_string(&blocks).unwrap();
        assert_eq!(serde_json::from_str::<Blocks<2>>(&text).unwrap(), blocks);
        assert!(serde_json::from_str::<Blocks<5>>(&text).is_err());
    }
}
