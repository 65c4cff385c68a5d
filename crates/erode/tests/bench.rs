//! `erode bench` through the real program, with very few particles.

#![allow(clippy::unwrap_used)]

use serde_json::Value;
use std::process::{Command, Output};

fn erode(args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_erode"))
        .args(args)
        .output()
        .expect("the program starts")
}

fn positive(value: &Value, key: &str) -> f64 {
    let number = value[key].as_f64();
    let number = number.unwrap_or_else(|| panic!("{key} is no number in {value}"));
    assert!(number > 0.0 && number.is_finite(), "{key} = {number}");
    number
}

#[test]
fn every_kind_of_workload_has_rates_phases_and_memory() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("bench.json");
    let mut args = vec![
        "bench",
        "--particles",
        "900",
        "--json",
        file.to_str().unwrap(),
    ];
    let names = [
        "liquid-plane",
        "liquid-axisymmetric",
        "solid-plane",
        "solid-axisymmetric",
    ];
    for name in names {
        args.extend(["--case", name]);
    }
    let output = erode(&args);
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    let text = String::from_utf8(output.stdout).unwrap();
    let json: Value = serde_json::from_str(&std::fs::read_to_string(&file).unwrap()).unwrap();
    assert!(!json["machine"]["processor"].as_str().unwrap().is_empty());
    // No processor of today does less than 1e8 or more than 1e12 operations per second in one thread.
    assert!((0.1..1000.0).contains(&positive(&json["machine"], "peak_one_thread")));
    let workloads = json["workloads"].as_array().unwrap();
    assert_eq!(workloads.len(), names.len());
    for (w, name) in workloads.iter().zip(names) {
        assert_eq!(w["name"], name);
        assert!(text.contains(name));
        assert_eq!(w["particles"], 900);
        // 2h = 2.6 spacings: 20 neighbours inside, fewer at free faces and without images.
        let neighbours = positive(w, "pairs") / 900.0;
        assert!((16.0..21.5).contains(&neighbours), "{name}: {neighbours}");
        check_runs(w);
    }
}

fn check_runs(w: &Value) {
    let runs = w["runs"].as_array().unwrap();
    assert_eq!(runs.len(), 2);
    for (run, threads) in runs.iter().zip(1..) {
        assert_eq!(run["threads"], threads);
        let (rate, mean) = (positive(run, "rate"), positive(run, "mean_rate"));
        assert!(
            mean <= rate * (1.0 + 1e-12),
            "the fastest block is no slower"
        );
        positive(run, "pair_rate");
        positive(run, "operation_rate");
        // Where the system does not tell, it is null and no zero.
        if !run["rate_per_processor_second"].is_null() {
            positive(run, "rate_per_processor_second");
        }
        let shares = run["phases"].as_object().unwrap().values();
        let sum: f64 = shares.map(|s| s.as_f64().unwrap()).sum();
        // The phases leave out nothing but calls and the reading of the clock.
        assert!((0.8..=1.0).contains(&sum), "{run}");
    }
    positive(w, "two_over_one");
    positive(w, "checkpoint_seconds");
}

#[test]
fn the_mixture_is_measured_too() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("bench.json");
    let to = file.to_str().unwrap();
    let output = erode(&[
        "bench",
        "--particles",
        "6",
        "--case",
        "main-case",
        "--json",
        to,
    ]);
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    assert!(text.contains("main-case: bubble next to steel"), "{text}");
    let json: Value = serde_json::from_str(&std::fs::read_to_string(&file).unwrap()).unwrap();
    let w = &json["workloads"][0];
    // Liquid and metal fill a domain of some radii: more than the area of the bubble, which is pi 6^2 / 2 spacings.
    let particles = positive(w, "particles");
    assert!((400.0..20_000.0).contains(&particles), "{particles}");
    let neighbours = positive(w, "pairs") / particles;
    assert!((12.0..24.0).contains(&neighbours), "{neighbours}");
    check_runs(w);
}

#[test]
fn an_unknown_workload_is_refused_with_the_known_ones() {
    let output = erode(&["bench", "--case", "gas"]);
    assert_eq!(output.status.code(), Some(1));
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(
        text.contains("`gas`") && text.contains("solid-plane"),
        "{text}"
    );
    let list = String::from_utf8(erode(&["bench", "--list"]).stdout).unwrap();
    for name in ["main-case-60", "liquid-space", "solid-space"] {
        assert!(list.contains(name), "{name}: {list}");
    }
}
