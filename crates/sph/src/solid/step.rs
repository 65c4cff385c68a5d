//! Time step of a solid on its own (kick, drift, kick) and its stable length.

use super::mat2::{Mat2, smallest_stretch};
use super::points::TASK;
use super::sums::matrices;
use super::{Formulation, Solid, SolidError};
use crate::geometry::Vec2;
use crate::simd::{self, LANES, Simd, Task};
use rayon::prelude::*;

/// Compression that the Courant number has room for.
const ROOM: f64 = 0.8;
/// Particles per task of loops without neighbours.
pub(super) const LONG_TASK: usize = 2048;

/// The stable step and what limits it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepLimit {
    /// Largest stable step, s.
    pub dt: f64,
    /// Particle that limits it.
    pub particle: usize,
    /// What limits it.
    pub reason: &'static str,
}

/// The first of those with the smallest number; particle 0 and infinity if there are none.
fn least(all: impl Iterator<Item = (usize, f64)>) -> (usize, f64) {
    all.fold((0, f64::INFINITY), |m, x| if x.1 < m.1 { x } else { m })
}

/// Adds `dt` times a rate.
fn add(field: &mut [Vec2], rate: &[Vec2], dt: f64) {
    let tasks = field
        .par_chunks_mut(LONG_TASK)
        .zip(rate.par_chunks(LONG_TASK));
    tasks.for_each(|(field, rate)| {
        let rate = rate.as_flattened();
        for (x, v) in field.as_flattened_mut().iter_mut().zip(rate) {
            *x += dt * v;
        }
    });
}

/// Whether the smallest stretches of the particles of a cluster are seen without effort to be above [`ROOM`]:
/// |F^T F - I| <= 1 - ROOM^2 says so.
struct IsCalm<'a>(&'a [Mat2], usize);

impl Task for IsCalm<'_> {
    type Output = bool;

    #[inline(always)]
    fn run<S: Simd>(self) -> bool {
        let [a, b, c, d] = matrices::<S>(self.0, self.1);
        let one = S::splat(1.0);
        let xx = a.mul_add(a, c.mul_add(c, -one));
        let yy = b.mul_add(b, d.mul_add(d, -one));
        let xy = a.mul_add(b, c * d);
        let square = xx.mul_add(xx, yy.mul_add(yy, (xy + xy) * xy));
        let most = 1.0 - ROOM * ROOM;
        S::bits(square.lt(S::splat(most * most))) == u8::MAX
    }
}

impl Solid {
    /// Courant number x spacing / longitudinal wave speed of the material in the first configuration, the smallest.
    ///
    /// Waves cross a compressed spacing sooner: beyond [`ROOM`] the spacing counts as compressed by the smallest stretch
    /// in the plane. Removed particles do not count.
    #[must_use]
    pub fn stable_time_step(&self) -> StepLimit {
        let tasks = 0..self.len().div_ceil(TASK);
        let all: Vec<(usize, f64)> = (tasks.into_par_iter())
            .map(|task| {
                let clusters =
                    task * TASK / LANES..self.len().min((task + 1) * TASK).div_ceil(LANES);
                least(clusters.map(|c| self.shortest_step(c)))
            })
            .collect();
        let (particle, dt) = match least(all.into_iter()) {
            // Nothing is left.
            (a, dt) if dt == f64::INFINITY => {
                (a, self.numerics.courant * self.reference.crossing[a])
            }
            found => found,
        };
        StepLimit {
            dt,
            particle,
            reason: "longitudinal wave in the solid",
        }
    }

    /// The particle of a cluster with the shortest step, and that step (s).
    fn shortest_step(&self, cluster: usize) -> (usize, f64) {
        let s = &self.state;
        let calm = s.base.is_none() && simd::run(IsCalm(&s.deformation, cluster));
        let crossing = &self.reference.crossing;
        let first = cluster * LANES;
        let here = first..self.len().min(first + LANES);
        least(here.filter(|&a| s.removed[a] == 0.0).map(|a| {
            let stretch = if calm {
                1.0
            } else {
                (smallest_stretch(&self.total_deformation(a)) / ROOM).min(1.0)
            };
            (a, self.numerics.courant * crossing[a] * stretch)
        }))
    }

    /// Adds acceleration x `dt` to the velocities.
    pub fn kick(&mut self, dt: f64) {
        let s = &mut self.state;
        add(&mut s.velocity, &s.acceleration, dt);
    }

    /// Adds velocity x `dt` to the positions; in the published form with XSPH its smoothed velocity.
    pub fn drift(&mut self, dt: f64) {
        if let Formulation::Joshi(settings) = self.numerics.formulation
            && settings.xsph != 0.0
        {
            self.follow_neighbours(settings.xsph, dt);
        }
        let s = &mut self.state;
        add(&mut s.position, &s.velocity, dt);
    }

    /// The same, one after the other.
    pub fn kick_and_drift(&mut self, kick: f64, drift: f64) {
        if let Formulation::Joshi(_) = self.numerics.formulation {
            self.kick(kick);
            return self.drift(drift);
        }
        let s = &mut self.state;
        let tasks = (s.position.par_chunks_mut(LONG_TASK))
            .zip(s.velocity.par_chunks_mut(LONG_TASK))
            .zip(s.acceleration.par_chunks(LONG_TASK));
        tasks.for_each(|((position, velocity), acceleration)| {
            let (x, v) = (position.as_flattened_mut(), velocity.as_flattened_mut());
            let both = x.iter_mut().zip(v);
            for ((x, v), a) in both.zip(acceleration.as_flattened()) {
                *v += kick * a;
                *x += drift * *v;
            }
        });
    }

    /// One step of a solid on its own, with its pressures held: kick, drift, stress, accelerations, kick, ledger.
    ///
    /// # Errors
    /// As [`Self::update_stress`].
    pub fn step(&mut self, dt: f64) -> Result<(), SolidError> {
        self.kick_and_drift(0.5 * dt, dt);
        self.update_stress(dt)?;
        self.accelerations();
        self.kick(0.5 * dt);
        self.account(dt);
        Ok(())
    }
}
