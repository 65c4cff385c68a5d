//! Starting the program, the shortened cases, and comparing run folders.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::sync::{Mutex, OnceLock};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// The case of the tests that need one: the hardest, as the jet meets the wall and the liquid breaks up.
pub(crate) const CASE: &str = "bubble-attached";

/// Particles per radius of a shortened case: a run takes seconds and still goes through the collapse.
const COARSE: &str = "6";

/// Nothing here takes this long.
const PATIENCE: Duration = Duration::from_secs(300);

pub(crate) fn erode(args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_erode"))
        .args(args)
        .output()
        .unwrap()
}

pub(crate) fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// Standard error of a command that must end with `code`.
pub(crate) fn refused(args: &[&str], code: i32) -> String {
    let output = erode(args);
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(code), "{args:?}: {said}");
    said
}

/// Standard output of a command that must succeed.
pub(crate) fn says(args: &[&str]) -> String {
    let output = erode(args);
    assert!(
        output.status.success(),
        "{args:?}: {}",
        text(&output.stderr)
    );
    text(&output.stdout)
}

/// The folder of all cases.
fn cases_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases")
}

/// Cases without particles: they run in the tests of `bubbles`.
const WITHOUT_PARTICLES: [&str; 2] = ["single-bubble", "bubble-cloud"];

/// The names of all cases with particles.
pub(crate) fn cases() -> Vec<String> {
    let entries = fs::read_dir(cases_folder())
        .unwrap()
        .map(|e| e.unwrap().path());
    let mut names: Vec<String> = entries
        .filter(|p| p.is_dir())
        .map(|p| p.file_name().unwrap().to_str().unwrap().to_owned())
        .collect();
    names.retain(|n| !WITHOUT_PARTICLES.contains(&n.as_str()));
    names.sort();
    names
}

/// Arguments that run a case shortened: coarsely if it has a setup, else for a few steps.
pub(crate) fn short(case: &str, dir: &Path) -> Vec<String> {
    let folder = cases_folder().join(case);
    let given: toml::Table = fs::read_to_string(folder.join("case.toml"))
        .unwrap()
        .parse()
        .unwrap();
    let setup = given
        .get("setup")
        .and_then(|s| s.as_table())
        .and_then(|s| s.keys().next().cloned());
    let shorter = match setup {
        Some(name) if name == "indentation" => format!("setup.{name}.spacing=25 um"),
        Some(name) => format!("setup.{name}.particles_per_radius={COARSE}"),
        None => "run.max_steps=20".to_owned(),
    };
    [
        "run",
        folder.to_str().unwrap(),
        "-o",
        dir.to_str().unwrap(),
        "--set",
        &shorter,
    ]
    .map(str::to_owned)
    .to_vec()
}

/// Starts a shortened case in the background.
pub(crate) fn start(case: &str, dir: &Path, more: &[&str]) -> Child {
    Command::new(env!("CARGO_BIN_EXE_erode"))
        .args(short(case, dir))
        .args(more)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

/// A path for a run that does not exist yet.
pub(crate) fn fresh(name: &str) -> PathBuf {
    let dir = Path::new(env!("CARGO_TARGET_TMPDIR"))
        .join("run")
        .join(name);
    if dir.is_dir() {
        fs::remove_dir_all(&dir).unwrap();
    } else if dir.exists() {
        fs::remove_file(&dir).unwrap();
    }
    fs::create_dir_all(dir.parent().unwrap()).unwrap();
    dir
}

/// A finished run and what it said.
#[derive(Clone)]
pub(crate) struct Finished {
    pub(crate) dir: PathBuf,
    pub(crate) said: String,
}

/// The shortened run of a case with two threads, made once for all tests.
pub(crate) fn finished(case: &str) -> Finished {
    static RUNS: OnceLock<Mutex<BTreeMap<String, Finished>>> = OnceLock::new();
    let mut runs = RUNS.get_or_init(Mutex::default).lock().unwrap();
    let make = || {
        let dir = fresh(&format!("finished-{case}"));
        let output = start(case, &dir, &["--threads", "2"])
            .wait_with_output()
            .unwrap();
        assert_eq!(
            output.status.code(),
            Some(0),
            "{case}: {}",
            text(&output.stderr)
        );
        Finished {
            dir,
            said: text(&output.stdout),
        }
    };
    runs.entry(case.to_owned()).or_insert_with(make).clone()
}

pub(crate) fn summary(dir: &Path) -> serde_json::Value {
    serde_json::from_slice(&fs::read(dir.join("summary.json")).unwrap()).unwrap()
}

/// Every file below `dir` with its bytes.
pub(crate) fn tree(dir: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut files = BTreeMap::new();
    let mut folders = vec![dir.to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else {
                files.insert(
                    path.strip_prefix(dir).unwrap().to_owned(),
                    fs::read(&path).unwrap(),
                );
            }
        }
    }
    files
}

/// The results of two runs, byte for byte; of the summary all but what tells of the machine.
pub(crate) fn assert_identical(a: &Path, b: &Path) {
    let results = |dir: &Path| {
        let mut files = tree(dir);
        files.retain(|path, _| {
            let top = path
                .components()
                .next()
                .unwrap()
                .as_os_str()
                .to_str()
                .unwrap();
            [
                "case.toml",
                "resolved.toml",
                "history.csv",
                "impacts.csv",
                "surface",
                "probes",
                "fields",
                "fields.pvd",
            ]
            .contains(&top)
        });
        files
    };
    let (first, second) = (results(a), results(b));
    assert_eq!(
        first.keys().collect::<Vec<_>>(),
        second.keys().collect::<Vec<_>>()
    );
    for (path, bytes) in &first {
        assert!(
            *bytes == second[path],
            "{} differs between {} and {}",
            path.display(),
            a.display(),
            b.display()
        );
    }
    let physics = |dir: &Path| {
        let mut all = summary(dir);
        let scalars = all.as_object_mut().unwrap();
        scalars.retain(|name, _| !["wall_time", "threads", "seconds"].contains(&name.as_str()));
        all
    };
    assert_eq!(physics(a), physics(b));
}

/// Waits for something that must happen.
pub(crate) fn until(what: &str, happened: impl Fn() -> bool) {
    let begun = Instant::now();
    while !happened() {
        assert!(begun.elapsed() < PATIENCE, "waited in vain for {what}");
        sleep(Duration::from_millis(5));
    }
}

/// The checkpoints of a run, oldest first.
pub(crate) fn checkpoints(dir: &Path) -> Vec<PathBuf> {
    let Ok(entries) = fs::read_dir(dir.join("checkpoints")) else {
        return Vec::new();
    };
    let mut paths: Vec<PathBuf> = entries.map(|e| e.unwrap().path()).collect();
    paths.retain(|p| p.extension().is_some_and(|e| e == "erode"));
    paths.sort();
    paths
}
