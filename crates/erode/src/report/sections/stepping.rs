//! The time step, what limited it, and facts about the run.

use serde_json::Value;

use super::asked::duration;
use super::results::FACTS;
use crate::report::html::Page;
use crate::report::instants::Instants;
use crate::report::plot::{Axis, Plot};
use crate::report::run_data::RunData;
use crate::report::units::{grouped, in_words, quantity, significant};

/// Writes the section.
pub(crate) fn write(page: &mut Page, data: &RunData, instants: &Instants) {
    page.section("Time step and run");
    match data.history_points("dt") {
        Some(steps) => page.figures(&[(step_plot(steps, instants), "The time step.".into())]),
        None => page.absent("No time steps were recorded: history.csv has no column dt."),
    }
    page.columns(
        |left| {
            write_limiters(left, data);
            write_seconds(left, data);
        },
        |right| write_facts(right, data),
    );
}

fn step_plot(steps: Vec<[f64; 2]>, instants: &Instants) -> String {
    let sizes = || steps.iter().map(|p| p[1]).filter(|v| *v > 0.0);
    let spread = sizes().fold(0.0, f64::max) / sizes().fold(f64::INFINITY, f64::min);
    let axis = Axis::new("time step", "s");
    let axis = if spread > 30.0 {
        axis.logarithmic()
    } else {
        axis
    };
    let mut plot = Plot::new(Axis::new("time", "s"), axis)
        .sized(1100.0, 260.0)
        .line("", steps);
    for (time, name) in instants.named() {
        plot = plot.event(time, name);
    }
    plot.to_svg()
}

fn write_limiters(page: &mut Page, data: &RunData) {
    let counts = ["limiters", "limiter_counts"]
        .iter()
        .find_map(|key| data.summary.get(key)?.as_object());
    let mut counts: Vec<(&String, f64)> = counts
        .into_iter()
        .flatten()
        .filter_map(|(name, count)| Some((name, count.as_f64()?)))
        .collect();
    let total: f64 = counts.iter().map(|c| c.1).sum();
    if total <= 0.0 {
        page.absent("What limited the step was not recorded (summary.json has no limiters).");
        return;
    }
    counts.sort_by(|a, b| b.1.total_cmp(&a.1));
    let rows: Vec<Vec<String>> = counts
        .iter()
        .map(|(name, count)| {
            vec![
                in_words(name),
                grouped(*count),
                format!("{} %", significant(100.0 * count / total, 3)),
            ]
        })
        .collect();
    page.table(&["what limited the step", "steps", "share"], &rows);
}

/// Where the time of the run went.
fn write_seconds(page: &mut Page, data: &RunData) {
    let parts = data.summary.get("seconds").and_then(Value::as_object);
    let parts: Vec<(&String, f64)> = (parts.into_iter().flatten())
        .filter_map(|(name, seconds)| Some((name, seconds.as_f64()?)))
        .collect();
    let total: f64 = parts.iter().map(|p| p.1).sum();
    if total <= 0.0 {
        return;
    }
    let rows: Vec<Vec<String>> = (parts.iter())
        .map(|(name, seconds)| {
            vec![
                in_words(name),
                format!("{} s", significant(*seconds, 3)),
                format!("{} %", significant(100.0 * seconds / total, 3)),
            ]
        })
        .collect();
    page.table(&["part of the run", "time", "share"], &rows);
}

fn write_facts(page: &mut Page, data: &RunData) {
    let fact = |key: &str| match data.summary.get(key)? {
        Value::Number(number) if key == "wall_time" => Some(duration(number.as_f64()?)),
        Value::Number(number) => Some(quantity(number.as_f64()?, data.unit(key))),
        Value::String(text) => Some(text.clone()),
        _ => None,
    };
    let mut rows: Vec<Vec<String>> = FACTS
        .iter()
        .filter_map(|(key, words)| Some(vec![words.to_string(), fact(key)?]))
        .collect();
    if let (Some(steps), Some(time)) = (
        data.number("steps"),
        data.number("wall_time").filter(|t| *t > 0.0),
    ) {
        rows.push(vec![
            "Steps per second".into(),
            significant(steps / time, 3),
        ]);
    }
    let versions = data.summary.get("versions").and_then(Value::as_object);
    for (name, version) in versions.into_iter().flatten() {
        rows.push(vec![
            format!("Version of {name}").replace('_', " "),
            version.as_str().unwrap_or("").to_string(),
        ]);
    }
    rows.push(vec![
        "Instants with fields".into(),
        data.frames.len().to_string(),
    ]);
    page.table(&["run", ""], &rows);
}
