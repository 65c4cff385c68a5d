//! Radius and pressure of a spherical bubble over time, and what happened to it.

use crate::output::{RunPaths, Table};
use crate::report::html::Page;
use crate::report::plot::{Axis, Plot};
use crate::report::run_data::RunData;
use crate::report::units::quantity;

/// Events in the table at most.
const SHOWN: usize = 20;

/// Whether the run is one of a single spherical bubble.
pub(crate) fn is(data: &RunData) -> bool {
    let history = data.history.as_ref();
    history
        .is_some_and(|h| h.column("wall_velocity").is_some() && h.column("bubble_radius").is_some())
}

/// Writes the section.
pub(crate) fn write(page: &mut Page, data: &RunData) {
    page.section("The bubble");
    let curve = |name: &str| data.history_points(name).unwrap_or_default();
    let size = |plot: Plot| plot.sized(1100.0, 320.0);
    let time = || Axis::new("time", "s");
    let radius = size(Plot::new(time(), Axis::new("radius", "m"))).line("", curve("bubble_radius"));
    let inside = Axis::new("pressure", "Pa").logarithmic();
    let pressure = size(Plot::new(time(), inside))
        .line("in the bubble", curve("bubble_pressure"))
        .dashed("liquid, where positive", curve("ambient_pressure"));
    let ambient = Plot::new(time(), Axis::new("pressure of the liquid", "Pa"))
        .line("", curve("ambient_pressure"));
    let phase: Vec<[f64; 2]> = curve("bubble_radius")
        .iter()
        .zip(curve("wall_velocity"))
        .map(|(r, v)| [r[1], v[1]])
        .collect();
    let phase = Plot::new(
        Axis::new("radius", "m").logarithmic(),
        Axis::new("wall velocity", "m/s"),
    )
    .line("", phase);
    page.figures(&[(
        radius.to_svg(),
        "Radius; rows are added where it changes fast, so that no collapse is missed.".into(),
    )]);
    page.figures(&[(
        pressure.to_svg(),
        "Pressure of vapour and gas in the bubble, and of the liquid.".into(),
    )]);
    page.figures(&[
        (ambient.to_svg(), "Pressure of the liquid, given.".into()),
        (
            phase.to_svg(),
            "Wall velocity against radius, growth positive.".into(),
        ),
    ]);
    write_events(page, data);
}

fn write_events(page: &mut Page, data: &RunData) {
    let Ok(events) = Table::read(&RunPaths::new(&data.dir).events()) else {
        page.absent("Largest and smallest radii were not recorded: events.csv is missing.");
        return;
    };
    let column = |name: &str| events.column(name).unwrap_or(&[]);
    let rows: Vec<Vec<String>> = (0..events.rows())
        .take(SHOWN)
        .map(|i| {
            let number = |name: &str, unit: &str| {
                column(name)
                    .get(i)
                    .map_or(String::new(), |v| quantity(*v, unit))
            };
            let largest = column("largest").get(i) == Some(&1.0);
            vec![
                if largest {
                    "largest: a collapse begins"
                } else {
                    "smallest: it rebounds"
                }
                .into(),
                number("time", "s"),
                number("bubble_radius", "m"),
                number("bubble_pressure", "Pa"),
                number("ambient_pressure", "Pa"),
            ]
        })
        .collect();
    if rows.is_empty() {
        page.absent("The radius had no largest or smallest value.");
        return;
    }
    let heads = [
        "event",
        "time",
        "radius",
        "pressure in the bubble",
        "pressure of the liquid",
    ];
    page.table(&heads, &rows);
    if events.rows() > SHOWN {
        page.paragraph(&format!(
            "The first {SHOWN} of {}; all of them are in events.csv.",
            events.rows()
        ));
    }
}
