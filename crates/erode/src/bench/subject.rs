//! What a workload steps: a world of bodies in the plane, or one body in space.

use super::BenchError;
use crate::output::{Array, Checkpoint, CheckpointMeta, CheckpointStore};
use crate::run::{accounts, store_state};
use erode_sph::fluid::Fluid;
use erode_sph::neighbours::Neighbours;
use erode_sph::phases::Phases;
use erode_sph::solid::space::{Blocks, SpaceSolid};
use erode_sph::world::{Body, World};
use serde_json::Value;
use std::time::Instant;

/// Additions, multiplications, divisions and roots that one pair needs in a step, counted in the formulas of the source:
/// 74 + 60 + 66 for velocity gradient, exchange of volume and forces in the plane, 100 + 68 + 93 in space.
const LIQUID_OPERATIONS: [f64; 2] = [200.0, 261.0];
/// The same of deformation gradient and forces: 14 + 39 in the plane, 38 + 89 in space.
const SOLID_OPERATIONS: [f64; 2] = [53.0, 127.0];

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

/// A state for comparison, bit by bit: fields by name, and the accounts in words.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct State {
    fields: Vec<(String, Vec<u64>)>,
    accounts: String,
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
    /// All that the next step depends on, and all that is counted.
    fn state(&self) -> Result<State, BenchError>;
    /// Seconds to write one checkpoint; none for a body that has none.
    fn write_checkpoint(&self) -> Result<Option<f64>, BenchError>;
    /// The same once more.
    fn duplicate(&self) -> Box<dyn Subject>;
}

fn liquid_work<const D: usize>(f: &Fluid<D>) -> Work {
    Work {
        pairs: Neighbours::build(&f.position, &f.smoothing_length, f.len(), 0.0).pairs(),
        sums: 3,
        operations: LIQUID_OPERATIONS[D - 2],
    }
}

fn bits(array: &Array) -> Vec<u64> {
    match array {
        Array::F64(values) => values.iter().map(|x| x.to_bits()).collect(),
        Array::U64(values) => values.clone(),
        Array::U32(values) => values.iter().map(|x| u64::from(*x)).collect(),
        Array::U8(values) => values.iter().map(|x| u64::from(*x)).collect(),
    }
}

fn checkpoint(world: &World) -> Result<Checkpoint, BenchError> {
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
                operations: SOLID_OPERATIONS[0],
            },
        };
        self.bodies.iter().map(|b| of_body(&b.body)).collect()
    }

    fn state(&self) -> Result<State, BenchError> {
        let checkpoint = checkpoint(self)?;
        let arrays = checkpoint.arrays().iter();
        Ok(State {
            fields: arrays.map(|(name, a)| (name.clone(), bits(a))).collect(),
            accounts: accounts(self).to_string(),
        })
    }

    /// Into a folder that goes away again.
    fn write_checkpoint(&self) -> Result<Option<f64>, BenchError> {
        let folder = tempfile::tempdir().map_err(|e| BenchError::Folder(e.to_string()))?;
        let begun = Instant::now();
        let written = CheckpointStore::new(folder.path()).write(&checkpoint(self)?);
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

    fn state(&self) -> Result<State, BenchError> {
        let f = &self.fluid;
        let bits = |x: &f64| x.to_bits();
        let vectors = [
            ("position", &f.position),
            ("velocity", &f.velocity),
            ("acceleration", &f.acceleration),
        ];
        let scalars = [
            ("mass", &f.mass),
            ("volume", &f.volume),
            ("pressure", &f.pressure),
            ("smoothing_length", &f.smoothing_length),
        ];
        let vector = |(name, v): (&str, &Vec<_>)| {
            let numbers: &Vec<[f64; 3]> = v;
            (
                name.to_owned(),
                numbers.iter().flatten().map(bits).collect(),
            )
        };
        let scalar = |(name, v): (&str, &Vec<f64>)| (name.to_owned(), v.iter().map(bits).collect());
        Ok(State {
            fields: (vectors.into_iter().map(vector))
                .chain(scalars.into_iter().map(scalar))
                .collect(),
            accounts: format!("{:?}", f.account),
        })
    }

    fn write_checkpoint(&self) -> Result<Option<f64>, BenchError> {
        Ok(None)
    }

    fn duplicate(&self) -> Box<dyn Subject> {
        Box::new(self.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bench::workloads;
    use erode_sph::Geometry;

    /// One step of a small world, in which everything moves.
    fn stepped(mut world: World) -> World {
        world.step().unwrap();
        world
    }

    #[test]
    fn a_last_bit_anywhere_in_the_state_of_a_solid_is_seen() {
        let a = stepped(workloads::solid(Geometry::Plane, 100).unwrap());
        assert!(a.state().unwrap() == a.clone().state().unwrap());
        let changed = |change: fn(&mut erode_sph::solid::Solid)| {
            let mut b = a.clone();
            let Body::Solid(s) = &mut b.bodies[0].body else {
                panic!("the body is a solid")
            };
            change(s);
            a.state().unwrap() == b.state().unwrap()
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
        let a = stepped(workloads::liquid(Geometry::Plane, 100).unwrap());
        let mut b = a.clone();
        let Body::Fluid(f) = &mut b.bodies[0].body else {
            panic!("the body is a liquid")
        };
        f.volume[7] = f.volume[7].next_up();
        assert!(a.state().unwrap() != b.state().unwrap());
    }
}

/// A solid in space with free faces.
#[derive(Clone)]
pub(super) struct SolidInSpace {
    pub(super) solid: SpaceSolid,
    pub(super) phases: Phases,
}

impl Subject for SolidInSpace {
    fn particles(&self) -> usize {
        self.solid.len()
    }

    fn step(&mut self) -> Result<f64, BenchError> {
        let begun = Instant::now();
        let limit = self.solid.stable_time_step();
        let searching = begun.elapsed().as_secs_f64();
        self.solid.timed_step(limit.dt, &mut self.phases)?;
        Ok(searching)
    }

    fn phases(&self) -> Phases {
        self.phases
    }

    fn work(&self) -> Vec<Work> {
        vec![Work {
            pairs: self.solid.pairs(),
            sums: 2,
            operations: SOLID_OPERATIONS[1],
        }]
    }

    fn state(&self) -> Result<State, BenchError> {
        fn field<const N: usize>(name: &str, of: &Blocks<N>) -> (String, Vec<u64>) {
            (
                name.to_owned(),
                of.iter().flatten().map(f64::to_bits).collect(),
            )
        }
        let s = &self.solid.state;
        Ok(State {
            fields: vec![
                field("position", &s.position),
                field("velocity", &s.velocity),
                field("acceleration", &s.acceleration),
                field("deformation", &s.deformation),
                field("flux", &s.flux),
                field("plastic_strain", &s.plastic_strain),
                field("plastic_strain_rate", &s.plastic_strain_rate),
                field("plastic_work", &s.plastic_work),
            ],
            accounts: format!("{:?}", s.work),
        })
    }

    fn write_checkpoint(&self) -> Result<Option<f64>, BenchError> {
        Ok(None)
    }

    fn duplicate(&self) -> Box<dyn Subject> {
        Box::new(self.clone())
    }
}
