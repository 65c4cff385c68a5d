//! Eight lanes in one 512-bit vector.
#![allow(unsafe_code)] // vector instructions: see the reason below

use super::{LANES, Simd, Task, Width};
use std::arch::x86_64::*;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Eight numbers in one vector.
///
/// Why the calls of instructions below are sound: this type is private, and the only place that names it is [`run`], which
/// makes sure that the processor has them.
#[derive(Clone, Copy)]
struct Lanes(__m512d);

/// Does a task with AVX-512.
///
/// # Panics
/// If the processor does not have it.
pub(super) fn run<T: Task>(task: T) -> T::Output {
    #[target_feature(enable = "avx512f,avx512dq,avx2,fma")]
    fn with_features<T: Task>(task: T) -> T::Output {
        super::align_stack();
        task.run::<Lanes>()
    }
    assert!(Width::Avx512.is_available());
    // SAFETY: the processor has these instructions; processors with AVX-512 have AVX2 and FMA.
    unsafe { with_features(task) }
}

macro_rules! operator {
    ($trait:ident, $name:ident, $instruction:ident) => {
        impl $trait for Lanes {
            type Output = Self;
            #[inline(always)]
            fn $name(self, other: Self) -> Self {
                // SAFETY: see `Lanes`.
                Self(unsafe { $instruction(self.0, other.0) })
            }
        }
    };
}

operator!(Add, add, _mm512_add_pd);
operator!(Sub, sub, _mm512_sub_pd);
operator!(Mul, mul, _mm512_mul_pd);
operator!(Div, div, _mm512_div_pd);

impl Neg for Lanes {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        // SAFETY: see `Lanes`.
        Self(unsafe { _mm512_xor_pd(_mm512_set1_pd(-0.0), self.0) })
    }
}

impl Simd for Lanes {
    type Mask = __mmask8;

    #[inline(always)]
    fn splat(x: f64) -> Self {
        // SAFETY: see `Lanes`.
        Self(unsafe { _mm512_set1_pd(x) })
    }

    #[inline(always)]
    fn splat_halves(low: f64, high: f64) -> Self {
        const HIGH: __mmask8 = 0b1111_0000;
        // SAFETY: see `Lanes`.
        Self(unsafe { _mm512_mask_broadcastsd_pd(_mm512_set1_pd(low), HIGH, _mm_set_sd(high)) })
    }

    #[inline(always)]
    fn halves(self) -> [Self; 2] {
        // SAFETY: see `Lanes`.
        unsafe {
            [
                Self(_mm512_shuffle_f64x2::<0b01_00_01_00>(self.0, self.0)),
                Self(_mm512_shuffle_f64x2::<0b11_10_11_10>(self.0, self.0)),
            ]
        }
    }

    #[inline(always)]
    fn sum_halves(self, other: Self) -> Self {
        // SAFETY: see `Lanes`.
        unsafe {
            let low = _mm512_shuffle_f64x2::<0b01_00_01_00>(self.0, other.0);
            let high = _mm512_shuffle_f64x2::<0b11_10_11_10>(self.0, other.0);
            Self(_mm512_add_pd(low, high))
        }
    }

    #[inline(always)]
    fn load(x: &[f64; LANES]) -> Self {
        // SAFETY: see `Lanes`; eight numbers are read from an array of eight, at any alignment.
        Self(unsafe { _mm512_loadu_pd(x.as_ptr()) })
    }

    #[inline(always)]
    fn load_single(x: &[f32; LANES]) -> Self {
        // SAFETY: see `Lanes`; eight numbers are read from an array of eight, at any alignment.
        Self(unsafe { _mm512_cvtps_pd(_mm256_loadu_ps(x.as_ptr())) })
    }

    #[inline(always)]
    fn split(self) -> (Self, Self) {
        // SAFETY: see `Lanes`.
        unsafe {
            let fraction = _mm512_getmant_pd::<_MM_MANT_NORM_1_2, _MM_MANT_SIGN_SRC>(self.0);
            (Self(fraction), Self(_mm512_getexp_pd(self.0)))
        }
    }

    #[inline(always)]
    fn scale(self, power: Self) -> Self {
        // SAFETY: see `Lanes`.
        let factor = unsafe {
            let power = _mm512_add_epi64(_mm512_cvtpd_epi64(power.0), _mm512_set1_epi64(1023));
            _mm512_castsi512_pd(_mm512_slli_epi64::<52>(power))
        };
        self * Self(factor)
    }

    #[inline(always)]
    fn store(self) -> [f64; LANES] {
        let mut x = [0.0; LANES];
        // SAFETY: see `Lanes`; eight numbers are written to an array of eight, at any alignment.
        unsafe { _mm512_storeu_pd(x.as_mut_ptr(), self.0) };
        x
    }

    #[inline(always)]
    fn mul_add(self, factor: Self, summand: Self) -> Self {
        // SAFETY: see `Lanes`.
        Self(unsafe { _mm512_fmadd_pd(self.0, factor.0, summand.0) })
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        // SAFETY: see `Lanes`.
        Self(unsafe { _mm512_sqrt_pd(self.0) })
    }

    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: see `Lanes`.
        Self(unsafe { _mm512_abs_pd(self.0) })
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        // SAFETY: see `Lanes`.
        Self(unsafe { _mm512_min_pd(self.0, other.0) })
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        // SAFETY: see `Lanes`.
        Self(unsafe { _mm512_max_pd(self.0, other.0) })
    }

    #[inline(always)]
    fn lt(self, other: Self) -> Self::Mask {
        // SAFETY: see `Lanes`.
        unsafe { _mm512_cmp_pd_mask::<_CMP_LT_OQ>(self.0, other.0) }
    }

    #[inline(always)]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
        // SAFETY: see `Lanes`.
        Self(unsafe { _mm512_mask_blend_pd(mask, no.0, yes.0) })
    }

    #[inline(always)]
    fn bits(mask: Self::Mask) -> u8 {
        mask
    }
}
