//! One pulse through the interface.
//!
//! Lengths are in units of the width W of the pulse in the body where it starts, so that pulses of any width have the
//! same picture: start 3.5 W before the interface, first probe 2 W before it (its incident and reflected pulse are 4 W
//! apart), second probe behind it.

use super::column::{DX, Pulse, steel_block, water_column, world};
use super::record::{
    Sample, extreme, impulse, mean_time, part, peak_time, pressure, stress, watch,
};
use crate::validate::Failure;
use crate::validate::materials::{steel, water};
use erode_sph::Geometry::{self, Axisymmetric};
use erode_sph::solid::Face;
use erode_sph::world::{Body, World};

/// Where the pulse comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Direction {
    WaterToSteel,
    SteelToWater,
}

/// What came of it: amplitudes in Pa, impulses in Pa s.
#[derive(Debug, Clone)]
pub(super) struct Crossing {
    pub(super) geometry: Geometry,
    pub(super) direction: Direction,
    pub(super) width: usize,
    pub(super) incident: f64,
    pub(super) reflected: f64,
    pub(super) transmitted: f64,
    pub(super) incident_impulse: f64,
    pub(super) reflected_impulse: f64,
    pub(super) transmitted_impulse: f64,
    /// Speeds of the middle and of the peak of the incident pulse, where it starts in steel, m/s.
    pub(super) speed: Option<[f64; 2]>,
    /// Pressure at the probe in front of the interface and behind it.
    pub(super) record: Vec<Sample>,
}

impl Crossing {
    pub(super) fn title(&self) -> String {
        let way = match self.direction {
            Direction::WaterToSteel => "water to steel",
            Direction::SteelToWater => "steel to water",
        };
        let column = match self.geometry {
            Geometry::Plane => "plane",
            Axisymmetric => "axisymmetric",
        };
        format!("{way}, {column}, {} dx", self.width)
    }
}

/// Start of the pulse, first probe, end of the record, in widths.
const START: f64 = 3.5;
const PROBE: f64 = 2.0;
const END: f64 = 7.5;

/// Columns of particles: the steel needs more than the support of its kernel.
fn columns(geometry: Geometry) -> usize {
    if geometry == Axisymmetric { 6 } else { 4 }
}

/// Runs a pulse that is `width` spacings wide in water.
pub(super) fn run(
    geometry: Geometry,
    direction: Direction,
    width: usize,
) -> Result<Crossing, Failure> {
    let (density, elastic, _) = steel()?;
    let (fast, slow) = (elastic.longitudinal_speed(density), water()?.sound_speed);
    let in_water = width as f64 * DX;
    let in_steel = in_water * fast / slow;
    let end = END * in_water / slow;
    let (mut world, from, behind) = match direction {
        Direction::WaterToSteel => (water_to_steel(geometry, in_water, in_steel)?, in_water, 1.0),
        Direction::SteelToWater => (steel_to_water(geometry, in_water, in_steel)?, in_steel, 0.8),
    };
    let record = watch(&mut world, end, |w| match direction {
        Direction::WaterToSteel => [
            pressure(w, PROBE * in_water, DX),
            stress(w, 1, -behind * in_steel, DX),
        ],
        Direction::SteelToWater => [
            stress(w, 1, -PROBE * in_steel, DX),
            pressure(w, behind * in_water, DX),
        ],
    })?;
    let unit = in_water / slow;
    let early = part(&record, 0.0, START * unit);
    let late = part(&record, START * unit, f64::INFINITY);
    let speed = match direction {
        Direction::WaterToSteel => None,
        // From the start, which is exact, to the probe.
        Direction::SteelToWater => {
            let way = (START - PROBE) * from;
            peak_time(early, 0).map(|peak| [way / mean_time(early, 0), way / peak])
        }
    };
    Ok(Crossing {
        geometry,
        direction,
        width,
        incident: extreme(early, 0),
        reflected: extreme(late, 0),
        transmitted: extreme(&record, 1),
        incident_impulse: impulse(early, 0),
        reflected_impulse: impulse(late, 0),
        transmitted_impulse: impulse(&record, 1),
        speed,
        record,
    })
}

fn rows(length: f64) -> usize {
    (length / DX).round() as usize
}

fn water_to_steel(geometry: Geometry, in_water: f64, in_steel: f64) -> Result<World, Failure> {
    let n = columns(geometry);
    let mut liquid = water_column(geometry, [n, rows(6.5 * in_water)], 0.0)?;
    let faces = [Face::Symmetry, Face::Absorbing, Face::Traction];
    let solid = steel_block(geometry, [n, rows(3.0 * in_steel)], faces)?;
    Pulse {
        axis: 1,
        centre: START * in_water,
        width: in_water,
        towards: -1.0,
    }
    .start_in_liquid(&mut liquid);
    world(vec![Body::Fluid(liquid), Body::Solid(solid)])
}

fn steel_to_water(geometry: Geometry, in_water: f64, in_steel: f64) -> Result<World, Failure> {
    let n = columns(geometry);
    let liquid = water_column(geometry, [n, rows(5.0 * in_water)], 0.0)?;
    let faces = [Face::Symmetry, Face::Absorbing, Face::Traction];
    let mut solid = steel_block(geometry, [n, rows(5.5 * in_steel)], faces)?;
    Pulse {
        axis: 1,
        centre: -START * in_steel,
        width: in_steel,
        towards: 1.0,
    }
    .start_in_solid(&mut solid)?;
    world(vec![Body::Fluid(liquid), Body::Solid(solid)])
}
