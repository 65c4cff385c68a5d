//! What was asked: title, the case in short, the case files.

use serde_json::Value;

use crate::output::RunPaths;
use crate::report::html::Page;
use crate::report::run_data::RunData;
use crate::report::units::quantity;

/// The title of the case, else the name of the folder.
pub(crate) fn title(data: &RunData) -> String {
    let given = [&data.case, &data.resolved].into_iter().find_map(|text| {
        let table: toml::Table = text.parse().ok()?;
        Some(table.get("title")?.as_str()?.to_string())
    });
    let summary = || {
        data.summary
            .get("title")
            .and_then(Value::as_str)
            .map(str::to_string)
    };
    let folder = || {
        let dir = data.dir.canonicalize().unwrap_or_else(|_| data.dir.clone());
        dir.file_name()
            .map_or("run".into(), |n| n.to_string_lossy().into_owned())
    };
    given.or_else(summary).unwrap_or_else(folder)
}

/// Title, state of the run and troubles.
pub(crate) fn write_head(page: &mut Page, data: &RunData, title: &str) {
    let mut facts = vec!["Erode report".to_string()];
    let fact = |key: &str, words: &str| {
        data.number(key)
            .map(|v| format!("{} {words}", quantity(v, "-")))
    };
    facts.extend(fact("particles", "particles"));
    facts.extend(fact("steps", "steps"));
    facts.extend(
        data.number("wall_time")
            .map(|t| format!("computed in {}", duration(t))),
    );
    page.title(title, &facts.join(" · "));
    if let Some(warning) = incomplete(data) {
        page.alert(&warning);
    }
    for trouble in &data.troubles {
        page.alert(trouble);
    }
    let findings = data.summary.get("findings").and_then(Value::as_array);
    for finding in findings.into_iter().flatten().filter_map(Value::as_str) {
        page.alert(finding);
    }
}

/// Why the run is not a finished one, if it is not.
fn incomplete(data: &RunData) -> Option<String> {
    let text = |key: &str| data.status.get(key).and_then(Value::as_str).unwrap_or("");
    let message = text("message");
    let so_far = "The report shows what was written until then.";
    match text("state") {
        "failed" => Some(format!("This run failed. {message} {so_far}")),
        "interrupted" => Some(format!(
            "This run was interrupted. {message} `erode resume` continues it."
        )),
        "running" if RunPaths::new(&data.dir).holder().is_none() => Some(format!(
            "This run was killed; `erode resume` continues it. {so_far}"
        )),
        "running" => {
            Some("This run is still going on. The report shows what was written so far.".into())
        }
        _ if data.summary.is_null() => Some(format!(
            "This run has not ended: summary.json is missing. {so_far}"
        )),
        _ => None,
    }
}

/// The settings of the case file in a table.
pub(crate) fn write(page: &mut Page, data: &RunData) {
    page.section("What was asked");
    let Some(table) = data
        .case
        .parse::<toml::Table>()
        .ok()
        .filter(|_| !data.case.is_empty())
    else {
        page.absent("case.toml is missing or cannot be read.");
        return;
    };
    let mut rows = Vec::new();
    for key in ["setup", "bubble", "impacts", "run", "output", "checkpoint"] {
        if let Some(value) = table.get(key) {
            flatten(key, value, &mut rows);
        }
    }
    if let Some(bodies) = table.get("body").and_then(toml::Value::as_array) {
        let names: Vec<&str> = bodies
            .iter()
            .filter_map(|b| b.get("name")?.as_str())
            .collect();
        rows.push(vec!["bodies".into(), names.join(", ")]);
    }
    if rows.is_empty() {
        page.absent("The case file has no setup or run table; it is shown in full below.");
    } else {
        page.table(&["setting", "as written in case.toml"], &rows);
        page.paragraph(
            "What `--set` or a sweep changed is not in this table: resolved.toml, below, is what was computed.",
        );
    }
}

fn flatten(name: &str, value: &toml::Value, rows: &mut Vec<Vec<String>>) {
    match value {
        toml::Value::Table(table) => {
            for (key, inner) in table {
                flatten(&format!("{name}.{key}"), inner, rows);
            }
        }
        toml::Value::String(text) => rows.push(vec![shorter(name), text.clone()]),
        other => rows.push(vec![shorter(name), other.to_string()]),
    }
}

/// `setup.bubble_near_wall.radius` as `bubble_near_wall.radius`.
fn shorter(name: &str) -> String {
    name.strip_prefix("setup.").unwrap_or(name).to_string()
}

/// The case files in full.
pub(crate) fn write_files(page: &mut Page, data: &RunData) {
    page.section("Files");
    let files = [
        ("case.toml, as given", &data.case),
        ("resolved.toml, every default written out", &data.resolved),
    ];
    for (name, text) in files {
        if text.is_empty() {
            page.absent(&format!("{name}: not in the run folder."));
        } else {
            page.details(name, text);
        }
    }
    if !data.summary.is_null() {
        let text = serde_json::to_string_pretty(&data.summary).unwrap_or_default();
        page.details("summary.json, all final numbers", &text);
    }
    page.paragraph(
        "Numbers behind the figures: history.csv, surface/wall_pressure.csv, probes/*.csv (and impacts.csv of repeated impacts); fields.pvd opens in \
         ParaView.",
    );
}

/// A duration for people.
pub(crate) fn duration(seconds: f64) -> String {
    if seconds < 120.0 {
        format!("{seconds:.1} s")
    } else if seconds < 7200.0 {
        format!(
            "{:.0} min {:02.0} s",
            (seconds / 60.0).floor(),
            (seconds % 60.0).floor()
        )
    } else {
        format!(
            "{:.0} h {:02.0} min",
            (seconds / 3600.0).floor(),
            (seconds % 3600.0 / 60.0).floor()
        )
    }
}

#[cfg(test)]
mod tests {
    use super::duration;

    #[test]
    fn durations() {
        assert_eq!(duration(1.25), "1.2 s");
        assert_eq!(duration(245.9), "4 min 05 s");
        assert_eq!(duration(7385.0), "2 h 03 min");
    }
}
