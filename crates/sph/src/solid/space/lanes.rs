//! 3x3 tensors of eight particles.
//!
//! Loops over components are written out: what `map` calls may stay outside of the instructions that `simd::run` turns on.

use crate::simd::Simd;

/// A vector.
pub(super) type Vector<S> = [S; 3];

/// A matrix, rows first.
pub(super) type Matrix<S> = [S; 9];

/// A symmetric tensor: xx, yy, zz, xy, xz, yz, as in `Sym3`.
pub(super) type Symmetric<S> = [S; 6];

/// Component of a symmetric tensor in row i, column j.
pub(super) const AT: [[usize; 3]; 3] = [[0, 3, 4], [3, 1, 5], [4, 5, 2]];

#[inline(always)]
pub(super) fn dot<S: Simd>(a: Vector<S>, b: Vector<S>) -> S {
    a[0].mul_add(b[0], a[1].mul_add(b[1], a[2] * b[2]))
}

/// A B.
#[inline(always)]
pub(super) fn product<S: Simd>(a: &Matrix<S>, b: &Matrix<S>) -> Matrix<S> {
    let mut c = *a;
    for i in 0..3 {
        for j in 0..3 {
            let (p, q) = (
                [a[3 * i], a[3 * i + 1], a[3 * i + 2]],
                [b[j], b[j + 3], b[j + 6]],
            );
            c[3 * i + j] = dot(p, q);
        }
    }
    c
}

/// A v.
#[inline(always)]
pub(super) fn apply<S: Simd>(a: &Matrix<S>, v: Vector<S>) -> Vector<S> {
    [
        dot([a[0], a[1], a[2]], v),
        dot([a[3], a[4], a[5]], v),
        dot([a[6], a[7], a[8]], v),
    ]
}

/// The nine components of a symmetric tensor.
#[inline(always)]
pub(super) fn full<S: Simd>(t: &Symmetric<S>) -> Matrix<S> {
    [t[0], t[3], t[4], t[3], t[1], t[5], t[4], t[5], t[2]]
}

/// A B^T, which is known to be symmetric.
#[inline(always)]
pub(super) fn symmetric_product<S: Simd>(a: &Matrix<S>, b: &Matrix<S>) -> Symmetric<S> {
    let mut c = [S::splat(0.0); 6];
    for i in 0..3 {
        for j in i..3 {
            let (p, q) = (3 * i, 3 * j);
            c[AT[i][j]] = dot([a[p], a[p + 1], a[p + 2]], [b[q], b[q + 1], b[q + 2]]);
        }
    }
    c
}

/// Cofactors: A^-1 = cof(A)^T / det A.
#[inline(always)]
pub(super) fn cofactors<S: Simd>(a: &Matrix<S>) -> Matrix<S> {
    let mut c = *a;
    for i in 0..3 {
        for j in 0..3 {
            let (r, s) = (3 * ((i + 1) % 3), 3 * ((i + 2) % 3));
            let (k, l) = ((j + 1) % 3, (j + 2) % 3);
            c[3 * i + j] = a[r + k].mul_add(a[s + l], -(a[r + l] * a[s + k]));
        }
    }
    c
}

/// Determinant of a matrix with these cofactors.
#[inline(always)]
pub(super) fn determinant<S: Simd>(a: &Matrix<S>, cofactors: &Matrix<S>) -> S {
    dot(
        [a[0], a[1], a[2]],
        [cofactors[0], cofactors[1], cofactors[2]],
    )
}

#[inline(always)]
pub(super) fn transposed<S: Simd>(a: &Matrix<S>) -> Matrix<S> {
    [a[0], a[3], a[6], a[1], a[4], a[7], a[2], a[5], a[8]]
}

#[inline(always)]
pub(super) fn times<S: Simd, const N: usize>(mut a: [S; N], factor: S) -> [S; N] {
    for x in &mut a {
        *x = *x * factor;
    }
    a
}

/// Q T Q^T for the rotation Q = (I - W/2)^-1 (I + W/2) of a spin increment W, given by its axial vector: W u = w x u
/// (Hughes and Winget 1980); Q = I + 2 (H + H^2)/(1 + h^2), H = W/2, h = w/2, H^2 = h (x) h - h^2 I.
#[inline(always)]
pub(super) fn rotated<S: Simd>(t: &Symmetric<S>, spin: Vector<S>) -> Symmetric<S> {
    let (one, half) = (S::splat(1.0), S::splat(0.5));
    let h = times(spin, half);
    let square = dot(h, h);
    let scale = S::splat(2.0) / (one + square);
    let mut q = [one; 9];
    for i in 0..3 {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        q[3 * i + i] = scale.mul_add(h[i].mul_add(h[i], -square), one);
        q[3 * i + j] = scale * h[i].mul_add(h[j], -h[k]);
        q[3 * i + k] = scale * h[i].mul_add(h[k], h[j]);
    }
    symmetric_product(&product(&q, &full(t)), &q)
}

/// Von Mises norm of a tensor without trace.
#[inline(always)]
pub(super) fn von_mises<S: Simd>(d: &Symmetric<S>) -> S {
    let normal = dot([d[0], d[1], d[2]], [d[0], d[1], d[2]]);
    let shear = dot([d[3], d[4], d[5]], [d[3], d[4], d[5]]);
    (S::splat(1.5) * (shear + shear + normal)).sqrt()
}
