//! Figure 6.11: the metal under the recorded pressure at the wall, at its own speed and so slowly that inertia is gone.

use super::super::Options;
use super::super::session::{Judged, Need, Session};
use super::chapter6::shock_front;
use super::near_wall::{Collapse, at, note};
use crate::analysis::{WallPressure, largest_in_column};
use crate::run::{Metal, off_axis_maximum};
use crate::validate::steel_lattice::Lattice;
use crate::validate::{Check, Failure, Figure, Finding, Style};
use erode_sph::Geometry;
use erode_sph::solid::{Face, Formulation, Side, Solid};

/// What the thesis has, and one more.
const STANDOFFS: [f64; 2] = [STATED, 1.5];
/// The stand-off of figure 6.11.
const STATED: f64 = 1.33;
/// Block of steel, m: twice as wide and deep as the load reaches.
const SIZE: [f64; 2] = [0.6e-3, 0.6e-3];
/// Spacing, m: quick, full.
const SPACING: (f64, f64) = (10e-6, 5e-6);
/// How many times slower: the front then runs at a fortieth of the slowest wave, the block is crossed 80 times.
const SLOWER: f64 = 20.0;
/// Rate at which the slow motion is damped, 1/s: within two passages of a wave through the block.
const DAMPING: f64 = 5e6;
/// The record begins so long before the front arrives, s.
const BEFORE: f64 = 20e-9;
/// Largest kinetic over largest internal energy up to which a motion counts as static.
const STATIC: f64 = 0.05;
/// The energies are looked at in so many steps.
const LOOK_EVERY: u64 = 20;
/// The load is taken away at the end of the record in this time of it, s.
const AWAY: f64 = 50e-9;

pub(super) fn needs(options: &Options) -> Vec<Need> {
    STANDOFFS.iter().map(|s| at(*s).need(options)).collect()
}

/// Pressure on the wall over the time of the record, from nothing to nothing.
struct Load {
    wall: WallPressure,
    begin: f64,
    end: f64,
}

impl Load {
    fn of(wall: WallPressure) -> Result<Self, Failure> {
        let first = shock_front(&wall).first().map(|f| f.time - BEFORE);
        let begin = first.ok_or_else(|| Failure::Absent("no shock reached the wall".into()))?;
        let end = wall.time.last().copied().unwrap_or(begin);
        if wall.time.len() < 2 || wall.radius.len() < 2 {
            return Err(Failure::Absent(
                "the wall pressure has fewer than two rows or radii".into(),
            ));
        }
        Ok(Self { wall, begin, end })
    }

    /// Pressure at a radius (m) and a time of the record (s), linear between its rows and columns.
    fn at(&self, r: f64, time: f64) -> f64 {
        let part = |places: &[f64], x: f64| {
            let k = places
                .partition_point(|p| *p <= x)
                .clamp(1, places.len() - 1);
            let f = (x - places[k - 1]) / (places[k] - places[k - 1]);
            (k, f.clamp(0.0, 1.0))
        };
        let (i, f) = part(&self.wall.radius, r);
        let (k, g) = part(&self.wall.time, time);
        let row =
            |i: usize| (1.0 - g) * self.wall.pressure[i][k - 1] + g * self.wall.pressure[i][k];
        // It is put on and taken away without a jump.
        let on = ((time - self.begin) / BEFORE).min((self.end - time) / AWAY);
        on.clamp(0.0, 1.0) * ((1.0 - f) * row(i - 1) + f * row(i))
    }

    /// A block of steel without strain-rate effect under the record, `slower` times as long; the largest kinetic over the
    /// largest internal energy on the way.
    fn press(&self, spacing: f64, slower: f64) -> Result<(Solid, f64), Failure> {
        let lattice = Lattice {
            geometry: Geometry::Axisymmetric,
            size: SIZE,
            spacing,
            faces: [Face::Axis, Face::Symmetry, Face::Symmetry, Face::Traction],
            formulation: Formulation::TotalLagrangian,
        };
        let mut solid = lattice.build()?;
        let duration = slower * (self.end - self.begin);
        let steps = (duration / solid.stable_time_step().dt).ceil();
        let (mut kinetic, mut internal) = (0.0_f64, 0.0_f64);
        for step in 1..=steps as u64 {
            let time = self.begin + step as f64 / steps * (self.end - self.begin);
            if let Some(top) = solid.surface_mut(Side::Top) {
                top.push(|x| self.at(x[0], time));
            }
            solid.step(duration / steps)?;
            if slower > 1.0 {
                solid.damp(DAMPING, duration / steps);
            }
            if step % LOOK_EVERY == 0 {
                let energy = solid.energy();
                kinetic = kinetic.max(energy.kinetic);
                internal = internal.max(energy.elastic + energy.plastic_work);
            }
        }
        Ok((solid, kinetic / internal))
    }
}

/// Largest strain, its distance from the axis, and that of the largest one apart from the axis; places are no numbers where
/// there are none.
fn places(solid: &Solid) -> [f64; 3] {
    let metal = Metal::of(solid);
    let ring = off_axis_maximum(&crate::run::columns(solid));
    [
        metal.max_plastic_strain,
        metal.place[0],
        ring.map_or(f64::NAN, |c| c.r),
    ]
}

fn below(solid: &Solid, spacing: f64) -> Vec<[f64; 2]> {
    let columns = (SIZE[0] / spacing).round() as usize;
    let radii: Vec<f64> = (0..columns).map(|i| (i as f64 + 0.5) * spacing).collect();
    let strain = largest_in_column(
        &solid.reference.position,
        &solid.state.plastic_strain,
        &radii,
    );
    radii.into_iter().zip(strain).map(|(r, e)| [r, e]).collect()
}

pub(super) fn judge(session: &Session) -> Result<Judged, Failure> {
    let quick = session.options.quick;
    let spacing = if quick { SPACING.0 } else { SPACING.1 };
    let mut finding = Finding {
        notes: vec![
            note(session),
            format!(
                "A block of {} mm on rollers, spacing {} um, without strain-rate effect, under the recorded pressure: {SLOWER} times slower, and at its own \
                 speed. The thesis used a static finite-element calculation.",
                SIZE[0] * 1e3,
                spacing * 1e6
            ),
        ],
        ..Finding::default()
    };
    for standoff in STANDOFFS {
        let case: Collapse = at(standoff);
        let load = Load::of(case.results(session)?.wall()?)?;
        let (slow, inertia) = load.press(spacing, SLOWER)?;
        let (fast, _) = load.press(spacing, 1.0)?;
        let title = format!("Stand-off {standoff}");
        let mut figure = Figure::new(
            &format!("standoff-{standoff}"),
            &title,
            ("distance from the axis", "m"),
            ("largest plastic strain below", "-"),
        );
        figure.add("slowly", Style::Dashed, below(&slow, spacing));
        figure.add("at its own speed", Style::Line, below(&fast, spacing));
        finding.figures.push(figure);
        finding
            .checks
            .extend(checks(standoff, (&slow, inertia), &fast, spacing));
    }
    Ok(finding.into())
}

fn checks(standoff: f64, (slow, inertia): (&Solid, f64), fast: &Solid, spacing: f64) -> Vec<Check> {
    let ([e_slow, r_slow, _], [e_fast, r_fast, ring]) = (places(slow), places(fast));
    let named = |what: &str| format!("{standoff}: {what}");
    let slowly = named("distance of the largest strain from the axis, slowly");
    let fast_too = named("the same, at its own speed");
    let apart = 2.0 * spacing;
    let judged = |check: Check| {
        if inertia <= STATIC {
            check
        } else {
            check.without_data("the slow motion is not static: see its energies")
        }
    };
    let [slowly, fast_too] = if standoff == STATED {
        [
            judged(Check::absolute(
                slowly,
                "m",
                (r_slow, 0.0),
                apart,
                "\"the static response does not have an offset\" of \"the maximum plastic strain which occurs at the symmetry axis\": within two spacings",
            )),
            Check::more_than(
                fast_too,
                "m",
                r_fast,
                apart,
                "\"the reason for the offset of maximum plastic strain as shown in figure 6.7d is the dynamic loading\": more than two spacings",
            ),
        ]
    } else {
        let words = "not judged: the source has stand-off 1.33 only";
        [(slowly, r_slow), (fast_too, r_fast)]
            .map(|(quantity, r)| Check::shown(quantity, "m", r, None, words))
    };
    vec![
        slowly,
        fast_too,
        Check::shown(
            named("largest strain, slowly"),
            "-",
            e_slow,
            None,
            "the source gives no number",
        ),
        Check::shown(
            named("largest strain, at its own speed"),
            "-",
            e_fast,
            None,
            "the source gives no number",
        ),
        Check::shown(
            named("distance of the largest strain apart from the axis, at its own speed"),
            "m",
            ring,
            None,
            "the source gives no number",
        ),
        Check::shown(
            named("largest kinetic over largest internal energy, slowly"),
            "-",
            inertia,
            None,
            "up to 0.05 the motion counts as static: inertia is gone",
        ),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 3 GPa over 0.1 mm, falling slowly after its rise.
    fn bell(r: f64, t: f64) -> f64 {
        let course = if t < 40e-9 {
            0.0
        } else {
            1.0 - (t - 40e-9) / 1e-6
        };
        3e9 * course * (-(r / 5e-5).powi(2)).exp()
    }

    /// A pressure that is largest on the axis at all times yields there.
    #[test]
    fn a_pressure_on_the_axis_strains_the_axis() {
        let radius: Vec<f64> = (0..60).map(|i| (f64::from(i) + 0.5) * 10e-6).collect();
        let time: Vec<f64> = (0..200).map(|k| f64::from(k) * 2e-9).collect();
        let along = |r: &f64| time.iter().map(|t| bell(*r, *t)).collect();
        let pressure = radius.iter().map(along);
        let load = Load::of(WallPressure {
            pressure: pressure.collect(),
            time: time.clone(),
            radius: radius.clone(),
        })
        .unwrap();
        assert!(load.at(0.0, load.begin) == 0.0 && load.at(0.0, load.end) == 0.0);
        assert!((load.at(15e-6, 101e-9) / bell(15e-6, 101e-9) - 1.0).abs() < 1e-9);
        let between = load.at(20e-6, 101e-9) / bell(20e-6, 101e-9);
        assert!((between - 1.0).abs() < 0.02, "{between}");
        let (solid, inertia) = load.press(20e-6, 2.0).unwrap();
        let [strain, r, _] = places(&solid);
        assert!(inertia > 0.0 && inertia < 1.0, "{inertia}");
        assert!(strain > 1e-3 && r < 40e-6, "{strain} {r}");
    }
}
