//! What a workload steps: a world of bodies in the plane, or one body in space.

use super::BenchError;
use crate::output::{Checkpoint, CheckpointMeta, CheckpointStore};
use crate::run::store_state;
use erode_sph::fluid::Fluid;
use erode_sph::neighbours::Neighbours;
use erode_sph::phases::Phases;
use erode_sph::world::{Body, World};
use serde_json::Value;
use std::time::Instant;

/// Additions, multiplications, divisions and roots that one pair needs in a step, counted in the formulas of the source:
/// 74 + 60 + 66 for velocity gradient, exchange of volume and forces in the plane, 100 + 68 + 93 in space.
const LIQUID_OPERATIONS: [f64; 2] = [200.0, 261.0];
/// The same of deformation gradient and forces.
const SOLID_OPERATIONS: f64 = 56.0;

/// Pairs of a body and what is done with them in a step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Work {
    /// Directed pairs within the support of the kernel, without mirror images of liquids.
    pub(super) pairs: usize,
    /// Sums over all of them.
    pub(super) sums: usize,
    /// Operations per pair, of all sums.
    pub(super) operations: f64,
}

/// What can be stepped.
pub(super) trait Subject: Send {
    /// Number of particles.
    fn particles(&self) -> usize;
    /// One step; returns the seconds spent on finding the stable one.
    fn step(&mut self) -> Result<f64, BenchError>;
    /// Where the time of the steps went.
    fn phases(&self) -> Phases;
    /// What the bodies do in a step.
    fn work(&self) -> Vec<Work>;
    /// All fields that change.
    fn bits(&self) -> Vec<u64>;
    /// Seconds to write one checkpoint; none where there is no checkpoint yet.
    fn write_checkpoint(&self) -> Result<Option<f64>, BenchError>;
    /// The same once more.
    fn duplicate(&self) -> Box<dyn Subject>;
}

fn bits<'a>(numbers: impl Iterator<Item = &'a f64>) -> Vec<u64> {
    numbers.map(|x| x.to_bits()).collect()
}

fn liquid_bits<const D: usize>(f: &Fluid<D>) -> Vec<u64> {
    let vectors = [&f.position, &f.velocity, &f.acceleration];
    let scalars = [&f.mass, &f.volume, &f.pressure, &f.smoothing_length];
    let vectors = vectors.into_iter().flatten().flatten();
    bits(vectors.chain(scalars.into_iter().flatten()))
}

fn liquid_work<const D: usize>(f: &Fluid<D>) -> Work {
    Work {
        pairs: Neighbours::build(&f.position, &f.smoothing_length, f.len(), 0.0).pairs(),
        sums: 3,
        operations: LIQUID_OPERATIONS[D - 2],
    }
}

impl Subject for World {
    fn particles(&self) -> usize {
        let count = |b: &Body| match b {
            Body::Fluid(f) => f.len(),
            Body::Solid(s) => s.len(),
        };
        self.bodies.iter().map(|b| count(&b.body)).sum()
    }

    fn step(&mut self) -> Result<f64, BenchError> {
        let begun = Instant::now();
        let (dt, _) = self.stable_time_step();
        let searching = begun.elapsed().as_secs_f64();
        self.advance(dt)?;
        Ok(searching)
    }

    fn phases(&self) -> Phases {
        self.phases
    }

    fn work(&self) -> Vec<Work> {
        let of_body = |b: &Body| match b {
            Body::Fluid(f) => liquid_work(f),
            Body::Solid(s) => Work {
                pairs: s.reference.pairs(),
                sums: 2,
                operations: SOLID_OPERATIONS,
            },
        };
        self.bodies.iter().map(|b| of_body(&b.body)).collect()
    }

    fn bits(&self) -> Vec<u64> {
        let of_body = |b: &Body| match b {
            Body::Fluid(f) => liquid_bits(f),
            Body::Solid(s) => {
                let vectors = [&s.state.position, &s.state.velocity];
                let scalars = [&s.state.plastic_strain, &s.state.von_mises];
                let vectors = vectors.into_iter().flatten().flatten();
                bits(vectors.chain(scalars.into_iter().flatten()))
            }
        };
        self.bodies.iter().flat_map(|b| of_body(&b.body)).collect()
    }

    /// Into a folder that goes away again.
    fn write_checkpoint(&self) -> Result<Option<f64>, BenchError> {
        let folder = tempfile::tempdir().map_err(|e| BenchError::Folder(e.to_string()))?;
        let begun = Instant::now();
        let mut checkpoint = Checkpoint::new(CheckpointMeta {
            code_version: env!("CARGO_PKG_VERSION").to_owned(),
            case_hash: String::new(),
            time: self.time,
            step: self.step,
            extra: Value::Null,
        });
        store_state(self, &mut checkpoint)?;
        let written = CheckpointStore::new(folder.path()).write(&checkpoint);
        written.map_err(|e| BenchError::Folder(e.to_string()))?;
        Ok(Some(begun.elapsed().as_secs_f64()))
    }

    fn duplicate(&self) -> Box<dyn Subject> {
        Box::new(self.clone())
    }
}

/// A liquid in space between rigid sides.
#[derive(Clone)]
pub(super) struct Liquid {
    pub(super) fluid: Fluid<3>,
    /// Time, s.
    pub(super) time: f64,
    pub(super) phases: Phases,
}

impl Subject for Liquid {
    fn particles(&self) -> usize {
        self.fluid.len()
    }

    fn step(&mut self) -> Result<f64, BenchError> {
        let begun = Instant::now();
        let (dt, _) = self.fluid.stable_time_step(0.3);
        let searching = begun.elapsed().as_secs_f64();
        // Inside the pool of threads parallel loops begin at once.
        rayon::scope(|_| self.fluid.step(dt, self.time, &mut self.phases));
        self.time += dt;
        Ok(searching)
    }

    fn phases(&self) -> Phases {
        self.phases
    }

    fn work(&self) -> Vec<Work> {
        vec![liquid_work(&self.fluid)]
    }

    fn bits(&self) -> Vec<u64> {
        liquid_bits(&self.fluid)
    }

    fn write_checkpoint(&self) -> Result<Option<f64>, BenchError> {
        Ok(None)
    }

    fn duplicate(&self) -> Box<dyn Subject> {
        Box::new(self.clone())
    }
}
