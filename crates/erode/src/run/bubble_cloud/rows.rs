//! The rows of the tables of a cloud, and the wall on which its impacts are counted.

use crate::case::cloud::BubbleCloud;
use erode_fv::bubbles::{Cloud, CollapseRecord, Totals};
use erode_physics::erosion::{Assessment, Contact, PotentialMap, SurfaceError, WallElement};

pub(super) const HISTORY: [(&str, &str); 14] = [
    ("time", "s"),
    ("bubbles", "-"),
    ("bubble_volume", "m3"),
    ("mean_bubble_radius", "m"),
    ("max_bubble_radius", "m"),
    ("collapses", "-"),
    ("impacts", "-"),
    ("energy_kinetic", "J"),
    ("energy_potential", "J"),
    ("energy_gas", "J"),
    ("energy_viscous", "J"),
    ("energy_radiated", "J"),
    ("energy_driven", "J"),
    ("energy_slip", "J"),
];

/// A row of `history.csv`.
#[allow(clippy::cast_precision_loss)] // counts stay far below 2^53
pub(super) fn history(cloud: &Cloud, t: &Totals) -> [f64; 14] {
    let sum: f64 = cloud.state.iter().map(|s| s.radius).sum();
    let largest = cloud
        .state
        .iter()
        .map(|s| s.radius)
        .fold(f64::NAN, f64::max);
    [
        cloud.time,
        t.bubbles as f64,
        t.volume,
        sum / t.bubbles as f64,
        largest,
        cloud.ledger.collapses as f64,
        cloud.ledger.impacts as f64,
        t.radial_kinetic,
        t.potential,
        t.gas,
        t.viscous,
        t.radiated,
        t.driven,
        t.slip_energy,
    ]
}

pub(super) const COLLAPSES: [(&str, &str); 15] = [
    ("time", "s"),
    ("bubble", "-"),
    ("begin_time", "s"),
    ("largest_bubble_radius", "m"),
    ("smallest_bubble_radius", "m"),
    ("max_bubble_pressure", "Pa"),
    ("position_x", "m"),
    ("position_y", "m"),
    ("position_z", "m"),
    ("wall_distance", "m"),
    ("standoff", "-"),
    ("touching", "-"),
    ("impact_pressure", "Pa"),
    ("wall_x", "m"),
    ("wall_y", "m"),
];

/// Place of the impact pressure in a row of `collapses.csv`.
pub(super) const IMPACT: usize = 12;

/// A row of `collapses.csv`; NaN where there is no wall or the erosion model has no answer.
#[allow(clippy::cast_precision_loss)] // numbers of bubbles stay far below 2^53
pub(super) fn collapse(r: &CollapseRecord) -> [f64; 15] {
    let none = f64::NAN;
    let (standoff, touching, pressure) = match r.assessment {
        Some(Assessment::Impact(i)) => {
            let touching = f64::from(u8::from(i.contact == Contact::Touching));
            (i.standoff, touching, i.impact_pressure)
        }
        Some(Assessment::TooNear(standoff) | Assessment::TooFar(standoff)) => {
            (standoff, none, none)
        }
        Some(Assessment::Impossible) | None => (none, none, none),
    };
    let foot = r.begin.wall_point.unwrap_or([none; 3]);
    [
        r.time,
        r.bubble as f64,
        r.begin.time,
        r.begin.max_radius,
        r.min_radius,
        r.peak_pressure,
        r.position[0],
        r.position[1],
        r.position[2],
        r.begin.wall_distance.unwrap_or(none),
        standoff,
        touching,
        pressure,
        foot[0],
        foot[1],
    ]
}

pub(super) const PATH: [(&str, &str); 6] = [
    ("time", "s"),
    ("position_x", "m"),
    ("position_y", "m"),
    ("position_z", "m"),
    ("bubble_radius", "m"),
    ("wall_velocity", "m/s"),
];

/// A row of the path of a bubble; NaN once it is gone.
pub(super) fn path(cloud: &Cloud, bubble: u64) -> [f64; 6] {
    // Bubbles stay in the order of their numbers.
    let Ok(k) = cloud.bubble.binary_search(&bubble) else {
        let none = f64::NAN;
        return [cloud.time, none, none, none, none, none];
    };
    let (x, s) = (cloud.position[k], &cloud.state[k]);
    [cloud.time, x[0], x[1], x[2], s.radius, s.wall_velocity]
}

/// The empty map of the wall of a case.
pub(super) fn wall(case: &BubbleCloud) -> Result<Option<PotentialMap>, SurfaceError> {
    let Some((extent, count)) = case.map else {
        return Ok(None);
    };
    #[allow(clippy::cast_precision_loss)] // far below 2^53
    let side = 2.0 * extent / count as f64;
    #[allow(clippy::cast_precision_loss)]
    let centre = |i: u64| (i as f64 + 0.5) * side - extent;
    let elements = (0..count * count).map(|i| WallElement {
        centre: [centre(i % count), centre(i / count), 0.0],
        normal: [0.0, 0.0, 1.0],
        area: side * side,
    });
    PotentialMap::new(elements.collect()).map(Some)
}
