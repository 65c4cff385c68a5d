//! The energy ledger against time and how well it closes.

use serde_json::Value;

use crate::output::Table;
use crate::report::html::Page;
use crate::report::plot::{Axis, Plot};
use crate::report::run_data::{RunData, points};
use crate::report::units::{in_words, quantity, significant};

/// Writes the section.
pub(crate) fn write(page: &mut Page, data: &RunData) {
    page.section("Energy");
    write_curves(page, data);
    write_ledger(page, data);
}

/// The conservation ledger at the end: energies, masses and what left the computation.
fn write_ledger(page: &mut Page, data: &RunData) {
    let ledger = data.summary.get("ledger").and_then(Value::as_object);
    let row = |(name, value): (&String, &Value)| {
        let unit = data.unit(&format!("ledger.{name}"));
        let shown = value
            .as_f64()
            .map_or("not determined".into(), |v| quantity(v, unit));
        vec![in_words(name), shown]
    };
    let rows: Vec<Vec<String>> = ledger.into_iter().flatten().map(row).collect();
    if rows.is_empty() {
        page.absent("The final ledger is not known (summary.json has no ledger).");
    } else {
        page.table(&["ledger at the end", ""], &rows);
    }
}

fn write_curves(page: &mut Page, data: &RunData) {
    let Some((history, time)) = data
        .history
        .as_ref()
        .and_then(|h| Some((h, h.column("time")?)))
    else {
        page.absent("No energies were recorded: history.csv is missing.");
        return;
    };
    let entries = ledger(history, time);
    let closing = closing_error(history, time);
    let mut figures = Vec::new();
    if let Some(plot) = entries {
        figures.push((
            plot.to_svg(),
            "Entries of the energy ledger (columns energy_* of history.csv).".to_string(),
        ));
    }
    if let Some(plot) = closing {
        let last = data.number("energy_drift").map_or(String::new(), |drift| {
            format!(" Largest value: {} %.", significant(100.0 * drift, 2))
        });
        figures.push((plot.to_svg(), format!("Closing error of the ledger.{last}")));
    }
    if figures.is_empty() {
        page.absent("No energies were recorded: history.csv has no columns energy_*.");
    } else {
        page.figures(&figures);
    }
}

fn ledger(history: &Table, time: &[f64]) -> Option<Plot> {
    let mut plot = Plot::new(Axis::new("time", "s"), Axis::new("energy", "J")).sized(560.0, 400.0);
    let mut any = false;
    for (column, values) in history
        .columns
        .iter()
        .zip(&history.values)
        .filter(|(c, _)| c.unit == "J")
    {
        let Some(name) = column
            .name
            .strip_prefix("energy_")
            .filter(|name| !is_closing(name))
        else {
            continue;
        };
        plot = plot.line(&name.replace('_', " "), points(time, values));
        any = true;
    }
    any.then_some(plot)
}

/// What the ledger's columns call its error.
fn is_closing(name: &str) -> bool {
    ["drift", "error", "residual", "imbalance"]
        .iter()
        .any(|word| name.contains(word))
}

fn closing_error(history: &Table, time: &[f64]) -> Option<Plot> {
    let (column, values) = history
        .columns
        .iter()
        .zip(&history.values)
        .find(|(c, _)| c.name.starts_with("energy") && is_closing(&c.name))?;
    let (factor, unit) = if column.unit == "J" {
        (1.0, "J")
    } else {
        (100.0, "%")
    };
    let percent: Vec<f64> = values.iter().map(|v| factor * v).collect();
    let plot =
        Plot::new(Axis::new("time", "s"), Axis::new("closing error", unit)).sized(560.0, 400.0);
    Some(plot.line("", points(time, &percent)))
}
