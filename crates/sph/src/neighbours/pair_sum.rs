//! Sums over neighbours, eight particles side by side.

use crate::neighbours::clusters::Block;
use crate::simd::{LANES, Simd, Task};

/// A number, a vector of numbers, a matrix: of one particle or of eight.
pub(crate) trait Numbers: Copy + Send + Sync {
    /// The same of eight particles.
    type Lanes<S: Simd>: Copy;

    /// All zero.
    const ZERO: Self;

    /// The same in all lanes.
    fn splat<S: Simd>(self) -> Self::Lanes<S>;

    /// Those of eight particles.
    fn load<S: Simd>(eight: [Self; LANES]) -> Self::Lanes<S>;

    /// Back to eight particles.
    fn store<S: Simd>(lanes: Self::Lanes<S>) -> [Self; LANES];
}

impl Numbers for f64 {
    type Lanes<S: Simd> = S;

    const ZERO: Self = 0.0;

    #[inline(always)]
    fn splat<S: Simd>(self) -> S {
        S::splat(self)
    }

    #[inline(always)]
    fn load<S: Simd>(eight: [Self; LANES]) -> S {
        S::load(&eight)
    }

    #[inline(always)]
    fn store<S: Simd>(lanes: S) -> [Self; LANES] {
        lanes.store()
    }
}

impl<N: Numbers, const D: usize> Numbers for [N; D] {
    type Lanes<S: Simd> = [N::Lanes<S>; D];

    const ZERO: Self = [N::ZERO; D];

    // Loops and no closures: what a library function calls may stay outside of the instructions that `simd::run` turns on.

    #[inline(always)]
    fn splat<S: Simd>(self) -> [N::Lanes<S>; D] {
        let mut lanes = [N::ZERO.splat::<S>(); D];
        for k in 0..D {
            lanes[k] = self[k].splat::<S>();
        }
        lanes
    }

    #[inline(always)]
    fn load<S: Simd>(eight: [Self; LANES]) -> [N::Lanes<S>; D] {
        let mut lanes = [N::ZERO.splat::<S>(); D];
        for k in 0..D {
            let mut component = [N::ZERO; LANES];
            for i in 0..LANES {
                component[i] = eight[i][k];
            }
            lanes[k] = N::load::<S>(component);
        }
        lanes
    }

    #[inline(always)]
    fn store<S: Simd>(lanes: [N::Lanes<S>; D]) -> [Self; LANES] {
        let mut eight = [Self::ZERO; LANES];
        for k in 0..D {
            let component = N::store::<S>(lanes[k]);
            for i in 0..LANES {
                eight[i][k] = component[i];
            }
        }
        eight
    }
}

/// Named numbers of one particle.
pub(crate) trait Record: Copy + Default + Send + Sync {
    /// The same of eight particles.
    type Lanes<S: Simd>: Copy;

    /// The same particle in all lanes.
    fn splat<S: Simd>(&self) -> Self::Lanes<S>;

    /// Eight particles.
    fn load<S: Simd>(eight: &[Self; LANES]) -> Self::Lanes<S>;

    /// Back to eight particles.
    fn store<S: Simd>(lanes: Self::Lanes<S>) -> [Self; LANES];
}

/// Declares a [`Record`] in `D` dimensions: a struct of numbers `T`, vectors `[T; D]` and matrices `[[T; D]; D]` that can be those
/// of one particle or of eight.
macro_rules! record {
    ($(#[$about:meta])* struct $name:ident { $($(#[$what:meta])* $field:ident: $type:ty),* $(,)? }) => {
        $(#[$about])*
        #[derive(Debug, Clone, Copy)]
        pub(crate) struct $name<const D: usize, T = f64> {
            $($(#[$what])* pub(crate) $field: $type,)*
        }

        impl<const D: usize> Default for $name<D> {
            fn default() -> Self {
                Self { $($field: $crate::neighbours::pair_sum::Numbers::ZERO,)* }
            }
        }

        impl<const D: usize> $crate::neighbours::pair_sum::Record for $name<D> {
            type Lanes<S: $crate::simd::Simd> = $name<D, S>;

            #[inline(always)]
            fn splat<S: $crate::simd::Simd>(&self) -> $name<D, S> {
                use $crate::neighbours::pair_sum::Numbers;
                $name { $($field: Numbers::splat::<S>(self.$field),)* }
            }

            #[inline(always)]
            fn load<S: $crate::simd::Simd>(eight: &[Self; $crate::simd::LANES]) -> $name<D, S> {
                use $crate::neighbours::pair_sum::Numbers;
                $name { $($field: Numbers::load::<S>(eight.map(|one| one.$field)),)* }
            }

            #[inline(always)]
            fn store<S: $crate::simd::Simd>(lanes: $name<D, S>) -> [Self; $crate::simd::LANES] {
                use $crate::neighbours::pair_sum::Numbers;
                let mut eight = [Self::default(); $crate::simd::LANES];
                $(
                    let numbers = <_ as Numbers>::store::<S>(lanes.$field);
                    for (one, number) in eight.iter_mut().zip(numbers) {
                        one.$field = number;
                    }
                )*
                eight
            }
        }
    };
}
pub(crate) use record;

/// What a law needs: numbers of one particle and their lanes.
pub(crate) type Lanes<R, S> = <R as Record>::Lanes<S>;

/// A law between particles: what neighbour b adds to the sums of particle a, for eight a at once.
///
/// Every function is `#[inline(always)]`. A pair outside the support of the kernel and a particle with itself must add nothing:
/// their kernel gradient times separation is exactly zero.
pub(crate) trait PairSum: Sync {
    /// What the law reads of a particle.
    type Particle: Record;
    /// What comes out for a particle.
    type Result: Record;
    /// Sums under way.
    type Sums<S: Simd>: Copy;

    /// Before the first neighbour.
    fn zero<S: Simd>() -> Self::Sums<S>;

    /// Adds a neighbour.
    fn add<S: Simd>(
        &self,
        sums: &mut Self::Sums<S>,
        a: &Lanes<Self::Particle, S>,
        b: &Lanes<Self::Particle, S>,
    );

    /// Adds a neighbour behind the dividing place.
    fn add_divided<S: Simd>(
        &self,
        sums: &mut Self::Sums<S>,
        a: &Lanes<Self::Particle, S>,
        b: &Lanes<Self::Particle, S>,
    );

    /// After the last neighbour.
    fn finish<S: Simd>(
        &self,
        sums: Self::Sums<S>,
        a: &Lanes<Self::Particle, S>,
    ) -> Lanes<Self::Result, S>;
}

/// The sums of the clusters of one block.
pub(crate) struct SumBlock<'a, L: PairSum> {
    pub(crate) law: &'a L,
    /// All particles, in groups of eight.
    pub(crate) records: &'a [[L::Particle; LANES]],
    /// First cluster of the block.
    pub(crate) first: usize,
    pub(crate) block: &'a Block,
    pub(crate) results: &'a mut [[L::Result; LANES]],
    /// Only clusters with one of these places are summed.
    pub(crate) marked: Option<&'a [bool]>,
}

impl<L: PairSum> SumBlock<'_, L> {
    /// Whether a cluster with this list is summed.
    fn concerns(&self, cluster: usize, list: &[u32]) -> bool {
        self.marked.is_none_or(|marked| {
            let own = &marked[cluster * LANES..(cluster + 1) * LANES];
            own.contains(&true) || list.iter().any(|&b| marked[b as usize])
        })
    }
}

impl<L: PairSum> Task for SumBlock<'_, L> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let records = self.records.as_flattened();
        let mut begin = 0;
        for (c, ends) in self.block.ends.iter().enumerate() {
            let [divide, end] = ends.map(|e| e as usize);
            let (cluster, list) = (self.first + c, &self.block.neighbour[begin..end]);
            if self.concerns(cluster, list) {
                let (ordinary, divided) = list.split_at(divide - begin);
                let a = L::Particle::load::<S>(&self.records[cluster]);
                let mut sums = L::zero::<S>();
                for &b in ordinary {
                    self.law.add(&mut sums, &a, &records[b as usize].splat());
                }
                for &b in divided {
                    self.law
                        .add_divided(&mut sums, &a, &records[b as usize].splat());
                }
                self.results[c] = L::Result::store(self.law.finish(sums, &a));
            }
            begin = end;
        }
    }
}
