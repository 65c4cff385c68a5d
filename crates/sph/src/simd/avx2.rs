//! Eight lanes in two 256-bit vectors.
#![allow(unsafe_code)] // vector instructions: see the reason below

use super::{LANES, Simd, Task, Width};
use std::arch::x86_64::*;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Eight numbers in two vectors.
///
/// Why the calls of instructions below are sound: this type is private, and the only place that names it is [`run`], which
/// makes sure that the processor has them.
#[derive(Clone, Copy)]
struct Lanes(__m256d, __m256d);

/// Does a task with AVX2 and FMA.
///
/// # Panics
/// If the processor does not have them.
pub(super) fn run<T: Task>(task: T) -> T::Output {
    #[target_feature(enable = "avx2,fma")]
    fn with_features<T: Task>(task: T) -> T::Output {
        super::align_stack();
        task.run::<Lanes>()
    }
    assert!(Width::Avx2.is_available());
    // SAFETY: the processor has these instructions.
    unsafe { with_features(task) }
}

macro_rules! operator {
    ($trait:ident, $name:ident, $instruction:ident) => {
        impl $trait for Lanes {
            type Output = Self;
            #[inline(always)]
            fn $name(self, other: Self) -> Self {
                // SAFETY: see `Lanes`.
                unsafe { Self($instruction(self.0, other.0), $instruction(self.1, other.1)) }
            }
        }
    };
}

operator!(Add, add, _mm256_add_pd);
operator!(Sub, sub, _mm256_sub_pd);
operator!(Mul, mul, _mm256_mul_pd);
operator!(Div, div, _mm256_div_pd);

impl Neg for Lanes {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        // SAFETY: see `Lanes`.
        unsafe {
            let sign = _mm256_set1_pd(-0.0);
            Self(_mm256_xor_pd(sign, self.0), _mm256_xor_pd(sign, self.1))
        }
    }
}

impl Simd for Lanes {
    /// All bits of a lane set or none.
    type Mask = (__m256d, __m256d);

    #[inline(always)]
    fn splat(x: f64) -> Self {
        // SAFETY: see `Lanes`.
        let half = unsafe { _mm256_set1_pd(x) };
        Self(half, half)
    }

    #[inline(always)]
    fn splat_halves(low: f64, high: f64) -> Self {
        // SAFETY: see `Lanes`.
        unsafe { Self(_mm256_set1_pd(low), _mm256_set1_pd(high)) }
    }

    #[inline(always)]
    fn halves(self) -> [Self; 2] {
        [Self(self.0, self.0), Self(self.1, self.1)]
    }

    #[inline(always)]
    fn sum_halves(self, other: Self) -> Self {
        // SAFETY: see `Lanes`.
        unsafe {
            Self(
                _mm256_add_pd(self.0, self.1),
                _mm256_add_pd(other.0, other.1),
            )
        }
    }

    #[inline(always)]
    fn load(x: &[f64; LANES]) -> Self {
        let (low, high) = x.split_at(LANES / 2);
        // SAFETY: see `Lanes`; four numbers are read from each half of eight, at any alignment.
        unsafe {
            Self(
                _mm256_loadu_pd(low.as_ptr()),
                _mm256_loadu_pd(high.as_ptr()),
            )
        }
    }

    #[inline(always)]
    fn load_single(x: &[f32; LANES]) -> Self {
        let (low, high) = x.split_at(LANES / 2);
        // SAFETY: see `Lanes`; four numbers are read from each half of eight, at any alignment.
        unsafe {
            Self(
                _mm256_cvtps_pd(_mm_loadu_ps(low.as_ptr())),
                _mm256_cvtps_pd(_mm_loadu_ps(high.as_ptr())),
            )
        }
    }

    #[inline(always)]
    fn split(self) -> (Self, Self) {
        // SAFETY: see `Lanes`.
        let half = |x: __m256d| unsafe {
            let bits = _mm256_castpd_si256(x);
            let fraction = _mm256_and_si256(bits, _mm256_set1_epi64x((1 << 52) - 1));
            let one = _mm256_castpd_si256(_mm256_set1_pd(1.0));
            // The bits of 2^52 + n hold n: a whole number becomes a float.
            let large = _mm256_set1_pd(f64::from_bits(0x4330_0000_0000_0000));
            let exponent =
                _mm256_or_si256(_mm256_srli_epi64::<52>(bits), _mm256_castpd_si256(large));
            let exponent = _mm256_sub_pd(_mm256_castsi256_pd(exponent), large);
            (
                _mm256_castsi256_pd(_mm256_or_si256(fraction, one)),
                _mm256_sub_pd(exponent, _mm256_set1_pd(1023.0)),
            )
        };
        let (low, high) = (half(self.0), half(self.1));
        (Self(low.0, high.0), Self(low.1, high.1))
    }

    #[inline(always)]
    fn scale(self, power: Self) -> Self {
        // SAFETY: see `Lanes`.
        let factor = |p: __m256d| unsafe {
            // The low bits of 2^52 + n are n.
            let large = _mm256_set1_pd(f64::from_bits(0x4330_0000_0000_0000) + 1023.0);
            let bits = _mm256_castpd_si256(_mm256_add_pd(p, large));
            _mm256_castsi256_pd(_mm256_slli_epi64::<52>(bits))
        };
        self * Self(factor(power.0), factor(power.1))
    }

    #[inline(always)]
    fn store(self) -> [f64; LANES] {
        let mut x = [0.0; LANES];
        let (low, high) = x.split_at_mut(LANES / 2);
        // SAFETY: see `Lanes`; four numbers are written to each half of eight, at any alignment.
        unsafe {
            _mm256_storeu_pd(low.as_mut_ptr(), self.0);
            _mm256_storeu_pd(high.as_mut_ptr(), self.1);
        }
        x
    }

    #[inline(always)]
    fn mul_add(self, factor: Self, summand: Self) -> Self {
        // SAFETY: see `Lanes`.
        unsafe {
            Self(
                _mm256_fmadd_pd(self.0, factor.0, summand.0),
                _mm256_fmadd_pd(self.1, factor.1, summand.1),
            )
        }
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        // SAFETY: see `Lanes`.
        unsafe { Self(_mm256_sqrt_pd(self.0), _mm256_sqrt_pd(self.1)) }
    }

    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: see `Lanes`.
        unsafe {
            let sign = _mm256_set1_pd(-0.0);
            Self(
                _mm256_andnot_pd(sign, self.0),
                _mm256_andnot_pd(sign, self.1),
            )
        }
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        // SAFETY: see `Lanes`.
        unsafe {
            Self(
                _mm256_min_pd(self.0, other.0),
                _mm256_min_pd(self.1, other.1),
            )
        }
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        // SAFETY: see `Lanes`.
        unsafe {
            Self(
                _mm256_max_pd(self.0, other.0),
                _mm256_max_pd(self.1, other.1),
            )
        }
    }

    #[inline(always)]
    fn lt(self, other: Self) -> Self::Mask {
        // SAFETY: see `Lanes`.
        unsafe {
            (
                _mm256_cmp_pd::<_CMP_LT_OQ>(self.0, other.0),
                _mm256_cmp_pd::<_CMP_LT_OQ>(self.1, other.1),
            )
        }
    }

    #[inline(always)]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
        // SAFETY: see `Lanes`.
        unsafe {
            Self(
                _mm256_blendv_pd(no.0, yes.0, mask.0),
                _mm256_blendv_pd(no.1, yes.1, mask.1),
            )
        }
    }

    #[inline(always)]
    fn bits(mask: Self::Mask) -> u8 {
        // SAFETY: see `Lanes`.
        let (low, high) = unsafe { (_mm256_movemask_pd(mask.0), _mm256_movemask_pd(mask.1)) };
        (low | high << (LANES / 2)) as u8
    }
}
