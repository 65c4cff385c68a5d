//! Tables of reference data: CSV with a header, looked up by the first column.

use super::Failure;

/// A table; the first column ascends.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Columns {
    names: Vec<String>,
    rows: Vec<Vec<f64>>,
}

impl Columns {
    /// Reads a table.
    pub(super) fn parse(text: &str) -> Result<Self, Failure> {
        let mut lines = text.lines();
        let names: Vec<String> = (lines.next().unwrap_or_default().split(','))
            .map(str::to_owned)
            .collect();
        let row = |line: &str| -> Option<Vec<f64>> {
            let row: Option<Vec<f64>> = line.split(',').map(|x| x.parse().ok()).collect();
            row.filter(|r| r.len() == names.len())
        };
        let rows: Option<Vec<Vec<f64>>> = lines.map(row).collect();
        match rows {
            Some(rows) if rows.len() > 1 => Ok(Self { names, rows }),
            _ => Err(Failure::Absent(format!(
                "the reference table with columns {} is damaged",
                names.join(", ")
            ))),
        }
    }

    /// Place of a column.
    fn place(&self, name: &str) -> Result<usize, Failure> {
        let found = self.names.iter().position(|n| n == name);
        found.ok_or_else(|| Failure::Absent(format!("the reference has no column `{name}`")))
    }

    /// The first and another column, in other units: (x x_unit, y y_unit).
    pub(super) fn curve(
        &self,
        name: &str,
        x_unit: f64,
        y_unit: f64,
    ) -> Result<Vec<[f64; 2]>, Failure> {
        let place = self.place(name)?;
        let point = |row: &Vec<f64>| [x_unit * row[0], y_unit * row[place]];
        Ok(self.rows.iter().map(point).collect())
    }
}

/// Linear interpolation in a curve whose x ascends; beyond its ends the last pieces go on.
pub(super) fn interpolate(curve: &[[f64; 2]], x: f64) -> f64 {
    let after = curve.partition_point(|p| p[0] < x);
    let i = after.clamp(1, curve.len() - 1);
    let ([x0, y0], [x1, y1]) = (curve[i - 1], curve[i]);
    y0 + (y1 - y0) * (x - x0) / (x1 - x0)
}

/// Largest size of y.
pub(super) fn peak(curve: &[[f64; 2]]) -> f64 {
    curve.iter().fold(0.0, |m: f64, p| m.max(p[1].abs()))
}

/// Mean and largest error of a curve, in units of the peak of its reference, and where it is largest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct CurveError {
    pub(super) mean: f64,
    pub(super) largest: f64,
    pub(super) place: f64,
}

impl CurveError {
    pub(super) fn of(curve: &[[f64; 2]], reference: &[[f64; 2]]) -> Self {
        let peak = peak(reference);
        let mut sum = 0.0;
        let mut error = Self {
            mean: f64::NAN,
            largest: 0.0,
            place: f64::NAN,
        };
        for p in curve {
            let e = (p[1] - interpolate(reference, p[0])).abs() / peak;
            sum += e;
            // Not a number counts as the largest.
            if e.is_nan() || e > error.largest {
                (error.largest, error.place) = (e, p[0]);
            }
        }
        error.mean = sum / curve.len() as f64;
        error
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_are_read_and_interpolated() {
        let table = Columns::parse("x_mm,y,z\n0,1,5\n1,3,6\n").unwrap();
        let curve = table.curve("y", 1e-3, 2.0).unwrap();
        assert_eq!(curve, [[0.0, 2.0], [1e-3, 6.0]]);
        assert!((interpolate(&curve, 0.5e-3) - 4.0).abs() < 1e-12);
        assert!(table.curve("w", 1.0, 1.0).is_err());
        assert!(Columns::parse("x,y\n0,1\n1\n").is_err());
    }

    #[test]
    fn errors_are_shares_of_the_peak() {
        let reference = [[0.0, 0.0], [1.0, -4.0]];
        let error = CurveError::of(&[[0.5, -2.4], [1.0, -4.0]], &reference);
        assert!((error.largest - 0.1).abs() < 1e-12 && (error.mean - 0.05).abs() < 1e-12);
        assert_eq!(error.place, 0.5);
        assert!(
            CurveError::of(&[[0.5, f64::NAN]], &reference)
                .largest
                .is_nan()
        );
    }
}
