//! `[setup.bubble_cloud]`.

use super::common::{assert_identical, case, checkpoints, fresh, says, summary, wrong};
use erode::output::{Collection, Snapshot, Table};
use std::fs;
use std::path::PathBuf;

const TABLES: [&str; 6] = [
    "history.csv",
    "collapses.csv",
    "probes/bubble_0.csv",
    "surface/erosion_potential.csv",
    "fields.pvd",
    "fields/bubbles_000003.vtu",
];

/// The case with fewer bubbles for one period, so that each collapses.
fn finished(name: &str, more: &[&str]) -> PathBuf {
    let dir = fresh(name);
    let folder = case("bubble-cloud");
    let shorter = ["setup.bubble_cloud.count=40", "run.end_time=50 us"];
    let mut args = vec!["run", &folder, "-o", dir.to_str().unwrap()];
    args.extend(shorter.iter().flat_map(|m| ["--set", m]));
    args.extend(more);
    says(&args);
    dir
}

#[test]
fn the_case_writes_its_folder_and_loses_no_bubble() {
    let dir = finished("cloud", &["--threads", "2"]);
    let s = summary(&dir);
    let count = |key: &str| s[key].as_u64().unwrap();
    assert_eq!(s["ledger"]["bubbles_unaccounted"], 0.0);
    assert_eq!(s["ledger"]["bubbles_injected"], 40.0);
    assert_eq!(count("bubbles"), 40);
    assert!(count("impacts") > 5, "{s}");
    let collapses = Table::read(&dir.join("collapses.csv")).unwrap();
    assert_eq!(collapses.rows() as u64, count("collapses"));
    let impacts = collapses.column("impact_pressure").unwrap();
    let told = impacts.iter().filter(|p| p.is_finite()).count() as u64;
    assert_eq!(told, count("impacts"));
    for (standoff, impact) in collapses.column("standoff").unwrap().iter().zip(impacts) {
        assert_eq!(
            (0.2..=3.0).contains(standoff),
            impact.is_finite(),
            "{standoff}"
        );
    }
    let map = Table::read(&dir.join("surface/erosion_potential.csv")).unwrap();
    let total: f64 = map.column("erosion_potential").unwrap().iter().sum();
    assert!((total - 1.0).abs() < 1e-12);
    let hits: f64 = map.column("impacts").unwrap().iter().sum();
    assert_eq!(hits as u64, count("impacts"));
    let fields = Collection::read(&dir.join("fields.pvd")).unwrap();
    let last = fields.entries().last().unwrap();
    let snapshot = Snapshot::read(&dir.join(&last.file)).unwrap();
    assert_eq!(snapshot.points.len(), 40);
    assert!(snapshot.points.iter().all(|x| x[2] > 0.0), "above the wall");
    let report = fs::read_to_string(dir.join("report/index.html")).unwrap();
    for part in [
        "The cloud",
        "Paths of the followed bubbles",
        "impact pressure",
    ] {
        assert!(report.contains(part), "the report lacks `{part}`");
    }
}

/// Resumed from the older checkpoint, and with another number of threads.
#[test]
fn neither_threads_nor_a_resume_change_a_bit() {
    let (one, two) = (
        finished("one-thread", &["--threads", "1"]),
        finished("resumed", &["--threads", "2"]),
    );
    assert_identical(&one, &two, &TABLES);
    let kept = checkpoints(&two);
    assert_eq!(kept.len(), 2);
    fs::remove_file(&kept[1]).unwrap();
    fs::remove_file(two.join("summary.json")).unwrap();
    says(&["resume", two.to_str().unwrap()]);
    assert_identical(&one, &two, &TABLES);
}

#[test]
fn another_seed_is_another_cloud() {
    let one = finished("seed-1", &[]);
    let two = finished("seed-2", &["--set", "setup.bubble_cloud.seed=2"]);
    let read = |dir: &PathBuf| fs::read(dir.join("collapses.csv")).unwrap();
    assert_ne!(read(&one), read(&two));
}

#[test]
fn bubbles_outside_the_flow_are_refused_with_the_place() {
    let said = wrong(
        "below",
        "[setup.bubble_cloud]\ncount = 3\nregion = { x = [0, 0], y = [0, 0], z = [-1e-3, -1e-3] }\n\
         nuclei.constant.radius = 1e-5\nflow.stagnation = { strain_rate = 10, pressure = 1e5 }\n\
         [run]\nend_time = 1e-3\n",
    );
    let joined = said.replace(['\n', '│', ' '], "");
    assert!(
        joined.contains("outsideitsdomain") && joined.contains("-1e-3"),
        "{said}"
    );
}

#[test]
fn nuclei_without_equilibrium_name_the_threshold() {
    let said = wrong(
        "tension",
        "[setup.bubble_cloud]\ncount = 3\nregion = { x = [0, 0], y = [0, 0], z = [1, 2] }\n\
         nuclei.constant.radius = 1e-5\nflow.still.pressure = \"-50 kPa\"\n",
    );
    assert!(said.contains("Blake"), "{said}");
    assert!(said.contains("lacks `end_time`"), "{said}");
}
