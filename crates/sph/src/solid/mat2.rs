//! 2x2 matrices, rows first.

use crate::geometry::Vec2;

/// A 2x2 matrix, `m[row][column]`.
pub type Mat2 = [[f64; 2]; 2];

/// The unit matrix.
pub(super) const UNIT: Mat2 = [[1.0, 0.0], [0.0, 1.0]];

pub(super) fn determinant(m: &Mat2) -> f64 {
    m[0][0] * m[1][1] - m[0][1] * m[1][0]
}

/// The inverse; not finite when the matrix is singular.
pub(super) fn inverse(m: &Mat2) -> Mat2 {
    let k = 1.0 / determinant(m);
    [[m[1][1] * k, -m[0][1] * k], [-m[1][0] * k, m[0][0] * k]]
}

pub(super) fn product(a: &Mat2, b: &Mat2) -> Mat2 {
    let cell = |i: usize, j: usize| a[i][0] * b[0][j] + a[i][1] * b[1][j];
    [[cell(0, 0), cell(0, 1)], [cell(1, 0), cell(1, 1)]]
}

pub(super) fn scaled(m: &Mat2, k: f64) -> Mat2 {
    m.map(|row| row.map(|x| x * k))
}

pub(super) fn combine(a: &Mat2, ka: f64, b: &Mat2, kb: f64) -> Mat2 {
    let cell = |i: usize, j: usize| ka * a[i][j] + kb * b[i][j];
    [[cell(0, 0), cell(0, 1)], [cell(1, 0), cell(1, 1)]]
}

pub(super) fn apply(m: &Mat2, v: Vec2) -> Vec2 {
    [
        m[0][0] * v[0] + m[0][1] * v[1],
        m[1][0] * v[0] + m[1][1] * v[1],
    ]
}

/// S M S for a reflection S of either axis: the off-diagonal elements change sign.
pub(super) fn mirrored(m: &Mat2) -> Mat2 {
    [[m[0][0], -m[0][1]], [-m[1][0], m[1][1]]]
}

/// Smallest principal stretch of a deformation gradient: its smaller singular value.
pub(super) fn smallest_stretch(f: &Mat2) -> f64 {
    let [sum, difference] = singular_values(f);
    0.5 * (sum - difference)
}

/// Largest principal stretch of a deformation gradient.
pub(super) fn largest_stretch(f: &Mat2) -> f64 {
    let [sum, difference] = singular_values(f);
    0.5 * (sum + difference)
}

/// Sum and difference of the singular values.
fn singular_values(f: &Mat2) -> Vec2 {
    let square = f.iter().flatten().map(|x| x * x).sum::<f64>();
    let j = determinant(f);
    // (s1 + s2)^2 = square + 2 |j|, (s1 - s2)^2 = square - 2 |j|.
    let sum = (square + 2.0 * j.abs()).sqrt();
    let difference = (square - 2.0 * j.abs()).max(0.0).sqrt();
    [sum, difference]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn smallest_stretch_of_a_turned_stretch() {
        let (s, c) = 0.7_f64.sin_cos();
        let turn = [[c, -s], [s, c]];
        let f = product(&turn, &product(&[[1.8, 0.0], [0.0, 0.3]], &turn));
        assert!((smallest_stretch(&f) - 0.3).abs() < 1e-14);
        assert!((largest_stretch(&f) - 1.8).abs() < 1e-14);
        assert!((smallest_stretch(&UNIT) - 1.0).abs() < 1e-14);
    }
}
