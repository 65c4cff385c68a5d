//! The implicit method for stiff walls (viscosity times wall speed far above inertia): Radau IIA of order 5, L-stable.
//!
//! Source: Hairer and Wanner, Solving Ordinary Differential Equations II, 2nd ed. 1996, section IV.8, with its error
//! estimate of order 3. Two unknowns and three stages: Newton on all six with a dense elimination.

use super::dense::RADAU_C as C;
use super::{DenseStep, Rates, Start, Tolerance, Trial, Values};

const S6: f64 = 2.449_489_742_783_178;
const A: [[f64; 3]; 3] = [
    [
        (88.0 - 7.0 * S6) / 360.0,
        (296.0 - 169.0 * S6) / 1800.0,
        (-2.0 + 3.0 * S6) / 225.0,
    ],
    [
        (296.0 + 169.0 * S6) / 1800.0,
        (88.0 + 7.0 * S6) / 360.0,
        (-2.0 - 3.0 * S6) / 225.0,
    ],
    [(16.0 - S6) / 36.0, (16.0 + S6) / 36.0, 1.0 / 9.0],
];
/// Weights of the error estimate.
const E: [f64; 3] = [
    (-13.0 - 7.0 * S6) / 3.0,
    (-13.0 + 7.0 * S6) / 3.0,
    -1.0 / 3.0,
];
/// Real eigenvalue of the inverse of A: 3 + 9^(1/3) - 3^(1/3).
const GAMMA: f64 = 3.637_834_252_744_496;
const NEWTON_STEPS: usize = 12;

/// Tries a step of length `h`.
pub(crate) fn implicit_step(
    law: &impl Rates,
    start: &Start,
    h: f64,
    tolerance: &Tolerance,
    direction: f64,
) -> Trial {
    let jacobian = jacobian(law, start, tolerance);
    let failed = Trial {
        values: start.values,
        error: f64::INFINITY,
        factor: 0.25,
        stiffness: f64::INFINITY,
        turned: false,
        dense: DenseStep::empty(start, h),
    };
    let Some(stages) = solve_stages(law, start, h, tolerance, &jacobian) else {
        return failed;
    };
    let z = increments(law, start, h, &stages);
    let end: Values = std::array::from_fn(|i| start.values[i] + z[2][i]);
    let error = error(start, &end, &z, h, tolerance, &jacobian);
    if !error.is_finite() {
        return failed;
    }
    Trial {
        values: end,
        error,
        factor: (0.9 * error.max(1e-30).powf(-0.25)).clamp(0.2, 6.0),
        stiffness: h * jacobian[1].abs(),
        turned: z.iter().any(|z| (start.values[1] + z[1]) * direction < 0.0),
        dense: DenseStep::implicit(start, h, z),
    }
}

/// Derivatives of the acceleration with radius and velocity, by differences.
fn jacobian(law: &impl Rates, start: &Start, tolerance: &Tolerance) -> [f64; 2] {
    let [radius, velocity] = [start.values[0], start.values[1]];
    let step = 1e-7 * radius;
    let by_radius = (law.rates(start.time, radius + step, velocity)[1] - start.rates[1]) / step;
    let step = 1e-7 * velocity.abs().max(1e3 * tolerance.velocity_floor);
    let by_velocity = (law.rates(start.time, radius, velocity + step)[1] - start.rates[1]) / step;
    [by_radius, by_velocity]
}

/// Radius and velocity increments of the stages: Z = h A f(start + Z).
fn solve_stages(
    law: &impl Rates,
    start: &Start,
    h: f64,
    tolerance: &Tolerance,
    jacobian: &[f64; 2],
) -> Option<[[f64; 2]; 3]> {
    let mut z = [[0.0; 2]; 3];
    for (row, c) in z.iter_mut().zip(C) {
        *row = [c * h * start.values[1], 0.0];
    }
    let mut smallest = f64::INFINITY;
    for _ in 0..NEWTON_STEPS {
        let (mut matrix, residual) = newton_system(law, start, h, jacobian, &z);
        let change = eliminate(&mut matrix, residual)?;
        let end = [
            start.values[0] + z[2][0],
            start.values[1] + z[2][1],
            0.0,
            0.0,
            0.0,
        ];
        let scale = tolerance.scales(start, &end, h);
        let mut size: f64 = 0.0;
        for i in 0..6 {
            z[i / 2][i % 2] += change[i];
            size = size.max(change[i].abs() / scale[i % 2]);
        }
        if size < 1e-2 {
            return Some(z);
        }
        if !size.is_finite() || size > 1e3 * smallest {
            return None;
        }
        smallest = smallest.min(size);
    }
    None
}

fn newton_system(
    law: &impl Rates,
    start: &Start,
    h: f64,
    jacobian: &[f64; 2],
    z: &[[f64; 2]; 3],
) -> ([[f64; 6]; 6], [f64; 6]) {
    let mut matrix = [[0.0; 6]; 6];
    let mut residual = [0.0; 6];
    let rates: [Values; 3] = std::array::from_fn(|j| {
        let [dr, dv] = z[j];
        law.rates(
            start.time + C[j] * h,
            start.values[0] + dr,
            start.values[1] + dv,
        )
    });
    for i in 0..3 {
        residual[2 * i] = -z[i][0];
        residual[2 * i + 1] = -z[i][1];
        matrix[2 * i][2 * i] = 1.0;
        matrix[2 * i + 1][2 * i + 1] = 1.0;
        for j in 0..3 {
            let weight = h * A[i][j];
            residual[2 * i] += weight * rates[j][0];
            residual[2 * i + 1] += weight * rates[j][1];
            matrix[2 * i][2 * j + 1] -= weight;
            matrix[2 * i + 1][2 * j] -= weight * jacobian[0];
            matrix[2 * i + 1][2 * j + 1] -= weight * jacobian[1];
        }
    }
    (matrix, residual)
}

/// Gaussian elimination with partial pivoting; `None` if singular or not finite.
fn eliminate(m: &mut [[f64; 6]; 6], mut b: [f64; 6]) -> Option<[f64; 6]> {
    for column in 0..6 {
        let pivot =
            (column..6).max_by(|&a, &b| m[a][column].abs().total_cmp(&m[b][column].abs()))?;
        m.swap(column, pivot);
        b.swap(column, pivot);
        let diagonal = m[column][column];
        if !diagonal.is_finite() || diagonal == 0.0 {
            return None;
        }
        for row in column + 1..6 {
            let factor = m[row][column] / diagonal;
            let above = m[column];
            for (entry, over) in m[row].iter_mut().zip(above) {
                *entry -= factor * over;
            }
            b[row] -= factor * b[column];
        }
    }
    for row in (0..6).rev() {
        for k in row + 1..6 {
            b[row] -= m[row][k] * b[k];
        }
        b[row] /= m[row][row];
    }
    b.iter().all(|x| x.is_finite()).then_some(b)
}

/// Increments of all five components at the stages.
fn increments(law: &impl Rates, start: &Start, h: f64, z: &[[f64; 2]; 3]) -> [Values; 3] {
    let rates: [Values; 3] = std::array::from_fn(|j| {
        let [dr, dv] = z[j];
        law.rates(
            start.time + C[j] * h,
            start.values[0] + dr,
            start.values[1] + dv,
        )
    });
    std::array::from_fn(|i| {
        std::array::from_fn(|k| match k {
            0 | 1 => z[i][k],
            _ => h * (0..3).map(|j| A[i][j] * rates[j][k]).sum::<f64>(),
        })
    })
}

/// Error over tolerance: (gamma/h - J)^-1 (f + E Z/h), filtered so that stiff parts do not count.
fn error(
    start: &Start,
    end: &Values,
    z: &[Values; 3],
    h: f64,
    tolerance: &Tolerance,
    jacobian: &[f64; 2],
) -> f64 {
    if end[0] <= 0.0 {
        return f64::INFINITY;
    }
    let right: [f64; 2] = std::array::from_fn(|i| {
        start.rates[i] + (E[0] * z[0][i] + E[1] * z[1][i] + E[2] * z[2][i]) / h
    });
    let g = GAMMA / h;
    let determinant = g * (g - jacobian[1]) - jacobian[0];
    let radius = ((g - jacobian[1]) * right[0] + right[1]) / determinant;
    let velocity = (g * right[1] + jacobian[0] * right[0]) / determinant;
    let scale = tolerance.scales(start, end, h);
    (0.5 * ((radius / scale[0]).powi(2) + (velocity / scale[1]).powi(2))).sqrt()
}
