//! The report of a sweep: one page with the table, every scalar against every varied key, and the end of each run.

use super::SweepError;
use super::chart::charts;
use super::execute::Outcome;
use super::folder::Folder;
use super::pictures::small_multiples;
use super::plan::{Plan, Planned, short_keys};
use super::results::Results;
use crate::output::atomic::write_atomic;
use crate::report::html::Page;
use crate::report::quantity;
use std::path::PathBuf;

/// Width of a picture, pixels.
const WIDTH: f64 = 370.0;
/// Scalars that the first table shows; all are in the files.
const SHOWN: usize = 6;

/// Writes `report.html`; its path.
///
/// # Errors
/// If it cannot be written.
pub fn write_report(
    plan: &Plan,
    folder: &Folder,
    results: &Results,
) -> Result<PathBuf, SweepError> {
    let mut page = Page::default();
    page.title(&plan.title, &subtitle(plan, results));
    for (run, outcome) in plan.runs.iter().zip(&results.outcomes) {
        if let Outcome::Failed(why) = outcome {
            page.alert(&format!("{} failed: {why}", run.name));
        }
    }
    overview(&mut page, plan, results);
    ends(&mut page, plan, folder, results);
    let short = short_keys(&plan.keys);
    for (k, key) in short.iter().enumerate() {
        let charts = charts(plan, results, k);
        page.section(&format!("Against {}", key.replace('_', " ")));
        if charts.figures.is_empty() {
            page.absent("No scalar is known in two runs and differs between them.");
            continue;
        }
        page.multiples(&charts.figures);
        if !charts.without.is_empty() {
            page.absent(&format!(
                "The same in all runs, or known in less than two: {}.",
                charts.without.join(", ")
            ));
        }
    }
    page.section("The sweep file");
    page.details("sweep.toml", &plan.source);
    let html = page.finish(&plan.title);
    write_atomic(&folder.report(), |f| f.write_all(html.as_bytes()))?;
    Ok(folder.report())
}

fn subtitle(plan: &Plan, results: &Results) -> String {
    let complete = results.outcomes.iter().filter(|o| o.is_complete()).count();
    let form = if plan.quick { "Quick form. " } else { "" };
    format!(
        "{form}{complete} of {} runs complete. All scalars: results.csv, results.parquet.",
        plan.runs.len()
    )
}

/// Name, state, and the scalars that differ most between the runs.
fn overview(page: &mut Page, plan: &Plan, results: &Results) {
    page.section("Runs");
    let chosen = telling(results);
    let mut heads = vec!["run".to_owned(), "state".to_owned()];
    heads.extend(chosen.iter().map(|(name, _)| name.replace('_', " ")));
    let heads: Vec<&str> = heads.iter().map(String::as_str).collect();
    let row = |k: usize| {
        let mut cells = vec![
            plan.runs[k].name.clone(),
            results.outcomes[k].word().to_owned(),
        ];
        cells.extend(chosen.iter().map(|(name, unit)| {
            let value = results.summaries[k].as_ref().and_then(|s| s.get(name));
            value.map_or("-".into(), |v| quantity(v, unit))
        }));
        cells
    };
    let rows: Vec<Vec<String>> = (0..plan.runs.len()).map(row).collect();
    page.table(&heads, &rows);
}

/// The first scalars that are not the same in all runs.
fn telling(results: &Results) -> Vec<(String, String)> {
    let differs = |name: &str| {
        let mut values = results.summaries.iter().flatten().map(|s| s.get(name));
        let first = values.next().flatten();
        results.summaries.iter().flatten().count() < 2 || values.any(|v| v != first)
    };
    let all = results.scalars().into_iter();
    all.filter(|(name, _)| differs(name)).take(SHOWN).collect()
}

fn ends(page: &mut Page, plan: &Plan, folder: &Folder, results: &Results) {
    page.section("The end of each run");
    let complete = plan.runs.iter().zip(&results.outcomes);
    let runs: Vec<(String, PathBuf)> = complete
        .filter(|(_, o)| o.is_complete())
        .map(|(r, _)| (heading(plan, r), folder.run(&r.name)))
        .collect();
    let ends = small_multiples(&runs, WIDTH);
    if runs.is_empty() {
        page.absent("No run is complete.");
    } else if !ends.pictures.is_empty() {
        page.paragraph(ends.told);
        let figures = ends.pictures.into_iter().map(|p| (p.svg, p.caption));
        page.multiples(&figures.collect::<Vec<_>>());
    }
    for sentence in &ends.absent {
        page.absent(sentence);
    }
}

/// The varied values of a run in words.
fn heading(plan: &Plan, run: &Planned) -> String {
    let short = short_keys(&plan.keys);
    let parts = plan.keys.iter().zip(short).filter_map(|(key, short)| {
        let value = run.value(key)?;
        Some(format!("{} {}", short.replace('_', " "), value.shown))
    });
    parts.collect::<Vec<_>>().join(", ")
}
