//! Values inside a step.

use super::{Start, Values};

/// A step with its values in between: order 7 inside explicit steps, 3 inside implicit ones.
#[derive(Debug, Clone, Copy)]
pub struct DenseStep {
    start_time: f64,
    length: f64,
    values: Values,
    form: Form,
}

#[derive(Debug, Clone, Copy)]
enum Form {
    Empty,
    Explicit([Values; 7]),
    Implicit([Values; 3]),
}

/// Times of the stages of Radau IIA.
pub(super) const RADAU_C: [f64; 3] = [0.155_051_025_721_682_2, 0.644_948_974_278_317_8, 1.0];

impl DenseStep {
    pub(super) fn empty(start: &Start, length: f64) -> Self {
        Self::new(start, length, Form::Empty)
    }

    pub(super) fn explicit(start: &Start, length: f64, coefficients: [Values; 7]) -> Self {
        Self::new(start, length, Form::Explicit(coefficients))
    }

    pub(super) fn implicit(start: &Start, length: f64, stages: [Values; 3]) -> Self {
        Self::new(start, length, Form::Implicit(stages))
    }

    fn new(start: &Start, length: f64, form: Form) -> Self {
        Self {
            start_time: start.time,
            length,
            values: start.values,
            form,
        }
    }

    /// Start of the step, s.
    #[must_use]
    pub fn start_time(&self) -> f64 {
        self.start_time
    }

    /// End of the step, s.
    #[must_use]
    pub fn end_time(&self) -> f64 {
        self.start_time + self.length
    }

    /// Radius (m), wall velocity (m/s) and the ledger (viscous, radiated, driven, J) at a time (s) within the step.
    #[must_use]
    pub fn at(&self, time: f64) -> [f64; 5] {
        self.at_fraction((time - self.start_time) / self.length)
    }

    /// The same at a fraction of the step, from 0 to 1.
    #[must_use]
    pub fn at_fraction(&self, x: f64) -> [f64; 5] {
        match &self.form {
            Form::Empty => self.values,
            Form::Explicit(f) => self.explicit_at(f, x),
            Form::Implicit(z) => self.implicit_at(z, x),
        }
    }

    fn explicit_at(&self, f: &[Values; 7], x: f64) -> Values {
        std::array::from_fn(|i| {
            let mut value = 0.0;
            for (j, row) in f.iter().rev().enumerate() {
                value = (value + row[i]) * if j % 2 == 0 { x } else { 1.0 - x };
            }
            self.values[i] + value
        })
    }

    /// The cubic through the start and the three stages.
    fn implicit_at(&self, z: &[Values; 3], x: f64) -> Values {
        let c = RADAU_C;
        let weight = |j: usize, a: usize, b: usize| {
            x * (x - c[a]) * (x - c[b]) / (c[j] * (c[j] - c[a]) * (c[j] - c[b]))
        };
        let w = [weight(0, 1, 2), weight(1, 0, 2), weight(2, 0, 1)];
        std::array::from_fn(|i| self.values[i] + w[0] * z[0][i] + w[1] * z[1][i] + w[2] * z[2][i])
    }
}
