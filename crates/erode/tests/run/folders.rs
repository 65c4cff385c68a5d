//! Folders that cannot be used, and other things that are refused before anything is computed.

use super::common::{CASE, finished, fresh, refused, says, short, tree};
use std::fs;
use std::path::Path;

fn refused_run(dir: &Path) -> String {
    let args = short(CASE, dir);
    refused(&args.iter().map(String::as_str).collect::<Vec<_>>(), 1)
}

#[test]
fn an_existing_run_is_not_touched() {
    let dir = finished(CASE).dir;
    let before = tree(&dir);
    let said = refused_run(&dir);
    assert!(
        said.contains("nothing in it was changed") && said.contains("erode resume"),
        "{said}"
    );
    assert!(
        tree(&dir) == before,
        "something in {} was changed",
        dir.display()
    );
}

#[test]
fn a_folder_that_cannot_be_made_is_named_with_the_cause() {
    let file = fresh("a-file");
    fs::write(&file, "not a folder").unwrap();
    let said = refused_run(&file);
    assert!(
        said.contains("is a file, so it cannot be a run folder") && said.contains("-o DIR"),
        "{said}"
    );
    let below = file.join("run");
    let said = refused_run(&below);
    assert!(
        said.contains(below.to_str().unwrap()) && said.contains("a part of the path is a file"),
        "{said}"
    );
    assert_eq!(fs::read_to_string(&file).unwrap(), "not a folder");
    if cfg!(target_os = "linux") {
        let said = refused_run(Path::new("/proc/erode"));
        assert!(
            said.contains("the run folder /proc/erode cannot be written"),
            "{said}"
        );
    }
}

#[test]
fn a_folder_that_is_no_run_is_refused() {
    let dir = fresh("foreign");
    fs::create_dir_all(&dir).unwrap();
    fs::write(dir.join("notes.txt"), "mine").unwrap();
    let path = dir.to_str().unwrap();
    for command in ["status", "resume", "report"] {
        let said = refused(&[command, path], 1);
        assert!(said.contains("is not a run folder"), "{command}: {said}");
        let said = refused(&[command, dir.join("missing").to_str().unwrap()], 1);
        assert!(said.contains("missing"), "{command}: {said}");
    }
    let said = refused_run(&dir);
    assert!(said.contains("other files (notes.txt)"), "{said}");
    assert_eq!(tree(&dir).len(), 1, "nothing is added to a foreign folder");
}

#[test]
fn no_threads_is_wrong_input() {
    let said = refused(&["run", "case.toml", "--threads", "0"], 1);
    assert!(said.contains("--threads"), "{said}");
}

#[test]
fn a_finished_run_tells_so() {
    let dir = finished(CASE).dir;
    let said = says(&["status", dir.to_str().unwrap()]);
    assert!(
        said.contains("done") && said.contains("(100.0 %)"),
        "{said}"
    );
}
