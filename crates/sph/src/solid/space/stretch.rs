//! Smallest principal stretch of a deformation gradient in three dimensions: the root of the smallest eigenvalue of C = F^T F.

use super::blocks::Block;
use super::lanes::{AT, dot};
use crate::simd::{self, LANES, Simd, Task};
use std::f64::consts::PI;

/// C, components as in `Sym3`.
fn right_cauchy(f: &[f64; 9]) -> [f64; 6] {
    let mut c = [0.0; 6];
    for i in 0..3 {
        for j in i..3 {
            c[AT[i][j]] = f[i] * f[j] + f[3 + i] * f[3 + j] + f[6 + i] * f[6 + j];
        }
    }
    c
}

/// The smallest principal stretch of F (rows first).
pub(super) fn smallest(f: &[f64; 9]) -> f64 {
    // C = q I + p B, det B = 2 cos(3 phi): eigenvalues q + 2 p cos(phi + 2 pi k/3), the least one for k = 1.
    let c = right_cauchy(f);
    let q = (c[0] + c[1] + c[2]) / 3.0;
    let b = [c[0] - q, c[1] - q, c[2] - q, c[3], c[4], c[5]];
    let shear = b[3] * b[3] + b[4] * b[4] + b[5] * b[5];
    let p = ((b[0] * b[0] + b[1] * b[1] + b[2] * b[2] + 2.0 * shear) / 6.0).sqrt();
    if p == 0.0 {
        return q.sqrt();
    }
    let b = b.map(|x| x / p);
    let determinant = b[0] * (b[1] * b[2] - b[5] * b[5]) - b[3] * (b[3] * b[2] - b[5] * b[4])
        + b[4] * (b[3] * b[5] - b[1] * b[4]);
    let phi = (0.5 * determinant).clamp(-1.0, 1.0).acos() / 3.0;
    let least = q + 2.0 * p * (phi + 2.0 * PI / 3.0).cos();
    // The difference is small beside q when one stretch is.
    least.max(0.0).sqrt()
}

/// Whether the smallest stretches of eight particles are seen without effort to be above `least` (< 1):
/// |C - I| <= 1 - least^2 says so.
pub(super) fn is_above(f: &Block<9>, least: f64) -> bool {
    simd::run(IsAbove(f, least))
}

struct IsAbove<'a>(&'a Block<9>, f64);

impl Task for IsAbove<'_> {
    type Output = bool;

    #[inline(always)]
    fn run<S: Simd>(self) -> bool {
        let f: [S; 9] = self.0.load();
        let one = S::splat(1.0);
        let mut sum = S::splat(0.0);
        for i in 0..3 {
            for j in 0..3 {
                let c = dot([f[i], f[3 + i], f[6 + i]], [f[j], f[3 + j], f[6 + j]]);
                let e = if i == j { c - one } else { c };
                sum = e.mul_add(e, sum);
            }
        }
        let most = S::splat((1.0 - self.1 * self.1).powi(2));
        S::bits(sum.lt(most)).count_ones() as usize == LANES
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// F = R diag(stretches), R about an axis in space.
    fn turned(stretches: [f64; 3]) -> [f64; 9] {
        let (s, c) = 0.7_f64.sin_cos();
        let (t, d) = 1.1_f64.sin_cos();
        let r = [c, -s, 0.0, d * s, d * c, -t, t * s, t * c, d];
        std::array::from_fn(|k| r[k] * stretches[k % 3])
    }

    #[test]
    fn smallest_stretch_of_a_turned_stretch() {
        for stretches in [
            [1.0, 1.0, 1.0],
            [1.8, 0.3, 1.0],
            [0.9, 1.0, 1.0],
            [2.0, 2.0, 0.5],
        ] {
            let f = turned(stretches);
            let least = stretches.iter().copied().fold(9.0, f64::min);
            assert!((smallest(&f) - least).abs() < 1e-7, "{}", smallest(&f));
            let block = Block(f.map(|x| [x; LANES]));
            assert!(!is_above(&block, 0.8) || least > 0.8);
        }
        assert!(is_above(&Block(turned([1.0; 3]).map(|x| [x; LANES])), 0.8));
    }
}
