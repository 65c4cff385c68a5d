//! Scalars of an impact that need its whole course: the ring of void, the shock front on the wall, the times of load and
//! metal. They are taken from the tables that the run wrote.

use super::monitor::{COLLAPSED, Record, YIELDED, solid};
use crate::analysis::{self, WallPressure, energy_density, front, last_toroid, zone_depth};
use crate::case::{BodyKind, Simulation, Solid};
use crate::output::{RunPaths, Summary, Table};
use erode_sph::world::World;

/// The front is followed down to this part of the yield stress: below, other waves are as strong.
const FOLLOWED: f64 = 0.4;
/// Radii on each side that its speed is read from.
const REACH: usize = 3;

/// Adds the scalars of a bubble next to a wall; those whose table is missing are not a number.
pub(super) fn add(
    s: &mut Summary,
    world: &World,
    simulation: &Simulation,
    record: &Record,
    paths: &RunPaths,
) {
    let Some(bubble) = simulation.bubble.filter(|b| b.wall_distance.is_some()) else {
        return;
    };
    let none = f64::NAN;
    s.set("jet_half_width", "m", record.jet_half_width.unwrap_or(none));
    let history = Table::read(&paths.history()).ok();
    let toroid = history.and_then(|h| toroid(&h, COLLAPSED * record.initial_volume));
    s.set("toroid_r", "m", toroid.map_or(none, |t| t.r));
    s.set("toroid_z", "m", toroid.map_or(none, |t| t.z));
    s.set("toroid_time", "s", toroid.map_or(none, |t| t.time));
    let Some(metal) = simulation.bodies.iter().find_map(|b| match &b.kind {
        BodyKind::Solid(metal) => Some(metal),
        BodyKind::Fluid(_) => None,
    }) else {
        return;
    };
    let get = |s: &Summary, name: &str| s.get(name).unwrap_or(none);
    let density = energy_density(get(s, "plastic_work"), get(s, "plastic_volume"));
    s.set("absorbed_energy_density", "J/m3", density);
    let wall = Table::read(&paths.surface("wall_pressure")).ok();
    let wall = wall.as_ref().and_then(WallPressure::of);
    let yield_stress = metal.strength.yield_stress(0.0, 0.0, ROOM);
    let found = wall
        .as_ref()
        .map(|w| front(w, FOLLOWED * yield_stress, REACH));
    let at = |r: f64| {
        let all = found.iter().flatten();
        all.min_by(|a, b| (a.radius - r).abs().total_cmp(&(b.radius - r).abs()))
            .filter(|f| (f.radius - r).abs() < 0.1 * bubble.radius)
    };
    let speed = at(bubble.radius).map_or(none, |f| f.speed);
    s.set("shock_front_speed", "m/s", speed);
    times(s, world, metal, wall.as_ref(), yield_stress);
}

/// Temperature at which the yield stress is taken, K: that of the reference tests.
const ROOM: f64 = 293.15;

/// Load and metal where the plastic strain is largest.
fn times(
    s: &mut Summary,
    world: &World,
    metal: &Solid,
    wall: Option<&WallPressure>,
    yield_stress: f64,
) {
    let place = s.get("max_plastic_strain_r").unwrap_or(f64::NAN);
    let strained = s.get("max_plastic_strain").is_some_and(|e| e > 0.0);
    let wall = wall.filter(|_| strained);
    let load = wall.and_then(|w| {
        let pressure = &w.pressure[w.nearest(place)];
        analysis::loading_time(&w.time, pressure, analysis::RISE, yield_stress)
    });
    let depth = wall.zip(solid(world)).map(|(w, body)| {
        let (position, strain) = (&body.reference.position, &body.state.plastic_strain);
        let top = body.block.upper[1];
        zone_depth(position, strain, top, &w.radius, YIELDED)[w.nearest(place)]
    });
    let sound = metal.elastic.longitudinal_speed(metal.density);
    let answer = depth.map(|d| analysis::material_time(d, sound));
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
