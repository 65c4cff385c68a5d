//! Logarithm and exponential of lanes, from the arithmetic of [`Simd`] alone: the same bits at every width.
//!
//! Both are right to about two units in the last place.

use super::Simd;
use std::f64::consts::LOG2_E;

/// ln 2 in two parts; the first has so few digits that its products with exponents are exact.
const LN_2: [f64; 2] = [0.693_147_180_369_123_8, 1.908_214_929_270_587_7e-10];

/// 2^52 + 2^51: adding and subtracting it rounds to whole numbers.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// 1/3, 1/5, 1/7, ...
const ODD: [f64; 12] = {
    let mut c = [0.0; 12];
    let mut k = 0;
    while k < 12 {
        c[k] = 1.0 / (2 * k + 3) as f64;
        k += 1;
    }
    c
};

/// 1/2!, 1/3!, 1/4!, ...
const FACTORIALS: [f64; 12] = {
    let mut c = [0.5; 12];
    let mut k = 1;
    while k < 12 {
        c[k] = c[k - 1] / (k + 2) as f64;
        k += 1;
    }
    c
};

/// sum c_k x^k, by pairs and pairs of pairs: many of the operations wait for no other.
#[inline(always)]
fn polynomial<S: Simd>(x: S, c: &[f64; 12]) -> S {
    let (square, mut quads) = (x * x, [x; 3]);
    for (k, quad) in quads.iter_mut().enumerate() {
        let c = [S::splat(c[4 * k]), S::splat(c[4 * k + 1])];
        *quad = c[1].mul_add(x, c[0]);
    }
    for (k, quad) in quads.iter_mut().enumerate() {
        let c = [S::splat(c[4 * k + 2]), S::splat(c[4 * k + 3])];
        *quad = c[1].mul_add(x, c[0]).mul_add(square, *quad);
    }
    let fourth = square * square;
    quads[2].mul_add(fourth, quads[1]).mul_add(fourth, quads[0])
}

/// Natural logarithm of positive normal numbers; meaningless for others.
///
/// ln(m 2^e) = e ln 2 + 2 artanh s, s = (m - 1)/(m + 1), m in [0.7, 1.5): the series of artanh ends below rounding.
#[inline(always)]
pub fn ln<S: Simd>(x: S) -> S {
    let (m, e) = x.split();
    let one = S::splat(1.0);
    let large = S::splat(1.42).lt(m);
    let m = S::select(large, m * S::splat(0.5), m);
    let e = S::select(large, e + one, e);
    let f = m - one;
    let s = f / (m + one);
    let z = s * s;
    let sum = polynomial(z, &ODD);
    // 2 s = f - s f: the large part stays exact.
    let rest = (sum * z).mul_add(s + s, -(s * f));
    e.mul_add(S::splat(LN_2[0]), f + e.mul_add(S::splat(LN_2[1]), rest))
}

/// Exponential of numbers between -700 and 700; those beyond count as the nearest of these, and those that are not a number
/// as 700.
///
/// exp(n ln 2 + r) = 2^n exp r, |r| < 0.35: the power series ends below rounding.
#[inline(always)]
pub fn exp<S: Simd>(x: S) -> S {
    let x = x.min(S::splat(700.0)).max(S::splat(-700.0));
    let n = x.mul_add(S::splat(LOG2_E), S::splat(ROUND)) - S::splat(ROUND);
    let r = n.mul_add(S::splat(-LN_2[1]), n.mul_add(S::splat(-LN_2[0]), x));
    // 1 + (r + r^2 (1/2 + ...)): the large parts are added last.
    let sum = (polynomial(r, &FACTORIALS) * r).mul_add(r, r) + S::splat(1.0);
    sum.scale(n)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simd::{self, LANES, Task};

    struct Both([f64; LANES]);

    impl Task for Both {
        type Output = [[f64; LANES]; 2];

        #[inline(always)]
        fn run<S: Simd>(self) -> Self::Output {
            let x = S::load(&self.0);
            [ln(x), exp(ln(x) * S::splat(0.29))].map(S::store)
        }
    }

    #[test]
    fn logarithms_and_powers_are_those_of_the_library() {
        let number = |k: i32| 1e-12 * 1.003_f64.powi(k);
        for first in (0..18_000).step_by(LANES) {
            let x: [f64; LANES] = std::array::from_fn(|l| number(first + l as i32));
            let [logarithms, powers] = simd::run(Both(x));
            for l in 0..LANES {
                let (ln, power) = (x[l].ln(), x[l].powf(0.29));
                // Near 1 the logarithm itself is small; it keeps its relative precision there.
                assert!((logarithms[l] - ln).abs() <= 5e-16 * ln.abs(), "{}", x[l]);
                // An error in the last place of ln x is one of ln x as many in the power.
                assert!((powers[l] / power - 1.0).abs() < 4e-15, "{}", x[l]);
            }
        }
    }
}
