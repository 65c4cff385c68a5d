//! Time step of a solid on its own (kick, drift, kick) and its stable length.

use super::mat2::smallest_stretch;
use super::{Formulation, Solid, SolidError};
use rayon::prelude::*;

/// Compression that the Courant number has room for.
const ROOM: f64 = 0.8;

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

impl Solid {
    /// Courant number x spacing / longitudinal wave speed of the material in the first configuration, the smallest.
    ///
    /// Waves cross a compressed spacing sooner: beyond [`ROOM`] the spacing counts as compressed by the smallest stretch
    /// in the plane. Removed particles do not count.
    #[must_use]
    pub fn stable_time_step(&self) -> StepLimit {
        let s = &self.state;
        let spacing = |a: usize| {
            let stretch = smallest_stretch(&self.total_deformation(a)) / ROOM;
            self.reference.first_area[a].sqrt() * stretch.min(1.0)
        };
        let speed: Vec<f64> = self.wave_speeds().collect();
        let step = |a: usize| self.numerics.courant * spacing(a) / speed[self.layers.index(a)];
        // The first of the smallest, whatever is compared first.
        let smaller = |p: (usize, f64), q: (usize, f64)| {
            if q.1.total_cmp(&p.1).then(q.0.cmp(&p.0)).is_lt() {
                q
            } else {
                p
            }
        };
        let (particle, dt) = (0..self.len())
            .into_par_iter()
            .with_min_len(1024)
            .filter(|&a| s.removed[a] == 0.0)
            .map(|a| (a, step(a)))
            .reduce_with(smaller)
            .unwrap_or_else(|| (0, step(0)));
        StepLimit {
            dt,
            particle,
            reason: "longitudinal wave in the solid",
        }
    }

    /// Adds acceleration x `dt` to the velocities.
    pub fn kick(&mut self, dt: f64) {
        let s = &mut self.state;
        (&mut s.velocity, &s.acceleration)
            .into_par_iter()
            .with_min_len(1024)
            .for_each(|(v, a)| *v = [v[0] + dt * a[0], v[1] + dt * a[1]]);
    }

    /// Adds velocity x `dt` to the positions; in the published form with XSPH its smoothed velocity.
    pub fn drift(&mut self, dt: f64) {
        if let Formulation::Joshi(settings) = self.numerics.formulation
            && settings.xsph != 0.0
        {
            self.follow_neighbours(settings.xsph, dt);
        }
        let s = &mut self.state;
        (&mut s.position, &s.velocity)
            .into_par_iter()
            .with_min_len(1024)
            .for_each(|(x, v)| *x = [x[0] + dt * v[0], x[1] + dt * v[1]]);
    }

    /// One step of a solid on its own, with its pressures held: kick, drift, stress, accelerations, kick, ledger.
    ///
    /// # Errors
    /// As [`Self::update_stress`].
    pub fn step(&mut self, dt: f64) -> Result<(), SolidError> {
        self.kick(0.5 * dt);
        self.drift(dt);
        self.update_stress(dt)?;
        self.accelerations();
        self.kick(0.5 * dt);
        self.account(dt);
        Ok(())
    }
}
