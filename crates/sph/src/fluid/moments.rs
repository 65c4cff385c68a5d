//! The symmetric moment matrix of kernel gradients and its inverse.

use crate::fluid::pair::dot;
use crate::simd::Simd;

/// Matrix of `D` rows.
pub(crate) type Matrix<const D: usize, T = f64> = [[T; D]; D];

/// Inverse of the symmetric M = -sum A_b (x_a - x_b) (x) grad W, of which the cells on and above the diagonal are read;
/// eigenvalues below `FLOOR` are lifted, so that a particle with too few neighbours falls back to the uncorrected gradient
/// instead of an arbitrary one. `smallest` is the smallest eigenvalue.
#[inline(always)]
pub(crate) fn inverse<S: Simd, const D: usize>(m: &Matrix<D, S>, smallest: S) -> Matrix<D, S> {
    let lift = (S::splat(FLOOR) - smallest).max(S::splat(0.0));
    let mut lifted = *m;
    for k in 0..D {
        lifted[k][k] = m[k][k] + lift;
    }
    let (adjugate, determinant) = adjugate(&lifted);
    let inverse = S::splat(1.0) / determinant;
    let mut result = adjugate;
    for i in 0..D {
        for j in 0..D {
            result[i][j] = adjugate[i.min(j)][i.max(j)] * inverse;
        }
    }
    result
}

/// Below this eigenvalue the moment matrix is regularised.
const FLOOR: f64 = 0.2;

/// Cells on and above the diagonal of the adjugate of a symmetric matrix; its determinant.
#[inline(always)]
fn adjugate<S: Simd, const D: usize>(m: &Matrix<D, S>) -> (Matrix<D, S>, S) {
    let mut a = *m;
    if D == 2 {
        (a[0][0], a[0][1], a[1][1]) = (m[1][1], -m[0][1], m[0][0]);
        (a, m[0][0] * m[1][1] - m[0][1] * m[0][1])
    } else {
        let ([xx, xy, xz], [yy, yz, zz]) =
            ([m[0][0], m[0][1], m[0][2]], [m[1][1], m[1][2], m[2][2]]);
        a[0][0] = yy * zz - yz * yz;
        a[0][1] = xz * yz - xy * zz;
        a[0][2] = xy * yz - xz * yy;
        a[1][1] = xx * zz - xz * xz;
        a[1][2] = xy * xz - xx * yz;
        a[2][2] = xx * yy - xy * xy;
        (a, xx * a[0][0] + xy * a[0][1] + xz * a[0][2])
    }
}

/// Newton steps towards the smallest eigenvalue in three dimensions: to rounding where it is a single one, to 2e-4 of the
/// spread of the eigenvalues where two are equal.
const NEWTON_STEPS: usize = 12;

/// Smallest eigenvalue of a symmetric matrix, of which the cells on and above the diagonal are read.
#[inline(always)]
pub(crate) fn smallest_eigenvalue<S: Simd, const D: usize>(m: &Matrix<D, S>) -> S {
    let half = S::splat(0.5);
    if D == 2 {
        let difference = half * (m[0][0] - m[1][1]);
        let radius = difference.mul_add(difference, m[0][1] * m[0][1]).sqrt();
        return half * (m[0][0] + m[1][1]) - radius;
    }
    // Of the deviator B: x^3 - 3 q x - 2 r = 0 with 3 q = |B|^2/2 and 2 r = det B; all roots lie in +-2 sqrt(q), and left of
    // them Newton's method climbs to the smallest.
    let mean = S::splat(1.0 / 3.0) * (m[0][0] + m[1][1] + m[2][2]);
    let mut b = *m;
    for k in 0..D {
        b[k][k] = m[k][k] - mean;
    }
    let off = b[0][1].mul_add(b[0][1], b[0][2].mul_add(b[0][2], b[1][2] * b[1][2]));
    let diagonal = b[0][0].mul_add(b[0][0], b[1][1].mul_add(b[1][1], b[2][2] * b[2][2]));
    let three_q = half.mul_add(diagonal, off);
    let (_, two_r) = adjugate(&b);
    let mut x = -(S::splat(4.0 / 3.0) * three_q).sqrt();
    let (zero, least) = (S::splat(0.0), S::splat(f64::MIN_POSITIVE));
    for _ in 0..NEWTON_STEPS {
        let square = x * x;
        let value = x.mul_add(square - three_q, -two_r);
        let slope = S::splat(3.0).mul_add(square, -three_q).max(least);
        // Below the root the value is negative; above it only by rounding.
        x = x - value.min(zero) / slope;
    }
    mean + x
}

/// Matrix times vector, for eight particles.
#[inline(always)]
pub(crate) fn apply_lanes<S: Simd, const D: usize>(m: &Matrix<D, S>, x: &[S; D]) -> [S; D] {
    let mut result = *x;
    for k in 0..D {
        result[k] = dot(&m[k], x);
    }
    result
}

/// Matrix times vector.
pub(crate) fn apply<const D: usize>(m: &Matrix<D>, x: [f64; D]) -> [f64; D] {
    m.map(|row| crate::geometry::dot(row, x))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simd::{self, LANES, Task};

    struct Both<const D: usize>(Matrix<D>);

    impl<const D: usize> Task for Both<D> {
        type Output = (f64, Matrix<D>);

        #[inline(always)]
        fn run<S: Simd>(self) -> Self::Output {
            let mut m = [[S::splat(0.0); D]; D];
            for i in 0..D {
                for j in 0..D {
                    m[i][j] = S::splat(self.0[i][j]);
                }
            }
            let smallest = smallest_eigenvalue(&m);
            let inverse = inverse(&m, smallest);
            (first(smallest), inverse.map(|row| row.map(first)))
        }
    }

    fn first<S: Simd>(x: S) -> f64 {
        let all: [f64; LANES] = x.store();
        all[0]
    }

    /// The symmetric matrix with these eigenvalues, turned about three axes.
    fn turned(eigenvalues: [f64; 3]) -> Matrix<3> {
        let mut m = [[0.0; 3]; 3];
        for k in 0..3 {
            m[k][k] = eigenvalues[k];
        }
        for (p, q, angle) in [(0, 1, 0.4_f64), (1, 2, 1.1), (0, 2, -0.7)] {
            let (s, c) = angle.sin_cos();
            let mut t = [[0.0; 3]; 3];
            for (k, row) in t.iter_mut().enumerate() {
                row[k] = 1.0;
            }
            (t[p][p], t[p][q], t[q][p], t[q][q]) = (c, -s, s, c);
            let product = |a: Matrix<3>, b: Matrix<3>| {
                [0, 1, 2].map(|i| [0, 1, 2].map(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
            };
            let transposed = [0, 1, 2].map(|i| [0, 1, 2].map(|j| t[j][i]));
            m = product(product(t, m), transposed);
        }
        m
    }

    #[test]
    fn smallest_eigenvalue_and_inverse_in_space() {
        for eigenvalues in [
            [1.0, 0.9, 0.5],
            [0.3, 0.31, 2.0],
            [1.0, 1.0, 1.0],
            [0.7, 0.7, 1.0],
            [0.25, 0.9, 0.9],
        ] {
            let m = turned(eigenvalues);
            let (smallest, inverse) = simd::run(Both(m));
            let expected = eigenvalues.into_iter().fold(f64::INFINITY, f64::min);
            assert!(
                (smallest - expected).abs() < 2e-4,
                "{smallest} for {eigenvalues:?}"
            );
            for i in 0..3 {
                for j in 0..3 {
                    let cell: f64 = (0..3).map(|k| m[i][k] * inverse[k][j]).sum();
                    assert!((cell - f64::from(u8::from(i == j))).abs() < 1e-12);
                }
            }
        }
    }

    #[test]
    fn too_few_neighbours_are_lifted() {
        let (smallest, inverse) = simd::run(Both(turned([0.05, 1.0, 0.8])));
        assert!((smallest - 0.05).abs() < 1e-12);
        // All eigenvalues are lifted by 0.15.
        let trace: f64 = (0..3).map(|k| inverse[k][k]).sum();
        assert!((trace - (1.0 / 0.2 + 1.0 / 1.15 + 1.0 / 0.95)).abs() < 1e-11);
        let (smallest, inverse) = simd::run(Both([[0.6, 0.2], [0.2, 0.9]]));
        assert!((smallest - 0.5).abs() < 1e-15);
        assert!((inverse[0][1] + 0.2 / 0.5).abs() < 1e-15);
    }
}
