//! Scalars of an impact that need its whole course: the ring of void, the shock front on the wall, the times of load and
//! metal. They are taken from the tables that the run wrote.

use super::impacts::{Sequence, last};
use super::monitor::{COLLAPSED, Record, solid};
use crate::analysis::{
    self, WallPressure, YIELDED, energy_density, followed_above, front, last_toroid, zone_depth,
};
use crate::case::{BodyKind, Simulation, Solid};
use crate::output::{OutputError, RunPaths, Summary, Table};
use erode_sph::world::World;

/// Adds the scalars of a bubble next to a wall, of a sequence those of the last one; those of a wall without a recorded pressure are not a number.
///
/// # Errors
/// If a table that the run wrote cannot be read.
pub(super) fn add(
    s: &mut Summary,
    world: &World,
    simulation: &Simulation,
    record: &Record,
    (paths, sequence): (&RunPaths, Option<&Sequence>),
) -> Result<(), OutputError> {
    let Some(bubble) = simulation.bubble.filter(|b| b.wall_distance.is_some()) else {
        return Ok(());
    };
    let none = f64::NAN;
    s.set("jet_half_width", "m", record.jet_half_width.unwrap_or(none));
    let history = last(Table::read(&paths.history())?, sequence);
    let toroid = toroid(&history, COLLAPSED * record.initial_volume);
    s.set("toroid_r", "m", toroid.map_or(none, |t| t.r));
    s.set("toroid_z", "m", toroid.map_or(none, |t| t.z));
    s.set("toroid_time", "s", toroid.map_or(none, |t| t.time));
    let Some(metal) = simulation.bodies.iter().find_map(|b| match &b.kind {
        BodyKind::Solid(metal) => Some(metal),
        BodyKind::Fluid(_) => None,
    }) else {
        return Ok(());
    };
    let get = |s: &Summary, name: &str| s.get(name).unwrap_or(none);
    let density = energy_density(get(s, "plastic_work"), get(s, "plastic_volume"));
    s.set("absorbed_energy_density", "J/m3", density);
    let recorded = paths.surface("wall_pressure");
    // Metal without an upper face has no such table.
    let wall = recorded.exists().then(|| Table::read(&recorded));
    let wall = wall.transpose()?.map(|w| last(w, sequence));
    let wall = wall.as_ref().and_then(WallPressure::of);
    let yield_stress = yield_stress(metal);
    let least = followed_above(yield_stress, bubble.driving_pressure);
    let found = wall.as_ref().map(|w| front(w, least));
    let at = |r: f64| {
        let all = found.iter().flatten();
        all.min_by(|a, b| (a.radius - r).abs().total_cmp(&(b.radius - r).abs()))
            .filter(|f| (f.radius - r).abs() < 0.1 * bubble.radius)
    };
    let speed = at(bubble.radius).map_or(none, |f| f.speed);
    s.set("shock_front_speed", "m/s", speed);
    let rise = analysis::above_step(analysis::RISE, bubble.driving_pressure);
    times(s, world, metal, wall.as_ref(), [rise, yield_stress]);
    Ok(())
}

/// Temperature at which the yield stress is taken, K: that of the reference tests.
const ROOM: f64 = 293.15;

/// Yield stress of what the liquid meets, Pa: of the uppermost layer, or of the body without layers.
fn yield_stress(metal: &Solid) -> f64 {
    let skin = metal
        .layers
        .first()
        .map_or(&metal.strength, |l| &l.strength);
    skin.yield_stress(0.0, 0.0, ROOM)
}

/// Time that a longitudinal wave needs to a depth (m), layer by layer, s.
fn material_time(metal: &Solid, depth: f64) -> f64 {
    let (mut left, mut time) = (depth, 0.0);
    for layer in &metal.layers {
        let inside = left.min(layer.thickness);
        time += analysis::material_time(inside, layer.elastic.longitudinal_speed(layer.density));
        left -= inside;
    }
    time + analysis::material_time(left, metal.elastic.longitudinal_speed(metal.density))
}

/// Load and metal where the plastic strain is largest.
fn times(
    s: &mut Summary,
    world: &World,
    metal: &Solid,
    wall: Option<&WallPressure>,
    [rise, fall]: [f64; 2],
) {
    // Metal that did not yield has no such place.
    let place = s.get("max_plastic_strain_r").unwrap_or(f64::NAN);
    let wall = wall.filter(|_| place.is_finite());
    let load = wall.and_then(|w| {
        let pressure = &w.pressure[w.nearest(place)];
        analysis::loading_time(&w.time, pressure, rise, fall)
    });
    let depth = wall.zip(solid(world)).map(|(w, body)| {
        let (position, strain) = (&body.reference.position, &body.state.plastic_strain);
        let top = body.block.upper[1];
        zone_depth(position, strain, top, &w.radius, YIELDED)[w.nearest(place)]
    });
    let answer = depth.map(|d| material_time(metal, d));
    s.set("loading_time", "s", load.unwrap_or(f64::NAN));
    s.set("material_time", "s", answer.unwrap_or(f64::NAN));
}

/// The ring of void before less than `volume` is left.
fn toroid(history: &Table, volume: f64) -> Option<analysis::Toroid> {
    let column = |name: &str| history.column(name);
    let left = column("bubble_volume")?;
    let rows = left.iter().take_while(|v| **v > volume).count();
    let cut = |name: &str| column(name).map(|c| &c[..rows]);
    last_toroid(
        cut("time")?,
        cut("bubble_inner_radius")?,
        [cut("bubble_centre_r")?, cut("bubble_centre")?],
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::Case;

    #[test]
    fn a_coated_wall_is_judged_by_its_layers() {
        let text = include_str!("../../../../cases/bubble-near-steel/case.toml");
        let of = |set: &str| {
            let set = [format!("setup.bubble_near_wall.{set}")];
            let simulation = Case::parse("case.toml", text, &set).unwrap();
            let walls = simulation.bodies.into_iter();
            walls
                .filter_map(|b| match b.kind {
                    BodyKind::Solid(s) => Some(s),
                    BodyKind::Fluid(_) => None,
                })
                .next()
                .unwrap()
        };
        let coated = of("wall_layers=[{material=\"copper_ofhc\", thickness=\"20 um\"}]");
        let copper = of("wall=copper_ofhc");
        let (layer, bare) = (
            coated.layers[0].thickness,
            Solid {
                layers: Vec::new(),
                ..coated.clone()
            },
        );
        assert_eq!(
            yield_stress(&coated),
            copper.strength.yield_stress(0.0, 0.0, ROOM)
        );
        assert!(yield_stress(&coated) < yield_stress(&bare));
        // Inside the copper, and as far again in the steel below it.
        let in_copper = layer / copper.elastic.longitudinal_speed(copper.density);
        let in_steel = layer / bare.elastic.longitudinal_speed(bare.density);
        assert!((material_time(&coated, layer) / in_copper - 1.0).abs() < 1e-12);
        assert!((material_time(&coated, 2.0 * layer) / (in_copper + in_steel) - 1.0).abs() < 1e-12);
        assert!((material_time(&bare, layer) / in_steel - 1.0).abs() < 1e-12);
        assert!(material_time(&coated, f64::NAN).is_nan());
    }

    #[test]
    fn a_table_that_cannot_be_read_is_an_error_and_no_missing_number() {
        let text = include_str!("../../../../cases/bubble-near-steel/case.toml");
        let coarse = "setup.bubble_near_wall.particles_per_radius=4".to_owned();
        let simulation = Case::parse("case.toml", text, &[coarse]).unwrap();
        let world = crate::run::world(&simulation).unwrap();
        let folder = tempfile::tempdir().unwrap();
        let paths = RunPaths::new(folder.path());
        let add = || {
            let mut summary = Summary::default();
            add(
                &mut summary,
                &world,
                &simulation,
                &Record::default(),
                (&paths, None),
            )
        };
        let error = add().unwrap_err();
        assert!(
            error.to_string().contains("history.csv could not be read"),
            "{error}"
        );
        std::fs::write(paths.history(), "time [s]\n0\n").unwrap();
        std::fs::create_dir(folder.path().join("surface")).unwrap();
        // Without a table of the wall its numbers are not known; with a damaged one the run must not end as if.
        add().unwrap();
        std::fs::write(paths.surface("wall_pressure"), "").unwrap();
        assert!(add().is_err());
    }
}
