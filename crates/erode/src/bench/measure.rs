//! One workload: warm-up, then the same steps with one thread and with two.

use super::BenchError;
use super::machine::{processor_time, resident_memory};
use super::workloads::Workload;
use crate::output::{Array, Checkpoint, CheckpointMeta, CheckpointStore};
use crate::run::{accounts, store_state};
use erode_sph::neighbours::Neighbours;
use erode_sph::phases::Phase;
use erode_sph::world::{Body, World};
use rayon::{ThreadPool, ThreadPoolBuilder};
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
use std::time::Instant;

/// Steps before the measured ones.
const WARM_UP: usize = 12;
/// Blocks of steps; the fastest counts.
const BLOCKS: usize = 5;
/// Sums over all pairs in a step: velocity gradient, two of the exchange of volume, forces.
const LIQUID_SUMS: usize = 4;
/// Deformation gradient, forces.
const SOLID_SUMS: usize = 2;
/// Additions, multiplications, divisions and roots that one pair needs in a step, counted in the formulas of the source.
const LIQUID_OPERATIONS: f64 = 263.0;
const SOLID_OPERATIONS: f64 = 56.0;

/// What one workload showed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Measurement {
    /// Name of the workload.
    pub name: String,
    /// In words.
    pub description: String,
    /// Particles.
    pub particles: usize,
    /// Neighbours of all particles together (without mirror images of liquids), at the end.
    pub pairs: usize,
    /// Measured steps.
    pub steps: usize,
    /// Resident memory after the steps less that before the world was built, per particle, bytes; none where the system does
    /// not tell.
    pub bytes_per_particle: Option<f64>,
    /// Seconds to write one checkpoint.
    pub checkpoint_seconds: f64,
    /// One and two threads.
    pub runs: Vec<Run>,
    /// Rate of two threads over that of one.
    pub two_over_one: f64,
    /// Asked rate of one thread, 1e6 particle-steps/s.
    pub target: Option<f64>,
}

/// The same steps with some number of threads.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Run {
    /// Number of threads.
    pub threads: usize,
    /// Steps of the fastest block, 1e6 particle-steps/s.
    pub rate: f64,
    /// All steps, 1e6 particle-steps/s.
    pub mean_rate: f64,
    /// All steps by processor time of all threads, 1e6 particle-steps/s; none where the system does not tell.
    pub rate_per_processor_second: Option<f64>,
    /// Evaluations of a pair in the fastest block, 1e6/s.
    pub pair_rate: f64,
    /// Operations on pairs in the fastest block, 1e9/s.
    pub operation_rate: f64,
    /// Seconds of all steps.
    pub seconds: f64,
    /// Share of the time in each phase; `time_step` is the search of the stable step.
    pub phases: Map<String, Value>,
}

/// A pool of this number of threads.
///
/// # Errors
/// If they cannot be started.
pub(super) fn pool(threads: usize) -> Result<ThreadPool, BenchError> {
    let why = |e: rayon::ThreadPoolBuildError| BenchError::Threads {
        threads,
        why: e.to_string(),
    };
    ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .map_err(why)
}

/// Measures one workload of about `size` particles (per radius in a mixture).
///
/// # Errors
/// If it cannot be built or advanced, or if the number of threads changes a bit of the result.
pub(super) fn measure(workload: &Workload, size: usize) -> Result<Measurement, BenchError> {
    let before = resident_memory();
    let mut world = (workload.build)(size)?;
    let particles = world.bodies.iter().map(|b| count(&b.body)).sum();
    let single = pool(1)?;
    single.install(|| advance(&mut world, WARM_UP))?;
    let more = resident_memory()
        .zip(before)
        .map(|(now, before)| now - before);
    let bytes = more.map(|m| m.max(0.0) / particles as f64);
    let start = world.clone();
    let steps = workload.steps;
    let first = single.install(|| timed(&mut world, steps, 1, particles))?;
    let mut again = start;
    let second = pool(2)?.install(|| timed(&mut again, steps, 2, particles))?;
    if !same_bits(&world, &again)? {
        return Err(BenchError::OtherBits {
            name: workload.name.to_owned(),
            threads: 2,
        });
    }
    Ok(Measurement {
        name: workload.name.to_owned(),
        description: workload.description.to_owned(),
        particles,
        pairs: world.bodies.iter().map(|b| pairs(&b.body)).sum(),
        steps,
        bytes_per_particle: bytes,
        checkpoint_seconds: write_checkpoint(&world)?,
        two_over_one: second.rate / first.rate,
        runs: vec![first, second],
        target: workload.target,
    })
}

fn advance(world: &mut World, steps: usize) -> Result<f64, BenchError> {
    let mut searching = 0.0;
    for _ in 0..steps {
        let begun = Instant::now();
        let (dt, _) = world.stable_time_step();
        searching += begun.elapsed().as_secs_f64();
        world.advance(dt)?;
    }
    Ok(searching)
}

fn timed(
    world: &mut World,
    steps: usize,
    threads: usize,
    particles: usize,
) -> Result<Run, BenchError> {
    let before = world.phases;
    let (mut fastest, mut all, mut searching) = (f64::INFINITY, 0.0, 0.0);
    let processor = processor_time();
    let per_block = steps.div_ceil(BLOCKS);
    for _ in 0..BLOCKS {
        let begun = Instant::now();
        searching += advance(world, per_block)?;
        let seconds = begun.elapsed().as_secs_f64();
        fastest = f64::min(fastest, seconds);
        all += seconds;
    }
    let processor = processor_time()
        .zip(processor)
        .map(|(now, then)| now - then);
    let million = |steps: usize, seconds: f64| 1e-6 * (particles * steps) as f64 / seconds;
    let bodies = || world.bodies.iter().map(|b| &b.body);
    let evaluations: usize = bodies().map(|b| pairs(b) * sums(b)).sum();
    let operations: f64 = bodies().map(|b| pairs(b) as f64 * operations(b)).sum();
    let mut phases = Map::new();
    let mut share = |name: &str, seconds: f64| phases.insert(name.into(), (seconds / all).into());
    for phase in Phase::ALL {
        share(
            phase.name(),
            world.phases.seconds(phase) - before.seconds(phase),
        );
    }
    share("time_step", searching);
    Ok(Run {
        threads,
        rate: million(per_block, fastest),
        mean_rate: million(per_block * BLOCKS, all),
        rate_per_processor_second: processor
            .filter(|seconds| *seconds > 0.0)
            .map(|seconds| million(per_block * BLOCKS, seconds)),
        pair_rate: 1e-6 * (evaluations * per_block) as f64 / fastest,
        operation_rate: 1e-9 * operations * per_block as f64 / fastest,
        seconds: all,
        phases,
    })
}

fn count(body: &Body) -> usize {
    match body {
        Body::Fluid(f) => f.len(),
        Body::Solid(s) => s.len(),
    }
}

fn pairs(body: &Body) -> usize {
    match body {
        Body::Fluid(f) => Neighbours::build(&f.position, &f.smoothing_length, f.len(), 0.0).pairs(),
        Body::Solid(s) => s.reference.pairs(),
    }
}

fn sums(body: &Body) -> usize {
    match body {
        Body::Fluid(_) => LIQUID_SUMS,
        Body::Solid(_) => SOLID_SUMS,
    }
}

fn operations(body: &Body) -> f64 {
    match body {
        Body::Fluid(_) => LIQUID_OPERATIONS,
        Body::Solid(_) => SOLID_OPERATIONS,
    }
}

/// Whether all that the next step depends on, and all that is counted, is the same bit for bit.
fn same_bits(a: &World, b: &World) -> Result<bool, BenchError> {
    let (one, other) = (state_of(a)?, state_of(b)?);
    let counted = |world: &World| accounts(world).to_string();
    let mut pairs = one.arrays().iter().zip(other.arrays());
    Ok(one.arrays().len() == other.arrays().len()
        && pairs.all(|(a, b)| a.0 == b.0 && bits(&a.1) == bits(&b.1))
        && counted(a) == counted(b))
}

fn bits(array: &Array) -> Vec<u64> {
    match array {
        Array::F64(values) => values.iter().map(|x| x.to_bits()).collect(),
        Array::U64(values) => values.clone(),
        Array::U32(values) => values.iter().map(|x| u64::from(*x)).collect(),
        Array::U8(values) => values.iter().map(|x| u64::from(*x)).collect(),
    }
}

/// All that the next step depends on.
fn state_of(world: &World) -> Result<Checkpoint, BenchError> {
    let mut checkpoint = Checkpoint::new(CheckpointMeta {
        code_version: env!("CARGO_PKG_VERSION").to_owned(),
        case_hash: String::new(),
        time: world.time,
        step: world.step,
        extra: Value::Null,
    });
    store_state(world, &mut checkpoint)?;
    Ok(checkpoint)
}

/// Seconds to write one checkpoint into a folder that goes away again.
fn write_checkpoint(world: &World) -> Result<f64, BenchError> {
    let folder = tempfile::tempdir().map_err(|e| BenchError::Folder(e.to_string()))?;
    let begun = Instant::now();
    let written = CheckpointStore::new(folder.path()).write(&state_of(world)?);
    written.map_err(|e| BenchError::Folder(e.to_string()))?;
    Ok(begun.elapsed().as_secs_f64())
}

#[cfg(test)]
mod tests {
    use super::super::ALL;
    use super::*;

    /// One step of a small world, in which everything moves.
    fn world(name: &str, size: usize) -> World {
        let workload = ALL.iter().find(|w| w.name == name).unwrap();
        let mut world = (workload.build)(size).unwrap();
        advance(&mut world, 1).unwrap();
        world
    }

    #[test]
    fn a_last_bit_anywhere_in_the_state_of_a_solid_is_seen() {
        let a = world("solid-plane", 100);
        assert!(same_bits(&a, &a.clone()).unwrap());
        let changed = |change: fn(&mut erode_sph::solid::Solid)| {
            let mut b = a.clone();
            let Body::Solid(s) = &mut b.bodies[0].body else {
                panic!("the body is a solid")
            };
            change(s);
            same_bits(&a, &b).unwrap()
        };
        assert!(!changed(
            |s| s.state.stress[7].zz = s.state.stress[7].zz.next_up()
        ));
        assert!(!changed(|s| s.state.plastic_strain[7] = 1e-300));
        assert!(!changed(
            |s| s.state.position[7][0] = s.state.position[7][0].next_up()
        ));
    }

    #[test]
    fn a_last_bit_of_the_density_of_a_liquid_is_seen() {
        let a = world("liquid-plane", 100);
        let mut b = a.clone();
        let Body::Fluid(f) = &mut b.bodies[0].body else {
            panic!("the body is a liquid")
        };
        f.volume[7] = f.volume[7].next_up();
        assert!(!same_bits(&a, &b).unwrap());
    }
}
