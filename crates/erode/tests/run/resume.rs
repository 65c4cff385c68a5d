//! Runs that end early, by whatever cause, go on to the same bits.

use super::common::{
    CASE, assert_identical, checkpoints, erode, finished, fresh, refused, says, short, start,
    summary, text, until,
};
use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::{Duration, SystemTime};

fn status(dir: &Path) -> String {
    says(&["status", dir.to_str().unwrap()])
}

/// A number between 0 and 1 that differs from run to run.
fn chance() -> f64 {
    let now = SystemTime::now()
        .duration_since(SystemTime::UNIX_EPOCH)
        .unwrap();
    f64::from(now.subsec_nanos() % 1_000_003) / 1_000_003.0
}

#[test]
fn a_killed_run_goes_on_to_the_same_bits() {
    let whole = finished(CASE).dir;
    let mut wait = chance() * summary(&whole)["wall_time"].as_f64().unwrap();
    let dir = loop {
        let dir = fresh("killed");
        let mut child = start(CASE, &dir, &["--threads", "2"]);
        until("the first checkpoint", || {
            !checkpoints(&dir).is_empty() && dir.join("status.json").exists()
        });
        std::thread::sleep(Duration::from_secs_f64(wait));
        child.kill().unwrap();
        child.wait().unwrap();
        if !status(&dir).contains("done") {
            break dir;
        }
        // It was faster than the finished run.
        wait *= 0.5;
    };
    let said = status(&dir);
    assert!(
        said.contains("killed?") && said.contains("erode resume"),
        "{said}"
    );
    let path = dir.to_str().unwrap();
    says(&["report", path]);
    let resumed = says(&["resume", path, "--threads", "1"]);
    assert!(resumed.contains("going on from"), "{resumed}");
    assert!(status(&dir).contains("done"));
    println!("killed after {wait} s: {said}");
    assert_identical(&dir, &whole);
}

#[test]
fn a_stopped_run_refuses_bad_checkpoints_and_goes_on_from_a_good_one() {
    let dir = fresh("stopped");
    let path = dir.to_str().unwrap();
    stop(&dir);
    another_case_is_refused(&dir);
    a_changed_case_is_refused(&dir);
    let [older, newest] = &checkpoints(&dir)[..] else {
        panic!("two checkpoints are kept")
    };
    let (good, better) = (fs::read(older).unwrap(), fs::read(newest).unwrap());

    fs::write(older, flipped(&good)).unwrap();
    fs::write(newest, flipped(&better)).unwrap();
    let said = refused(&["resume", path], 2);
    assert!(
        said.contains("no usable checkpoint") && said.contains("erode run"),
        "{said}"
    );
    for file in [older, newest] {
        assert!(
            said.contains(&format!("{} is refused", file.display())),
            "{said}"
        );
    }
    assert!(said.contains("the checksum is wrong"), "{said}");

    fs::write(older, &good).unwrap();
    let said = says(&["resume", path, "--threads", "2"]);
    assert!(
        said.contains(&format!("{} is refused", newest.display())) && said.contains("is damaged"),
        "{said}"
    );
    assert!(
        said.contains(&format!("going on from {}", older.display())),
        "{said}"
    );
    let aside = newest.with_extension("erode.refused");
    assert_eq!(
        fs::read(aside).unwrap(),
        flipped(&better),
        "a refused file is kept"
    );
    assert_identical(&dir, &finished(CASE).dir);

    // A finished run has nothing left to do and stays as it is.
    says(&["resume", path]);
    assert_identical(&dir, &finished(CASE).dir);
}

/// Starts a run, looks at it, and stops it with SIGTERM when it has two checkpoints.
fn stop(dir: &Path) {
    let path = dir.to_str().unwrap();
    let child = start(CASE, dir, &["--threads", "2"]);
    until("two checkpoints", || checkpoints(dir).len() == 2);
    let said = status(dir);
    assert!(
        said.contains("running") && said.contains("limited by"),
        "{said}"
    );
    let said = refused(&["resume", path], 1);
    assert!(
        said.contains("in use by another process") && said.contains(&child.id().to_string()),
        "{said}"
    );
    assert!(
        Command::new("kill")
            .args(["-TERM", &child.id().to_string()])
            .status()
            .unwrap()
            .success()
    );
    let output = child.wait_with_output().unwrap();
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(3), "{said}");
    assert!(
        said.contains("interrupted at t = ") && said.contains(&format!("erode resume {path}")),
        "{said}"
    );
    let said = status(dir);
    assert!(
        said.contains("interrupted") && said.contains("erode resume"),
        "{said}"
    );
}

fn another_case_is_refused(dir: &Path) {
    let resolved = dir.join("resolved.toml");
    let given = fs::read_to_string(&resolved).unwrap();
    let changed = given.replace("safety = 0.3", "safety = 0.2");
    assert_ne!(changed, given);
    fs::write(&resolved, changed).unwrap();
    let said = refused(&["resume", dir.to_str().unwrap()], 2);
    assert!(said.contains("belongs to another case"), "{said}");
    fs::write(&resolved, given).unwrap();
}

/// What is changed in the case after the beginning would be ignored: it is refused, with what was changed.
fn a_changed_case_is_refused(dir: &Path) {
    let case = dir.join("case.toml");
    let given = fs::read_to_string(&case).unwrap();
    let changed = given.replace("standoff = 0.66", "standoff = 0.7");
    assert_ne!(changed, given);
    fs::write(&case, changed).unwrap();
    let said = refused(&["resume", dir.to_str().unwrap()], 1);
    for part in [
        "was changed since the run began",
        "- standoff = 0.66",
        "+ standoff = 0.7",
        "erode run",
    ] {
        assert!(said.contains(part), "`{part}` is not in: {said}");
    }
    fs::write(&case, given).unwrap();
}

fn flipped(bytes: &[u8]) -> Vec<u8> {
    let mut other = bytes.to_vec();
    other[bytes.len() / 2] ^= 1;
    other
}

/// A limit on the size of files stands for a full disk, which a test cannot make.
#[test]
fn a_file_that_cannot_grow_stops_the_run_and_loses_nothing() {
    let dir = fresh("full");
    // More than a checkpoint has, less than the largest table, whether the shell counts in 512 or 1024 bytes.
    let limited = "trap '' XFSZ; ulimit -f 400; exec \"$0\" \"$@\"";
    let output = Command::new("sh")
        .args(["-c", limited, env!("CARGO_BIN_EXE_erode")])
        .args(short(CASE, &dir))
        .args(["--threads", "2"])
        .output()
        .unwrap();
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(
        said.contains(".csv could not be written: the file would be larger"),
        "{said}"
    );
    assert!(said.contains("erode resume"), "{said}");
    let now = status(&dir);
    assert!(
        now.contains("failed") && now.contains("could not be written"),
        "{now}"
    );
    let resumed = erode(&["resume", dir.to_str().unwrap()]);
    assert!(resumed.status.success(), "{}", text(&resumed.stderr));
    assert_identical(&dir, &finished(CASE).dir);
}

/// A load follows time alone: a run that goes on from a checkpoint finds it where it was.
#[test]
fn an_indentation_goes_on_to_the_same_bits() {
    let dirs = ["indented", "indented-again"].map(fresh);
    for dir in &dirs {
        let output = start("indentation", dir, &[]).wait_with_output().unwrap();
        assert!(output.status.success(), "{}", text(&output.stderr));
    }
    fs::remove_file(&checkpoints(&dirs[1])[1]).unwrap();
    says(&["resume", dirs[1].to_str().unwrap()]);
    assert_identical(&dirs[0], &dirs[1]);
}

/// The published forms carry other state than the default ones; without its last checkpoint a finished run is one that
/// was killed after the one before.
#[test]
fn a_run_of_the_published_forms_goes_on_to_the_same_bits() {
    let more = [
        "--set",
        "setup.bubble_near_wall.liquid_formulation.joshi={}",
        "--set",
        "setup.bubble_near_wall.wall_formulation.joshi={}",
        "--set",
        "run.end_time=0.4 us",
    ];
    let dirs = ["published", "published-again"].map(fresh);
    for dir in &dirs {
        let output = start(CASE, dir, &more).wait_with_output().unwrap();
        assert!(output.status.success(), "{}", text(&output.stderr));
    }
    fs::remove_file(&checkpoints(&dirs[1])[1]).unwrap();
    says(&["resume", dirs[1].to_str().unwrap()]);
    assert_identical(&dirs[0], &dirs[1]);
}

/// Particles that came and went: their number, order and origin are part of a checkpoint. One or two threads.
#[test]
fn a_refined_run_goes_on_to_the_same_bits() {
    let dirs = ["refined", "refined-again"].map(fresh);
    for (dir, threads) in dirs.iter().zip(["2", "1"]) {
        let refined =
            "setup.bubble_near_wall.liquid_formulation.corrected.refinement.per_radius=12";
        let short = "run.end_time=1 us";
        let set = ["--set", refined, "--set", short, "--threads", threads];
        let output = start(CASE, dir, &set).wait_with_output().unwrap();
        assert!(output.status.success(), "{}", text(&output.stderr));
    }
    let halved = summary(&dirs[0])["ledger"]["particles_halved"].as_f64();
    assert!(halved.unwrap() > 10.0, "{halved:?}");
    fs::remove_file(&checkpoints(&dirs[1])[1]).unwrap();
    says(&["resume", dirs[1].to_str().unwrap(), "--threads", "1"]);
    assert_identical(&dirs[0], &dirs[1]);
}

/// Gas beside particles that come and go: its cells become smaller with them.
#[test]
fn a_refined_gas_bubble_goes_on_to_the_same_bits() {
    let dirs = ["refined-gas", "refined-gas-again"].map(fresh);
    for (dir, threads) in dirs.iter().zip(["2", "1"]) {
        let refined = "setup.bubble_in_liquid.liquid_formulation.corrected.refinement={per_radius=8, growth=0.3}";
        let set = ["--set", refined, "--threads", threads];
        let output = start("gas-rebound", dir, &set).wait_with_output().unwrap();
        assert!(output.status.success(), "{}", text(&output.stderr));
    }
    let halved = summary(&dirs[0])["ledger"]["particles_halved"].as_f64();
    assert!(halved.unwrap() > 10.0, "{halved:?}");
    fs::remove_file(checkpoints(&dirs[1]).last().unwrap()).unwrap();
    says(&["resume", dirs[1].to_str().unwrap(), "--threads", "1"]);
    assert_identical(&dirs[0], &dirs[1]);
}

#[test]
fn a_gas_bubble_comes_back_and_goes_on_to_the_same_bits() {
    let whole = finished("gas-rebound").dir;
    let all = summary(&whole);
    let number = |key: &str| all[key].as_f64().unwrap();
    // Keller and Miksis: 0.288 and 18.6 MPa; six particles per radius leave less than two at the smallest radius.
    let smallest = number("smallest_bubble_radius") / 1e-4;
    assert!((smallest / 0.288 - 1.0).abs() < 0.25, "{smallest}");
    assert!(number("max_gas_pressure") > 5e6 && number("gas_parts") == 1.0);
    let dir = fresh("gas-stopped");
    let mut child = start("gas-rebound", &dir, &["--threads", "1"]);
    until("two checkpoints", || checkpoints(&dir).len() == 2);
    child.kill().unwrap();
    child.wait().unwrap();
    says(&["resume", dir.to_str().unwrap(), "--threads", "2"]);
    assert_identical(&dir, &whole);
}

#[test]
fn a_coated_solid_goes_on_to_the_same_bits() {
    let whole = finished("coated-steel").dir;
    let layers = summary(&whole)["layers"].as_array().unwrap().clone();
    let of = |key: &'static str| layers.iter().map(move |l| l[key].as_f64().unwrap());
    // The copper is thicker than two of the coarse spacings, and both metals yield.
    let thick: Vec<f64> = of("resolved_thickness").collect();
    assert!(
        layers.len() == 2 && (thick[0] / 20e-6 - 1.0).abs() < 0.25,
        "{layers:?}"
    );
    assert!(of("max_plastic_strain").all(|e| e > 1e-3), "{layers:?}");
    // Two coarse rows of it are 11 % too thin, which is told at the start and at the end.
    let said = finished("coated-steel").said;
    assert_eq!(
        said.matches("note: layer 1 (copper_ofhc) is ").count(),
        2,
        "{said}"
    );
    let total: f64 = of("plastic_work").sum();
    let told = summary(&whole)["plastic_work"].as_f64().unwrap();
    assert!((total / told - 1.0).abs() < 1e-9);
    let report = fs::read_to_string(whole.join("report/index.html")).unwrap();
    assert!(report.contains("copper_ofhc") && report.contains("Layers"));

    let dir = fresh("coated-stopped");
    let mut child = start("coated-steel", &dir, &["--threads", "1"]);
    until("two checkpoints", || checkpoints(&dir).len() == 2);
    child.kill().unwrap();
    child.wait().unwrap();
    says(&["resume", dir.to_str().unwrap(), "--threads", "2"]);
    assert_identical(&dir, &whole);
}
