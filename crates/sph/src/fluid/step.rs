//! The step of a liquid in either formulation.
//!
//! 1. kick by half a step, drift by half a step; ghosts, neighbours, velocity gradients ([`super::kinematics`]);
//! 2. what the formulation moves there: volume and shifting ([`super::corrected`]), or XSPH ([`super::joshi`]);
//! 3. drift by half a step; meanwhile the solids move too;
//! 4. density and pressure; accelerations ([`super::momentum`] or [`super::joshi`]); kick by half a step.
//!
//! Second order in time: volume changes with the velocity of the middle of the step at the positions of the middle.

use crate::fluid::extended::Extended;
use crate::fluid::ghosts::{Ghosts, Wall};
use crate::fluid::kinematics::{self, Kinematics};
use crate::fluid::momentum::{self, Forces};
use crate::fluid::places::Places;
use crate::fluid::{
    Fluid, Formulation, PARTICLES_PER_TASK, joshi, ordered_sums, shifting, spacing,
};
use crate::geometry::dot;
use crate::neighbours::Neighbours;
use crate::phases::{Phase, Phases};
use rayon::prelude::*;

/// Room for motion in the list of single particles during the second half of a step, in units of the support.
const SKIN: f64 = 0.1;

/// What the first half of a step hands to the second. Kept for the next step for the sake of its memory.
#[derive(Debug, Clone)]
pub(crate) struct Sweep<const D: usize = 2> {
    pub(crate) ghosts: Ghosts<D>,
    pub(crate) places: Places<D>,
    /// Neighbours of single particles, for the published formulation alone.
    pub(crate) list: Neighbours,
    pub(crate) memory: Memory<D>,
}

impl<const D: usize> Default for Sweep<D> {
    fn default() -> Self {
        Self {
            ghosts: Ghosts::default(),
            places: Places::default(),
            list: Neighbours::default(),
            memory: Memory::default(),
        }
    }
}

/// Memory of the sums over neighbours.
#[derive(Debug, Clone)]
pub(crate) struct Memory<const D: usize> {
    pub(crate) kinematics: kinematics::Memory<D>,
    pub(crate) shifting: shifting::Memory<D>,
    pub(crate) momentum: momentum::Memory<D>,
}

impl<const D: usize> Default for Memory<D> {
    fn default() -> Self {
        Self {
            kinematics: kinematics::Memory::default(),
            shifting: shifting::Memory::default(),
            momentum: momentum::Memory::default(),
        }
    }
}

impl<const D: usize> Sweep<D> {
    /// Ghosts, neighbours for a step of `dt`, velocity gradients.
    pub(crate) fn find(
        fluid: &mut Fluid<D>,
        walls: &[&dyn Wall<D>],
        dt: f64,
        clock: &mut Phases,
    ) -> Self {
        fluid.renew_clusters();
        clock.lap(Phase::Sort);
        let mut sweep = std::mem::take(&mut fluid.sweep);
        sweep.ghosts = Ghosts::find(fluid, walls);
        clock.lap(Phase::Boundaries);
        sweep.places.find(fluid, &sweep.ghosts, dt);
        if let Formulation::Joshi(_) = fluid.formulation {
            let x = Extended::new(fluid, &sweep.ghosts, &fluid.velocity);
            sweep.list = Neighbours::build(&x.position, &x.smoothing_length, fluid.len(), SKIN);
        }
        clock.lap(Phase::List);
        kinematics::sweep(
            fluid,
            &sweep.ghosts,
            &sweep.places,
            &mut sweep.memory.kinematics,
        );
        sweep
    }

    /// What the first sweep found for particle `a`.
    #[inline]
    pub(crate) fn kinematics(&self, a: usize) -> &Kinematics<D> {
        &self.memory.kinematics.results[self.places.of(a)]
    }
}

impl<const D: usize> Fluid<D> {
    /// Steps 1 to 3: positions from t to t + dt; the velocity stays at the middle of the step.
    pub(crate) fn advance_positions(
        &mut self,
        walls: &[&dyn Wall<D>],
        dt: f64,
        clock: &mut Phases,
    ) -> Sweep<D> {
        self.kick(0.5 * dt);
        self.drift(0.5 * dt, walls);
        clock.lap(Phase::Integrate);
        let mut sweep = Sweep::find(self, walls, dt, clock);
        let extra = match self.formulation {
            Formulation::Corrected(s) => self.exchange_volume(&s, &mut sweep, dt),
            Formulation::Joshi(s) => {
                self.keep_kinematics(&sweep);
                self.advance_far_volume(&sweep, dt);
                let x = Extended::new(self, &sweep.ghosts, &self.velocity);
                self.smoothing_velocities(&x, &sweep, s.xsph)
            }
        };
        clock.lap(Phase::Sweeps);
        (self.position.par_iter_mut().zip(&extra))
            .with_min_len(PARTICLES_PER_TASK)
            .for_each(|(x, u)| {
                for (x, u) in x.iter_mut().zip(u) {
                    *x += dt * u;
                }
            });
        self.drift(0.5 * dt, walls);
        clock.lap(Phase::Integrate);
        sweep
    }

    /// Step 4 without the kick: forces at the end of the step (`time`), with the ghosts where they are then. Returns the force of the liquid on the surfaces
    /// of solids, N per particle (whole ring).
    pub(crate) fn push(
        &mut self,
        mut sweep: Sweep<D>,
        ghosts: &Ghosts<D>,
        dt: f64,
        time: f64,
        clock: &mut Phases,
    ) -> Vec<[f64; D]> {
        match self.formulation {
            Formulation::Corrected(_) => self.update_smoothing_length(),
            Formulation::Joshi(_) => {
                self.sum_density(ghosts, &sweep);
                self.update_pressure();
            }
        }
        let (predicted, outside) = self.surroundings(dt, time);
        let forces = match self.formulation {
            Formulation::Corrected(_) => {
                momentum::sweep(self, ghosts, &predicted, &outside, &mut sweep)
            }
            Formulation::Joshi(s) => {
                let x = Extended::new(self, ghosts, &predicted);
                joshi::forces(self, &x, &outside, &sweep, &s)
            }
        };
        self.book(&forces, &predicted, &outside, &sweep, dt);
        self.sweep = sweep;
        let reaction = (self.acceleration.par_iter_mut().zip(&forces))
            .zip(&self.mass)
            .with_min_len(PARTICLES_PER_TASK)
            .map(|((a, f), m)| {
                *a = f.acceleration;
                f.wall.map(|w| -m * w)
            })
            .collect();
        clock.lap(Phase::Sweeps);
        reaction
    }

    /// Velocities at the end of a step of `dt`, at `time`, and the pressure outside each particle: of its far field or of the
    /// gas beside it, Pa.
    fn surroundings(&self, dt: f64, time: f64) -> (Vec<[f64; D]>, Vec<f64>) {
        let (mut predicted, mut outside) = (Vec::new(), Vec::new());
        (self.velocity.par_iter().zip(&self.acceleration))
            .zip(&self.far_field)
            .enumerate()
            .with_min_len(PARTICLES_PER_TASK)
            .map(|(a, ((v, rate), far))| {
                let v: [f64; D] = std::array::from_fn(|i| v[i] + 0.5 * dt * rate[i]);
                let outside = if far.is_some() {
                    far.pressure_outside(&self.eos, v, time)
                } else {
                    self.gas_pressure.get(a).copied().unwrap_or(0.0)
                };
                (v, outside)
            })
            .unzip_into_vecs(&mut predicted, &mut outside);
        (predicted, outside)
    }

    fn keep_kinematics(&mut self, sweep: &Sweep<D>) {
        (self.support.par_iter_mut().zip(&mut self.strain_rate))
            .enumerate()
            .with_min_len(PARTICLES_PER_TASK)
            .for_each(|(a, (support, strain_rate))| {
                let k = sweep.kinematics(a);
                *support = k.support;
                *strain_rate = shifting::norm(&k.gradient);
            });
    }

    /// Dissipation and work of the far field during one step.
    fn book(
        &mut self,
        forces: &[Forces<D>],
        velocity: &[[f64; D]],
        outside: &[f64],
        sweep: &Sweep<D>,
        dt: f64,
    ) {
        let dissipated = |a: usize| self.mass[a] * dot(forces[a].dissipation, velocity[a]);
        let leaving = |a: usize| {
            let (far, v) = (&self.far_field[a], velocity[a]);
            if !far.is_some() {
                return 0.0;
            }
            let half = 0.5 * spacing::<D>(self.area(a));
            let stretch = sweep
                .kinematics(a)
                .gradient
                .map(|row| half * dot(row, far.normal));
            let speed = dot(far.normal, std::array::from_fn(|i| v[i] + stretch[i]));
            outside[a] * speed * far.face_area
        };
        let [dissipation, work] = ordered_sums(self.len(), |a| [dissipated(a), leaving(a)]);
        self.account.dissipation -= dt * dissipation;
        self.account.far_field_work -= dt * work;
    }
}
