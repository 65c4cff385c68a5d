use super::*;
use crate::case::keys::CASE;
use std::fs;

/// A sweep of the case of a single bubble, written to a folder of its own.
fn plan(text: &str, quick: bool) -> Result<Plan, SweepError> {
    let folder = tempfile::tempdir().unwrap();
    let case = include_str!("../../../../cases/single-bubble/case.toml");
    fs::write(folder.path().join("bubble.toml"), case).unwrap();
    let file = folder.path().join("sweep.toml");
    fs::write(&file, format!("case = \"bubble.toml\"\n{text}")).unwrap();
    Plan::read(&file, quick)
}

fn complaint(text: &str) -> String {
    match plan(text, false) {
        Err(SweepError::Case(errors)) => errors.to_string(),
        other => panic!("{other:?}"),
    }
}

fn names(plan: &Plan) -> Vec<&str> {
    plan.runs.iter().map(|r| r.name.as_str()).collect()
}

const RADIUS: &str = "\"setup.single_bubble.radius\"";

#[test]
fn a_grid_takes_every_combination_and_a_zip_goes_along() {
    let plan = plan(
        "[grid]\nsetup.single_bubble.radius = [\"8 um\", 1e-5]\n\"run.end_time\" = [\"10 us\", \"20 us\"]\n\
         [zip]\n\"setup.single_bubble.tolerance\" = [1e-9, 1e-8]\n\"output.history_every\" = [\"1 us\", \"2 us\"]\n",
        false,
    )
    .unwrap();
    assert_eq!(plan.runs.len(), 8);
    assert_eq!(
        plan.runs[1].name,
        "radius=8um,end_time=10us,tolerance=1e-8,history_every=2us"
    );
    assert_eq!(plan.tied, [2, 3]);
    let last = &plan.runs[7];
    assert_eq!(last.value("run.end_time").unwrap().number, Some(20e-6));
    assert_eq!(last.value("run.end_time").unwrap().unit, "s");
    assert!(last.resolved.contains("radius = 1e-5"), "{}", last.resolved);
}

/// With or without a unit written, a number is in the unit of its key.
#[test]
fn units_are_those_of_the_keys() {
    let text = format!(
        "[zip]\n{RADIUS} = [8e-6, \"9 um\"]\n\"run.end_time\" = [1e-5, 2e-5]\n\"setup.single_bubble.tolerance\" = [1e-9, 1e-8]\n\
         \"setup.single_bubble.liquid.density\" = [998, 1000]\n"
    );
    let plan = plan(&text, false).unwrap();
    let units = |k: usize| -> Vec<String> {
        let all = plan.runs[k].settings.iter();
        all.map(|s| s.value.unit.clone()).collect()
    };
    assert_eq!(units(0), ["m", "s", "-", "kg/m3"]);
    assert_eq!(units(1), units(0));
    assert_eq!(plan.runs[1].settings[0].value.number, Some(9e-6));
    let unit = |key: &str| CASE.dimension(key).map(|d| d.to_string());
    assert_eq!(unit("probe.0.position").as_deref(), Some("m"));
    assert_eq!(
        unit("material.steel.solid.density.value").as_deref(),
        Some("kg/m^3")
    );
    assert_eq!(unit("run.frobnicate"), None);
    assert_eq!(unit("run"), None);
}

#[test]
fn runs_can_be_listed_and_named() {
    let text = format!(
        "[[run]]\nname = \"small-one\"\n{RADIUS} = \"8 um\"\n[[run]]\n{RADIUS} = \"9 um\"\n[[run]]\n{RADIUS} = \"10 um\"\nsetup.single_bubble.tolerance = 1e-9\n"
    );
    let plan = plan(&text, false).unwrap();
    assert_eq!(
        names(&plan),
        ["small-one", "radius=9um", "radius=10um,tolerance=1e-9"]
    );
}

#[test]
fn quick_settings_replace_those_of_all_runs() {
    let text = format!(
        "[set]\n\"run.end_time\" = \"90 us\"\n[quick]\n\"run.end_time\" = \"5 us\"\n[grid]\n{RADIUS} = [\"8 um\", \"9 um\"]\n"
    );
    let of = |quick| plan(&text, quick).unwrap().runs[0].resolved.clone();
    assert!(of(true).contains("end_time = 5e-6") && of(false).contains("end_time = 9e-5"));
    let none = plan(&format!("[grid]\n{RADIUS} = [\"8 um\"]\n"), true).unwrap_err();
    let SweepError::Case(errors) = none else {
        panic!()
    };
    assert!(errors.to_string().contains("no quick form"));
}

#[test]
fn wrong_files_are_told_with_their_place() {
    let empty = complaint(&format!("[grid]\n{RADIUS} = []\n"));
    assert!(
        empty.contains("is empty") && empty.contains("sweep.toml:3"),
        "{empty}"
    );
    let unknown = complaint("[gird]\na = [1]\n");
    assert!(unknown.contains("did you mean `grid`"), "{unknown}");
    let scalar = complaint(&format!("[grid]\n{RADIUS} = 3\n"));
    assert!(scalar.contains("must be a list"), "{scalar}");
    let uneven = complaint(&format!(
        "[zip]\n{RADIUS} = [1e-6]\n\"run.end_time\" = [1e-6, 2e-6]\n"
    ));
    assert!(
        uneven.contains("has 1 values") && uneven.contains("has 2"),
        "{uneven}"
    );
    let twice = complaint(&format!(
        "[set]\n{RADIUS} = 1e-6\n[grid]\n{RADIUS} = [2e-6]\n"
    ));
    assert!(twice.contains("more than once"), "{twice}");
    let hidden = complaint(&format!(
        "[quick]\n{RADIUS} = 1e-6\n[grid]\n{RADIUS} = [2e-6, 3e-6]\n"
    ));
    assert!(
        hidden.contains("radius` is given more than once"),
        "{hidden}"
    );
    let alike = complaint(&format!(
        "[[run]]\nname = \"ab\"\n{RADIUS} = 1e-6\n[[run]]\nname = \"ab\"\n{RADIUS} = 2e-6\n"
    ));
    assert!(alike.contains("two runs have the name `ab`"), "{alike}");
    assert!(complaint("").contains("varies nothing"));
}

#[test]
fn a_wrong_key_of_the_case_is_told_once_for_all_runs() {
    let told = complaint("[grid]\n\"setup.single_bubble.radios\" = [1e-6, 2e-6, 3e-6]\n");
    assert_eq!(told.lines().count(), 1, "{told}");
    assert!(told.contains("did you mean `radius`"), "{told}");
    let range = complaint(&format!("[grid]\n{RADIUS} = [1e-6, -1e-6]\n"));
    assert!(
        range.contains("run `radius=-1e-6` of ") && range.contains("sweep.toml: `radius` must be"),
        "{range}"
    );
}

#[test]
fn two_runs_of_the_same_case_are_refused() {
    let told = complaint(&format!("[grid]\n{RADIUS} = [\"8 um\", 8e-6]\n"));
    assert!(told.contains("the same case"), "{told}");
}

#[test]
fn keys_are_as_short_as_they_can_be_told_apart() {
    let keys = ["a.gas.pressure", "a.wave.pressure", "run.end_time"].map(str::to_owned);
    assert_eq!(
        short_keys(&keys),
        ["gas.pressure", "wave.pressure", "end_time"]
    );
}

#[test]
fn names_are_safe_in_file_systems() {
    assert_eq!(plain("50 MPa"), "50MPa");
    assert_eq!(plain("a/b\\c:{x = 1}"), "a_b_c__x=1_");
    assert_eq!(plain(".."), "run..");
}

#[test]
fn a_given_name_is_kept_or_refused() {
    let listed = |name: &str| format!("[[run]]\nname = \"{name}\"\n{RADIUS} = 1e-6\n");
    // The name that the grid would make is given to another run.
    let both = format!("[grid]\n{RADIUS} = [2e-6]\n{}", listed("radius=2e-6"));
    assert_eq!(
        names(&plan(&both, false).unwrap()),
        ["radius=2e-6-2", "radius=2e-6"]
    );
    for name in ["", "..", "a b", "a/b", &"x".repeat(200)] {
        let told = complaint(&listed(name));
        assert!(
            told.contains(&format!("`{name}` cannot be the name of a run")),
            "{told}"
        );
    }
}
