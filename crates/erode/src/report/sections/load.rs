//! A load on a solid: force against depth of an indenter, lost mass, inertia, the stress at the end.

use std::borrow::Cow;

use super::fields::{colouring, draw};
use crate::erosion::ErosionCurve;
use crate::report::colour::{ColourMap, robust_range};
use crate::report::html::Page;
use crate::report::picture::Layer;
use crate::report::plot::{Axis, Plot};
use crate::report::run_data::{RunData, points};
use crate::report::snapshot::Body;
use crate::report::units::quantity;
use crate::report::view::fine_view;

/// Window over which a rate of loss is taken, as a share of the run.
const RATE_WINDOW: f64 = 0.1;

/// Components of the stress tensor in the order of the field files, with their names in (r, z, theta).
const COMPONENTS: [(usize, &str); 3] = [(0, "stress rr"), (1, "stress zz"), (2, "stress tt")];

/// Writes the section; nothing, and false, for a run without a prescribed load.
pub(crate) fn write(page: &mut Page, data: &RunData, end: &[Body]) -> bool {
    let Some(history) = &data.history else {
        return false;
    };
    let Some(inertia) = history.column("inertia_share") else {
        return false;
    };
    page.section("Load");
    let mut figures = Vec::new();
    if let (Some(depth), Some(force)) = (
        history.column("indenter_depth"),
        history.column("indenter_force"),
    ) {
        let plot = Plot::new(
            Axis::new("depth of the indenter", "m"),
            Axis::new("force", "N"),
        )
        .line("", points(depth, force));
        let peak = force.iter().copied().fold(0.0, f64::max);
        figures.push((
            plot.to_svg(),
            format!(
                "Force of the indenter against its depth, largest {}; the curve comes back where it is taken away.",
                quantity(peak, "N")
            ),
        ));
    }
    if let Some(points) = data.history_points("wall_depth") {
        let plot = Plot::new(Axis::new("time", "s"), Axis::new("depth of the pit", "m"));
        figures.push((
            plot.line("", points).to_svg(),
            "Depth of the deepest point of the surface below its rim, elastic part included."
                .into(),
        ));
    }
    figures.extend(data.history_points("lost_mass").and_then(lost_mass));
    let last = inertia.iter().rev().find(|v| v.is_finite());
    if let Some(last) = last {
        page.paragraph(&format!(
            "Kinetic energy over internal energy at the end: {last:.1e} (far below 1 what is left is at rest)."
        ));
    }
    figures.extend(stresses(end));
    page.figures(&figures);
    true
}

/// Lost mass against time with its incubation; nothing when no material failed.
fn lost_mass(curve: Vec<[f64; 2]>) -> Option<(String, String)> {
    let end = curve.last().filter(|p| p[1] > 0.0)?[0];
    let found = ErosionCurve::of(&curve, RATE_WINDOW * end);
    let mut plot = Plot::new(Axis::new("time", "s"), Axis::new("lost mass", "kg")).line("", curve);
    let words = match found {
        Ok(c) => {
            plot = plot.event(c.onset, "first loss");
            if c.nominal_incubation > c.onset {
                plot = plot.event(c.nominal_incubation, "incubation");
            }
            format!(
                "Mass of failed material. First loss at {}, nominal incubation {} (where the line of the largest rate, \
                 {}, meets the time axis), lost at the end {}.",
                quantity(c.onset, "s"),
                quantity(c.nominal_incubation, "s"),
                quantity(c.max_rate, "kg/s"),
                quantity(c.final_loss, "kg"),
            )
        }
        Err(cause) => format!("Mass of failed material. No incubation time: {cause}."),
    };
    Some((plot.to_svg(), words))
}

/// Stress at the end in the first solid: von Mises and the normal components.
fn stresses(end: &[Body]) -> Vec<(String, String)> {
    let Some(solid) = end.iter().find(|b| b.is_solid()) else {
        return Vec::new();
    };
    let mut fields: Vec<(&str, Vec<f64>, ColourMap)> = Vec::new();
    if let Some(v) = solid.field("von_mises") {
        fields.push(("von Mises stress", v.to_vec(), ColourMap::Viridis));
    }
    for (index, name) in COMPONENTS {
        if let Some(values) = solid.component("stress", index) {
            fields.push((name, values, ColourMap::CoolWarm));
        }
    }
    let Some(view) = fine_view(end) else {
        return Vec::new();
    };
    (fields.into_iter())
        .filter_map(|(name, values, map)| {
            let [low, high] = robust_range(&values, 0.002)?;
            let range = match map {
                ColourMap::CoolWarm => {
                    let bound = low.abs().max(high.abs()).max(1.0);
                    [-bound, bound]
                }
                _ => [0.0, high.max(1.0)],
            };
            let layer = Layer {
                position: &solid.position,
                size: &solid.size,
                value: Cow::Owned(values),
                colouring: colouring(name, "Pa", range, map),
            };
            Some((
                draw("", view, vec![layer]),
                format!("{name} at the end (positive in tension)."),
            ))
        })
        .collect()
}
