//! The reference curve.

use super::{C0, R0};
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
}
