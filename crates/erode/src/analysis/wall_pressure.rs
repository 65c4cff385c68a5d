//! Pressure at the wall over time and distance from the axis, as `surface/wall_pressure.csv` has it.

use crate::output::Table;

/// Pressure over time and radius.
#[derive(Debug, Clone, PartialEq)]
pub struct WallPressure {
    /// Instants, s, increasing.
    pub time: Vec<f64>,
    /// Distances from the axis, m, increasing.
    pub radius: Vec<f64>,
    /// `pressure[radius][time]`, Pa.
    pub pressure: Vec<Vec<f64>>,
}

impl WallPressure {
    /// From a table with `time` and columns named `r=1.25e-06`; none without rows or such columns.
    #[must_use]
    pub fn of(table: &Table) -> Option<Self> {
        let mut columns: Vec<(f64, &Vec<f64>)> = table
            .columns
            .iter()
            .zip(&table.values)
            .filter_map(|(c, values)| Some((c.name.strip_prefix("r=")?.parse().ok()?, values)))
            .collect();
        columns.sort_by(|a, b| a.0.total_cmp(&b.0));
        let time = table.column("time")?.to_vec();
        let (radius, pressure): (Vec<f64>, Vec<Vec<f64>>) =
            columns.into_iter().map(|(r, p)| (r, p.clone())).unzip();
        (!radius.is_empty() && !time.is_empty()).then_some(Self {
            time,
            radius,
            pressure,
        })
    }

    /// Largest pressure at each radius, Pa, with its time, s.
    #[must_use]
    pub fn peaks(&self) -> Vec<[f64; 2]> {
        let peak = |p: &Vec<f64>| {
            let all = p.iter().zip(&self.time).filter(|(p, _)| p.is_finite());
            let best = all.max_by(|a, b| a.0.total_cmp(b.0));
            best.map_or([f64::NAN; 2], |(p, t)| [*p, *t])
        };
        self.pressure.iter().map(peak).collect()
    }

    /// Pressure along the wall at the row nearest to `time`: (radius, pressure).
    #[must_use]
    pub fn profile(&self, time: f64) -> Vec<[f64; 2]> {
        let row = crate::report::map::nearest(&self.time, time);
        let at = |(r, p): (&f64, &Vec<f64>)| [*r, p[row]];
        self.radius.iter().zip(&self.pressure).map(at).collect()
    }

    /// Index of the radius nearest to `r`.
    #[must_use]
    pub fn nearest(&self, r: f64) -> usize {
        crate::report::map::nearest(&self.radius, r)
    }
}
