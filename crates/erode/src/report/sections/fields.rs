//! Pictures of the bodies at several instants: pressure in liquids, plastic strain in solids.

use crate::report::colour::{ColourMap, Colouring, robust_range};
use crate::report::html::Page;
use crate::report::instants::{Instants, choose};
use crate::report::picture::{Layer, Picture};
use crate::report::raster::View;
use crate::report::run_data::RunData;
use crate::report::snapshot::Body;
use crate::report::units::quantity;
use crate::report::view::{fine_view, strained_view};

/// Pictures in a report.
const PICTURES: usize = 6;
/// Width of a picture, pixels.
const WIDTH: f64 = 560.0;
/// Solid that never yielded.
const ELASTIC: [u8; 3] = [0xcf, 0xd3, 0xd8];
const AXES: [&str; 2] = ["r", "z"];

/// The solid as later sections need it.
#[derive(Debug, Default)]
pub(crate) struct Pictured {
    /// The first solid at the end of the run.
    pub(crate) solid: Option<Body>,
}

/// Writes the section.
pub(crate) fn write(page: &mut Page, data: &RunData, instants: &Instants) -> Pictured {
    page.section("Fields");
    let times: Vec<f64> = data.frames.iter().map(|f| f.time).collect();
    let Some((first, last)) = data.frames.first().zip(data.frames.last()) else {
        page.absent("No fields were written: fields.pvd is missing or empty.");
        return Pictured::default();
    };
    let (start, _) = first.read();
    let (end, _) = last.read();
    let Some(view) = fine_view(&start) else {
        page.absent("The snapshots hold no particles.");
        return Pictured::default();
    };
    let largest_strain = largest_strain(&end);
    let mut figures = Vec::new();
    let mut troubles = Vec::new();
    for (index, words) in choose(&times, &instants.named(), PICTURES) {
        let (bodies, missing) = data.frames[index].read();
        troubles.extend(missing);
        let title = heading(times[index], &words);
        figures.push((
            picture(&title, view, &bodies, largest_strain).to_svg(),
            caption(&bodies, view),
        ));
    }
    if let Some(view) = strained_view(&end, largest_strain) {
        let title = format!(
            "Plastic strain at the end, t = {}",
            quantity(last.time, "s")
        );
        let solids: Vec<Body> = end.iter().filter(|b| b.is_solid()).cloned().collect();
        let caption = format!(
            "Where the plastic strain is; largest value {}.",
            percent(largest_strain)
        );
        figures.push((
            picture(&title, view, &solids, largest_strain).to_svg(),
            caption,
        ));
    }
    troubles.iter().for_each(|trouble| page.alert(trouble));
    page.paragraph(
        "Each picture shows the finely resolved region, mirrored about the axis r = 0. A void is white; solid that never \
         yielded is grey.",
    );
    page.figures(&figures);
    Pictured {
        solid: end.into_iter().find(Body::is_solid),
    }
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
        let values = seen(body, name, view);
        let low = values.iter().copied().fold(f64::INFINITY, f64::min);
        let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        match (values.is_empty(), body.is_solid()) {
            (true, _) => None,
            (_, true) => Some(format!(
                "{}: plastic strain up to {}",
                body.name,
                percent(high)
            )),
            _ => Some(format!(
                "{}: pressure {} to {}",
                body.name,
                quantity(low, "Pa"),
                quantity(high, "Pa")
            )),
        }
    };
    let parts: Vec<String> = bodies.iter().filter_map(part).collect();
    format!("{}.", parts.join("; "))
}

fn percent(strain: f64) -> String {
    quantity(100.0 * strain, "%")
}

fn seen(body: &Body, name: &str, view: View) -> Vec<f64> {
    let values = body.field(name).unwrap_or(&[]);
    let inside = |p: &[f64; 2]| view.contains([p[0].abs(), p[1]]);
    body.position
        .iter()
        .zip(values)
        .filter(|(p, v)| inside(p) && v.is_finite())
        .map(|(_, v)| *v)
        .collect()
}

fn largest_strain(bodies: &[Body]) -> f64 {
    let strains = bodies
        .iter()
        .filter_map(|b| b.field("plastic_strain"))
        .flatten();
    strains
        .copied()
        .filter(|v| v.is_finite())
        .fold(0.0, f64::max)
}

fn picture<'a>(title: &str, view: View, bodies: &'a [Body], largest_strain: f64) -> Picture<'a> {
    // Liquid first: its colour bar is the upper one, as the liquid is above the solid.
    let mut layers: Vec<Layer<'a>> = Vec::new();
    for body in bodies
        .iter()
        .filter(|b| !b.is_solid())
        .chain(bodies.iter().filter(|b| b.is_solid()))
    {
        let layer = if body.is_solid() {
            solid_layer(body, largest_strain)
        } else {
            liquid_layer(body, view)
        };
        layers.extend(layer);
    }
    Picture {
        title: title.to_string(),
        view,
        mirrored: true,
        layers,
        width: WIDTH,
        axes: AXES,
    }
}

fn liquid_layer(body: &Body, view: View) -> Option<Layer<'_>> {
    let value = body.field("pressure")?;
    let [low, high] = robust_range(&seen(body, "pressure", view), 0.002)?;
    let low = if low > 0.0 && low < 0.3 * high {
        0.0
    } else {
        low
    };
    // A uniform pressure still needs a range, and noise of a few pascal is not worth colours.
    let high = high.max(low + 1e3);
    Some(Layer {
        position: &body.position,
        size: &body.size,
        value,
        colouring: Colouring {
            label: format!("pressure, {}", body.name),
            unit: "Pa".into(),
            range: [low, high],
            map: ColourMap::Viridis,
            floor: None,
        },
    })
}

fn solid_layer(body: &Body, largest_strain: f64) -> Option<Layer<'_>> {
    Some(Layer {
        position: &body.position,
        size: &body.size,
        value: body.field("plastic_strain")?,
        colouring: Colouring {
            label: "plastic strain".into(),
            unit: "-".into(),
            range: [
                0.0,
                if largest_strain > 0.0 {
                    largest_strain
                } else {
                    0.01
                },
            ],
            map: ColourMap::Heat,
            floor: Some((0.0, ELASTIC)),
        },
    })
}
