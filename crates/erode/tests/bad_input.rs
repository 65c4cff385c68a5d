//! Wrong input through the real program: exit code 1, place, what is allowed, suggestion, all errors in one pass.

use std::{
    path::{Path, PathBuf},
    process::{Command, Output},
};

const CASE: &str = include_str!("../../../cases/bubble-near-steel/case.toml");

fn erode(args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_erode"))
        .args(args)
        .output()
        .expect("the program starts")
}

/// What `erode check` says about a case file that must be refused.
fn refused(file: &Path, more: &[&str]) -> String {
    let mut args = vec!["check", file.to_str().expect("the path is UTF-8")];
    args.extend(more);
    let output = erode(&args);
    let text = String::from_utf8(output.stderr).expect("output is UTF-8");
    assert_eq!(output.status.code(), Some(1), "{text}");
    assert!(output.stdout.is_empty(), "errors go to stderr");
    text
}

struct Folder(tempfile::TempDir);

impl Folder {
    fn new() -> Self {
        Self(tempfile::tempdir().expect("a folder"))
    }

    fn file(&self, bytes: impl AsRef<[u8]>) -> PathBuf {
        let file = self.0.path().join("case.toml");
        std::fs::write(&file, bytes).expect("a writable folder");
        file
    }
}

/// The case with one line replaced, and the number of that line.
fn changed(old: &str, new: &str) -> (String, usize) {
    let line = CASE
        .lines()
        .position(|l| l.starts_with(old))
        .expect("a line of the case")
        + 1;
    let lines = CASE
        .lines()
        .enumerate()
        .map(|(i, l)| if i + 1 == line { new } else { l });
    (lines.collect::<Vec<_>>().join("\n"), line)
}

/// Lines wrap at the width of the report; phrases are looked for without line breaks.
fn flat(text: &str) -> String {
    text.replace('│', " ")
        .split_whitespace()
        .collect::<Vec<_>>()
        .join(" ")
}

fn assert_refused(old: &str, new: &str, phrases: &[&str]) {
    let folder = Folder::new();
    let (text, line) = changed(old, new);
    let said = flat(&refused(&folder.file(text), &[]));
    assert!(
        said.contains(&format!("case.toml:{line}:")),
        "{new}: line {line} is not named: {said}"
    );
    for phrase in phrases {
        assert!(said.contains(phrase), "{new}: `{phrase}` is not in: {said}");
    }
    assert!(said.ends_with("1 error: nothing was run."), "{new}: {said}");
}

#[test]
fn wrong_values_are_named_with_their_place() {
    for (old, new, phrases) in [
        (
            "radius",
            "radius = \"-0.15 mm\"",
            &["must be greater than zero", "radius of the bubble"][..],
        ),
        (
            "radius",
            "radius = \"0.15 MPa\"",
            &["`radius` is a length", "is a pressure", "\"0.15 mm\""],
        ),
        (
            "radius",
            "radius = \"0.15 mn\"",
            &["not a known unit", "did you mean `mm`"],
        ),
        ("radius", "radius = \"0,15 mm\"", &["decimal comma"]),
        ("radius", "radius = nan", &["must be finite", "NaN"]),
        ("radius", "radius = inf", &["must be finite"]),
        ("radius", "radius = 1e999", &["must be finite"]),
        (
            "radius",
            "radius = true",
            &["`radius` is a length, but this is true or false"],
        ),
        (
            "radius",
            "radius = []",
            &["`radius` is a length, but this is an array"],
        ),
        (
            "standoff",
            "standoff = \"1 m\"",
            &["number without unit", "is a length"],
        ),
        ("standoff", "standoff = 0", &["must be greater than zero"]),
        (
            "particles",
            "particles_per_radius = 30.5",
            &["must be a whole number"],
        ),
        ("particles", "particles_per_radius = -30", &["at least 4"]),
        (
            "particles",
            "particles_per_radius = 3000000",
            &["cannot fit in memory", "coarser by a factor of"],
        ),
        (
            "liquid",
            "liquid = \"wter\"",
            &["no material `wter`", "did you mean `water`"],
        ),
        (
            "liquid",
            "liquid = \"steel_a2205\"",
            &["cannot be used as a liquid", "fluid.tait.sound_speed"],
        ),
        (
            "wall",
            "wall = \"steel_316l\"",
            &["it lacks", "solid.strength.johnson_cook.b", "no hardening"],
        ),
        (
            "wall",
            "wall = 3",
            &["must be a text in quotes, but this is an integer"],
        ),
        (
            "body = \"liquid\"",
            "body = \"liqid\"",
            &["did you mean `liquid`"],
        ),
        (
            "position",
            "position = [0, \"-1 mm\"]",
            &["lies outside `liquid`"],
        ),
        ("name", "name = \"../x\"", &["names files"]),
    ] {
        assert_refused(old, new, phrases);
    }
}

#[test]
fn a_bubble_outside_the_liquid_is_refused() {
    for (key, what) in [
        ("height", "top of the bubble"),
        ("width", "side of the bubble"),
    ] {
        let folder = Folder::new();
        let (text, line) = changed("wall", &format!("wall = \"steel_a2205\"\n{key} = 0.9"));
        let said = flat(&refused(&folder.file(text), &[]));
        assert!(
            said.contains("lies outside the liquid") && said.contains(what),
            "{said}"
        );
        assert!(said.contains(&format!("case.toml:{}:", line + 1)), "{said}");
    }
}

#[test]
fn a_bubble_that_reaches_through_the_wall_is_refused() {
    let folder = Folder::new();
    let (text, _) = changed("wall", "wall = \"steel_a2205\"\nwall_depth = 0.4");
    let text = text.replace("standoff = 1.33", "standoff = 0.33");
    let said = flat(&refused(&folder.file(text), &[]));
    assert!(
        said.contains("reaches through the wall") && said.contains("here they are 0.730"),
        "{said}"
    );
}

#[test]
fn all_errors_come_in_one_pass() {
    let folder = Folder::new();
    let text = CASE
        .replace("radius = \"0.15 mm\"", "radius = \"-0.15 mm\"")
        .replace("particles_per_radius", "particle_per_radius")
        .replace("\"50 MPa\"", "\"50 mm\"")
        .replace("\"water\"", "\"watr\"")
        .replace("\"40 ns\"", "nan");
    let said = flat(&refused(
        &folder.file(text),
        &["--set", "run.sefety=1", "--set", "x"],
    ));
    for phrase in [
        "must be greater than zero",
        "did you mean `particles_per_radius`",
        "\"50 mm\" is a length",
        "did you mean `water`",
        "must be finite",
        "did you mean `safety`",
        "an override needs a path and a value",
        "7 errors",
    ] {
        assert!(said.contains(phrase), "`{phrase}` is not in: {said}");
    }
}

#[test]
fn a_caret_line_marks_the_text() {
    let folder = Folder::new();
    let (text, _) = changed("radius", "radios = 1");
    let said = refused(&folder.file(text), &[]);
    let marked = said
        .lines()
        .skip_while(|l| !l.contains("radios = 1"))
        .nth(1)
        .unwrap();
    assert_eq!(
        marked.chars().filter(|c| "─┬".contains(*c)).count(),
        "radios".len(),
        "{said}"
    );
}

#[test]
fn syntax_errors_are_placed() {
    assert_refused("radius", "radius = 0.15 mm", &["not valid TOML"]);
    let folder = Folder::new();
    let said = flat(&refused(
        &folder.file("[run\nend_time = 1\n\nx = = 2\n"),
        &[],
    ));
    assert!(
        said.contains("case.toml:1:5") && said.contains("case.toml:4:5"),
        "{said}"
    );
}

#[test]
fn unreadable_files_are_explained() {
    let folder = Folder::new();
    let file = folder.file(b"title = \"ok\"\ntitle2 = \"\xff\"\n");
    let said = flat(&refused(&file, &[]));
    assert!(
        said.contains("case.toml:2:11") && said.contains("not UTF-8"),
        "{said}"
    );
    for empty in ["", "\n \n", "# only a comment\n"] {
        let said = flat(&refused(&folder.file(empty), &[]));
        assert!(
            said.contains("is empty") || said.contains("neither a setup nor a body"),
            "{said}"
        );
        assert!(said.contains("erode new"), "{said}");
    }
    std::fs::remove_file(&file).unwrap();
    let said = flat(&refused(folder.0.path(), &[]));
    assert!(said.contains("a folder without a case.toml"), "{said}");
    let said = flat(&refused(&folder.0.path().join("other.toml"), &[]));
    assert!(said.contains("there is no file"), "{said}");
}

#[test]
fn files_of_other_systems_are_read() {
    let folder = Folder::new();
    let windows = format!("\u{feff}{}", CASE.replace('\n', "\r\n"));
    let file = folder.file(windows);
    let output = erode(&["check", file.to_str().unwrap()]);
    assert_eq!(
        output.status.code(),
        Some(0),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
}

#[test]
fn wrong_command_lines_are_wrong_input() {
    for args in [
        &["chek", "x"][..],
        &["check"],
        &["run", "x", "--threads", "0"],
        &["new", "nothing"],
        &["materials", "x"],
    ] {
        assert_eq!(erode(args).status.code(), Some(1), "{args:?}");
    }
}

#[test]
fn refinement_and_gas_go_together_but_not_in_the_published_form() {
    let folder = Folder::new();
    let file = folder.file(CASE);
    let formulation = "setup.bubble_near_wall.liquid_formulation";
    let refinement =
        format!("{formulation}.corrected.refinement={{per_radius=8, growth=0.06, smallest=0.05}}");
    let gas = "setup.bubble_near_wall.gas={pressure=\"100 kPa\"}";
    let path = file.to_str().expect("the path is UTF-8");
    let checked = erode(&["check", path, "--set", &refinement, "--set", gas]);
    assert!(checked.status.success());
    let published = format!("{formulation}.joshi={{}}");
    let text = flat(&refused(&file, &["--set", &published, "--set", gas]));
    assert!(text.contains("has no gas in its bubble"), "{text}");
}
