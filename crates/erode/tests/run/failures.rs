//! Calculations that go wrong stop with a place and an explanation.

use super::common::{CASE, checkpoints, erode, fresh, says, start, text};
use erode::output::{Collection, Snapshot};
use std::path::Path;

/// What every message of an instability must tell.
fn assert_explained(said: &str, body: &str) {
    let place = format!("in body `{body}` at r = ");
    for part in [
        "` of particle ",
        &place,
        " m, z = ",
        " at t = ",
        "(step ",
        "time step ",
        ", limited by ",
        "likely cause",
    ] {
        assert!(said.contains(part), "`{part}` is missing: {said}");
    }
    assert!(
        said.contains("run.safety") && said.contains("failure.vtu") && said.contains("checkpoint"),
        "{said}"
    );
}

/// Every snapshot that lies there is listed, the last one before the failure too.
fn assert_all_listed(dir: &Path) {
    let listed = Collection::read(&dir.join("fields.pvd")).unwrap();
    let mut listed: Vec<_> = listed.entries().iter().map(|e| dir.join(&e.file)).collect();
    listed.sort();
    let files = std::fs::read_dir(dir.join("fields")).unwrap();
    let mut there: Vec<_> = files.map(|f| f.unwrap().path()).collect();
    there.sort();
    assert!(!there.is_empty());
    assert_eq!(listed, there);
}

fn particles(path: &Path) -> usize {
    Snapshot::read(path).unwrap().points.len()
}

#[test]
fn a_time_step_ten_times_too_large_is_found_in_the_metal() {
    let dir = fresh("unstable-metal");
    let output = start(CASE, &dir, &["--set", "run.safety=3"])
        .wait_with_output()
        .unwrap();
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert_explained(&said, "wall");
    assert!(said.contains("10.0 times the usual one"), "{said}");
    assert_all_listed(&dir);
    let near = particles(&dir.join("failure_wall.vtu"));
    let all = particles(&dir.join("fields/wall_000000.vtu"));
    assert!(0 < near && near < all, "{near} of {all} particles");
    particles(&dir.join("failure.vtu"));
    assert!(!checkpoints(&dir).is_empty());
    let now = says(&["status", dir.to_str().unwrap()]);
    assert!(
        now.contains("failed") && now.contains("likely cause"),
        "{now}"
    );
    assert!(
        !dir.join("summary.json").exists(),
        "a failed run has no final numbers"
    );
}

/// A bubble in liquid alone with a time step `safety` / 0.3 of the usual.
fn liquid_alone(name: &str, safety: &str) -> String {
    let case = fresh(&format!("{name}-case"));
    says(&["new", "bubble-in-liquid", case.to_str().unwrap()]);
    let dir = fresh(name);
    let output = erode(&[
        "run",
        case.to_str().unwrap(),
        "-o",
        dir.to_str().unwrap(),
        "--set",
        "setup.bubble_in_liquid.particles_per_radius=6",
        "--set",
        "run.end_time=2 us",
        "--set",
        "output.history_every=20 ns",
        "--set",
        &format!("run.safety={safety}"),
    ]);
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(particles(&dir.join("failure.vtu")) > 0);
    assert_all_listed(&dir);
    said
}

#[test]
fn a_time_step_ten_times_too_large_is_found_in_the_liquid() {
    assert_explained(&liquid_alone("unstable-liquid", "3"), "liquid");
}

/// Five times too large is not enough to tear the liquid apart, only to heat it without end.
#[test]
fn energy_from_nowhere_stops_the_run() {
    let said = liquid_alone("open-ledger", "1.5");
    assert!(
        said.contains("`energy_residual` is +") && said.contains("likely cause"),
        "{said}"
    );
}
