//! Sums over neighbours: four particles times two neighbours side by side.

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

    /// This one in the lower half of the lanes, another one in the upper half.
    fn splat_halves<S: Simd>(self, high: Self) -> Self::Lanes<S>;

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
    fn splat_halves<S: Simd>(self, high: Self) -> S {
        S::splat_halves(self, high)
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
    fn splat_halves<S: Simd>(self, high: Self) -> [N::Lanes<S>; D] {
        let mut lanes = [N::ZERO.splat::<S>(); D];
        for k in 0..D {
            lanes[k] = self[k].splat_halves::<S>(high[k]);
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

/// A number, a vector, a matrix of eight particles, half by half.
pub(crate) trait Halves: Copy {
    /// Each number's [`Simd::halves`].
    fn halves(self) -> [Self; 2];

    /// Each number's [`Simd::sum_halves`].
    fn sum_halves(self, other: Self) -> Self;
}

impl<S: Simd> Halves for S {
    #[inline(always)]
    fn halves(self) -> [Self; 2] {
        Simd::halves(self)
    }

    #[inline(always)]
    fn sum_halves(self, other: Self) -> Self {
        Simd::sum_halves(self, other)
    }
}

impl<N: Halves, const D: usize> Halves for [N; D] {
    #[inline(always)]
    fn halves(self) -> [Self; 2] {
        let mut halves = [self; 2];
        for k in 0..D {
            [halves[0][k], halves[1][k]] = self[k].halves();
        }
        halves
    }

    #[inline(always)]
    fn sum_halves(self, other: Self) -> Self {
        let mut sums = self;
        for k in 0..D {
            sums[k] = self[k].sum_halves(other[k]);
        }
        sums
    }
}

/// Named numbers of one particle.
pub(crate) trait Record: Copy + Default + Send + Sync {
    /// The same of eight particles.
    type Lanes<S: Simd>: Copy;

    /// The same particle in all lanes.
    fn splat<S: Simd>(&self) -> Self::Lanes<S>;

    /// This particle in the lower half of the lanes, another one in the upper half.
    fn splat_halves<S: Simd>(&self, high: &Self) -> Self::Lanes<S>;

    /// Of eight particles the lower four twice and the upper four twice.
    fn halves<S: Simd>(lanes: Self::Lanes<S>) -> [Self::Lanes<S>; 2];

    /// Each number's [`Simd::sum_halves`].
    fn sum_halves<S: Simd>(low: Self::Lanes<S>, high: Self::Lanes<S>) -> Self::Lanes<S>;

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
            fn splat_halves<S: $crate::simd::Simd>(&self, high: &Self) -> $name<D, S> {
                use $crate::neighbours::pair_sum::Numbers;
                $name { $($field: Numbers::splat_halves::<S>(self.$field, high.$field),)* }
            }

            #[inline(always)]
            fn halves<S: $crate::simd::Simd>(lanes: $name<D, S>) -> [$name<D, S>; 2] {
                use $crate::neighbours::pair_sum::Halves;
                let mut halves = [lanes; 2];
                $([halves[0].$field, halves[1].$field] = Halves::halves(lanes.$field);)*
                halves
            }

            #[inline(always)]
            fn sum_halves<S: $crate::simd::Simd>(low: $name<D, S>, high: $name<D, S>) -> $name<D, S> {
                use $crate::neighbours::pair_sum::Halves;
                $name { $($field: Halves::sum_halves(low.$field, high.$field),)* }
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

/// A law between particles: what neighbour b adds to the sums of particle a, for eight pairs at once.
///
/// Every function is `#[inline(always)]`. A pair outside the support of the kernel and a particle with itself must add nothing:
/// their kernel gradient times separation is exactly zero.
pub(crate) trait PairSum: Sync {
    /// What the law reads of a particle.
    type Particle: Record;
    /// What is summed, and what comes out for a particle.
    type Result: Record;

    /// Adds a neighbour.
    fn add<S: Simd>(
        &self,
        sums: &mut Lanes<Self::Result, S>,
        a: &Lanes<Self::Particle, S>,
        b: &Lanes<Self::Particle, S>,
    );

    /// Adds a neighbour behind the dividing place.
    fn add_divided<S: Simd>(
        &self,
        sums: &mut Lanes<Self::Result, S>,
        a: &Lanes<Self::Particle, S>,
        b: &Lanes<Self::Particle, S>,
    );

    /// After the last neighbour.
    fn finish<S: Simd>(
        &self,
        sums: Lanes<Self::Result, S>,
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
    /// Whether a cluster with these neighbours is summed.
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
        let mut begin = 0;
        for (c, ends) in self.block.ends.iter().enumerate() {
            let [divided_low, end_low, divided_high, end] = ends.map(|e| e as usize);
            let cluster = self.first + c;
            if self.concerns(cluster, &self.block.neighbour[begin..end]) {
                let a = L::Particle::load::<S>(&self.records[cluster]);
                let [a_low, a_high] = L::Particle::halves::<S>(a);
                let low = self.half::<S>(&a_low, [begin, divided_low, end_low]);
                let high = self.half::<S>(&a_high, [end_low, divided_high, end]);
                let sums = L::Result::sum_halves::<S>(low, high);
                self.results[c] = L::Result::store(self.law.finish(sums, &a));
            }
            begin = end;
        }
    }
}

impl<L: PairSum> SumBlock<'_, L> {
    /// Sums over the neighbours of four particles, which `a` holds twice: even ones in the lower half of the lanes, odd ones in
    /// the upper. The list begins, is divided and ends at these places.
    #[inline(always)]
    fn half<S: Simd>(
        &self,
        a: &Lanes<L::Particle, S>,
        [begin, divided, end]: [usize; 3],
    ) -> Lanes<L::Result, S> {
        let records = self.records.as_flattened();
        let list = &self.block.neighbour;
        let mut sums = L::Result::default().splat::<S>();
        for [even, odd] in list[begin..divided].as_chunks().0 {
            let b = records[*even as usize].splat_halves::<S>(&records[*odd as usize]);
            self.law.add(&mut sums, a, &b);
        }
        for [even, odd] in list[divided..end].as_chunks().0 {
            let b = records[*even as usize].splat_halves::<S>(&records[*odd as usize]);
            self.law.add_divided(&mut sums, a, &b);
        }
        sums
    }
}
