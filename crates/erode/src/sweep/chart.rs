//! Every scalar against a varied key.

use super::plan::{Plan, short_keys};
use super::results::Results;
use crate::report::plot::{Axis, Plot, Series, Style};

/// Size of a chart, pixels.
const SIZE: [f64; 2] = [370.0, 260.0];

/// The charts of one key.
pub(super) struct Charts {
    /// SVG and caption of each.
    pub(super) figures: Vec<(String, String)>,
    /// Scalars that are the same in all runs, or known in less than two.
    pub(super) without: Vec<String>,
}

/// One chart per scalar, the key along x, a curve for each combination of the other keys.
pub(super) fn charts(plan: &Plan, results: &Results, key: usize) -> Charts {
    let mut charts = Charts {
        figures: Vec::new(),
        without: Vec::new(),
    };
    let places = places(plan, key);
    for (name, unit) in results.scalars() {
        let value = |k: usize| results.summaries[k].as_ref().and_then(|s| s.get(&name));
        let values: Vec<f64> = (0..plan.runs.len())
            .filter(|k| places.x[*k].is_some())
            .filter_map(value)
            .collect();
        if values.len() < 2 || values.iter().all(|v| *v == values[0]) {
            charts.without.push(name);
            continue;
        }
        let axes = (
            Axis::new(&places.label, &places.unit),
            Axis::new(&name.replace('_', " "), &unit),
        );
        let mut plot = Plot::new(axes.0, axes.1).sized(SIZE[0], SIZE[1]);
        for (index, (label, members)) in curves(plan, key).into_iter().enumerate() {
            let mut points: Vec<[f64; 2]> = members
                .iter()
                .filter_map(|k| Some([places.x[*k]?, value(*k)?]))
                .collect();
            points.sort_by(|a, b| a[0].total_cmp(&b[0]));
            plot = marked(plot, &label, points, index);
        }
        charts.figures.push((plot.to_svg(), String::new()));
    }
    charts
}

/// A curve with a dot at each run.
fn marked(plot: Plot, label: &str, points: Vec<[f64; 2]>, index: usize) -> Plot {
    use crate::report::plot::COLOURS;
    let colour = Some(COLOURS[index % COLOURS.len()].to_owned());
    let series = |label: &str, style: Style| Series {
        label: label.to_owned(),
        points: points.clone(),
        style,
        colour: colour.clone(),
    };
    plot.series(series(label, Style::Line))
        .series(series("", Style::Points))
}

/// Where each run lies along x.
struct Places {
    x: Vec<Option<f64>>,
    label: String,
    unit: String,
}

fn places(plan: &Plan, key: usize) -> Places {
    let short = &short_keys(&plan.keys)[key];
    let values: Vec<_> = plan.runs.iter().map(|r| r.value(&plan.keys[key])).collect();
    let given = || values.iter().flatten();
    if given().all(|v| v.number.is_some()) {
        return Places {
            x: values.iter().map(|v| v.and_then(|v| v.number)).collect(),
            label: short.replace('_', " "),
            unit: given()
                .map(|v| v.unit.clone())
                .find(|u| u != "-")
                .unwrap_or_else(|| "-".into()),
        };
    }
    let mut words: Vec<&str> = Vec::new();
    for v in given() {
        if !words.contains(&v.shown.as_str()) {
            words.push(&v.shown);
        }
    }
    let number = |shown: &str| words.iter().position(|w| *w == shown).map(|k| k as f64);
    let list = words.iter().enumerate();
    let list: Vec<String> = list.map(|(k, w)| format!("{k}: {w}")).collect();
    Places {
        x: values
            .iter()
            .map(|v| v.and_then(|v| number(&v.shown)))
            .collect(),
        label: format!("{} ({})", short.replace('_', " "), list.join(", ")),
        unit: "-".into(),
    }
}

/// Runs that share all other values, with what they share in words. Values that are taken together with the key vary
/// along the curve.
fn curves(plan: &Plan, key: usize) -> Vec<(String, Vec<usize>)> {
    let short = short_keys(&plan.keys);
    let tied = |k: usize| plan.tied.contains(&key) && plan.tied.contains(&k);
    let others: Vec<usize> = (0..plan.keys.len())
        .filter(|k| *k != key && !tied(*k))
        .collect();
    let mut curves: Vec<(String, Vec<usize>)> = Vec::new();
    for (index, run) in plan.runs.iter().enumerate() {
        let parts = others.iter().filter_map(|k| {
            let value = run.value(&plan.keys[*k])?;
            Some(format!("{} {}", short[*k].replace('_', " "), value.shown))
        });
        let label = parts.collect::<Vec<_>>().join(", ");
        match curves.iter_mut().find(|c| c.0 == label) {
            Some(curve) => curve.1.push(index),
            None => curves.push((label, vec![index])),
        }
    }
    curves
}
