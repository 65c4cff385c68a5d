//! The explicit method of order 8 with an error estimate from orders 5 and 3 (DOP853 of Hairer, Norsett and Wanner).

use super::dop853_table::{A, B, C, D, E3, E5, EXTRA, Weights};
use super::{DenseStep, Rates, Start, Tolerance, Trial, Values};

/// Stages of a step.
type Stages = [Values; 16];

/// Tries a step of length `h`. With `dense` the coefficients of dense output are filled.
pub(crate) fn explicit_step(
    law: &impl Rates,
    start: &Start,
    h: f64,
    tolerance: &Tolerance,
    direction: f64,
    dense: bool,
) -> Trial {
    let mut k: Stages = [[0.0; 5]; 16];
    k[0] = start.rates;
    let mut last_velocity = 0.0;
    for (i, weights) in A.iter().enumerate() {
        let [radius, velocity] = stage(start, &k, h, weights);
        last_velocity = velocity;
        k[i + 1] = law.rates(start.time + C[i + 1] * h, radius, velocity);
    }
    let end = combined(start, &k, h, B);
    k[12] = law.rates(start.time + h, end[0], end[1]);
    let error = error(start, &end, &k, h, tolerance);
    let turned = (1..13).any(|i| k[i][0] * direction < 0.0);
    let spread = (end[1] - last_velocity).abs();
    let stiffness = if spread > 0.0 {
        h * (k[12][1] - k[11][1]).abs() / spread
    } else {
        0.0
    };
    let mut trial = Trial {
        values: end,
        error,
        factor: factor(error),
        stiffness,
        turned,
        dense: DenseStep::empty(start, h),
    };
    if dense && error.is_finite() {
        trial.dense = coefficients(law, start, &end, &mut k, h);
    }
    trial
}

/// Radius and velocity of a stage.
#[inline]
fn stage(start: &Start, k: &Stages, h: f64, weights: Weights) -> [f64; 2] {
    let (mut radius, mut velocity) = (0.0, 0.0);
    for &(j, w) in weights {
        radius += w * k[j][0];
        velocity += w * k[j][1];
    }
    [start.values[0] + h * radius, start.values[1] + h * velocity]
}

/// start + h sum of weights times stages.
#[inline]
fn combined(start: &Start, k: &Stages, h: f64, weights: Weights) -> Values {
    let sum = weighted(k, weights);
    std::array::from_fn(|i| start.values[i] + h * sum[i])
}

#[inline]
fn weighted(k: &Stages, weights: Weights) -> Values {
    let mut sum = [0.0; 5];
    for &(j, w) in weights {
        for (s, value) in sum.iter_mut().zip(&k[j]) {
            *s += w * value;
        }
    }
    sum
}

/// Error over tolerance as in DOP853: the estimate of order 5, damped by that of order 3.
fn error(start: &Start, end: &Values, k: &Stages, h: f64, tolerance: &Tolerance) -> f64 {
    let scale = tolerance.scales(start, end, h);
    let (mut fifth, mut third) = (0.0, 0.0);
    for i in 0..2 {
        let e5: f64 = E5.iter().map(|&(j, w)| w * k[j][i]).sum();
        let e3: f64 = E3.iter().map(|&(j, w)| w * k[j][i]).sum();
        fifth += (e5 / scale[i]).powi(2);
        third += (e3 / scale[i]).powi(2);
    }
    if fifth == 0.0 && third == 0.0 {
        return 0.0;
    }
    let error = h.abs() * fifth / (2.0 * (fifth + 0.01 * third)).sqrt();
    if error.is_finite() && k[12][1].is_finite() && end[0] > 0.0 {
        error
    } else {
        f64::INFINITY
    }
}

/// Change of the step size: between 1/3 and 6, with a safety of 0.9.
fn factor(error: f64) -> f64 {
    if error.is_infinite() {
        return 0.25;
    }
    let factor = 0.9 * error.max(1e-30).powf(-0.125);
    factor.clamp(1.0 / 3.0, 6.0)
}

/// Dense output of order 7 (three more rates).
fn coefficients(
    law: &impl Rates,
    start: &Start,
    end: &Values,
    k: &mut Stages,
    h: f64,
) -> DenseStep {
    for (i, weights) in EXTRA.iter().enumerate() {
        let [radius, velocity] = stage(start, k, h, weights);
        k[13 + i] = law.rates(start.time + C[13 + i] * h, radius, velocity);
    }
    let mut f = [[0.0; 5]; 7];
    for i in 0..5 {
        let change = end[i] - start.values[i];
        f[0][i] = change;
        f[1][i] = h * k[0][i] - change;
        f[2][i] = 2.0 * change - h * (k[12][i] + k[0][i]);
    }
    for (row, weights) in f[3..].iter_mut().zip(D) {
        *row = weighted(k, weights).map(|x| h * x);
    }
    DenseStep::explicit(start, h, f)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The weights fulfil sum b c^q = 1/(q + 1) up to order 8 and every stage sits at its time.
    #[test]
    fn quadrature_conditions() {
        for q in 0..8 {
            let sum: f64 = B.iter().map(|&(j, w)| w * C[j].powi(q)).sum();
            assert!((sum - 1.0 / f64::from(q + 1)).abs() < 1e-14, "order {q}");
        }
        for (i, weights) in A.iter().enumerate() {
            let sum: f64 = weights.iter().map(|&(_, w)| w).sum();
            assert!((sum - C[i + 1]).abs() < 1e-13, "stage {i}");
        }
        for (i, weights) in EXTRA.iter().enumerate() {
            let sum: f64 = weights.iter().map(|&(_, w)| w).sum();
            assert!((sum - C[13 + i]).abs() < 1e-13, "extra stage {i}");
        }
    }

    struct Oscillator;

    impl Rates for Oscillator {
        fn rates(&self, time: f64, radius: f64, velocity: f64) -> Values {
            [velocity, 1.0 - radius, velocity * velocity, time.cos(), 0.0]
        }
    }

    fn error_of(steps: u32) -> (f64, f64) {
        let h = 3.0 / f64::from(steps);
        let tolerance = Tolerance {
            relative: 1.0,
            velocity_floor: 1.0,
        };
        let mut values = [1.5, 0.0, 0.0, 0.0, 0.0];
        let mut middle: f64 = 0.0;
        for i in 0..steps {
            let time = f64::from(i) * h;
            let start = Start {
                time,
                values,
                rates: Oscillator.rates(time, values[0], values[1]),
            };
            let trial = explicit_step(&Oscillator, &start, h, &tolerance, 0.0, true);
            let inside = trial.dense.at_fraction(0.37);
            middle = middle.max((inside[0] - 1.0 - 0.5 * (time + 0.37 * h).cos()).abs());
            values = trial.values;
        }
        let exact = 0.125 * (3.0 - 3.0_f64.sin() * 3.0_f64.cos());
        assert!((values[3] - 3.0_f64.sin()).abs() < 1e-5 && (values[2] - exact).abs() < 1e-5);
        ((values[0] - 1.0 - 0.5 * 3.0_f64.cos()).abs(), middle)
    }

    /// Halving the step divides the error by 2^8 at the end and 2^8 (local order of the dense output) inside.
    #[test]
    fn eighth_order_and_dense_output_of_seventh() {
        let (coarse, coarse_inside) = error_of(3);
        let (fine, fine_inside) = error_of(6);
        assert!((coarse / fine).log2() > 7.5, "{coarse:e} {fine:e}");
        let inside = (coarse_inside / fine_inside).log2();
        assert!(inside > 7.0, "{coarse_inside:e} {fine_inside:e}");
    }
}
