//! What probes see in time.

use crate::validate::Failure;
use erode_sph::fluid::Fluid;
use erode_sph::solid::Solid;
use erode_sph::world::{Body, World};

/// One instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Sample {
    pub(super) time: f64,
    pub(super) value: [f64; 2],
}

/// Advances until `end` and reads two probes after each step.
pub(super) fn watch(
    world: &mut World,
    end: f64,
    probe: impl Fn(&World) -> [f64; 2],
) -> Result<Vec<Sample>, Failure> {
    let mut record = Vec::new();
    while world.time < end {
        let dt = world.stable_time_step().0;
        world.advance(dt)?;
        let (time, value) = (world.time, probe(world));
        record.push(Sample { time, value });
    }
    Ok(record)
}

/// The first liquid of a world.
pub(super) fn liquid(world: &World) -> Option<&Fluid> {
    world.bodies.iter().find_map(|b| match &b.body {
        Body::Fluid(f) => Some(f),
        Body::Solid(_) => None,
    })
}

/// The first solid of a world.
pub(super) fn solid(world: &World) -> Option<&Solid> {
    world.bodies.iter().find_map(|b| match &b.body {
        Body::Solid(s) => Some(s),
        Body::Fluid(_) => None,
    })
}

/// Mean over the rows beside the place `x` on a coordinate, linear between them.
fn between(
    places: impl Iterator<Item = f64>,
    x: f64,
    dx: f64,
    value: impl Fn(usize) -> f64,
) -> f64 {
    let (mut sum, mut weight) = (0.0, 0.0);
    for (a, place) in places.enumerate() {
        let w = 1.0 - (place - x).abs() / dx;
        if w > 0.0 {
            sum += w * value(a);
            weight += w;
        }
    }
    sum / weight
}

/// Pressure of the liquid at a height z.
pub(super) fn pressure(world: &World, z: f64, dx: f64) -> f64 {
    liquid(world).map_or(f64::NAN, |f| {
        between(f.position.iter().map(|x| x[1]), z, dx, |a| f.pressure[a])
    })
}

/// Minus the normal stress of the solid along `axis` at a reference place on that axis.
pub(super) fn stress(world: &World, axis: usize, x: f64, dx: f64) -> f64 {
    solid(world).map_or(f64::NAN, |s| {
        let places = s.reference.position.iter().map(|x| x[axis]);
        between(places, x, dx, |a| {
            let t = s.state.stress[a];
            -[t.xx, t.yy][axis]
        })
    })
}

/// Part of a record between two times.
pub(super) fn part(record: &[Sample], from: f64, to: f64) -> &[Sample] {
    let at = |t: f64| record.partition_point(|s| s.time < t);
    &record[at(from)..at(to)]
}

/// Value of probe `k` that is farthest from zero.
pub(super) fn extreme(record: &[Sample], k: usize) -> f64 {
    let far = |m: f64, s: &Sample| {
        if s.value[k].abs() > m.abs() {
            s.value[k]
        } else {
            m
        }
    };
    record.iter().fold(0.0, far)
}

/// Integral of probe `k` over time.
pub(super) fn impulse(record: &[Sample], k: usize) -> f64 {
    let piece = |w: &[Sample]| 0.5 * (w[0].value[k] + w[1].value[k]) * (w[1].time - w[0].time);
    record.windows(2).map(piece).sum()
}

/// Time at which probe `k` peaks, by a parabola through the highest sample and its neighbours.
pub(super) fn peak_time(record: &[Sample], k: usize) -> Option<f64> {
    let higher = |a: &usize, b: &usize| record[*a].value[k].total_cmp(&record[*b].value[k]);
    let i = (1..record.len().checked_sub(1)?).max_by(higher)?;
    let [a, b, c] = [i - 1, i, i + 1].map(|j| record[j].value[k]);
    let shift = 0.5 * (a - c) / (a - 2.0 * b + c);
    Some(record[i].time + shift * (record[i + 1].time - record[i].time))
}

/// Mean time at which probe `k` sees the pulse, weighted with its value.
pub(super) fn mean_time(record: &[Sample], k: usize) -> f64 {
    let (mut sum, mut weight) = (0.0, 0.0);
    for w in record.windows(2) {
        let dt = w[1].time - w[0].time;
        sum += dt * w[1].value[k] * w[1].time;
        weight += dt * w[1].value[k];
    }
    sum / weight
}
