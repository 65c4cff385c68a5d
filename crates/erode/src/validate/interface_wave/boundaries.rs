//! Sides through which waves leave, and through which a pressure step enters.

use super::column::{DX, HEIGHT, Pulse, steel_block, water_column, world};
use super::record::{Sample, extreme, part, pressure, stress, watch};
use crate::validate::Failure;
use crate::validate::check::Check;
use crate::validate::materials::water;
use erode_sph::Geometry::{Axisymmetric, Plane};
use erode_sph::fluid::far_field::FarField;
use erode_sph::fluid::ghosts;
use erode_sph::geometry::Vec2;
use erode_sph::solid::{Face, Side, Solid};
use erode_sph::world::Body;

/// Width of the pulses, m.
const WIDTH: f64 = 25.0 * DX;

/// Pressure of the water at rest: an echo in tension must not be cut off.
const REST: f64 = 10e6;

/// The pulse starts 1.5 widths before the probe, which is 2 widths before the open side.
const START: f64 = 3.5;
const PROBE: f64 = 2.0;
const END: f64 = 8.0;

pub(super) fn checks() -> Result<Vec<Check>, Failure> {
    Ok(vec![
        far_field()?,
        step()?,
        absorbing(1)?,
        absorbing(0)?,
        along()?,
        impact()?,
    ])
}

/// Largest value after the pulse has passed, relative to the pulse; `speed` is that of the wave.
fn echo(record: &[Sample], speed: f64, rest: f64) -> f64 {
    let unit = WIDTH / speed;
    // The pulse passes the probe at 1.5 widths and is gone at 3.2; its echo comes at 5.5.
    let shifted: Vec<Sample> = record
        .iter()
        .map(|s| Sample {
            value: s.value.map(|v| v - rest),
            ..*s
        })
        .collect();
    extreme(part(&shifted, 3.2 * unit, END * unit), 0) / extreme(part(&shifted, 0.0, 3.2 * unit), 0)
}

fn returned(what: &str, echo: f64) -> Check {
    Check::absolute(
        format!("{what}: returned part of the pulse"),
        "-",
        (echo, 0.0),
        0.05,
        "issue 2; what returns from the sides must be small beside what the bubble sends",
    )
}

fn open_top(height: f64) -> ghosts::Plane {
    ghosts::Plane {
        normal: [0.0, -1.0],
        offset: -height,
        speed: 0.0,
    }
}

const FLOOR: ghosts::Plane = ghosts::Plane {
    normal: [0.0, 1.0],
    offset: 0.0,
    speed: 0.0,
};

fn far_field() -> Result<Check, Failure> {
    let height = 7.0 * WIDTH;
    let mut f = water_column(Plane, [4, (height / DX).round() as usize], REST)?;
    f.sides.push(FLOOR);
    let far = FarField {
        pressure: REST,
        step_pressure: REST,
        ..FarField::NONE
    };
    f.open_side(&open_top(height), far);
    Pulse {
        axis: 1,
        centre: height - START * WIDTH,
        width: WIDTH,
        towards: 1.0,
    }
    .start_in_liquid(&mut f);
    let c = f.eos.sound_speed_at(f.density(0));
    let mut world = world(vec![Body::Fluid(f)])?;
    let record = watch(&mut world, END * WIDTH / c, |w| {
        [pressure(w, height - PROBE * WIDTH, DX), 0.0]
    })?;
    Ok(returned("far field of water", echo(&record, c, REST)))
}

/// A step of 50 MPa enters water at rest.
fn step() -> Result<Check, Failure> {
    let height = 6.0 * WIDTH;
    let driving = 50e6;
    let mut f = water_column(Plane, [4, (height / DX).round() as usize], 1e5)?;
    f.sides.push(FLOOR);
    let far = FarField {
        pressure: 1e5,
        step_pressure: driving,
        ..FarField::NONE
    };
    f.open_side(&open_top(height), far);
    let c = water()?.sound_speed;
    let mut world = world(vec![Body::Fluid(f)])?;
    let record = watch(&mut world, 4.0 * WIDTH / c, |w| {
        [pressure(w, height - PROBE * WIDTH, DX), 0.0]
    })?;
    // The step passes the probe at 2 widths; its tail is read.
    let tail = part(&record, 3.2 * WIDTH / c, f64::INFINITY);
    let mean = tail.iter().map(|s| s.value[0]).sum::<f64>() / tail.len() as f64;
    Ok(Check::relative(
        "far field of water: pressure behind a step that enters",
        "Pa",
        (mean, driving),
        0.01,
        "the driving pressure of the main case; the far field is exact for simple waves",
    ))
}

/// A pulse in steel that meets the bottom (axis 1) or the right face (axis 0) head on.
fn absorbing(axis: usize) -> Result<Check, Failure> {
    let length = (7.0 * WIDTH / DX).round() as usize;
    let (n, faces, towards) = if axis == 1 {
        (
            [4, length],
            [Face::Symmetry, Face::Absorbing, Face::Traction],
            -1.0,
        )
    } else {
        (
            [length, 4],
            [Face::Absorbing, Face::Symmetry, Face::Symmetry],
            1.0,
        )
    };
    let mut s = steel_block(Plane, n, faces)?;
    let end = if axis == 1 {
        s.block.lower[1]
    } else {
        s.block.upper[0]
    };
    Pulse {
        axis,
        centre: end - towards * START * WIDTH,
        width: WIDTH,
        towards,
    }
    .start_in_solid(&mut s)?;
    let c = speed(&s);
    let mut world = world(vec![Body::Solid(s)])?;
    let record = watch(&mut world, END * WIDTH / c, |w| {
        [stress(w, axis, end - towards * PROBE * WIDTH, DX), 0.0]
    })?;
    let what = if axis == 1 { "bottom" } else { "right face" };
    Ok(returned(
        &format!("absorbing {what} of steel, head on"),
        echo(&record, c, 0.0),
    ))
}

/// A pulse in steel that runs along an absorbing right face.
fn along() -> Result<Check, Failure> {
    let length = (7.0 * WIDTH / DX).round() as usize;
    let faces = [Face::Absorbing, Face::Absorbing, Face::Traction];
    let mut s = steel_block(Plane, [10, length], faces)?;
    let start = -2.0 * WIDTH;
    Pulse {
        axis: 1,
        centre: start,
        width: WIDTH,
        towards: -1.0,
    }
    .start_in_solid(&mut s)?;
    let c = speed(&s);
    let mut world = world(vec![Body::Solid(s)])?;
    let record = watch(&mut world, 4.0 * WIDTH / c, |w| {
        [stress(w, 1, start - 3.0 * WIDTH, DX), 0.0]
    })?;
    Ok(Check::shown(
        "pulse along an absorbing right face of steel, strip of 10 dx: height after 3 widths",
        "Pa",
        extreme(&record, 0),
        Some(HEIGHT),
        "not judged: the dashpots along the face brake a wave at grazing incidence; an open side must be far from what \
         matters (next row)",
    ))
}

/// Radius of the load and sizes of the block whose open sides are tried and of one whose echo comes too late, in spacings.
const LOAD: f64 = 10.0;
const BLOCK: usize = 80;
const LARGE_BLOCK: usize = 120;

/// What a load near the axis does to the steel below it, in a block with open sides and in a larger one.
fn impact() -> Result<Check, Failure> {
    let (near, far) = rayon::join(|| pressed(BLOCK), || pressed(LARGE_BLOCK));
    let (near, far) = (near?, far?);
    let size = |m: f64, x: f64| f64::max(m, x.abs());
    let peak = far.iter().copied().fold(0.0, size);
    let difference = near.iter().zip(&far).map(|(a, b)| a - b).fold(0.0, size);
    Ok(Check::absolute(
        format!(
            "axisymmetric block of {BLOCK} dx, load of radius {LOAD} dx: change of the stress 20 dx below it by open sides, \
             in units of its peak"
        ),
        "-",
        (difference / peak, 0.0),
        0.05,
        "issue 2; what returns from the sides must be small beside what the bubble sends",
    ))
}

/// -s_zz on the axis 20 spacings below a pulse of pressure on the top of a block of n by n particles.
fn pressed(n: usize) -> Result<Vec<f64>, Failure> {
    let faces = [Face::Absorbing, Face::Absorbing, Face::Traction];
    let mut s = steel_block(Axisymmetric, [n, n], faces)?;
    let (c, dt) = (speed(&s), s.stable_time_step().dt);
    let duration = WIDTH / c;
    let particle = n * (n - 1 - 20);
    let mut record = Vec::new();
    s.accelerations();
    for step in 1..=(8.0 * duration / dt) as u32 {
        let t = f64::from(step) * dt / duration - 1.5;
        let now = HEIGHT * (-4.0 * std::f64::consts::LN_2 * t * t).exp();
        if let Some(top) = s.surface_mut(Side::Top) {
            let spread = |x: &Vec2| now * (-(x[0] / (LOAD * DX)).powi(2)).exp();
            top.pressure = top.reference_position.iter().map(spread).collect();
        }
        s.step(dt)?;
        record.push(-s.state.stress[particle].yy);
    }
    Ok(record)
}

fn speed(s: &Solid) -> f64 {
    s.material.elastic.longitudinal_speed(s.material.density)
}
