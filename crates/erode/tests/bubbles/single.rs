//! `[setup.single_bubble]`.

use super::common::{assert_identical, case, checkpoints, fresh, refused, says, summary, wrong};
use erode::output::Table;
use erode::run::{self, Ended, Quiet, Start};
use std::fs;
use std::sync::atomic::AtomicBool;

const TABLES: [&str; 3] = ["history.csv", "events.csv", "resolved.toml"];

fn finished(name: &str, more: &[&str]) -> std::path::PathBuf {
    let dir = fresh(name);
    let folder = case("single-bubble");
    let mut args = vec!["run", &folder, "-o", dir.to_str().unwrap()];
    args.extend(more.iter().flat_map(|m| ["--set", m]));
    says(&args);
    dir
}

#[test]
fn the_case_writes_its_folder_and_meets_the_reference() {
    let dir = finished("whole", &[]);
    for file in [
        "case.toml",
        "summary.json",
        "status.json",
        "report/index.html",
    ] {
        assert!(dir.join(file).metadata().unwrap().len() > 0, "{file}");
    }
    let history = Table::read(&dir.join("history.csv")).unwrap();
    let time = history.column("time").unwrap();
    assert!(history.rows() > 1000 && time.windows(2).all(|t| t[1] > t[0]));
    assert!(history.values.iter().flatten().all(|v| v.is_finite()));
    let radius = history.column("bubble_radius").unwrap();
    let jumps = radius.windows(2).map(|r| (r[1] / r[0]).ln().abs());
    assert!(
        jumps.fold(0.0, f64::max) < 0.6,
        "the collapse is not resolved in the rows"
    );
    // validation/bubble-acoustic, Keller-Miksis: the largest radii and the smallest one of both periods.
    let s = summary(&dir);
    let near = |key: &str, reference: f64| {
        let value = s[key].as_f64().unwrap();
        assert!((value / reference - 1.0).abs() < 1e-6, "{key} {value}");
        assert!(s["units"][key].is_string());
    };
    near("largest_bubble_radius", 5.921_313_962_985_6e-5);
    near("smallest_bubble_radius", 4.911_272_558_976e-7);
    near("max_bubble_pressure", 8.151_686_671_67e9);
    near("equilibrium_radius", 8e-6);
    assert!(s["energy_drift"].as_f64().unwrap().abs() < 1e-6);
    let report = fs::read_to_string(dir.join("report/index.html")).unwrap();
    for part in [
        "The bubble",
        "smallest: it rebounds",
        "radiated",
        "Pressure of vapour and gas",
    ] {
        assert!(report.contains(part), "the report lacks `{part}`");
    }
}

#[test]
fn a_run_goes_on_from_an_older_checkpoint_to_the_same_bits() {
    let (whole, cut) = (finished("one", &[]), finished("other", &[]));
    assert_identical(&whole, &cut, &TABLES);
    let kept = checkpoints(&cut);
    assert_eq!(kept.len(), 2);
    fs::remove_file(&kept[1]).unwrap();
    fs::remove_file(cut.join("summary.json")).unwrap();
    let said = says(&["resume", cut.to_str().unwrap()]);
    assert!(said.contains("going on from"), "{said}");
    assert_identical(&whole, &cut, &TABLES);
}

#[test]
fn a_stopped_run_goes_on_to_the_same_bits() {
    let whole = finished("unstopped", &[]);
    let dir = fresh("stopped");
    let start = Start {
        case: case("single-bubble").into(),
        overrides: Vec::new(),
        output: dir.clone(),
        threads: None,
    };
    let ended = run::start(&start, &AtomicBool::new(true), &mut Quiet).unwrap();
    assert!(matches!(ended, Ended::Interrupted { .. }));
    assert!(says(&["status", dir.to_str().unwrap()]).contains("interrupted"));
    run::resume(&dir, None, &AtomicBool::new(false), &mut Quiet).unwrap();
    assert_identical(&whole, &dir, &TABLES);
}

/// A cavity of vapour closes after 0.914681 R sqrt(rho/(p - p_v)), a little later for its surface tension.
#[test]
fn a_bubble_of_vapour_closes_after_rayleighs_time() {
    let dir = finished(
        "vapour",
        &[
            "setup.single_bubble.radius=1 mm",
            "setup.single_bubble.ambient_pressure.constant={pressure=\"1 bar\"}",
            "setup.single_bubble.gas.given={pressure=0}",
            "setup.single_bubble.liquid={surface_tension=0,viscosity=0}",
            "setup.single_bubble.model.rayleigh_plesset={}",
            "run.end_time=1 ms",
        ],
    );
    let s = summary(&dir);
    assert_eq!(s["closed"], 1);
    let ratio = s["end_time"].as_f64().unwrap() / s["rayleigh_time"].as_f64().unwrap();
    assert!((ratio - 1.0).abs() < 1e-6, "{ratio}");
    assert!(s["equilibrium_radius"].is_null());
}

#[test]
fn a_pressure_step_is_followed_across_its_kinks() {
    let dir = finished(
        "ramp",
        &[
            "setup.single_bubble.ambient_pressure.ramp={from=1e5,to=1e6,start=1e-6,duration=2e-7}",
            "run.end_time=6 us",
        ],
    );
    let history = Table::read(&dir.join("history.csv")).unwrap();
    let time = history.column("time").unwrap();
    let radius = history.column("bubble_radius").unwrap();
    let still = time.iter().zip(radius).filter(|(t, _)| **t <= 1e-6);
    assert!(
        still
            .map(|(_, r)| (r / 8e-6 - 1.0).abs())
            .fold(0.0, f64::max)
            < 1e-9
    );
    let smallest = radius.iter().copied().fold(f64::INFINITY, f64::min);
    assert!(smallest < 4e-6, "{smallest}");
    let s = summary(&dir);
    assert!(s["energy_drift"].as_f64().unwrap().abs() < 1e-6);
    let pressure = history.column("ambient_pressure").unwrap();
    assert_eq!(pressure.last(), Some(&1e6));
}

#[test]
fn bad_bubbles_are_refused_with_all_errors_in_one_pass() {
    let said = wrong(
        "signs",
        "[setup.single_bubble]\nradius = \"-8 um\"\nambient_pressure.constant.pressure = \"1 m\"\n\
         gas.given.pressure = -5\nmodel.keler_miksis = {}\n",
    );
    for part in [
        "`radius`",
        "greater than zero",
        "zero or greater",
        "a pressure",
        "did you mean `keller_miksis`",
    ] {
        assert!(said.contains(part), "`{part}` is not in {said}");
    }
    assert!(said.contains("4 errors"), "{said}");
}

#[test]
fn an_equilibrium_that_does_not_exist_names_the_blake_threshold() {
    // p_v - 2 sigma/R (1 - 1/(3 k)) = 2337 - 2 * 0.0725/1e-5 * 3/4 = -8538 Pa for k = 4/3.
    let said = wrong(
        "blake",
        "[setup.single_bubble]\nradius = \"10 um\"\nambient_pressure.constant.pressure = \"-10 kPa\"\n",
    );
    let joined = said.replace(['\n', '│', ' '], "");
    assert!(joined.contains("Blakethresholdof-8.5380e3Pa"), "{said}");
    assert!(joined.contains("gas.given"), "{said}");
}

#[test]
fn what_does_not_belong_is_said() {
    let said = wrong(
        "bodies",
        "[setup.single_bubble]\nradius = \"10 um\"\nambient_pressure.constant.pressure = \"1 bar\"\n\
         [bubble]\ncentre = [0, 0]\nradius = 1\ndriving_pressure = 1\n",
    );
    assert!(
        said.contains("`bubble` has no meaning beside [setup.single_bubble]"),
        "{said}"
    );
}

#[test]
fn a_step_limit_ends_the_run_with_its_cause() {
    let dir = fresh("limit");
    let folder = case("single-bubble");
    let path = dir.to_str().unwrap();
    let said = refused(
        &["run", &folder, "-o", path, "--set", "run.max_steps=300"],
        2,
    );
    assert!(
        said.contains("more than") && said.contains("steps") && said.contains("tolerance"),
        "{said}"
    );
    assert!(says(&["status", path]).contains("failed"));
    says(&["report", path]);
}
