//! Probes: one figure per recorded quantity with a curve per probe.

use crate::report::html::Page;
use crate::report::plot::{Axis, Plot};
use crate::report::run_data::{RunData, points};
use crate::report::units::in_words;

/// Figures at most; further quantities are named and stay in the tables.
const SHOWN: usize = 6;

/// Writes the section.
pub(crate) fn write(page: &mut Page, data: &RunData) {
    page.section("Probes");
    let mut quantities: Vec<(&str, &str)> = Vec::new();
    let columns = data
        .probes
        .iter()
        .flat_map(|(_, table)| table.columns.iter().zip(&table.values));
    for (column, values) in columns {
        let known = quantities.iter().any(|q| q.0 == column.name);
        if column.name != "time" && !known && values.iter().any(|v| v.is_finite()) {
            quantities.push((&column.name, &column.unit));
        }
    }
    if quantities.is_empty() {
        page.absent("This run has no probes.");
        return;
    }
    let figures: Vec<(String, String)> = quantities
        .iter()
        .take(SHOWN)
        .map(|(name, unit)| {
            (
                figure(data, name, unit),
                format!("{} at the probes.", in_words(name)),
            )
        })
        .collect();
    page.figures(&figures);
    let rest: Vec<&str> = quantities.iter().skip(SHOWN).map(|q| q.0).collect();
    if !rest.is_empty() {
        page.paragraph(&format!(
            "Also recorded, in probes/*.csv: {}.",
            rest.join(", ")
        ));
    }
}

fn figure(data: &RunData, name: &str, unit: &str) -> String {
    let mut plot = Plot::new(
        Axis::new("time", "s"),
        Axis::new(&name.replace('_', " "), unit),
    )
    .sized(560.0, 320.0);
    for (probe, table) in &data.probes {
        if let (Some(time), Some(values)) = (table.column("time"), table.column(name)) {
            plot = plot.line(probe, points(time, values));
        }
    }
    plot.to_svg()
}
