//! Run folders with invented but plausible contents: a sphere collapses as Rayleigh says next to a solid in which a ring
//! yields.

mod fields;

use erode::output::{Column, TableWriter};
use erode::report::{collapse_curve, collapse_time};
use std::fs;
use std::path::Path;

pub(crate) const RADIUS: f64 = 1.5e-4;
pub(crate) const CENTRE: f64 = 2.0e-4;
pub(crate) const DRIVING: f64 = 5.0e7;
pub(crate) const END: f64 = 1.2e-6;
/// When the wave meets the bubble.
const ARRIVAL: f64 = 2.5e-7;
const LARGEST_STRAIN: f64 = 0.0025;

/// What a synthetic run has.
#[derive(Clone, Copy)]
pub(crate) struct Has {
    pub(crate) bubble: bool,
    pub(crate) solid: bool,
}

pub(crate) fn write_run(dir: &Path, has: Has) {
    for folder in ["fields", "probes", "surface"] {
        fs::create_dir_all(dir.join(folder)).unwrap();
    }
    fs::write(dir.join("case.toml"), CASE).unwrap();
    fs::write(dir.join("resolved.toml"), RESOLVED).unwrap();
    fs::write(
        dir.join("status.json"),
        r#"{"state":"done","time":1.2e-6,"message":null}"#,
    )
    .unwrap();
    fs::write(dir.join("summary.json"), summary(has)).unwrap();
    write_history(dir, has);
    if has.solid {
        write_wall(dir);
    }
    write_probes(dir);
    fields::write_fields(dir, has);
}

const CASE: &str = r#"title = "Bubble next to A-2205 steel, standoff 1.33"
[setup.bubble_near_wall]
radius = "0.15 mm"
standoff = 1.33               # centre to wall / radius
driving_pressure = "50 MPa"
particles_per_radius = 30
liquid = "water"
wall = "steel_a2205"
[run]
end_time = "1.2 us"
[output]
fields_every = "0.1 us"
"#;

const RESOLVED: &str = "title = \"x\"\n[bubble]\nradius = 1.5e-4\ndriving_pressure = 5.0e7\n[[body]]\nname = \"liquid\"\n\
                        [body.eos]\nrho0 = 1000.0\n";

fn summary(has: Has) -> String {
    let mut value = serde_json::json!({
        "steps": 12345, "particles": 81234, "wall_time": 187.4, "energy_drift": -0.0031,
        "units": {"steps": "-", "particles": "-", "wall_time": "s", "energy_drift": "-", "ledger.energy_kinetic": "J",
                  "ledger.mass_left": "kg"},
        "versions": {"erode": "0.1.0"},
        "ledger": {"energy_kinetic": 2.0e-4, "mass_left": 0.0, "particles_left": 0},
        "limiters": {"liquid sound": 9000, "solid longitudinal": 3300, "artificial_viscosity": 45},
    });
    let mut set = |key: &str, unit: &str, number: f64| {
        value[key] = number.into();
        value["units"][key] = unit.into();
    };
    if has.bubble {
        let collapse = collapse_time(RADIUS, DRIVING, 1000.0);
        set("collapse_time", "s", collapse);
        set("collapse_instant", "s", ARRIVAL + collapse);
        set("jet_time", "s", 0.92 * (ARRIVAL + collapse));
        set("jet_speed", "m/s", 812.0);
    }
    if has.solid {
        set("peak_wall_pressure", "Pa", 1.234e9);
        set("max_plastic_strain", "-", LARGEST_STRAIN);
        set("max_plastic_strain_r", "m", 6.0e-5);
        set("max_plastic_strain_depth", "m", 1.2e-5);
        set("plastic_work", "J", 3.2e-6);
        set("pit_depth", "m", 2.1e-7);
        value["comparison"] = serde_json::json!([
            {"quantity": "max_plastic_strain", "value": LARGEST_STRAIN, "reference": 0.0023, "unit": "-",
             "source": "Joshi 2018, figure 6.7d"},
            {"quantity": "place of the largest plastic strain", "value": "off the axis", "reference": "off the axis",
             "source": "Joshi 2018, section 6.4.1"}
        ]);
    }
    serde_json::to_string_pretty(&value).unwrap()
}

/// Rayleigh's radius, then a rebound to nothing.
pub(crate) fn radius(time: f64) -> f64 {
    let curve = collapse_curve(RADIUS, DRIVING, 1000.0, 200);
    let after = curve.partition_point(|p| p[0] < time - ARRIVAL);
    if after == 0 {
        RADIUS
    } else if after == curve.len() {
        0.0
    } else {
        let [a, b] = [curve[after - 1], curve[after]];
        a[1] + (time - ARRIVAL - a[0]) / (b[0] - a[0]) * (b[1] - a[1])
    }
}

fn table(path: &Path, heads: &[(&str, &str)], rows: impl Iterator<Item = Vec<f64>>) {
    let columns: Vec<Column> = heads
        .iter()
        .map(|(name, unit)| Column::new(*name, *unit))
        .collect();
    let mut writer = TableWriter::create(path, &columns).unwrap();
    rows.for_each(|row| writer.write_row(&row).unwrap());
    writer.sync().unwrap();
}

fn times(count: i32) -> impl Iterator<Item = f64> {
    (0..=count).map(move |k| END * f64::from(k) / f64::from(count))
}

fn write_history(dir: &Path, has: Has) {
    let mut heads = vec![
        ("time", "s"),
        ("dt", "s"),
        ("energy_kinetic", "J"),
        ("energy_compression", "J"),
        ("energy_boundary_work", "J"),
        ("energy_dissipation", "J"),
        ("energy_drift", "-"),
    ];
    if has.solid {
        heads.push(("max_plastic_strain", "-"));
    }
    if has.bubble {
        heads.extend([("bubble_volume", "m3"), ("bubble_radius", "m")]);
    }
    let rows = times(2000).map(|t| {
        let s = t / END;
        let mut row = vec![
            t,
            1e-10 * (1.0 + 0.3 * (20.0 * s).sin()),
            2e-4 * s * s,
            1e-4 * s,
            -3e-4 * s,
            4e-5 * s.powi(3),
        ];
        row.push(-0.003 * s.powi(2));
        if has.solid {
            row.push(LARGEST_STRAIN * grown(t));
        }
        if has.bubble {
            let radius = radius(t);
            row.extend([4.0 / 3.0 * std::f64::consts::PI * radius.powi(3), radius]);
        }
        row
    });
    table(&dir.join("history.csv"), &heads, rows);
}

/// Incoming step and a decaying shock that leaves the bubble's centre when it has vanished.
fn pressure(r: f64, z: f64, time: f64) -> f64 {
    let collapse = ARRIVAL + collapse_time(RADIUS, DRIVING, 1000.0);
    let distance = r.hypot(z - CENTRE).max(1e-5);
    let step = if z > CENTRE + RADIUS - 1500.0 * (time - ARRIVAL) {
        DRIVING
    } else {
        0.0
    };
    let behind = (time - collapse) * 1600.0 - distance;
    let shock = if behind > 0.0 {
        1.2e9 * 2e-5 / distance * (-behind / 6e-5).exp()
    } else {
        0.0
    };
    step + shock
}

fn write_wall(dir: &Path) {
    let radii: Vec<f64> = (0..60).map(|k| 2.5e-6 + 5e-6 * f64::from(k)).collect();
    let names: Vec<String> = radii.iter().map(|r| format!("r={r:e}")).collect();
    let mut heads = vec![("time", "s")];
    heads.extend(names.iter().map(|n| (n.as_str(), "Pa")));
    let row = |t: f64| {
        std::iter::once(t)
            .chain(radii.iter().map(move |r| pressure(*r, 0.0, t)))
            .collect()
    };
    table(
        &dir.join("surface/wall_pressure.csv"),
        &heads,
        times(400).map(row),
    );
}

fn write_probes(dir: &Path) {
    for (name, z) in [("above", 4e-4), ("at_wall", 0.0)] {
        let row = |t: f64| {
            vec![
                t,
                pressure(0.0, z, t),
                if t < 2e-7 { f64::NAN } else { -40.0 * t / END },
            ]
        };
        table(
            &dir.join(format!("probes/{name}.csv")),
            &[("time", "s"), ("pressure", "Pa"), ("velocity_z", "m/s")],
            times(300).map(row),
        );
    }
}

/// How much of the final plastic strain there is.
fn grown(time: f64) -> f64 {
    ((time / END - 0.8) / 0.2).clamp(0.0, 1.0)
}
