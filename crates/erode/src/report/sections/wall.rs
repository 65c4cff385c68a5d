//! Pressure at the wall: against time at several radii, against radius at several instants, and over both.

use crate::output::Table;
use crate::report::colour::{ColourMap, Colouring, robust_range};
use crate::report::html::Page;
use crate::report::instants::Instants;
use crate::report::map::{Map, nearest};
use crate::report::plot::{Axis, Plot};
use crate::report::run_data::{RunData, points};
use crate::report::units::quantity;

/// Pressure over radius and time.
struct WallPressure<'a> {
    time: &'a [f64],
    /// Radii, m, increasing.
    radius: Vec<f64>,
    /// One column per radius.
    pressure: Vec<&'a [f64]>,
}

impl<'a> WallPressure<'a> {
    /// Columns are named `r=1.25e-06`.
    fn of(table: &'a Table) -> Option<Self> {
        let mut columns: Vec<(f64, &[f64])> = table
            .columns
            .iter()
            .zip(&table.values)
            .filter_map(|(c, values)| {
                Some((c.name.strip_prefix("r=")?.parse().ok()?, values.as_slice()))
            })
            .collect();
        columns.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (radius, pressure): (Vec<f64>, Vec<&[f64]>) = columns.into_iter().unzip();
        let time = table.column("time")?;
        (!radius.is_empty() && !time.is_empty()).then_some(Self {
            time,
            radius,
            pressure,
        })
    }

    fn is_zero(&self) -> bool {
        self.pressure.iter().all(|p| p.iter().all(|v| *v == 0.0))
    }

    fn profile(&self, row: usize) -> Vec<[f64; 2]> {
        self.radius
            .iter()
            .zip(&self.pressure)
            .map(|(r, p)| [*r, p[row]])
            .collect()
    }
}

/// Whether a rigid indenter loads the solid instead of a pressure.
fn indented(data: &RunData) -> bool {
    data.history_points("indenter_force").is_some()
}

/// Writes the section; nothing for an indented solid without pressure.
pub(crate) fn write(page: &mut Page, data: &RunData, instants: &Instants) {
    let wall = data.wall.as_ref().and_then(WallPressure::of);
    if indented(data) && wall.as_ref().is_none_or(WallPressure::is_zero) {
        return;
    }
    page.section("Pressure at the wall");
    let Some(wall) = wall else {
        page.absent(
            "No wall pressure was recorded: surface/wall_pressure.csv is missing or empty.",
        );
        return;
    };
    page.figures(&[
        (against_time(&wall, instants), "Pressure in the liquid at the wall against time.".into()),
        (
            against_radius(&wall, instants),
            "Pressure at the wall against the distance from the axis, from its largest value on.".into(),
        ),
        (largest(&wall), "Largest pressure during the run at each distance from the axis.".into()),
        (
            over_both(&wall),
            "Pressure at the wall over time and distance from the axis; the 0.1 % smallest and largest values take the \
             end colours, white: no support."
                .into(),
        ),
    ]);
}

fn against_time(wall: &WallPressure, instants: &Instants) -> String {
    let mut plot = Plot::new(Axis::new("time", "s"), Axis::new("pressure", "Pa"));
    let last = wall.radius.len() - 1;
    let mut columns: Vec<usize> = [0.0, 0.125, 0.25, 0.5, 1.0]
        .iter()
        .map(|share| nearest(&wall.radius, share * wall.radius[last]))
        .collect();
    columns.dedup();
    for column in columns {
        let label = format!("r = {}", quantity(wall.radius[column], "m"));
        plot = plot.line(&label, points(wall.time, wall.pressure[column]));
    }
    if let Some(collapse) = instants.collapse {
        plot = plot.event(collapse, "collapse");
    }
    plot.to_svg()
}

fn largest(wall: &WallPressure) -> String {
    let peak = |p: &&[f64]| {
        p.iter()
            .copied()
            .filter(|v| v.is_finite())
            .reduce(f64::max)
            .unwrap_or(f64::NAN)
    };
    let peaks: Vec<f64> = wall.pressure.iter().map(peak).collect();
    let axes = (
        Axis::new("distance from the axis", "m"),
        Axis::new("largest pressure", "Pa"),
    );
    Plot::new(axes.0, axes.1)
        .line("", points(&wall.radius, &peaks))
        .to_svg()
}

/// Six instants from the largest pressure on, a twentieth of that time apart (the thesis steps by 0.05 collapse times).
fn against_radius(wall: &WallPressure, instants: &Instants) -> String {
    let end = wall.time[wall.time.len() - 1];
    let peak = instants.impact.unwrap_or(0.5 * end);
    let step = (0.05 * peak).min((end - peak) / 5.0);
    let mut rows: Vec<usize> = (0..6)
        .map(|k| nearest(wall.time, peak + f64::from(k) * step))
        .collect();
    rows.dedup();
    let mut plot = Plot::new(
        Axis::new("distance from the axis", "m"),
        Axis::new("pressure", "Pa"),
    );
    for row in rows {
        let label = format!("t = {}", quantity(wall.time[row], "s"));
        plot = plot.line(&label, wall.profile(row));
    }
    plot.to_svg()
}

fn over_both(wall: &WallPressure) -> String {
    let values: Vec<Vec<f64>> = wall.pressure.iter().map(|p| p.to_vec()).collect();
    let range = robust_range(&values.concat(), 0.001).unwrap_or([0.0, 1.0]);
    let map = Map {
        title: String::new(),
        x: (Axis::new("time", "s"), wall.time),
        y: (Axis::new("distance from the axis", "m"), &wall.radius),
        values: &values,
        colouring: Colouring {
            label: "pressure".into(),
            unit: "Pa".into(),
            range: widened(range),
            map: ColourMap::Viridis,
            floor: None,
        },
        size: [560.0, 380.0],
    };
    map.to_svg()
}

/// A range that is not empty; zero is included when it is near.
fn widened([low, high]: [f64; 2]) -> [f64; 2] {
    let low = if low > 0.0 && low < 0.3 * high {
        0.0
    } else {
        low
    };
    if high > low {
        [low, high]
    } else {
        [low, low + low.abs().max(1.0)]
    }
}
