//! Eight particles side by side: arithmetic on lanes of `f64`.
//!
//! A law between particles is written once, generic over [`Simd`], and run by [`run`] on what the processor has: AVX-512,
//! AVX2 with FMA (two halves), or plain scalar code. All three have eight lanes and give **the same bits**: every operation is
//! one IEEE operation per lane (`mul_add` is fused everywhere), square root and quotient are exact, and all that is ever added
//! up across lanes is one half and the other ([`Simd::sum_halves`]).
//!
//! How to write a law: a struct with what it needs, `impl Task for` it, and every function on the way down to the
//! arithmetic `#[inline(always)]`: the processor's instructions only reach code that is inlined into [`run`]. Branches become
//! [`Simd::select`].
//!
//! ```
//! use erode_sph::simd::{self, LANES, Simd, Task};
//!
//! /// |x| for eight vectors.
//! struct Norm<'a>(&'a [[f64; LANES]; 2]);
//!
//! impl Task for Norm<'_> {
//!     type Output = [f64; LANES];
//!
//!     #[inline(always)]
//!     fn run<S: Simd>(self) -> [f64; LANES] {
//!         let [x, y] = self.0.each_ref().map(S::load);
//!         x.mul_add(x, y * y).sqrt().store()
//!     }
//! }
//!
//! assert_eq!(simd::run(Norm(&[[3.0; 8], [4.0; 8]])), [5.0; 8]);
//! ```
//!
//! `ERODE_SIMD` = `avx512`, `avx2` or `scalar` in the environment takes that width where the processor has it.

#[cfg(target_arch = "x86_64")]
mod avx2;
#[cfg(target_arch = "x86_64")]
mod avx512;
pub mod functions;
mod scalar;

use std::ops::{Add, Div, Mul, Neg, Sub};
use std::sync::atomic::{AtomicU8, Ordering};

/// Particles side by side.
pub const LANES: usize = 8;

/// Eight numbers; each operation acts on every lane for itself.
pub trait Simd:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// One truth per lane.
    type Mask: Copy;

    /// The same number in every lane.
    fn splat(x: f64) -> Self;

    /// `low` in lanes 0 to 3, `high` in lanes 4 to 7.
    fn splat_halves(low: f64, high: f64) -> Self;

    /// Lanes 0 to 3 twice, and lanes 4 to 7 twice.
    fn halves(self) -> [Self; 2];

    /// In lanes 0 to 3 the lower half of `self` plus its upper half, in lanes 4 to 7 the same of `other`.
    fn sum_halves(self, other: Self) -> Self;

    /// Lanes from memory.
    fn load(x: &[f64; LANES]) -> Self;

    /// Lanes from memory in single precision, which is exact.
    fn load_single(x: &[f32; LANES]) -> Self;

    /// m in [1, 2) and e of each number m 2^e; meaningless where it is not positive and normal.
    fn split(self) -> (Self, Self);

    /// `self` times 2^`power`, a whole number in -1022..=1023.
    fn scale(self, power: Self) -> Self;

    /// Lanes to memory.
    fn store(self) -> [f64; LANES];

    /// `self * factor + summand`, rounded once.
    fn mul_add(self, factor: Self, summand: Self) -> Self;

    /// Square root, rounded correctly.
    fn sqrt(self) -> Self;

    /// Absolute value.
    fn abs(self) -> Self;

    /// `self` where it is less than `other`, else `other` (also where either is not a number).
    fn min(self, other: Self) -> Self;

    /// `self` where it is greater than `other`, else `other` (also where either is not a number).
    fn max(self, other: Self) -> Self;

    /// Where `self < other`.
    fn lt(self, other: Self) -> Self::Mask;

    /// `yes` where the mask is true, else `no`.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;

    /// The mask as bits, lane 0 the lowest.
    fn bits(mask: Self::Mask) -> u8;
}

/// Work that is generic over the lanes.
pub trait Task {
    /// Result.
    type Output;

    /// The work; must be `#[inline(always)]` down to the arithmetic.
    fn run<S: Simd>(self) -> Self::Output;
}

/// Which instructions do the work.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Width {
    /// Plain Rust, one lane after the other: runs everywhere, and is what the others are tested against.
    Scalar,
    /// 256-bit vectors, two of them.
    Avx2,
    /// 512-bit vectors.
    Avx512,
}

impl Width {
    /// All, the widest first.
    pub const ALL: [Self; 3] = [Self::Avx512, Self::Avx2, Self::Scalar];

    /// Whether this processor has it.
    #[must_use]
    pub fn is_available(self) -> bool {
        match self {
            Self::Scalar => true,
            #[cfg(target_arch = "x86_64")]
            Self::Avx2 => is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma"),
            #[cfg(target_arch = "x86_64")]
            Self::Avx512 => {
                is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx512dq")
            }
            #[cfg(not(target_arch = "x86_64"))]
            Self::Avx2 | Self::Avx512 => false,
        }
    }

    /// As in `ERODE_SIMD`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Scalar => "scalar",
            Self::Avx2 => "avx2",
            Self::Avx512 => "avx512",
        }
    }
}

/// Index into [`Width::ALL`] of the width in use; `UNKNOWN` before the first use.
static CHOSEN: AtomicU8 = AtomicU8::new(UNKNOWN);
const UNKNOWN: u8 = u8::MAX;

/// The width that [`run`] uses.
#[must_use]
pub fn width() -> Width {
    let chosen = CHOSEN.load(Ordering::Relaxed);
    if chosen == UNKNOWN {
        set_width(None)
    } else {
        Width::ALL[chosen as usize]
    }
}

/// Makes [`run`] use a width from now on, in all threads; without one that of the environment or the widest. A width that the
/// processor does not have counts as none. Returns the one chosen. Results are the same bits with all of them.
pub fn set_width(wanted: Option<Width>) -> Width {
    let named = || {
        let name = std::env::var("ERODE_SIMD").ok()?;
        Width::ALL.into_iter().find(|w| w.name() == name)
    };
    let first = wanted.or_else(named).filter(|w| w.is_available());
    let is_it = |w: &Width| first.map_or_else(|| w.is_available(), |f| f == *w);
    // The scalar width is always there.
    let chosen = Width::ALL.iter().position(is_it).unwrap_or(2);
    CHOSEN.store(chosen as u8, Ordering::Relaxed);
    Width::ALL[chosen]
}

/// Does a task with the widest instructions that this processor has.
#[inline]
pub fn run<T: Task>(task: T) -> T::Output {
    match width() {
        #[cfg(target_arch = "x86_64")]
        Width::Avx512 => avx512::run(task),
        #[cfg(target_arch = "x86_64")]
        Width::Avx2 => avx2::run(task),
        _ => task.run::<scalar::Lanes>(),
    }
}

/// Makes the function that this is inlined into begin its frame at a cache line. Without it the compiler keeps vectors that find no
/// register at multiples of 16 bytes, where most of them lie across two lines (2 to 3 % of a step of a liquid).
#[inline(always)]
fn align_stack() {
    #[repr(align(64))]
    struct Line([u8; 64]);
    let _ = std::hint::black_box(&mut Line([0; 64])).0;
}

#[cfg(test)]
mod tests;
