//! The reference curve.

use super::collapse::{C0, Collapse, R0};
use crate::validate::Failure;

const DATA: &str = include_str!("../../../../../validation/rayleigh-collapse/radius_of_time.csv");

/// One row: times in s, speed in m/s (positive inwards).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Row {
    /// R/R0.
    pub(super) radius: f64,
    pub(super) time: f64,
    pub(super) speed: f64,
    /// Time of the incompressible collapse.
    pub(super) rayleigh: f64,
}

/// Rows by falling radius.
pub(super) struct Reference {
    pub(super) rows: Vec<Row>,
}

pub(super) fn read() -> Result<Reference, Failure> {
    let wrong =
        |line: &str| Failure::Absent(format!("a row of the reference is not understood: {line}"));
    let row = |line: &str| -> Result<Row, Failure> {
        let cells: Vec<&str> = line.split(',').collect();
        let cell = |k: usize| -> Result<f64, Failure> {
            let parsed = cells.get(k).and_then(|c| c.trim().parse().ok());
            parsed.ok_or_else(|| wrong(line))
        };
        Ok(Row {
            radius: cell(0)?,
            time: cell(5)?,
            speed: -cell(7)?,
            rayleigh: cell(8)? * R0 / C0,
        })
    };
    let rows = DATA.lines().skip(1).map(row).collect::<Result<_, _>>()?;
    Ok(Reference { rows })
}

impl Reference {
    /// Rows with radii within a range, R/R0.
    pub(super) fn between(&self, low: f64, high: f64) -> impl Iterator<Item = &Row> {
        let inside = move |r: &&Row| r.radius > low - 1e-9 && r.radius < high + 1e-9;
        self.rows.iter().filter(inside)
    }

    /// The row of a radius of the table.
    pub(super) fn at(&self, radius: f64) -> Result<&Row, Failure> {
        let row = self.between(radius, radius).next();
        row.ok_or_else(|| Failure::Absent(format!("the reference has no row for R = {radius} R0")))
    }

    /// Largest radius of the table below 0.9 R0 at which the speed of a run is wrong by more than `share`, R/R0; where it
    /// never is, the smallest radius at which it is known.
    pub(super) fn speed_lost(&self, run: &Collapse, share: f64) -> f64 {
        let mut last = f64::NAN;
        for row in self.between(0.0, 0.9) {
            let Ok(speed) = run.speed_at(row.radius) else {
                return last;
            };
            last = row.radius;
            if (speed / row.speed - 1.0).abs() > share {
                return last;
            }
        }
        last
    }
}

#[cfg(test)]
mod tests {
    use super::super::history::{Sample, speed_at, time_at};
    use super::*;

    /// Times and speeds read from the reference curve itself, finely sampled, are those of its table.
    #[test]
    fn readings_of_a_known_curve_are_right() {
        let reference = read().unwrap();
        let point = |time: f64, radius: f64| Sample {
            time,
            radius,
            roundness: 0.0,
            energy: 0.0,
            balance: 0.0,
        };
        // Between rows R^(5/2) is nearly linear in time.
        let mut samples = Vec::new();
        for w in reference.rows.windows(2).filter(|w| w[1].radius > 0.1) {
            let power = |k: usize| w[k].radius.powf(2.5);
            for k in 0..4 {
                let f = f64::from(k) / 4.0;
                let radius = ((1.0 - f) * power(0) + f * power(1)).powf(0.4);
                samples.push(point((1.0 - f) * w[0].time + f * w[1].time, radius));
            }
        }
        for row in reference.between(0.2, 0.9) {
            let time = time_at(&samples, row.radius).unwrap();
            assert!((time / row.time - 1.0).abs() < 1e-6);
            let speed = speed_at(&samples, row.radius).unwrap() * R0;
            // The fit spans 6 % of the radius to each side; its tolerance is small beside the 6 % asked of a run.
            let error = speed / row.speed - 1.0;
            let tolerance = if row.radius > 0.8 { 0.05 } else { 0.01 };
            assert!(error.abs() < tolerance, "{} {error}", row.radius);
        }
    }
}
