//! One workload: warm-up, then the same steps with one thread and with two.

use super::BenchError;
use super::machine::{processor_time, resident_memory};
use super::subject::Subject;
use super::workloads::Workload;
use erode_sph::phases::Phase;
use rayon::{ThreadPool, ThreadPoolBuilder};
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
use std::time::Instant;

/// Blocks of steps; the fastest counts.
const BLOCKS: usize = 5;

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
    /// Seconds to write one checkpoint; none for a body that has none.
    pub checkpoint_seconds: Option<f64>,
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
    let mut subject = (workload.build)(size)?;
    let particles = subject.particles();
    let single = pool(1)?;
    single.install(|| advance(subject.as_mut(), workload.warm_up))?;
    let more = resident_memory()
        .zip(before)
        .map(|(now, before)| now - before);
    let bytes = more.map(|m| m.max(0.0) / particles as f64);
    let mut again = subject.duplicate();
    let steps = workload.steps;
    let first = single.install(|| timed(subject.as_mut(), steps, 1, particles))?;
    let second = pool(2)?.install(|| timed(again.as_mut(), steps, 2, particles))?;
    if subject.state()? != again.state()? {
        return Err(BenchError::OtherBits {
            name: workload.name.to_owned(),
            threads: 2,
        });
    }
    Ok(Measurement {
        name: workload.name.to_owned(),
        description: workload.description.to_owned(),
        particles,
        pairs: subject.work().iter().map(|w| w.pairs).sum(),
        steps,
        bytes_per_particle: bytes,
        checkpoint_seconds: subject.write_checkpoint()?,
        two_over_one: second.rate / first.rate,
        runs: vec![first, second],
        target: workload.target,
    })
}

fn advance(subject: &mut dyn Subject, steps: usize) -> Result<f64, BenchError> {
    let mut searching = 0.0;
    for _ in 0..steps {
        searching += subject.step()?;
    }
    Ok(searching)
}

fn timed(
    subject: &mut dyn Subject,
    steps: usize,
    threads: usize,
    particles: usize,
) -> Result<Run, BenchError> {
    let before = subject.phases();
    let (mut fastest, mut all, mut searching) = (f64::INFINITY, 0.0, 0.0);
    let processor = processor_time();
    let per_block = steps.div_ceil(BLOCKS);
    for _ in 0..BLOCKS {
        let begun = Instant::now();
        searching += advance(subject, per_block)?;
        let seconds = begun.elapsed().as_secs_f64();
        fastest = f64::min(fastest, seconds);
        all += seconds;
    }
    let processor = processor_time()
        .zip(processor)
        .map(|(now, then)| now - then);
    let million = |steps: usize, seconds: f64| 1e-6 * (particles * steps) as f64 / seconds;
    let work = subject.work();
    let evaluations: usize = work.iter().map(|w| w.pairs * w.sums).sum();
    let operations: f64 = work.iter().map(|w| w.pairs as f64 * w.operations).sum();
    let after = subject.phases();
    let mut phases = Map::new();
    let mut share = |name: &str, seconds: f64| phases.insert(name.into(), (seconds / all).into());
    for phase in Phase::ALL {
        share(phase.name(), after.seconds(phase) - before.seconds(phase));
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
