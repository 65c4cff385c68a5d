//! Wrong loads on solids through the real program: exit code 1, place, what is allowed; advice where a load is not resolved.

#![allow(clippy::unwrap_used)] // a failed test may panic

use std::process::{Command, Output};

const BLOCK: &str = r#"
[[body]]
name = "block"
shape.rectangle = { lower = [0, "-0.8 mm"], upper = ["1 mm", 0] }
spacing.finest = "20 um"
solid.material = "steel_a2205"
sides.bottom.clamped = {}

[run]
end_time = "1 us"
"#;

fn check(text: &str) -> Output {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("case.toml");
    std::fs::write(&file, text).unwrap();
    Command::new(env!("CARGO_BIN_EXE_erode"))
        .args(["check", file.to_str().unwrap()])
        .output()
        .unwrap()
}

/// Lines wrap at the width of the report; phrases are looked for without line breaks.
fn flat(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes)
        .replace('│', " ")
        .split_whitespace()
        .collect::<Vec<_>>()
        .join(" ")
}

fn refused(load: &str, phrases: &[&str]) {
    let output = check(&format!("{BLOCK}\n{load}"));
    let said = flat(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{load}: {said}");
    for phrase in phrases {
        assert!(
            said.contains(phrase),
            "{load}: `{phrase}` is not in: {said}"
        );
    }
}

/// A layer of the block.
fn layered(layers: &str, formulation: &str) -> String {
    let solid = "solid.material = \"steel_a2205\"";
    let with = format!("{solid}\nsolid.layers = [{layers}]\n{formulation}");
    BLOCK.replace(solid, &with)
}

#[test]
fn layers_that_do_not_fit_are_refused() {
    let refused = |text: &str, phrases: &[&str]| {
        let output = check(text);
        let said = flat(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{said}");
        for phrase in phrases {
            assert!(said.contains(phrase), "`{phrase}` is not in: {said}");
        }
    };
    let copper =
        |thickness: &str| format!("{{ thickness = \"{thickness}\", material = \"copper_ofhc\" }}");
    refused(
        &layered(&copper("15 um"), ""),
        &[
            "layer 1 (copper_ofhc)",
            "less than the particle spacing",
            "15 um thick",
        ],
    );
    let both = format!("{}, {}", copper("0.5 mm"), copper("0.4 mm"));
    refused(&layered(&both, ""), &["thick together", "800 um high"]);
    refused(
        &layered(&copper("0.1 mm"), "solid.formulation.joshi = {}"),
        &["one material and no layers"],
    );
    let unknown = "{ thickness = \"0.1 mm\", material = \"coper_ofhc\" }";
    refused(&layered(unknown, ""), &["did you mean `copper_ofhc`"]);
    let output = check(&layered(&copper("0.1 mm"), ""));
    assert_eq!(output.status.code(), Some(0));
    assert!(flat(&output.stdout).contains("copper_ofhc"));
}

#[test]
fn loads_that_cannot_act_are_refused() {
    let pressure = |more: &str| {
        format!(
            "[[pressure]]\nbody = \"block\"\namplitude = \"1 GPa\"\ndiameter = \"0.4 mm\"\n{more}"
        )
    };
    let pulse = "pulse = { peak_time = \"0.3 us\", rise_time = \"0.1 us\" }\n";
    refused(
        &pressure(&format!("centre = \"0.1 mm\"\n{pulse}")),
        &[
            "in axisymmetry the pressure must be on the axis",
            "[geometry.plane]",
        ],
    );
    refused(
        &format!(
            "[geometry.plane]\n{}",
            pressure(&format!("centre = \"2 mm\"\n{pulse}"))
        ),
        &["lies outside `block`", "reaches from"],
    );
    refused(
        &pressure(pulse).replace("\"block\"", "\"blok\""),
        &[
            "asks for a body `blok` that does not exist",
            "did you mean `block`",
        ],
    );
    refused(&pressure(""), &["ramp", "pulse"]);
    refused(
        "[indenter]\nbody = \"block\"\nradius = \"0.4 mm\"\ndepth = \"-5 um\"\nramp.rise = \"0.9 us\"\n",
        &["must be greater than zero", "how far it is pushed"],
    );
    refused(
        "[indenter]\nbody = \"block\"\nradius = \"0.4 mm\"\ndepth = \"5 um\"\n",
        &["lacks `ramp`"],
    );
}

#[test]
fn a_load_needs_a_free_side_of_a_solid() {
    let load = "[indenter]\nbody = \"block\"\nradius = \"0.4 mm\"\ndepth = \"20 um\"\nramp.rise = \"0.9 us\"\n";
    let clamped = BLOCK.replace("sides.bottom", "sides.top");
    let said = flat(&check(&format!("{clamped}\n{load}")).stderr);
    assert!(
        said.contains("which is not free") && said.contains("must be `free`"),
        "{said}"
    );
    let liquid = BLOCK.replace(
        "solid.material = \"steel_a2205\"",
        "fluid.material = \"water\"",
    );
    let said = flat(&check(&format!("{liquid}\n{load}")).stderr);
    assert!(said.contains("a liquid cannot be clamped"), "{said}");
    assert!(
        said.contains("is put on `block`, which is a liquid"),
        "{said}"
    );
}

#[test]
fn a_narrow_load_is_advised_against_with_the_number_of_particles() {
    let load = "[[pressure]]\nbody = \"block\"\namplitude = \"1 GPa\"\ndiameter = \"0.1 mm\"\n\
                pulse = { peak_time = \"0.3 us\", rise_time = \"0.1 us\" }\n";
    let output = check(&format!("{BLOCK}\n{load}"));
    let said = flat(&output.stdout) + &flat(&output.stderr);
    assert!(output.status.success(), "{said}");
    assert!(
        said.contains("2.5 particles across the radius of the pressure"),
        "{said}"
    );
}
