//! The commands that need no run, through the real program.

use std::process::{Command, Output};

fn erode(args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_erode"))
        .args(args)
        .output()
        .expect("the program starts")
}

fn says(args: &[&str]) -> String {
    let output = erode(args);
    assert!(
        output.status.success(),
        "{args:?}: {}",
        String::from_utf8_lossy(&output.stderr)
    );
    String::from_utf8(output.stdout).expect("output is UTF-8")
}

#[test]
fn a_new_case_checks_and_is_never_overwritten() {
    let folder = tempfile::tempdir().unwrap();
    let list = says(&["new"]);
    for template in [
        "bubble-near-wall",
        "bubble-attached",
        "bubble-in-liquid",
        "own-bodies",
    ] {
        assert!(list.contains(template));
        let dir = folder.path().join(template);
        let dir = dir.to_str().unwrap();
        says(&["new", template, dir]);
        let text = says(&["check", dir]);
        assert!(
            text.contains("the case is correct") && text.contains("particles"),
            "{text}"
        );
        assert!(!text.contains("Worth a look"), "{text}");
        let again = erode(&["new", template, dir]);
        assert_eq!(again.status.code(), Some(1));
        assert!(String::from_utf8_lossy(&again.stderr).contains("exists already"));
    }
}

#[test]
fn the_resolved_case_is_a_case_and_the_same_one() {
    let folder = tempfile::tempdir().unwrap();
    let case = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/bubble-near-steel");
    let resolved = says(&["check", case, "--resolved"]);
    let file = folder.path().join("resolved.toml");
    std::fs::write(&file, &resolved).unwrap();
    assert_eq!(
        says(&["check", file.to_str().unwrap(), "--resolved"]),
        resolved
    );
}

#[test]
fn a_check_tells_of_gas_and_refinement() {
    let case = |name: &str| format!("{}/../../cases/{name}", env!("CARGO_MANIFEST_DIR"));
    let gas = says(&["check", &case("gas-rebound")]);
    assert!(gas.contains("gas at 100 kPa, exponent 1.4"), "{gas}");
    let refinement = "setup.bubble_near_wall.liquid_formulation.corrected.refinement={per_radius=20, smallest=0.1}";
    let refined = says(&["check", &case("bubble-near-steel"), "--set", refinement]);
    // A tenth of 0.15 mm by 20; the step of a spacing of 5 um by 6.67.
    assert!(
        refined.contains("20 particles per radius down to 0.1 of the first: spacing 750 nm"),
        "{refined}"
    );
    assert!(!gas.contains("refinement") && !refined.contains("gas at"));
}

#[test]
fn materials_beside_the_case_are_used() {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path().to_str().unwrap();
    says(&["new", "bubble-in-liquid", dir]);
    std::fs::create_dir(folder.path().join("materials")).unwrap();
    let oil = "[sources]\nx = \"my own\"\n[fluid.tait]\nreference_density = { value = 900, source = \"x\" }\n\
               sound_speed = { value = \"1.3 km/s\", source = \"x\" }\ngamma = { value = 7, source = \"x\" }\n";
    std::fs::write(folder.path().join("materials/oil.toml"), oil).unwrap();
    let text = says(&[
        "check",
        dir,
        "--set",
        "setup.bubble_in_liquid.liquid=oil",
        "--resolved",
    ]);
    assert!(text.contains("sound_speed = 1300.0"), "{text}");
}

#[test]
fn the_schema_is_json() {
    let schema: serde_json::Value = serde_json::from_str(&says(&["check", "--schema"])).unwrap();
    assert!(
        schema["properties"]["setup"]["properties"]["bubble_near_wall"]["properties"]["radius"]
            .is_object()
    );
}

#[test]
fn materials_are_listed_and_shown_with_sources() {
    let list = says(&["materials"]);
    for name in ["water", "steel_a2205", "steel_316l", "aluminium_6061_t6"] {
        assert!(list.contains(name), "{list}");
    }
    let one = says(&["materials", "steel_316l"]);
    assert!(
        one.contains("400 MPa") && one.contains("Peters and el Moctar 2020"),
        "{one}"
    );
    assert!(one.contains("no hardening"), "{one}");
}

#[test]
fn help_teaches() {
    let help = says(&["--help"]);
    for word in [
        "new",
        "check",
        "run",
        "resume",
        "report",
        "validate",
        "materials",
        "status",
        "Exit codes",
        "First steps",
    ] {
        assert!(help.contains(word), "{word}");
    }
    // Lines that were wrapped by hand are not wrapped again.
    let codes = help.split("Exit codes:\n").nth(1).unwrap();
    for line in codes.lines().filter(|l| !l.is_empty()) {
        let begins = line.starts_with("    ") || line.as_bytes()[2].is_ascii_digit();
        assert!(line.starts_with("  ") && begins, "{line}");
    }
    for command in [
        "new",
        "check",
        "run",
        "resume",
        "report",
        "validate",
        "materials",
        "status",
    ] {
        assert!(says(&[command, "--help"]).contains("Example"), "{command}");
    }
}

#[test]
fn a_reader_that_goes_away_is_no_failure() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_erode"))
        .args(["check", "--schema"])
        .stdout(std::process::Stdio::piped())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    // The reading end closes before or while the program writes.
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(0));
    assert!(
        output.stderr.is_empty(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
}

#[test]
fn instructions_that_there_are_not_are_refused() {
    let with = |name: &str| {
        Command::new(env!("CARGO_BIN_EXE_erode"))
            .args(["materials"])
            .env("ERODE_SIMD", name)
            .output()
            .expect("the program starts")
    };
    let output = with("avx3");
    assert_eq!(output.status.code(), Some(1));
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(
        said.contains("ERODE_SIMD is `avx3`") && said.contains("avx512, avx2, scalar"),
        "{said}"
    );
    assert!(with("scalar").status.success());
}
