use super::*;

fn tree(root: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let mut files = Vec::new();
    for path in list(root).unwrap() {
        if path.is_dir() {
            files.push((path.clone(), Vec::new()));
            files.extend(tree(&path));
        } else {
            let bytes = fs::read(&path).unwrap();
            files.push((path, bytes));
        }
    }
    files
}

#[test]
fn a_new_folder_has_its_places_and_can_be_opened_again() {
    let base = tempfile::tempdir().unwrap();
    let root = base.path().join("a/b");
    let run = RunFolder::create(&root).unwrap();
    run.write_case(b"# as \xff given\r\n", "resolved = 1\n")
        .unwrap();
    fs::write(
        run.paths().snapshot("liquid", 7).with_extension("vtu.tmp"),
        "half",
    )
    .unwrap();
    assert!(matches!(
        RunFolder::open(&root),
        Err(OutputError::Locked { .. })
    ));
    drop(run);
    let run = RunFolder::open(&root).unwrap();
    assert_eq!(run.killed_process(), None);
    assert_eq!(
        fs::read(run.paths().case()).unwrap(),
        b"# as \xff given\r\n"
    );
    assert_eq!(
        run.paths().snapshot("liquid", 7),
        root.join("fields/liquid_000007.vtu")
    );
    assert_eq!(
        list(&root.join("fields")).unwrap().len(),
        0,
        "the half-written file is gone"
    );
}

#[test]
fn an_existing_run_is_refused_by_name_and_untouched() {
    let base = tempfile::tempdir().unwrap();
    let run = RunFolder::create(base.path()).unwrap();
    run.write_case(b"given", "resolved").unwrap();
    drop(run);
    let before = tree(base.path());
    let error = RunFolder::create(base.path()).unwrap_err();
    assert!(
        error
            .to_string()
            .contains("a run (case.toml, checkpoints, resolved.toml)"),
        "{error}"
    );
    assert!(error.hint().contains("`erode resume ") && error.hint().contains("`-o DIR`"));
    assert_eq!(tree(base.path()), before);
}

#[test]
fn a_folder_with_other_files_is_refused_without_offering_to_resume() {
    let base = tempfile::tempdir().unwrap();
    fs::write(base.path().join("thesis.tex"), "x").unwrap();
    let error = RunFolder::create(base.path()).unwrap_err();
    assert!(
        error.to_string().contains("other files (thesis.tex)"),
        "{error}"
    );
    assert!(!error.hint().contains("resume"));
    assert_eq!(tree(base.path()).len(), 1);
    assert!(matches!(
        RunFolder::open(base.path()),
        Err(OutputError::NotARun { .. })
    ));
}

#[test]
fn a_file_or_a_path_through_a_file_is_refused() {
    let base = tempfile::tempdir().unwrap();
    let file = base.path().join("file");
    fs::write(&file, "x").unwrap();
    assert!(matches!(
        RunFolder::create(&file),
        Err(OutputError::NotAFolder { .. })
    ));
    assert!(matches!(
        RunFolder::open(&file),
        Err(OutputError::NotAFolder { .. })
    ));
    let error = RunFolder::create(file.join("run")).unwrap_err();
    assert!(
        error
            .to_string()
            .ends_with("a part of the path is a file, not a folder"),
        "{error}"
    );
}

/// Not even the superuser can make folders there.
#[cfg(target_os = "linux")]
#[test]
fn an_unwritable_place_is_refused() {
    let error = RunFolder::create("/proc/self/erode").unwrap_err();
    assert!(matches!(error, OutputError::NotWritable { .. }), "{error}");
}

#[test]
fn a_folder_left_by_a_process_killed_before_its_first_file_can_be_used() {
    let base = tempfile::tempdir().unwrap();
    drop(RunFolder::create(base.path()).unwrap());
    RunFolder::create(base.path()).unwrap();
}

#[test]
fn a_run_does_not_go_on_with_a_case_that_was_changed() {
    let base = tempfile::tempdir().unwrap();
    let run = RunFolder::create(base.path()).unwrap();
    run.write_case(b"a = 1\nb = 2\n", "resolved").unwrap();
    run.require_same_case().unwrap();
    fs::write(run.paths().case(), "a = 1\nb = 3\n").unwrap();
    let error = run.require_same_case().unwrap_err();
    let text = error.to_string();
    assert!(
        text.contains("was changed") && text.ends_with("\n- b = 2\n+ b = 3"),
        "{text}"
    );
    assert!(error.hint().contains("erode run"), "{}", error.hint());
    // Runs of earlier versions kept no second copy.
    fs::remove_file(run.paths().begun_with()).unwrap();
    run.require_same_case().unwrap();
}

#[test]
fn a_folder_without_its_resolved_case_is_no_run_to_go_on_with() {
    let base = tempfile::tempdir().unwrap();
    let run = RunFolder::create(base.path()).unwrap();
    run.write_case(b"given", "resolved").unwrap();
    fs::remove_file(run.paths().resolved()).unwrap();
    drop(run);
    let error = RunFolder::open(base.path()).unwrap_err();
    assert!(
        error
            .to_string()
            .contains("is not a run folder: resolved.toml is missing"),
        "{error}"
    );
}
