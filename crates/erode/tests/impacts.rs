//! Repeated impacts: known answers, what is refused, and runs that go on after an interruption.

#![allow(clippy::unwrap_used)] // a failed test may panic, its helpers too

use erode::case::{Case, Simulation};
use erode::output::{Summary, Table};
use erode::run::{self, Ended, Quiet, Start};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use tempfile::TempDir;

/// A small, coarse liquid above a small wall of a soft metal that yields at every impact.
const NEAR: &str = r#"
[setup.bubble_near_wall]
radius = "0.15 mm"
standoff = 1.1
driving_pressure = "50 MPa"
particles_per_radius = 6
width = 5
height = 3
wall_depth = 4
liquid = "water"
wall = "soft"
strain_rate = false

[material.soft.solid]
density = 8000
elastic = { young_modulus = "120 GPa", poisson_ratio = 0.3 }
strength.linear_hardening = { yield_stress = "80 MPa", hardening_modulus = "1 GPa" }

[[probe]]
name = "below"
body = "liquid"
position = [0, "50 um"]

[output]
fields_every = "1 us"
history_every = "10 ns"
"#;

const THREE: &str = "[[impacts.bubble]]\ntimes = 3\n";

fn file(folder: &Path, text: &str) -> PathBuf {
    let path = folder.join("case.toml");
    fs::write(&path, text).unwrap();
    path
}

fn start(text: &str, folder: &Path, name: &str, stop: &AtomicBool) -> (Ended, PathBuf) {
    let output = folder.join(name);
    let options = Start {
        case: file(folder, text),
        overrides: Vec::new(),
        output: output.clone(),
        threads: None,
    };
    (run::start(&options, stop, &mut Quiet).unwrap(), output)
}

/// A finished run: its folder is removed with the first part.
fn finished(text: &str) -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let (ended, output) = start(text, folder.path(), "run", &AtomicBool::new(false));
    assert!(matches!(ended, Ended::Done { .. }));
    (folder, output)
}

fn summary(dir: &Path) -> Summary {
    Summary::read(&dir.join("summary.json")).unwrap()
}

fn impacts(dir: &Path) -> Table {
    Table::read(&dir.join("impacts.csv")).unwrap()
}

fn column(table: &Table, name: &str) -> Vec<f64> {
    table
        .column(name)
        .unwrap_or_else(|| panic!("{name}"))
        .to_vec()
}

fn damaged(rupture_strain: f64) -> String {
    let wall = "wall = \"soft\"";
    let law = format!("{wall}\ndamage.rupture_strain.rupture_strain = {rupture_strain:?}");
    format!("{}{THREE}", NEAR.replace(wall, &law))
}

/// Up to its end the only impact of a sequence is the run without one, byte for byte; so are the scalars of its bubble.
#[test]
fn one_impact_is_the_single_run_bit_for_bit() {
    let (_a, single) = finished(NEAR);
    let (_b, sequence) = finished(&format!("{NEAR}[[impacts.bubble]]\n"));
    for name in [
        "history.csv",
        "probes/below.csv",
        "surface/wall_pressure.csv",
    ] {
        let [one, other] = [&single, &sequence].map(|d| fs::read_to_string(d.join(name)).unwrap());
        assert!(one.lines().count() > 50);
        assert!(other.len() > one.len() && other.starts_with(&one), "{name}");
    }
    let [one, other] = [&single, &sequence].map(|d| summary(d));
    for name in [
        "jet_speed",
        "collapse_time",
        "peak_wall_pressure",
        "max_pressure",
        "shock_front_speed",
        "mass_drift",
        "bubble_energy",
        "particles",
    ] {
        assert!(one.get(name).is_some(), "{name}");
        assert_eq!(one.get(name), other.get(name), "{name}");
    }
    // Settling damps what still moves; it adds no energy of its own.
    let drift = |s: &Summary| s.get("energy_residual").unwrap();
    let settled = other.get("settling_energy").unwrap();
    assert!(settled > 0.0);
    assert!((drift(&other) - drift(&one)).abs() < 0.1 * settled);
}

/// Nothing fails: strain, damage and work only grow. Damage of the rupture strain is the plastic strain over it, so the impact
/// in which a wall of another rupture strain loses its first mass is known.
#[test]
fn strain_adds_up_and_tells_when_mass_is_lost() {
    let (_a, dir) = finished(&damaged(100.0));
    let sound = impacts(&dir);
    let strain = column(&sound, "max_plastic_strain");
    let damage = column(&sound, "max_damage");
    assert_eq!(strain.len(), 3);
    assert!(
        strain[0] > 1e-3 && strain.windows(2).all(|s| s[1] > s[0]),
        "{strain:?}"
    );
    for name in ["plastic_work", "plastic_volume", "pit_depth"] {
        let values = column(&sound, name);
        assert!(
            values[0] > 0.0 && values.windows(2).all(|v| v[1] >= v[0]),
            "{name} {values:?}"
        );
    }
    for (d, s) in damage.iter().zip(&strain) {
        assert!((100.0 * d / s - 1.0).abs() < 1e-9);
    }
    let absorbed: f64 = column(&sound, "absorbed_energy").iter().sum();
    assert!((absorbed / column(&sound, "plastic_work")[2] - 1.0).abs() < 1e-12);
    assert!(column(&sound, "lost_mass").iter().all(|m| *m == 0.0));
    // Miner's rule by hand: the last two of three impacts.
    let told = summary(&dir);
    assert_eq!(told.get("incubation_impacts"), None);
    let expected = 3.0 + (1.0 - damage[2]) / (0.5 * (damage[2] - damage[0]));
    assert!((told.get("incubation_impacts_estimate").unwrap() / expected - 1.0).abs() < 1e-12);
    let page = fs::read_to_string(dir.join("report/index.html")).unwrap();
    assert!(page.contains("No mass was lost within 3 impacts.") && page.contains("Miner"));

    for (rupture, expected) in [(0.5 * strain[0], 1.0), (0.5 * (strain[0] + strain[1]), 2.0)] {
        let (_b, dir) = finished(&damaged(rupture));
        let told = summary(&dir);
        assert_eq!(told.get("incubation_impacts"), Some(expected));
        assert_eq!(told.get("incubation_impacts_estimate"), None);
        let lost = column(&impacts(&dir), "lost_mass");
        let first = expected as usize - 1;
        assert!(
            lost[..first].iter().all(|m| *m == 0.0) && lost[first] > 0.0,
            "{lost:?}"
        );
        assert!(lost.windows(2).all(|m| m[1] >= m[0]), "{lost:?}");
        assert_eq!(told.get("lost_mass").unwrap(), lost[2]);
        let page = fs::read_to_string(dir.join("report/index.html")).unwrap();
        assert!(page.contains(&format!("mass was lost first in impact {expected} of 3")));
    }
}

/// An elastic wall is as it was: the second of two equal impacts finds the same wall. Where settling ended the surface is 2e-10 m
/// deep, 1e-5 of a spacing, and the liquid follows it; the jet, of which a particle or two are read, makes half a percent of it.
#[test]
fn an_elastic_wall_forgets() {
    let hardening = NEAR.lines().find(|l| l.starts_with("strength")).unwrap();
    let elastic = NEAR.replace(hardening, "strength.elastic = {}");
    let (_a, dir) = finished(&format!("{elastic}[[impacts.bubble]]\ntimes = 2\n"));
    let table = impacts(&dir);
    let of = |name: &str| column(&table, name);
    assert_eq!(of("plastic_work"), [0.0; 2]);
    // 1e-4 of a spacing; under the impact it is a few hundredths.
    assert!(
        of("pit_depth").iter().all(|d| d.abs() < 2.5e-9),
        "{:?}",
        of("pit_depth")
    );
    let alike = |name: &str, tolerance: f64| {
        let v = of(name);
        assert!((v[1] / v[0] - 1.0).abs() < tolerance, "{name} {v:?}");
    };
    // 3 x 2e-10 m over the radius.
    alike("bubble_volume", 1e-5);
    alike("jet_speed", 0.02);
    alike("peak_wall_pressure", 0.05);
    alike("wall_drift", 0.01);
    alike("liquid_energy", 0.01);
    let residual = of("settling_residual");
    assert!(residual.iter().all(|r| *r <= 1e-6), "{residual:?}");
}

fn same(a: &Path, b: &Path) {
    for name in [
        "history.csv",
        "impacts.csv",
        "fields.pvd",
        "probes/below.csv",
        "surface/wall_pressure.csv",
    ] {
        let [one, other] = [a, b].map(|d| fs::read(d.join(name)).unwrap());
        assert!(one == other, "{name} differs");
    }
    let fields = |d: &Path| {
        let mut names: Vec<PathBuf> = fs::read_dir(d.join("fields"))
            .unwrap()
            .map(|e| e.unwrap().path())
            .collect();
        names.sort();
        names
    };
    let (one, other) = (fields(a), fields(b));
    assert_eq!(one.len(), other.len());
    for (a, b) in one.iter().zip(&other) {
        assert!(
            fs::read(a).unwrap() == fs::read(b).unwrap(),
            "{}",
            a.display()
        );
    }
}

/// Stopped in the second impact, gone on; then again from the checkpoint at the beginning of the last settling.
#[test]
fn a_sequence_goes_on_to_the_same_bits() {
    let text = format!(
        "{NEAR}[[impacts.bubble]]\nradius = \"0.13 mm\"\n[[impacts.bubble]]\nstandoff = 0.95\n[checkpoint]\nevery = 1\n"
    );
    let (_a, whole) = finished(&text);
    let folder = tempfile::tempdir().unwrap();
    let stop = AtomicBool::new(false);
    let dir = folder.path().join("run");
    let ended = std::thread::scope(|s| {
        let run = s.spawn(|| start(&text, folder.path(), "run", &stop).0);
        while !dir.join("impacts.csv").is_file() && !run.is_finished() {
            std::thread::sleep(std::time::Duration::from_millis(2));
        }
        stop.store(true, Ordering::Relaxed);
        run.join().unwrap()
    });
    assert!(matches!(ended, Ended::Interrupted { .. }), "{ended:?}");
    let go_on = || run::resume(&dir, None, &AtomicBool::new(false), &mut Quiet).unwrap();
    assert!(matches!(go_on(), Ended::Done { .. }));
    same(&whole, &dir);

    let mut kept: Vec<PathBuf> = fs::read_dir(dir.join("checkpoints"))
        .unwrap()
        .map(|e| e.unwrap().path())
        .filter(|path| path.extension().is_some_and(|e| e == "erode"))
        .collect();
    kept.sort();
    assert_eq!(kept.len(), 2, "{kept:?}");
    fs::remove_file(&kept[1]).unwrap();
    assert!(matches!(go_on(), Ended::Done { .. }));
    same(&whole, &dir);
}

fn parsed(more: &str) -> Result<Simulation, String> {
    Case::parse("case.toml", &format!("{NEAR}{more}"), &[]).map_err(|e| e.to_string())
}

/// Mean and range of many bubbles; the same seed gives the same ones.
#[test]
fn bubbles_are_drawn_as_asked() {
    let draw = |seed: u32, radius: &str| {
        let more = format!(
            "[impacts.random]\ncount = 4000\nseed = {seed}\nradius.{radius}\nstandoff.uniform = {{ smallest = 0.9, largest = 1.3 }}"
        );
        parsed(&more).unwrap().impacts.unwrap().bubbles
    };
    let uniform = "uniform = { smallest = \"0.12 mm\", largest = \"0.2 mm\" }";
    let bubbles = draw(7, uniform);
    assert_eq!(bubbles.len(), 4000);
    assert_eq!(bubbles, draw(7, uniform));
    assert_ne!(bubbles, draw(8, uniform));
    let mean = |of: &dyn Fn(usize) -> f64| (0..4000).map(of).sum::<f64>() / 4000.0;
    // Five standard errors of a uniform distribution: 5 width/sqrt(12 n).
    let error = |width: f64| 5.0 * width / (12.0_f64 * 4000.0).sqrt();
    assert!((mean(&|k| bubbles[k].radius) - 0.16e-3).abs() < error(0.08e-3));
    assert!((mean(&|k| bubbles[k].standoff) - 1.1).abs() < error(0.4));
    assert!(
        bubbles
            .iter()
            .all(|b| (0.12e-3..0.2e-3).contains(&b.radius) && (0.9..1.3).contains(&b.standoff))
    );
    // Radius and stand-off are independent: their covariance is within five standard errors of zero.
    let covariance = mean(&|k| (bubbles[k].radius - 0.16e-3) * (bubbles[k].standoff - 1.1));
    assert!(covariance.abs() < 5.0 * 0.08e-3 * 0.4 / 12.0 / 4000.0_f64.sqrt());
    let bubbles = draw(7, "lognormal = { median = \"0.15 mm\", deviation = 0.05 }");
    let log = |k: usize| (bubbles[k].radius / 0.15e-3).ln();
    assert!(mean(&log).abs() < 5.0 * 0.05 / 4000.0_f64.sqrt());
    // Variance of a normal variance: 2 s^4/n.
    let variance = mean(&|k| log(k).powi(2));
    assert!((variance / 0.0025 - 1.0).abs() < 5.0 * (2.0_f64 / 4000.0).sqrt());
}

/// Written out and read again a sequence is the same.
#[test]
fn resolved_sequences_are_the_same() {
    let folder = tempfile::tempdir().unwrap();
    let more = "[[impacts.bubble]]\ntimes = 2\nstandoff = 0.9\n[[impacts.bubble]]\nradius = \"0.2 mm\"\nduration = \"2 us\"\n[impacts.settling]\nresidual = 1e-4\n";
    let path = file(folder.path(), &format!("{NEAR}{more}"));
    let loaded = Case::load(&path, &[], &[]).unwrap();
    let again = Case::parse("resolved.toml", &loaded.resolved_toml, &[]).unwrap();
    assert_eq!(again, loaded.simulation);
    let i = again.impacts.unwrap();
    assert_eq!(i.bubbles.len(), 3);
    assert_eq!(i.bubbles[2].duration, 2e-6);
    assert_eq!(again.run.end_time, i.bubbles[0].duration);
    // A larger bubble takes longer in proportion, as all times of the setup do.
    assert!(
        parsed("[[impacts.bubble]]\nradius = \"0.3 mm\"")
            .unwrap()
            .impacts
            .unwrap()
            .bubbles[0]
            .duration
            > 1.999 * i.bubbles[0].duration
    );
}

#[test]
fn wrong_sequences_are_refused_with_a_sentence() {
    let cases = [
        ("[impacts]\nbubble = []", "empty array"),
        ("[impacts]\n", "does not say what it is"),
        ("[[impacts.bubble]]\ntimes = 0", "times"),
        ("[impacts.random]\ncount = 0", "count"),
        ("[impacts.random]\nseed = 3", "lacks `count`"),
        ("[[impacts.bubble]]\nposition = 1e-4", "lies on the axis"),
        ("[[impacts.bubble]]\nradius = 1e-5", "0.4 particles"),
        ("[[impacts.bubble]]\nradius = 1e-3", "outside the liquid"),
        (
            "[[impacts.bubble]]\nstandoff = 0.1\nradius = 0.7e-3",
            "reaches through the wall",
        ),
        ("[[impacts.bubble]]\nstandof = 1", "did you mean"),
        ("[[impacts.bubble]]\n[impacts.random]\ncount = 2", "both"),
        (
            "[impacts.random]\ncount = 2\nradius.uniform = { smallest = 2e-4, largest = 1e-4 }",
            "below the smallest",
        ),
        (
            "[[impacts.bubble]]\n[impacts.settling]\nresidual = 2",
            "residual",
        ),
        ("[[impacts.bubble]]\n[settling]\nstart = 0", "another load"),
    ];
    for (more, phrase) in cases {
        let error = parsed(more).unwrap_err();
        assert!(error.contains(phrase), "{more}: {error}");
    }
    let joshi = NEAR.replace(
        "strain_rate = false",
        "strain_rate = false\nwall_formulation.joshi = {}",
    );
    let error = Case::parse("case.toml", &format!("{joshi}{THREE}"), &[]).unwrap_err();
    assert!(error.to_string().contains("total Lagrangian"), "{error}");
    let far = "[setup.bubble_in_liquid]\nradius = 1e-4\npressure = 1e6\nparticles_per_radius = 10\nliquid = \"water\"\n";
    let error = Case::parse("case.toml", &format!("{far}{THREE}"), &[]).unwrap_err();
    assert!(
        error.to_string().contains("a bubble next to a wall"),
        "{error}"
    );
    let alone = "[setup.single_bubble]\nradius = 1e-4\nambient_pressure.constant.pressure = 1e6\n";
    let error = Case::parse("case.toml", &format!("{alone}{THREE}"), &[]).unwrap_err();
    assert!(
        error.to_string().contains("`impacts` has no meaning"),
        "{error}"
    );
}
