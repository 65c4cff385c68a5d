//! `erode sweep`.

use super::common::{case, fresh, refused, says};
use erode::sweep::{Execution, Outcome, Overall, Plan, Watcher, execute};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

const RADII: &str = "\"setup.single_bubble.radius\" = [\"6 um\", \"8 um\", \"10 um\"]";

/// A sweep file over the case of a single bubble, and a folder for it that does not exist yet.
fn sweep(name: &str, text: &str) -> (String, PathBuf) {
    let root = fresh(&format!("sweep-{name}"));
    fs::create_dir_all(&root).unwrap();
    let file = root.join("radii.toml");
    write(&file, text);
    (file.to_str().unwrap().to_owned(), root.join("out"))
}

fn write(file: &Path, text: &str) {
    let head = format!(
        "case = \"{}\"\n[set]\nrun.end_time = \"30 us\"\n",
        case("single-bubble")
    );
    fs::write(file, head + text).unwrap();
}

/// Rows of results.csv as cells; none of them holds a comma here.
fn table(out: &Path) -> Vec<Vec<String>> {
    let text = fs::read_to_string(out.join("results.csv")).unwrap();
    text.lines()
        .map(|l| l.split(',').map(str::to_owned).collect())
        .collect()
}

fn column(table: &[Vec<String>], head: &str) -> Vec<String> {
    let at = table[0].iter().position(|h| h == head);
    let at = at.unwrap_or_else(|| panic!("no column {head} in {:?}", table[0]));
    table[1..].iter().map(|row| row[at].clone()).collect()
}

#[test]
fn all_runs_end_in_one_table_and_one_report() {
    let (file, out) = sweep("whole", &format!("[grid]\n{RADII}\n"));
    let to = out.to_str().unwrap();
    let dry = says(&["sweep", &file, "-o", to, "--dry-run"]);
    assert!(
        dry.contains("radius=10um") && dry.contains("3 runs"),
        "{dry}"
    );
    assert!(!out.exists(), "a dry run writes nothing");
    // A bubble has no particles, by which alone the cost could be told.
    assert!(
        dry.contains("unknown") && dry.contains("3 left; what they cost is not known"),
        "{dry}"
    );
    assert!(!dry.contains("less than"), "{dry}");
    let json = out.with_extension("json");
    let said = says(&["sweep", &file, "-o", to, "--json", json.to_str().unwrap()]);
    assert!(said.contains("3 of 3 runs complete"), "{said}");
    let table = table(&out);
    assert_eq!(
        column(&table, "run"),
        ["radius=6um", "radius=8um", "radius=10um"]
    );
    assert_eq!(column(&table, "state"), ["complete"; 3]);
    assert_eq!(
        column(&table, "setup.single_bubble.radius [m]"),
        ["6e-6", "8e-6", "1e-5"]
    );
    // Each run's own summary says the same.
    for (name, cell) in ["radius=6um", "radius=8um", "radius=10um"]
        .iter()
        .zip(column(&table, "largest_bubble_radius [m]"))
    {
        let own = super::common::summary(&out.join("runs").join(name));
        assert_eq!(
            own["largest_bubble_radius"].as_f64().unwrap(),
            cell.parse::<f64>().unwrap()
        );
    }
    assert_eq!(
        &fs::read(out.join("results.parquet")).unwrap()[..4],
        b"PAR1"
    );
    let report = fs::read_to_string(out.join("report.html")).unwrap();
    for part in [
        "Against radius",
        "largest bubble radius",
        "radius 8 um: radius of the bubble",
    ] {
        assert!(report.contains(part), "the report lacks `{part}`");
    }
    assert!(
        fs::read_to_string(json)
            .unwrap()
            .contains("\"run\": \"radius=6um\"")
    );
}

#[test]
fn complete_runs_are_kept_and_others_done_again() {
    let (file, out) = sweep("again", &format!("[grid]\n{RADII}\n"));
    let to = out.to_str().unwrap();
    says(&["sweep", &file, "-o", to]);
    let written = |name: &str| {
        let file = out.join("runs").join(name).join("history.csv");
        file.metadata().unwrap().modified().unwrap()
    };
    let before = ["radius=6um", "radius=8um"].map(written);
    fs::remove_dir_all(out.join("runs/radius=10um")).unwrap();
    // One that goes on from its checkpoint.
    fs::remove_file(out.join("runs/radius=8um/summary.json")).unwrap();
    let said = says(&["sweep", &file, "-o", to]);
    assert!(
        said.contains("begun: goes on") && said.contains("going on from"),
        "{said}"
    );
    assert!(said.contains("3 of 3 runs complete"), "{said}");
    assert_eq!(written("radius=6um"), before[0]);
    assert!(out.join("runs/radius=10um/summary.json").exists());
}

#[test]
fn a_changed_sweep_is_refused_with_the_difference() {
    let (file, out) = sweep("changed", &format!("[grid]\n{RADII}\n"));
    let to = out.to_str().unwrap();
    says(&["sweep", &file, "-o", to]);
    write(
        Path::new(&file),
        "[grid]\n\"setup.single_bubble.radius\" = [\"6 um\", \"9 um\"]\nsetup.single_bubble.tolerance = [1e-9]\n",
    );
    let said = refused(&["sweep", &file, "-o", to], 1);
    for part in [
        "- \"setup.single_bubble.radius\" = [\"6 um\", \"8 um\"",
        "+ setup.single_bubble.tolerance = [1e-9]",
        "radius=8um is no longer there",
        "--accept-changes",
    ] {
        assert!(said.contains(part), "`{part}` is not in {said}");
    }
    assert_eq!(table(&out).len(), 4, "the old results are as they were");
    says(&["sweep", &file, "-o", to, "--accept-changes"]);
    assert_eq!(table(&out).len(), 3);
    says(&["sweep", &file, "-o", to]);
}

/// With the base case changed, a run of the same name belongs to another case: refused, or set aside when asked to.
#[test]
fn a_changed_case_is_seen() {
    let (file, out) = sweep("base", &format!("[grid]\n{RADII}\n"));
    let to = out.to_str().unwrap();
    says(&["sweep", &file, "-o", to]);
    let text = fs::read_to_string(&file).unwrap();
    fs::write(&file, text.replace("30 us", "31 us")).unwrap();
    let said = refused(&["sweep", &file, "-o", to], 1);
    assert!(
        said.contains("- end_time = 3e-5") && said.contains("+ end_time = 3.1e-5"),
        "{said}"
    );
    let said = says(&["sweep", &file, "-o", to, "--accept-changes"]);
    assert!(said.contains("was moved to"), "{said}");
    assert!(out.join("runs/radius=6um.old-1/summary.json").exists());
}

/// A folder with other things in it is no folder for a sweep, whatever is accepted.
#[test]
fn files_of_others_are_kept() {
    let (file, out) = sweep("foreign", &format!("[grid]\n{RADII}\n"));
    let to = out.to_str().unwrap();
    let theirs =
        ["notes.txt", "cases/mine.toml", "runs/old.dat", "sweep.toml"].map(|f| out.join(f));
    for path in &theirs {
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, "mine").unwrap();
    }
    for more in [&["--accept-changes"][..], &[]] {
        let said = refused(&[&["sweep", &file, "-o", to], more].concat(), 1);
        assert!(said.contains("is not empty"), "{said}");
        for path in &theirs {
            assert_eq!(fs::read_to_string(path).unwrap(), "mine");
        }
        assert!(!out.join("plan").exists() && !out.join("results.csv").exists());
    }
}

/// What lies in the folder of a run that is not complete, or not by this program, is told for what it is.
#[test]
fn runs_that_cannot_be_used_are_told_apart() {
    let (file, out) = sweep("unfit", &format!("[grid]\n{RADII}\n"));
    let args = ["sweep", &file, "-o", out.to_str().unwrap()];
    says(&args);
    let older = out.join("runs/radius=6um/summary.json");
    let text = fs::read_to_string(&older).unwrap();
    let version = format!("\"erode\": \"{}\"", env!("CARGO_PKG_VERSION"));
    assert!(text.contains(&version), "{text}");
    fs::write(&older, text.replace(&version, "\"erode\": \"0.0.1\"")).unwrap();
    let begun = out.join("runs/radius=8um");
    fs::remove_file(begun.join("summary.json")).unwrap();
    fs::remove_dir_all(begun.join("checkpoints")).unwrap();
    let dry = says(&[&args[..], &["--dry-run"]].concat());
    let line = |name: &str| dry.lines().find(|l| l.contains(name)).unwrap().to_owned();
    assert!(
        line("radius=6um").contains("by another version of Erode: set aside"),
        "{dry}"
    );
    assert!(
        line("radius=8um").contains("without a usable checkpoint: set aside"),
        "{dry}"
    );
    assert!(line("radius=10um").ends_with("complete"), "{dry}");
    let said = says(&args);
    assert!(said.contains("3 of 3 runs complete"), "{said}");
    assert!(out.join("runs/radius=6um.old-1/summary.json").exists());
}

/// With all checkpoints damaged, the same command begins the run anew and loses nothing.
#[test]
fn a_run_without_a_whole_checkpoint_begins_anew() {
    let (file, out) = sweep("damaged", &format!("[grid]\n{RADII}\n"));
    let args = ["sweep", &file, "-o", out.to_str().unwrap()];
    says(&args);
    let run = out.join("runs/radius=8um");
    fs::remove_file(run.join("summary.json")).unwrap();
    for path in super::common::checkpoints(&run) {
        fs::write(path, "nothing").unwrap();
    }
    let said = says(&args);
    assert!(
        said.contains("there is no usable checkpoint") && said.contains("was moved to"),
        "{said}"
    );
    assert!(said.contains("3 of 3 runs complete"), "{said}");
    let old = out.join("runs/radius=8um.old-1/checkpoints");
    assert!(fs::read_dir(old).unwrap().next().is_some());
}

#[test]
fn what_was_found_is_told_before_a_file_that_cannot_be_written() {
    let (file, out) = sweep("unwritten", &format!("[grid]\n{RADII}\n"));
    let to = out.to_str().unwrap();
    let output = super::common::erode(&["sweep", &file, "-o", to, "--json", "/dev/null/x.json"]);
    assert_eq!(output.status.code(), Some(2));
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(said.contains("3 of 3 runs complete"), "{said}");
    let complaint = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(
        complaint.contains("x.json cannot be written"),
        "{complaint}"
    );
}

#[test]
fn a_run_that_fails_stops_none_of_the_others() {
    let (file, out) = sweep("failing", &format!("[grid]\n{RADII}\n"));
    let to = out.to_str().unwrap();
    says(&["sweep", &file, "-o", to]);
    // A run that is not complete, and of which another process has the folder.
    let run = out.join("runs/radius=8um");
    fs::remove_file(run.join("summary.json")).unwrap();
    let _other = erode::output::lock::RunLock::acquire(&run).unwrap();
    fs::remove_dir_all(out.join("runs/radius=10um")).unwrap();
    let said = refused(&["sweep", &file, "-o", to], 2);
    assert!(
        said.contains("1 run(s) failed") && said.contains("is in use by another process"),
        "{said}"
    );
    let table = table(&out);
    assert_eq!(column(&table, "state"), ["complete", "failed", "complete"]);
    assert!(
        fs::read_to_string(out.join("report.html"))
            .unwrap()
            .contains("radius=8um failed")
    );
}

/// Stops after the first run.
struct Stopper<'a> {
    stop: &'a AtomicBool,
    seen: Vec<f64>,
}

impl Watcher for Stopper<'_> {
    fn say(&mut self, _: &str) {}

    fn progress(&mut self, o: &Overall) {
        self.seen.push(o.whole);
    }

    fn ended(&mut self, _: &[Outcome]) {
        self.stop.store(true, Ordering::Relaxed);
    }
}

#[test]
fn a_stopped_sweep_goes_on_where_it_was() {
    let (file, out) = sweep("stopped", &format!("[grid]\n{RADII}\n"));
    let plan = Plan::read(Path::new(&file), false).unwrap();
    let stop = AtomicBool::new(false);
    let runs = plan
        .runs
        .iter()
        .map(|r| (r, out.join("runs").join(&r.name)));
    let what = Execution {
        case: &plan.case,
        runs: runs.collect(),
        threads: None,
        stop: &stop,
    };
    let mut stopper = Stopper {
        stop: &stop,
        seen: Vec::new(),
    };
    let outcomes = execute(&what, &mut stopper);
    assert_eq!(
        outcomes,
        [Outcome::Done, Outcome::Waiting, Outcome::Waiting]
    );
    stop.store(false, Ordering::Relaxed);
    let outcomes = execute(&what, &mut stopper);
    assert_eq!(outcomes[..2], [Outcome::Kept, Outcome::Done]);
    assert!(stopper.seen.iter().all(|w| (0.0..=1.0).contains(w)));
}

#[test]
fn wrong_sweeps_are_refused() {
    let (file, _) = sweep("empty", "[grid]\n\"setup.single_bubble.radius\" = []\n");
    let said = refused(&["sweep", &file], 1);
    assert!(
        said.contains("is empty") && said.contains("no value"),
        "{said}"
    );
    let (file, _) = sweep(
        "unknown",
        "[grid]\n\"setup.single_bubble.radios\" = [1e-6]\n",
    );
    let said = refused(&["sweep", &file], 1);
    assert!(said.contains("did you mean `radius`"), "{said}");
    let said = refused(&["sweep", "nowhere.toml"], 1);
    assert!(said.contains("nowhere.toml"), "{said}");
}
