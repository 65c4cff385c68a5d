//! Sums over neighbours, eight particles side by side.

use crate::neighbours::clusters::Block;
use crate::simd::{LANES, Simd, Task};

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

/// Declares a [`Record`]: a struct of numbers that can be those of one particle or of eight.
macro_rules! record {
    ($(#[$about:meta])* struct $name:ident { $($(#[$what:meta])* $field:ident),* $(,)? }) => {
        $(#[$about])*
        #[derive(Debug, Clone, Copy, Default)]
        pub(crate) struct $name<T = f64> {
            $($(#[$what])* pub(crate) $field: T,)*
        }

        impl $crate::neighbours::pair_sum::Record for $name {
            type Lanes<S: $crate::simd::Simd> = $name<S>;

            #[inline(always)]
            fn splat<S: $crate::simd::Simd>(&self) -> $name<S> {
                $name { $($field: S::splat(self.$field),)* }
            }

            #[inline(always)]
            fn load<S: $crate::simd::Simd>(eight: &[Self; $crate::simd::LANES]) -> $name<S> {
                $name { $($field: S::load(&eight.map(|one| one.$field)),)* }
            }

            #[inline(always)]
            fn store<S: $crate::simd::Simd>(lanes: $name<S>) -> [Self; $crate::simd::LANES] {
                $(let $field = lanes.$field.store();)*
                std::array::from_fn(|i| $name { $($field: $field[i],)* })
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
    /// Those from the first of the block on.
    pub(crate) own: &'a [[L::Particle; LANES]],
    pub(crate) block: &'a Block,
    pub(crate) results: &'a mut [[L::Result; LANES]],
}

impl<L: PairSum> Task for SumBlock<'_, L> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let records = self.records.as_flattened();
        let mut begin = 0;
        for ((own, ends), result) in self.own.iter().zip(&self.block.ends).zip(self.results) {
            let [divide, end] = ends.map(|e| e as usize);
            let a = L::Particle::load::<S>(own);
            let mut sums = L::zero::<S>();
            for &b in &self.block.neighbour[begin..divide] {
                self.law.add(&mut sums, &a, &records[b as usize].splat());
            }
            for &b in &self.block.neighbour[divide..end] {
                self.law
                    .add_divided(&mut sums, &a, &records[b as usize].splat());
            }
            *result = L::Result::store(self.law.finish(sums, &a));
            begin = end;
        }
    }
}
