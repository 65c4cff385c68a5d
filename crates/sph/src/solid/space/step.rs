//! Step of a solid in three dimensions: kick, drift, stress, accelerations, kick.

use super::super::return_in_lanes::YieldStress;
use super::super::step::StepLimit;
use super::super::stress::Failure;
use super::blocks::{Block, Blocks};
use super::lanes::{dot, times};
use super::points::{Fields, Laws, Update};
use super::sums::{self, Moving};
use super::{SpaceError, SpaceSolid, TASK, stretch};
use crate::phases::{Phase, Phases};
use crate::simd::{self, LANES, Simd, Task};
use rayon::prelude::*;

/// Compression that the Courant number has room for.
const ROOM: f64 = 0.8;
/// Clusters per task of loops without neighbours.
const LONG_TASK: usize = 256;

/// Powers of the viscous, hourglass and holding forces, W.
type Powers = [f64; 3];

impl SpaceSolid {
    /// Courant number x spacing / longitudinal wave speed, the spacing V^(1/3) of the reference; a spacing compressed to less than
    /// 0.8 counts as compressed by the smallest principal stretch.
    #[must_use]
    pub fn stable_time_step(&self) -> StepLimit {
        let elastic = &self.material.elastic;
        let clusters = self.reference.place.blocks.len();
        let of_task = |task: usize| {
            let last = clusters.min((task + 1) * LONG_TASK);
            least((task * LONG_TASK..last).map(|c| self.shortest_spacing(c)))
        };
        let tasks = 0..clusters.div_ceil(LONG_TASK);
        let all: Vec<(usize, f64)> = tasks.into_par_iter().map(of_task).collect();
        let (particle, spacing) = least(all.into_iter());
        StepLimit {
            dt: self.numerics.courant * spacing / elastic.longitudinal_speed(self.material.density),
            particle,
            reason: "longitudinal wave in the solid",
        }
    }

    /// The particle of a cluster with the shortest spacing, and that spacing as it counts for the step, m.
    fn shortest_spacing(&self, cluster: usize) -> (usize, f64) {
        let deformation = &self.state.deformation;
        let calm = stretch::is_above(&deformation.blocks[cluster], ROOM);
        let first = cluster * LANES;
        least((first..self.len().min(first + LANES)).map(|a| {
            let stretch = match calm {
                true => 1.0,
                false => (stretch::smallest(&deformation.get(a)) / ROOM).min(1.0),
            };
            (a, self.spacing(a) * stretch)
        }))
    }

    /// Adds acceleration x `dt` to the velocities.
    pub fn kick(&mut self, dt: f64) {
        add(&mut self.state.velocity, &self.state.acceleration, dt);
    }

    /// Adds velocity x `dt` to the positions.
    pub fn drift(&mut self, dt: f64) {
        add(&mut self.state.position, &self.state.velocity, dt);
    }

    /// Brings deformation and stress to the present positions; `dt` is the time (s) since they were last there.
    ///
    /// # Errors
    /// If a particle is turned inside out or its stress cannot be returned to the yield surface; the one with the smallest number is
    /// named. The state is then not usable any more.
    pub fn update_stress(&mut self, dt: f64) -> Result<(), SpaceError> {
        let laws = Laws {
            material: &self.material,
            yields: YieldStress::of(&self.material.strength),
            dt,
        };
        let (reference, s) = (&self.reference, &mut self.state);
        let position = &s.position;
        let tasks = (
            s.deformation.blocks.par_chunks_mut(TASK),
            s.flux.blocks.par_chunks_mut(TASK),
            s.plastic_strain.blocks.par_chunks_mut(TASK),
            s.plastic_strain_rate.blocks.par_chunks_mut(TASK),
            s.plastic_work.blocks.par_chunks_mut(TASK),
        );
        let update = |(task, f): (usize, (_, _, _, _, _))| {
            let fields = Fields {
                deformation: f.0,
                flux: f.1,
                plastic_strain: f.2,
                plastic_strain_rate: f.3,
                plastic_work: f.4,
            };
            simd::run(Update {
                reference,
                position,
                laws: &laws,
                task,
                fields,
            })
        };
        let failures = tasks.into_par_iter().enumerate().filter_map(update);
        let failed = failures.min_by_key(|(a, _)| *a);
        let Some((particle, why)) = failed else {
            return Ok(());
        };
        let position = self.state.position.get(particle);
        Err(match why {
            Failure::Inverted(volume_ratio) => SpaceError::Inverted {
                particle,
                position,
                volume_ratio,
            },
            Failure::Return(source) => SpaceError::Return {
                particle,
                position,
                source,
            },
        })
    }

    /// Evaluates all accelerations and books the work of viscosity, hourglass forces and held particles over the step of length
    /// `dt` (s) that is closed by a kick of dt/2: its powers are those of the velocities after that kick. With `dt` = 0, as before
    /// the first step, nothing is booked.
    pub fn accelerations(&mut self, dt: f64) {
        let mut acceleration = std::mem::take(&mut self.state.acceleration);
        let solid = &*self;
        let tasks = acceleration.blocks.par_chunks_mut(TASK).enumerate();
        let powers: Vec<Powers> = tasks
            .map(|(task, acceleration)| {
                simd::run(Accelerate {
                    solid,
                    task,
                    dt,
                    acceleration,
                })
            })
            .collect();
        self.state.acceleration = acceleration;
        let work = &mut self.state.work;
        for [viscous, hourglass, driving] in powers {
            work.viscous -= dt * viscous;
            work.hourglass -= dt * hourglass;
            work.driving += dt * driving;
        }
    }

    /// One step: kick, drift, stress, accelerations, kick.
    ///
    /// # Errors
    /// As [`Self::update_stress`].
    pub fn step(&mut self, dt: f64) -> Result<(), SpaceError> {
        self.timed_step(dt, &mut Phases::default())
    }

    /// The same; tells how long its parts took.
    ///
    /// # Errors
    /// As [`Self::update_stress`].
    pub fn timed_step(&mut self, dt: f64, phases: &mut Phases) -> Result<(), SpaceError> {
        phases.start();
        self.kick(0.5 * dt);
        self.drift(dt);
        phases.lap(Phase::Integrate);
        self.update_stress(dt)?;
        self.accelerations(dt);
        phases.lap(Phase::Sweeps);
        self.kick(0.5 * dt);
        phases.lap(Phase::Integrate);
        Ok(())
    }
}

/// The first of those with the smallest number.
fn least(all: impl Iterator<Item = (usize, f64)>) -> (usize, f64) {
    all.fold((0, f64::INFINITY), |m, x| if x.1 < m.1 { x } else { m })
}

/// Adds `dt` times a rate.
fn add(field: &mut Blocks<3>, rate: &Blocks<3>, dt: f64) {
    let tasks = (field.blocks.par_chunks_mut(LONG_TASK)).zip(rate.blocks.par_chunks(LONG_TASK));
    tasks.for_each(|(field, rate)| simd::run(Add { field, rate, dt }));
}

struct Add<'a> {
    field: &'a mut [Block<3>],
    rate: &'a [Block<3>],
    dt: f64,
}

impl Task for Add<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let dt = S::splat(self.dt);
        for (field, rate) in self.field.iter_mut().zip(self.rate) {
            let (mut x, v) = (field.load::<S>(), rate.load::<S>());
            for i in 0..3 {
                x[i] = dt.mul_add(v[i], x[i]);
            }
            field.store(x);
        }
    }
}

/// Accelerations of the clusters of one task.
struct Accelerate<'a> {
    solid: &'a SpaceSolid,
    task: usize,
    dt: f64,
    acceleration: &'a mut [Block<3>],
}

impl Task for Accelerate<'_> {
    type Output = Powers;

    #[inline(always)]
    fn run<S: Simd>(self) -> Powers {
        let mut powers = [S::splat(0.0); 3];
        for k in 0..self.acceleration.len() {
            let cluster = self.task * TASK + k;
            self.acceleration[k].store(self.cluster(cluster, &mut powers));
        }
        let mut sum = [0.0; 3];
        for i in 0..3 {
            sum[i] = powers[i].store().iter().sum();
        }
        sum
    }
}

impl Accelerate<'_> {
    #[inline(always)]
    fn cluster<S: Simd>(&self, cluster: usize, powers: &mut [S; 3]) -> [S; 3] {
        let (r, s) = (&self.solid.reference, &self.solid.state);
        let moving = Moving {
            position: &s.position,
            velocity: &s.velocity,
            deformation: &s.deformation,
            flux: &s.flux,
        };
        let sums = sums::forces(&r.list, &r.place, &moving, cluster);
        let before = &self.solid.stabilisers;
        let damping = r.damper_factor::<S>(cluster);
        let stress = S::splat(-1.0 / self.solid.material.density) * r.pair_factor(cluster);
        let viscous = times(sums.viscous, S::splat(-before.viscous) * damping);
        let hourglass = times(sums.hourglass, S::splat(before.hourglass) * damping);
        let mut total = times(sums.stress, stress);
        for i in 0..3 {
            total[i] = total[i] + (viscous[i] + hourglass[i]);
        }
        let mut v: [S; 3] = s.velocity.blocks[cluster].load();
        let half = S::splat(0.5 * self.dt);
        let mass = S::load(&self.solid.masses(cluster));
        if let Some(free) = &self.solid.free {
            let free: [S; 3] = free.blocks[cluster].load();
            for i in 0..3 {
                // A held component keeps its velocity; the holder takes up the force.
                let held = (S::splat(1.0) - free[i]) * total[i] * v[i];
                powers[2] = powers[2] - mass * held;
                total[i] = total[i] * free[i];
            }
        }
        for i in 0..3 {
            v[i] = half.mul_add(total[i], v[i]);
        }
        powers[0] = mass.mul_add(dot(viscous, v), powers[0]);
        powers[1] = mass.mul_add(dot(hourglass, v), powers[1]);
        total
    }
}
