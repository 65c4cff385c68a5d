//! Elastic and elastic-plastic waves in a bar (uniaxial stress) and in a plate (uniaxial strain) against exact speeds.

use super::check::Check;
use super::materials::steel;
use super::{Failure, Figure, Finding, Style, Validation};
use erode_physics::Elastic;
use erode_physics::material_point::Material;
use erode_physics::strength::Strength;
use erode_sph::Geometry;
use erode_sph::solid::{Block, Face, Numerics, Setup, Side, Solid};

pub(super) const BAR: Validation = Validation {
    name: "wave-in-bar",
    description: "speeds of elastic and plastic waves in a thin axisymmetric bar with linear hardening",
    reference: "theory of thin bars: sqrt(E/rho) and sqrt(E_t/rho), E_t = E H/(E + H) (validation/wave-in-bar)",
    run: bar,
};

pub(super) const PLATE: Validation = Validation {
    name: "plate-impact",
    description: "precursor, plastic front and plateaus behind them after the impact of a plate on its like",
    reference: "jump conditions of uniaxial strain: sqrt((K + 4G/3)/rho) and sqrt(K/rho) (validation/plate-impact)",
    run: plate,
};

const DX: f64 = 10e-6;
/// Particles across: of the radius, of the width.
const ACROSS: usize = 6;
const ASKED: f64 = 0.01;
const WHY: &str = "issue 3: 1 %";

/// Stress along the body at two stations against time.
struct Record {
    stations: [usize; 2],
    times: Vec<f64>,
    /// Compressive axial stress of the stations, Pa.
    stress: Vec<[f64; 2]>,
}

impl Record {
    fn new(stations: [usize; 2]) -> Self {
        Self {
            stations,
            times: Vec::new(),
            stress: Vec::new(),
        }
    }

    fn push(&mut self, time: f64, solid: &Solid) {
        self.times.push(time);
        let at = |row: usize| -solid.state.stress[ACROSS * row + ACROSS / 2].yy;
        self.stress.push(self.stations.map(at));
    }

    /// First time at which a station passes a stress, s.
    fn passes(&self, station: usize, level: f64) -> Result<f64, Failure> {
        let at = |i: usize| self.stress[i][station];
        let after = (1..self.times.len()).find(|&i| at(i) >= level);
        let i = after.ok_or_else(|| {
            Failure::Absent(format!("the stress never reaches {level} Pa at a station"))
        })?;
        let share = (level - at(i - 1)) / (at(i) - at(i - 1));
        Ok(self.times[i - 1] + share * (self.times[i] - self.times[i - 1]))
    }

    /// Speed between the stations of what passes at a stress, m/s of the reference configuration.
    fn speed(&self, level: f64) -> Result<f64, Failure> {
        let distance = self.stations[0].abs_diff(self.stations[1]) as f64 * DX;
        Ok(distance / (self.passes(1, level)? - self.passes(0, level)?))
    }

    /// Mean stress of a station between two times.
    fn mean(&self, station: usize, from: f64, to: f64) -> f64 {
        let inside = self.times.iter().zip(&self.stress);
        let inside = inside.filter(|(t, _)| (from..=to).contains(t));
        let (sum, count) = inside.fold((0.0, 0.0), |(s, n), (_, p)| (s + p[station], n + 1.0));
        sum / count
    }

    fn curve(&self, station: usize) -> Vec<[f64; 2]> {
        let points = self.times.iter().zip(&self.stress);
        points.map(|(t, p)| [*t, p[station]]).collect()
    }
}

fn body(
    geometry: Geometry,
    rows: usize,
    faces: [Face; 4],
    strength: Strength,
) -> Result<Solid, Failure> {
    let (density, elastic, _) = steel()?;
    let place = |k: usize| [k % ACROSS, k / ACROSS].map(|i| (i as f64 + 0.5) * DX);
    let [left, right, bottom, top] = faces;
    let mut solid = Solid::new(Setup {
        geometry,
        block: Block {
            lower: [0.0; 2],
            upper: [ACROSS as f64 * DX, rows as f64 * DX],
            left,
            right,
            bottom,
            top,
        },
        material: Material {
            elastic,
            strength,
            density,
            temperature: 293.0,
        },
        numerics: Numerics::default(),
        position: (0..ACROSS * rows).map(place).collect(),
        area: vec![DX * DX; ACROSS * rows],
    })?;
    solid.accelerations();
    Ok(solid)
}

/// The end is pressed to twice the yield stress within the time that a wave takes for 40 spacings.
fn bar(quick: bool, say: &mut dyn FnMut(&str)) -> Result<Finding, Failure> {
    let rows = if quick { 400 } else { 800 };
    let (density, elastic, _) = steel()?;
    let young = elastic.young_modulus;
    let (yield_stress, tangent) = (1e8, young / 4.0);
    let law = Strength::LinearHardening {
        yield_stress,
        // E_t = E H/(E + H).
        hardening_modulus: tangent / (1.0 - tangent / young),
    };
    let faces = [Face::Axis, Face::Traction, Face::Traction, Face::Traction];
    let mut solid = body(Geometry::Axisymmetric, rows, faces, law)?;
    let exact = [young, tangent].map(|modulus| (modulus / density).sqrt());
    let (dt, rise) = (solid.stable_time_step().dt, 40.0 * DX / exact[0]);
    let mut record = Record::new([rows - rows / 8, rows / 2]);
    let (mut time, end) = (0.0, 0.62 * rows as f64 * DX / exact[1]);
    say(&format!("{} particles", solid.len()));
    while time < end {
        time += dt;
        let x = (time / rise).min(1.0);
        if let Some(top) = solid.surface_mut(Side::Top) {
            top.pressure
                .fill(2.0 * yield_stress * x * x * (3.0 - 2.0 * x));
        }
        solid.step(dt)?;
        record.push(time, &solid);
    }
    let mut finding = Finding::default();
    for (what, level, exact) in [
        ("elastic wave", 0.5 * yield_stress, exact[0]),
        ("plastic wave", 1.5 * yield_stress, exact[1]),
    ] {
        let pair = (record.speed(level)?, exact);
        let quantity = format!("{rows} rows: speed of the {what}");
        finding
            .checks
            .push(Check::relative(quantity, "m/s", pair, ASKED, WHY));
    }
    // Between the arrivals of both waves at the far station.
    let arrive = [
        record.passes(1, 0.5 * yield_stress)?,
        record.passes(1, 1.5 * yield_stress)?,
    ];
    let span = arrive[1] - arrive[0];
    let between = record.mean(1, arrive[0] + 0.3 * span, arrive[0] + 0.7 * span);
    finding.checks.push(Check::relative(
        format!("{rows} rows: stress between the waves"),
        "Pa",
        (between, yield_stress),
        0.02,
        "the yield stress; the lateral inertia of the bar makes the wave ring by some percent",
    ));
    finding.figures.push(figure(
        "wave-in-bar",
        "Compressive axial stress in a bar",
        &record,
    ));
    Ok(finding)
}

fn figure(name: &str, title: &str, record: &Record) -> Figure {
    let mut figure = Figure::new(name, title, ("time", "s"), ("axial stress", "Pa"));
    figure.add("near station", Style::Line, record.curve(0));
    figure.add("far station", Style::Line, record.curve(1));
    figure
}

/// Exact answer of the impact of a perfectly plastic plate on a mirror.
struct Jumps {
    speeds: [f64; 2],
    stresses: [f64; 2],
}

impl Jumps {
    fn new(elastic: &Elastic, density: f64, yield_stress: f64, velocity: f64) -> Self {
        let longitudinal = elastic.longitudinal_speed(density);
        let bulk = (elastic.bulk_modulus() / density).sqrt();
        let nu = elastic.poisson_ratio;
        let limit = yield_stress * (1.0 - nu) / (1.0 - 2.0 * nu);
        let slowed = limit / (density * longitudinal);
        Self {
            speeds: [longitudinal, bulk],
            stresses: [limit, limit + density * bulk * (velocity - slowed)],
        }
    }
}

fn plate(quick: bool, say: &mut dyn FnMut(&str)) -> Result<Finding, Failure> {
    let rows = if quick { 400 } else { 1000 };
    let (density, elastic, _) = steel()?;
    let (yield_stress, velocity) = (1e8, 10.0);
    let law = Strength::PerfectlyPlastic { yield_stress };
    let faces = [
        Face::Symmetry,
        Face::Symmetry,
        Face::Symmetry,
        Face::Traction,
    ];
    let mut solid = body(Geometry::Plane, rows, faces, law)?;
    solid.state.velocity.fill([0.0, -velocity]);
    let exact = Jumps::new(&elastic, density, yield_stress, velocity);
    let dt = solid.stable_time_step().dt;
    let mut record = Record::new([rows / 4, 3 * rows / 4]);
    let (mut time, end) = (0.0, 0.95 * rows as f64 * DX / exact.speeds[1]);
    say(&format!("{} particles", solid.len()));
    while time < end {
        solid.step(dt)?;
        time += dt;
        record.push(time, &solid);
    }
    let mut finding = Finding::default();
    let levels = [
        0.5 * exact.stresses[0],
        0.5 * (exact.stresses[0] + exact.stresses[1]),
    ];
    for (k, what) in ["elastic precursor", "plastic front"]
        .into_iter()
        .enumerate()
    {
        let pair = (record.speed(levels[k])?, exact.speeds[k]);
        let quantity = format!("{rows} rows: speed of the {what}");
        finding
            .checks
            .push(Check::relative(quantity, "m/s", pair, ASKED, WHY));
    }
    let arrive = [record.passes(1, levels[0])?, record.passes(1, levels[1])?];
    let span = arrive[1] - arrive[0];
    let found = [
        record.mean(1, arrive[0] + 0.3 * span, arrive[0] + 0.6 * span),
        record.mean(0, record.passes(0, levels[1])? + 0.5 * span, arrive[1]),
    ];
    for (k, what) in ["behind the precursor", "behind the plastic front"]
        .into_iter()
        .enumerate()
    {
        let quantity = format!("{rows} rows: stress {what}");
        let pair = (found[k], exact.stresses[k]);
        finding
            .checks
            .push(Check::relative(quantity, "Pa", pair, ASKED, WHY));
    }
    finding.figures.push(figure(
        "plate-impact",
        "Compressive axial stress in a plate",
        &record,
    ));
    Ok(finding)
}
