//! Pictures of the bodies at several instants: pressure in liquids, plastic strain in solids; velocity around the jet.

use std::borrow::Cow;

use crate::report::colour::{ColourMap, Colouring, robust_range};
use crate::report::html::Page;
use crate::report::instants::{Instants, choose};
use crate::report::picture::{Layer, Picture};
use crate::report::raster::View;
use crate::report::run_data::RunData;
use crate::report::snapshot::Body;
use crate::report::units::quantity;
use crate::report::view::fine_view;

/// Pictures of pressure and plastic strain in a report.
const PICTURES: usize = 6;
/// Width of a picture, pixels.
pub(super) const WIDTH: f64 = 560.0;
/// Solid that never yielded.
const ELASTIC: [u8; 3] = [0xcf, 0xd3, 0xd8];
/// Shares of smallest and largest values that may take the end colours.
const TAIL: f64 = 0.002;

/// Writes the section; `end` are the bodies at the end of the run.
pub(crate) fn write(page: &mut Page, data: &RunData, instants: &Instants, end: &[Body]) {
    page.section("Fields");
    let times: Vec<f64> = data.frames.iter().map(|f| f.time).collect();
    let Some(first) = data.frames.first() else {
        page.absent("No fields were written: fields.pvd is missing or empty.");
        return;
    };
    let Some(view) = fine_view(&first.read().0) else {
        page.absent("The first snapshot cannot be read or holds no particles.");
        return;
    };
    let largest = largest_strain(end);
    let mut figures = Vec::new();
    let mut flows = Vec::new();
    for (index, words) in choose(&times, &instants.named(), PICTURES) {
        let (bodies, troubles) = data.frames[index].read();
        troubles.iter().for_each(|trouble| page.alert(trouble));
        let title = heading(times[index], &words);
        figures.push((
            state_picture(&title, view, &bodies, largest),
            caption(&bodies, view),
        ));
        if ["quarter", "jet", "collapse"]
            .iter()
            .any(|name| words.contains(name))
        {
            flows.extend(flow_picture(&title, view, &bodies));
        }
    }
    page.paragraph(
        "Pressure in liquids, plastic strain in solids. Each picture shows the finely resolved region at the snapshot nearest to the named instant, mirrored about the \
         axis. A void is white; solid that never yielded is grey. An arrow at a colour bar: some values lie beyond.",
    );
    figures.extend(flows);
    page.figures(&figures);
}

fn heading(time: f64, words: &str) -> String {
    let instant = format!("t = {}", quantity(time, "s"));
    if words.is_empty() {
        instant
    } else {
        format!("{instant}: {words}")
    }
}

/// Extremes of the shown part in numbers, since colours saturate.
fn caption(bodies: &[Body], view: View) -> String {
    let part = |body: &Body| {
        let name = if body.is_solid() {
            "plastic_strain"
        } else {
            "pressure"
        };
        let values = seen(body, body.field(name)?, view);
        let low = values.iter().copied().reduce(f64::min)?;
        let high = values.iter().copied().reduce(f64::max)?;
        Some(match (body.is_solid(), high > 0.0) {
            (true, true) => format!("plastic strain in {} up to {}", body.name, percent(high)),
            (true, false) => format!("no plastic strain in {}", body.name),
            _ => format!(
                "pressure in {} from {} to {}",
                body.name,
                quantity(low, "Pa"),
                quantity(high, "Pa")
            ),
        })
    };
    let parts: Vec<String> = bodies.iter().filter_map(part).collect();
    format!("In this view: {}.", parts.join("; "))
}

/// A strain in per cent.
pub(super) fn percent(strain: f64) -> String {
    quantity(100.0 * strain, "%")
}

/// The finite values of the particles in a view.
fn seen(body: &Body, values: &[f64], view: View) -> Vec<f64> {
    let inside = |p: &[f64; 2]| view.contains([p[0].abs(), p[1]]);
    body.position
        .iter()
        .zip(values)
        .filter(|(p, v)| inside(p) && v.is_finite())
        .map(|(_, v)| *v)
        .collect()
}

/// The largest plastic strain of all bodies.
pub(super) fn largest_strain(bodies: &[Body]) -> f64 {
    let strains = bodies
        .iter()
        .filter_map(|b| b.field("plastic_strain"))
        .flatten();
    strains
        .copied()
        .filter(|v| v.is_finite())
        .fold(0.0, f64::max)
}

/// Pressure in the liquids and plastic strain in the solids; the liquids' colour bars come first, as they are above.
fn state_picture(title: &str, view: View, bodies: &[Body], largest_strain: f64) -> String {
    let liquids = bodies
        .iter()
        .filter(|b| !b.is_solid())
        .filter_map(|body| pressure_layer(body, view));
    let solids = bodies
        .iter()
        .filter(|b| b.is_solid())
        .filter_map(|body| strain_layer(body, largest_strain));
    draw(title, view, liquids.chain(solids).collect())
}

/// A picture of some layers.
pub(super) fn draw(title: &str, view: View, layers: Vec<Layer>) -> String {
    let picture = Picture {
        title: title.to_string(),
        view,
        mirrored: true,
        layers,
        width: WIDTH,
        axes: ["r", "z"],
    };
    picture.to_svg()
}

fn pressure_layer(body: &Body, view: View) -> Option<Layer<'_>> {
    let value = body.field("pressure")?;
    let [low, high] = robust_range(&seen(body, value, view), TAIL)?;
    // Zero is shown when it is near or when the field is almost uniform; noise of a few pascal is not worth colours.
    let low = if low > 0.0 && (low < 0.3 * high || high - low < 0.1 * high) {
        0.0
    } else {
        low
    };
    let high = high.max(low + 1e3);
    Some(Layer {
        position: &body.position,
        size: &body.size,
        value: Cow::Borrowed(value),
        colouring: colouring(
            &format!("pressure, {}", body.name),
            "Pa",
            [low, high],
            ColourMap::Viridis,
        ),
    })
}

/// The plastic strain of a body in per cent, from none to `largest` (not in per cent).
pub(super) fn strain_layer(body: &Body, largest: f64) -> Option<Layer<'_>> {
    let value: Vec<f64> = body
        .field("plastic_strain")?
        .iter()
        .map(|e| 100.0 * e)
        .collect();
    let high = if largest > 0.0 { 100.0 * largest } else { 1.0 };
    let colouring = Colouring {
        floor: Some((0.0, ELASTIC)),
        ..colouring("plastic strain", "%", [0.0, high], ColourMap::Heat)
    };
    Some(Layer {
        position: &body.position,
        size: &body.size,
        value: Cow::Owned(value),
        colouring,
    })
}

pub(super) fn colouring(label: &str, unit: &str, range: [f64; 2], map: ColourMap) -> Colouring {
    Colouring {
        label: label.to_string(),
        unit: unit.to_string(),
        range,
        map,
        floor: None,
    }
}

/// Velocity along the axis in all bodies: shows the jet.
fn flow_picture(title: &str, view: View, bodies: &[Body]) -> Option<(String, String)> {
    let fields: Vec<(&Body, Vec<f64>)> = bodies
        .iter()
        .filter_map(|b| Some((b, b.component("velocity", 1)?)))
        .collect();
    let all: Vec<f64> = fields
        .iter()
        .flat_map(|(body, values)| seen(body, values, view))
        .collect();
    let [low, high] = robust_range(&all, 0.1 * TAIL)?;
    let extreme = all
        .iter()
        .copied()
        .fold(0.0_f64, |a, b| if b.abs() > a.abs() { b } else { a });
    let bound = low.abs().max(high.abs()).max(1e-3);
    let mut layers = Vec::new();
    for (index, (body, values)) in fields.into_iter().enumerate() {
        layers.push(Layer {
            position: &body.position,
            size: &body.size,
            value: Cow::Owned(values),
            colouring: colouring(
                // One scale for all bodies: one bar.
                if index == 0 { "axial velocity" } else { "" },
                "m/s",
                [-bound, bound],
                ColourMap::CoolWarm,
            ),
        });
    }
    let caption = format!(
        "Axial velocity (negative: towards smaller z), largest {}.",
        quantity(extreme, "m/s")
    );
    Some((
        draw(&format!("Axial velocity, {title}"), view, layers),
        caption,
    ))
}
