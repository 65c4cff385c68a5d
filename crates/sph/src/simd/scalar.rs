//! Plain Rust, one lane after the other: the reference of the other widths.

use super::{LANES, Simd};
use std::array::from_fn;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Eight numbers in an array.
#[derive(Clone, Copy)]
pub(super) struct Lanes([f64; LANES]);

impl Lanes {
    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Self(from_fn(|i| f(self.0[i], other.0[i])))
    }
}

impl Add for Lanes {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }
}

impl Sub for Lanes {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.zip(other, |a, b| a - b)
    }
}

impl Mul for Lanes {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.zip(other, |a, b| a * b)
    }
}

impl Div for Lanes {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        self.zip(other, |a, b| a / b)
    }
}

impl Neg for Lanes {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(self.0.map(|a| -a))
    }
}

impl Simd for Lanes {
    type Mask = [bool; LANES];

    #[inline(always)]
    fn splat(x: f64) -> Self {
        Self([x; LANES])
    }

    #[inline(always)]
    fn splat_halves(low: f64, high: f64) -> Self {
        Self(from_fn(|i| if i < LANES / 2 { low } else { high }))
    }

    #[inline(always)]
    fn halves(self) -> [Self; 2] {
        [0, LANES / 2].map(|first| Self(from_fn(|i| self.0[first + i % (LANES / 2)])))
    }

    #[inline(always)]
    fn sum_halves(self, other: Self) -> Self {
        let [a, b] = [self, other].map(Self::halves);
        Self(from_fn(|i| {
            let [low, high] = if i < LANES / 2 { a } else { b };
            low.0[i] + high.0[i]
        }))
    }

    #[inline(always)]
    fn load(x: &[f64; LANES]) -> Self {
        Self(*x)
    }

    #[inline(always)]
    fn load_single(x: &[f32; LANES]) -> Self {
        Self(x.map(f64::from))
    }

    #[inline(always)]
    fn split(self) -> (Self, Self) {
        const FRACTION: u64 = (1 << 52) - 1;
        let one = 1.0_f64.to_bits();
        let fraction = |x: f64| f64::from_bits(x.to_bits() & FRACTION | one);
        let exponent = |x: f64| (x.to_bits() >> 52) as f64 - 1023.0;
        (Self(self.0.map(fraction)), Self(self.0.map(exponent)))
    }

    #[inline(always)]
    fn scale(self, power: Self) -> Self {
        let factor = |p: f64| f64::from_bits(((p as i64 + 1023) as u64) << 52);
        self * Self(power.0.map(factor))
    }

    #[inline(always)]
    fn store(self) -> [f64; LANES] {
        self.0
    }

    #[inline(always)]
    fn mul_add(self, factor: Self, summand: Self) -> Self {
        Self(from_fn(|i| self.0[i].mul_add(factor.0[i], summand.0[i])))
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.map(f64::sqrt))
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.map(f64::abs))
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        self.zip(other, |a, b| if a < b { a } else { b })
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.zip(other, |a, b| if a > b { a } else { b })
    }

    #[inline(always)]
    fn lt(self, other: Self) -> Self::Mask {
        from_fn(|i| self.0[i] < other.0[i])
    }

    #[inline(always)]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
        Self(from_fn(|i| if mask[i] { yes.0[i] } else { no.0[i] }))
    }

    #[inline(always)]
    fn bits(mask: Self::Mask) -> u8 {
        (0..LANES).fold(0, |bits, i| bits | u8::from(mask[i]) << i)
    }
}
