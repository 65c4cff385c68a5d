//! A cloud of bubbles: paths, radii, collapses and impacts.

use crate::output::{RunPaths, Table};
use crate::report::html::Page;
use crate::report::plot::{Axis, Plot};
use crate::report::run_data::{RunData, points};

/// Bars of a histogram.
const BARS: usize = 30;

/// Whether the run is one of a cloud.
pub(crate) fn is(data: &RunData) -> bool {
    let history = data.history.as_ref();
    history.is_some_and(|h| h.column("bubbles").is_some() && h.column("collapses").is_some())
}

/// Writes the section.
pub(crate) fn write(page: &mut Page, data: &RunData) {
    page.section("The cloud");
    let over_time = |columns: &[(&str, &str)], label: &str, unit: &str| {
        let empty = Plot::new(Axis::new("time", "s"), Axis::new(label, unit));
        columns.iter().fold(empty, |plot, (column, name)| {
            plot.line(name, data.history_points(column).unwrap_or_default())
        })
    };
    let radii = [
        ("mean_bubble_radius", "mean"),
        ("max_bubble_radius", "largest"),
    ];
    let counts = [
        ("collapses", "collapses"),
        ("impacts", "impacts on the wall"),
    ];
    page.figures(&[
        (
            over_time(&radii, "radius", "m").to_svg(),
            "Radii of the bubbles present.".into(),
        ),
        (
            over_time(&counts, "number so far", "-").to_svg(),
            "Collapses, and those within the range of the erosion model.".into(),
        ),
    ]);
    write_paths(page, data);
    write_impacts(page, data);
}

fn write_paths(page: &mut Page, data: &RunData) {
    let followed: Vec<&(String, Table)> = data
        .probes
        .iter()
        .filter(|(name, _)| name.starts_with("bubble_"))
        .collect();
    if followed.is_empty() {
        page.absent("No bubble was followed (setup.bubble_cloud.followed).");
        return;
    }
    let draw = |x: &str, y: &str, labels: [(&str, &str); 2]| {
        let axes = labels.map(|(label, unit)| Axis::new(label, unit));
        let [a, b] = axes;
        followed.iter().fold(Plot::new(a, b), |plot, (_, table)| {
            let column = |name: &str| table.column(name).unwrap_or(&[]);
            let path = points(column(x), column(y));
            let start = path.first().copied().into_iter().collect();
            let plot = plot.line("", path);
            // A bubble that stays where it is has no line.
            if x == "time" {
                plot
            } else {
                plot.points("", start)
            }
        })
    };
    let figures = [
        (
            draw("position_x", "position_y", [("x", "m"), ("y", "m")]),
            "Paths of the followed bubbles, seen along z; dots: where they start.",
        ),
        (
            draw("position_x", "position_z", [("x", "m"), ("z", "m")]),
            "The same, seen along y.",
        ),
        (
            draw("time", "bubble_radius", [("time", "s"), ("radius", "m")]),
            "Their radii, at the times of the rows: a collapse is shorter than the distance of rows.",
        ),
    ];
    page.figures(&figures.map(|(plot, words)| (plot.to_svg(), words.to_string())));
}

fn write_impacts(page: &mut Page, data: &RunData) {
    page.section("Collapses and impacts");
    let Ok(table) = Table::read(&RunPaths::new(&data.dir).collapses()) else {
        page.absent("Collapses were not recorded: collapses.csv is missing.");
        return;
    };
    if table.rows() == 0 {
        page.absent("No bubble collapsed.");
        return;
    }
    let finite = |name: &str| -> Vec<f64> {
        let values = table.column(name).unwrap_or(&[]);
        values
            .iter()
            .copied()
            .filter(|v| v.is_finite() && *v > 0.0)
            .collect()
    };
    let kinds = [
        (
            "max_bubble_pressure",
            "pressure in the bubble",
            "Pa",
            "Pressure in the bubbles at their smallest radius.",
        ),
        (
            "impact_pressure",
            "impact pressure",
            "Pa",
            "Pressure on the wall by the Lagrangian erosion model (eqs 3.50 to 3.61).",
        ),
        (
            "standoff",
            "distance from the wall / largest radius",
            "-",
            "Stand-off; the erosion model holds from 0.2 to 3.",
        ),
    ];
    let figures: Vec<(String, String)> = kinds
        .into_iter()
        .filter_map(|(column, label, unit, words)| {
            Some((histogram(&finite(column), label, unit)?, words.to_string()))
        })
        .collect();
    page.figures(&figures);
    if finite("impact_pressure").is_empty() {
        page.absent("There was no impact on a wall: none is there, or all collapses were outside the range of the model.");
    } else {
        page.paragraph("Shares of the wall's elements in all impacts stand in surface/erosion_potential.csv: a potential, not a depth.");
    }
}

/// Numbers of values in bars of equal ratio.
fn histogram(values: &[f64], label: &str, unit: &str) -> Option<String> {
    let low = values.iter().copied().fold(f64::INFINITY, f64::min);
    let high = values.iter().copied().fold(0.0, f64::max);
    if values.is_empty() {
        return None;
    }
    let (low, high) = (low / 1.05, high * 1.05);
    let width = (high / low).ln() / BARS as f64;
    let mut counts = [0.0; BARS];
    for value in values {
        let bar = ((value / low).ln() / width) as usize;
        counts[bar.min(BARS - 1)] += 1.0;
    }
    let mut outline = vec![[low, 0.0]];
    for (bar, count) in counts.iter().enumerate() {
        let edge = |k: usize| low * (width * k as f64).exp();
        outline.push([edge(bar), *count]);
        outline.push([edge(bar + 1), *count]);
    }
    outline.push([high, 0.0]);
    let plot = Plot::new(
        Axis::new(label, unit).logarithmic(),
        Axis::new("collapses", "-"),
    );
    Some(plot.line("", outline).to_svg())
}

#[cfg(test)]
mod tests {
    use super::histogram;

    #[test]
    fn a_histogram_needs_values_and_takes_a_single_one() {
        assert!(histogram(&[], "p", "Pa").is_none());
        assert!(histogram(&[2e6], "p", "Pa").unwrap().contains("<svg"));
    }
}
