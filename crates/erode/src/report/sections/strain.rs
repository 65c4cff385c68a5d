//! Plastic strain at the end along the surface of the solid and along the axis.

use super::fields::{draw, largest_strain, percent, strain_layer};
use crate::report::html::Page;
use crate::report::instants::Instants;
use crate::report::picture::Layer;
use crate::report::plot::{Axis, Plot};
use crate::report::run_data::RunData;
use crate::report::snapshot::Body;
use crate::report::units::quantity;
use crate::report::view::strained_view;

/// Writes the section.
pub(crate) fn write(page: &mut Page, data: &RunData, instants: &Instants, end: &[Body]) {
    page.section("Plastic strain");
    let Some(profiles) = end.iter().find(|b| b.is_solid()).and_then(Profiles::of) else {
        page.absent(if data.frames.is_empty() {
            "Not known: no fields were written."
        } else {
            "This run has no solid with plastic strain, or its last snapshot cannot be read."
        });
        return;
    };
    if profiles.peak.strain <= 0.0 {
        page.absent("The solid stayed elastic: no particle has a plastic strain.");
        return;
    }
    let mut figures: Vec<(String, String)> = close_up(end).into_iter().collect();
    figures.extend(profiles.figures());
    figures.extend(growth(data, instants));
    page.figures(&figures);
}

/// The yielded region at the end.
fn close_up(end: &[Body]) -> Option<(String, String)> {
    let largest = largest_strain(end);
    let view = strained_view(end, largest)?;
    let layers: Vec<Layer> = end
        .iter()
        .filter_map(|body| strain_layer(body, largest))
        .collect();
    Some((
        draw("", view, layers),
        format!(
            "Plastic strain at the end, largest value {}.",
            percent(largest)
        ),
    ))
}

/// The largest plastic strain against time, if it was recorded.
fn growth(data: &RunData, instants: &Instants) -> Option<(String, String)> {
    let mut strain = data.history_points("max_plastic_strain")?;
    strain.iter_mut().for_each(|p| p[1] *= 100.0);
    let axes = (
        Axis::new("time", "s"),
        Axis::new("largest plastic strain", "%"),
    );
    let mut plot = Plot::new(axes.0, axes.1).line("", strain);
    for (time, name) in instants.named() {
        plot = plot.event(time, name);
    }
    Some((
        plot.to_svg(),
        "The largest plastic strain against time.".into(),
    ))
}

/// One particle of the solid.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Point {
    r: f64,
    depth: f64,
    strain: f64,
    size: f64,
}

#[derive(Debug)]
struct Profiles {
    /// By radius.
    surface: Vec<Point>,
    /// By radius, at the depth of the largest strain.
    level: Vec<Point>,
    /// By depth.
    axis: Vec<Point>,
    /// By depth, at the radius of the largest strain.
    column: Vec<Point>,
    peak: Point,
}

impl Profiles {
    fn of(solid: &Body) -> Option<Self> {
        let strain = solid.field("plastic_strain")?;
        // The highest particle centre is half a spacing below the surface.
        let top = solid
            .position
            .iter()
            .zip(&solid.size)
            .map(|(p, s)| p[1] + 0.5 * s)
            .fold(f64::NEG_INFINITY, f64::max);
        let points: Vec<Point> = (0..solid.position.len())
            .map(|k| Point {
                r: solid.position[k][0].abs(),
                depth: top - solid.position[k][1],
                strain: strain[k],
                size: solid.size[k],
            })
            .collect();
        let peak = *points.iter().max_by(|a, b| a.strain.total_cmp(&b.strain))?;
        let (depth, radius) = (|p: &Point| p.depth, |p: &Point| p.r);
        Some(Self {
            surface: line(&points, radius, depth, 0.0),
            level: line(&points, radius, depth, peak.depth),
            axis: line(&points, depth, radius, 0.0),
            column: line(&points, depth, radius, peak.r),
            peak,
        })
    }

    fn figures(&self) -> Vec<(String, String)> {
        // Beyond where the strain has died away the curves tell nothing.
        let reach = |lines: [&[Point]; 2], along: fn(&Point) -> f64| {
            let strained = lines
                .into_iter()
                .flatten()
                .filter(|p| p.strain > 0.01 * self.peak.strain);
            1.3 * strained.map(along).fold(4.0 * self.peak.size, f64::max)
        };
        let depth = quantity(self.peak.depth, "m");
        let radius = quantity(self.peak.r, "m");
        let along = plot(
            "distance from the axis",
            reach([&self.surface, &self.level], |p| p.r),
        )
        .line("first row below the surface", curve(&self.surface, |p| p.r))
        .line(&format!("at depth {depth}"), curve(&self.level, |p| p.r));
        let down = plot(
            "depth below the surface",
            reach([&self.axis, &self.column], |p| p.depth),
        )
        .line("on the axis", curve(&self.axis, |p| p.depth))
        .line(
            &format!("at r = {radius}"),
            curve(&self.column, |p| p.depth),
        );
        let peak = format!(
            "Largest plastic strain {} at r = {radius}, depth {depth}.",
            percent(self.peak.strain)
        );
        vec![
            (
                along.to_svg(),
                format!("Plastic strain along the surface at the end. {peak}"),
            ),
            (
                down.to_svg(),
                "Plastic strain along the axis at the end, and at the radius of its largest value."
                    .into(),
            ),
        ]
    }
}

fn plot(label: &str, reach: f64) -> Plot {
    Plot::new(
        Axis::new(label, "m").with_range(0.0, reach),
        Axis::new("plastic strain", "%"),
    )
}

fn curve(points: &[Point], along: fn(&Point) -> f64) -> Vec<[f64; 2]> {
    points
        .iter()
        .map(|p| [along(p), 100.0 * p.strain])
        .collect()
}

/// The particles nearest to the line `across = level`, one per spacing in the direction `along`, in order. A line at
/// an edge (level 0) takes the first row.
fn line(
    points: &[Point],
    along: fn(&Point) -> f64,
    across: fn(&Point) -> f64,
    level: f64,
) -> Vec<Point> {
    let mut near: Vec<Point> = points
        .iter()
        .copied()
        .filter(|p| (across(p) - level).abs() <= 1.5 * p.size)
        .collect();
    near.sort_by(|a, b| along(a).total_cmp(&along(b)));
    let mut chosen: Vec<Point> = Vec::new();
    for point in near {
        match chosen.last_mut() {
            Some(last) if along(&point) - along(last) < 0.5 * point.size.max(last.size) => {
                if (across(&point) - level).abs() < (across(last) - level).abs() {
                    *last = point;
                }
            }
            _ => chosen.push(point),
        }
    }
    chosen
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_takes_one_row_of_a_lattice() {
        let mut points = Vec::new();
        for i in 0..20 {
            for j in 0..10 {
                let (r, depth) = (f64::from(i) + 0.5, f64::from(j) + 0.5);
                points.push(Point {
                    r,
                    depth,
                    strain: r + 100.0 * depth,
                    size: 1.0,
                });
            }
        }
        let surface = line(&points, |p| p.r, |p| p.depth, 0.0);
        assert_eq!(surface.len(), 20);
        assert!(surface.iter().all(|p| p.depth == 0.5));
        let level = line(&points, |p| p.r, |p| p.depth, 4.5);
        assert!(level.len() == 20 && level.iter().all(|p| p.depth == 4.5));
        let axis = line(&points, |p| p.depth, |p| p.r, 0.0);
        assert!(axis.len() == 10 && axis.iter().all(|p| p.r == 0.5));
    }
}
