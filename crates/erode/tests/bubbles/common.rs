//! Starting the program and comparing run folders.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

pub(crate) fn erode(args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_erode"))
        .args(args)
        .output()
        .unwrap()
}

/// Standard output of a command that must succeed.
pub(crate) fn says(args: &[&str]) -> String {
    let output = erode(args);
    let complaint = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{args:?}: {complaint}");
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// Standard error of a command that must end with `code`.
pub(crate) fn refused(args: &[&str], code: i32) -> String {
    let output = erode(args);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(code), "{args:?}: {said}");
    said
}

/// The folder of a case.
pub(crate) fn case(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../cases")
        .join(name);
    folder.to_str().unwrap().to_owned()
}

/// A path that does not exist yet, in a folder that does.
pub(crate) fn fresh(name: &str) -> PathBuf {
    let dir = Path::new(env!("CARGO_TARGET_TMPDIR"))
        .join("bubbles")
        .join(name);
    if dir.exists() {
        fs::remove_dir_all(&dir).unwrap();
    }
    fs::create_dir_all(dir.parent().unwrap()).unwrap();
    dir
}

pub(crate) fn summary(dir: &Path) -> serde_json::Value {
    serde_json::from_slice(&fs::read(dir.join("summary.json")).unwrap()).unwrap()
}

/// The checkpoints of a run, oldest first.
pub(crate) fn checkpoints(dir: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(dir.join("checkpoints")).unwrap();
    let mut paths: Vec<PathBuf> = entries.map(|e| e.unwrap().path()).collect();
    paths.retain(|p| p.extension().is_some_and(|e| e == "erode"));
    paths.sort();
    paths
}

/// Standard error of `erode check` on a wrong case given as text.
pub(crate) fn wrong(name: &str, text: &str) -> String {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("bubbles-wrong");
    fs::create_dir_all(&folder).unwrap();
    let file = folder.join(format!("{name}.toml"));
    fs::write(&file, text).unwrap();
    refused(&["check", file.to_str().unwrap()], 1)
}

/// Tables byte for byte; of the summary all but what tells of the machine.
pub(crate) fn assert_identical(a: &Path, b: &Path, tables: &[&str]) {
    for file in tables {
        let same = fs::read(a.join(file)).unwrap() == fs::read(b.join(file)).unwrap();
        assert!(
            same,
            "{file} differs between {} and {}",
            a.display(),
            b.display()
        );
    }
    let physics = |dir: &Path| {
        let mut all = summary(dir);
        all.as_object_mut()
            .unwrap()
            .retain(|name, _| name != "wall_time" && name != "threads");
        all
    };
    assert_eq!(physics(a), physics(b));
}
