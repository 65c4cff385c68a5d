//! The documents say what is there: commands, paths, names.

#![allow(clippy::unwrap_used)]

use erode::case::{Case, json_schema};
use erode::output::{RunPaths, Snapshot, Table};
use erode::run::{self, Ended, Quiet, Start};
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

const RUN: &str = "cargo run --release -- run cases/bubble-near-steel";
const TEST: &str = "cargo test --release";

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .ancestors()
        .nth(2)
        .expect("the crate lies two folders below the root")
        .to_path_buf()
}

fn read(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|e| panic!("{path}: {e}"))
}

/// Documents at the root, in `docs`, and beside cases and validations.
fn documents() -> Vec<PathBuf> {
    let mut found = Vec::new();
    let folders = [".", "docs", "cases", "validation"].map(|f| root().join(f));
    let below = |folder: &Path| -> Vec<PathBuf> {
        let entries = fs::read_dir(folder).expect("the folder can be read");
        entries
            .map(|e| e.expect("the folder can be read").path())
            .collect()
    };
    for (depth, folder) in folders.iter().enumerate() {
        for path in below(folder) {
            if path.extension().is_some_and(|e| e == "md") {
                found.push(path);
            } else if depth >= 2 && path.is_dir() {
                found.extend(
                    below(&path)
                        .into_iter()
                        .filter(|p| p.ends_with("README.md")),
                );
            }
        }
    }
    assert!(found.len() >= 10, "{found:?}");
    found
}

#[test]
fn the_readme_names_exactly_two_commands() {
    let readme = read("README.md");
    let mut fenced = false;
    let mut commands = Vec::new();
    for line in readme.lines() {
        if line.starts_with("```") {
            fenced = !fenced;
        } else if fenced {
            commands.push(line);
        }
    }
    assert_eq!(commands, [RUN, TEST]);
    let case = RUN.rsplit(' ').next().unwrap();
    Case::load(&root().join(case), &[], &[]).unwrap();
}

#[test]
fn the_check_of_every_change_runs_the_test_command() {
    let script = read(".ci/run");
    assert!(script.starts_with("#!") && script.contains("set -euo pipefail"));
    assert!(script.lines().any(|l| l == format!("step {TEST}")));
}

#[test]
fn nothing_speaks_of_a_machine() {
    let mut files = documents();
    files.push(root().join(".ci/run"));
    let foreign = [
        "/work",
        "/home/",
        "/root",
        "/tmp/",
        "/Users/",
        "C:\\",
        "../shared",
        "crates.io",
    ];
    for file in files {
        let text = fs::read_to_string(&file).unwrap();
        for word in foreign {
            assert!(!text.contains(word), "{} contains {word}", file.display());
        }
    }
}

#[test]
fn paths_in_the_documents_exist() {
    for file in documents() {
        let text = fs::read_to_string(&file).unwrap();
        let folder = file.parent().unwrap();
        let links = text
            .split("](")
            .skip(1)
            .filter_map(|t| t.split(')').next())
            // Addresses elsewhere and places within a document are not files.
            .filter(|t| !t.contains("://") && !t.starts_with('#'))
            .map(|t| folder.join(t.split('#').next().unwrap_or(t)));
        let code = text
            .split('`')
            .skip(1)
            .step_by(2)
            .filter(|t| t.starts_with("crates/") && !t.contains(['*', ' ']) && !t.contains("NAME"))
            .map(|t| root().join(t));
        for path in links.chain(code) {
            assert!(path.exists(), "{}: {}", file.display(), path.display());
        }
    }
}

/// Names of properties anywhere in a JSON schema.
fn properties(schema: &Value, found: &mut BTreeSet<String>) {
    match schema {
        Value::Object(map) => {
            if let Some(Value::Object(keys)) = map.get("properties") {
                found.extend(keys.keys().cloned());
            }
            map.values().for_each(|v| properties(v, found));
        }
        Value::Array(list) => list.iter().for_each(|v| properties(v, found)),
        _ => {}
    }
}

fn explained(names: impl IntoIterator<Item = String>) {
    let text = read("docs/naming.md");
    let missing: Vec<String> = names
        .into_iter()
        .filter(|n| !text.contains(&format!("`{n}`")))
        .collect();
    assert!(missing.is_empty(), "not in docs/naming.md: {missing:?}");
}

#[test]
fn every_key_of_a_case_is_explained() {
    let mut names = BTreeSet::new();
    properties(&json_schema(), &mut names);
    assert!(names.contains("standoff") && names.contains("taylor_quinney"));
    explained(names);
}

#[test]
fn every_name_in_a_run_folder_is_explained() {
    names_of_a_run(
        "bubble-near-steel",
        "setup.bubble_near_wall.particles_per_radius=8",
        &["wall_centre", "steel_below_surface"],
        &["liquid", "wall"],
    );
    // Gas has names of its own.
    names_of_a_run(
        "gas-rebound",
        "setup.bubble_in_liquid.particles_per_radius=6",
        &["beside"],
        &["liquid"],
    );
}

fn names_of_a_run(case: &str, coarse: &str, probes: &[&str], bodies: &[&str]) {
    let folder = tempfile::tempdir().unwrap();
    let output = folder.path().join("run");
    let start = Start {
        case: root().join("cases").join(case),
        overrides: vec![coarse.into(), "run.max_steps=2".into()],
        output: output.clone(),
        threads: None,
    };
    let ended = run::start(&start, &AtomicBool::new(false), &mut Quiet).unwrap();
    assert!(matches!(ended, Ended::Done { .. }));
    let paths = RunPaths::existing(&output).unwrap();

    let tables = probes.iter().map(|p| paths.probe(p));
    for path in tables.chain([paths.history()]) {
        let table = Table::read(&path).unwrap();
        explained(table.columns.into_iter().map(|c| c.name));
    }
    for body in bodies {
        let snapshot = Snapshot::read(&paths.snapshot(body, 0)).unwrap();
        explained(snapshot.fields.into_iter().map(|f| f.name));
    }
    for path in [paths.summary(), paths.status()] {
        let value: Value = serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap();
        let keys = value.as_object().unwrap();
        explained(keys.keys().cloned());
        let ledger = keys.get("ledger").and_then(Value::as_object);
        explained(ledger.into_iter().flat_map(|l| l.keys().cloned()));
    }
}
