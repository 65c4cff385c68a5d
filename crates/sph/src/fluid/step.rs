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
use crate::fluid::{Fluid, Formulation, PARTICLES_PER_TASK, joshi, ordered_sum, shifting};
use crate::geometry::Vec2;
use crate::neighbours::Neighbours;
use crate::phases::{Phase, Phases};
use rayon::prelude::*;

/// Room for motion in the list of single particles during the second half of a step, in units of the support.
const SKIN: f64 = 0.1;

/// What the first half of a step hands to the second. Kept for the next step for the sake of its memory.
#[derive(Debug, Clone, Default)]
pub(crate) struct Sweep {
    pub(crate) ghosts: Ghosts,
    pub(crate) places: Places,
    /// Neighbours of single particles, for the published formulation alone.
    pub(crate) list: Neighbours,
    pub(crate) kinematics: Vec<Kinematics>,
    pub(crate) memory: Memory,
}

/// Memory of the sums over neighbours.
#[derive(Debug, Clone, Default)]
pub(crate) struct Memory {
    kinematics: kinematics::Memory,
    pub(crate) shifting: shifting::Memory,
    pub(crate) momentum: momentum::Memory,
}

impl Sweep {
    /// Takes out the velocity gradients of particles that are not to `keep`.
    pub(crate) fn retain_kinematics(&mut self, keep: &[bool]) {
        let mut keep = keep.iter();
        (self.kinematics).retain(|_| *keep.next().unwrap_or(&true));
    }

    /// Ghosts, neighbours for a step of `dt`, velocity gradients.
    pub(crate) fn find(
        fluid: &mut Fluid,
        walls: &[&dyn Wall],
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
            &mut sweep.kinematics,
        );
        sweep
    }
}

impl Fluid {
    /// Steps 1 to 3: positions from t to t + dt; the velocity stays at the middle of the step.
    pub(crate) fn advance_positions(
        &mut self,
        walls: &[&dyn Wall],
        dt: f64,
        clock: &mut Phases,
    ) -> Sweep {
        self.kick(0.5 * dt);
        self.drift(0.5 * dt, walls);
        clock.lap(Phase::Integrate);
        let mut sweep = Sweep::find(self, walls, dt, clock);
        self.keep_kinematics(&sweep.kinematics);
        let extra = match self.formulation {
            Formulation::Corrected(s) => self.exchange_volume(&s, &mut sweep, dt),
            Formulation::Joshi(s) => {
                self.advance_far_volume(&sweep.kinematics, dt);
                let x = Extended::new(self, &sweep.ghosts, &self.velocity);
                self.smoothing_velocities(&x, &sweep, s.xsph)
            }
        };
        clock.lap(Phase::Sweeps);
        for (x, u) in self.position.iter_mut().zip(&extra) {
            *x = [x[0] + dt * u[0], x[1] + dt * u[1]];
        }
        self.drift(0.5 * dt, walls);
        clock.lap(Phase::Integrate);
        sweep
    }

    /// Step 4 without the kick: forces at the end of the step (`time`). Returns the force of the liquid on the surfaces
    /// of solids, N per particle (whole ring).
    pub(crate) fn push(
        &mut self,
        mut sweep: Sweep,
        walls: &[&dyn Wall],
        dt: f64,
        time: f64,
        clock: &mut Phases,
    ) -> Vec<Vec2> {
        let predicted: Vec<Vec2> = (self.velocity.par_iter().zip(&self.acceleration))
            .with_min_len(PARTICLES_PER_TASK)
            .map(|(v, a)| [0, 1].map(|i| v[i] + 0.5 * dt * a[i]))
            .collect();
        let ghosts = sweep.ghosts.refresh(self, walls);
        clock.lap(Phase::Boundaries);
        match self.formulation {
            Formulation::Corrected(_) => self.update_smoothing_length(),
            Formulation::Joshi(_) => self.sum_density(&ghosts, &sweep),
        }
        self.update_pressure();
        let outside: Vec<f64> = (self.far_field.par_iter().zip(&predicted))
            .with_min_len(PARTICLES_PER_TASK)
            .map(|(far, v)| far.pressure_outside(&self.eos, *v, time))
            .collect();
        let forces = match self.formulation {
            Formulation::Corrected(_) => {
                momentum::sweep(self, &ghosts, &predicted, &outside, &mut sweep)
            }
            Formulation::Joshi(s) => {
                let x = Extended::new(self, &ghosts, &predicted);
                joshi::forces(self, &x, &outside, &sweep, &s)
            }
        };
        self.book(&forces, &predicted, &outside, &sweep, dt);
        self.sweep = sweep;
        for (a, f) in self.acceleration.iter_mut().zip(&forces) {
            *a = f.acceleration;
        }
        clock.lap(Phase::Sweeps);
        (forces.iter().zip(&self.mass))
            .map(|(f, m)| f.wall.map(|w| -m * w))
            .collect()
    }

    fn keep_kinematics(&mut self, kinematics: &[Kinematics]) {
        (self.support.par_iter_mut().zip(&mut self.strain_rate))
            .zip(kinematics)
            .with_min_len(PARTICLES_PER_TASK)
            .for_each(|((support, strain_rate), k)| {
                *support = k.support;
                *strain_rate = shifting::norm(&k.gradient);
            });
    }

    /// Dissipation and work of the far field during one step.
    fn book(
        &mut self,
        forces: &[Forces],
        velocity: &[Vec2],
        outside: &[f64],
        sweep: &Sweep,
        dt: f64,
    ) {
        let dissipated = |a: usize| {
            let (f, v) = (&forces[a].dissipation, velocity[a]);
            self.mass[a] * (f[0] * v[0] + f[1] * v[1])
        };
        let leaving = |a: usize| {
            let (far, v) = (&self.far_field[a], velocity[a]);
            if !far.is_some() {
                return 0.0;
            }
            let half = 0.5 * self.area(a).sqrt();
            let grad = sweep.kinematics[a].gradient;
            let stretch =
                |i: usize| half * (grad[i][0] * far.normal[0] + grad[i][1] * far.normal[1]);
            let speed = far.normal[0] * (v[0] + stretch(0)) + far.normal[1] * (v[1] + stretch(1));
            outside[a] * speed * far.face_area
        };
        let dissipation = ordered_sum(self.len(), dissipated);
        let work = ordered_sum(self.len(), leaving);
        self.account.dissipation -= dt * dissipation;
        self.account.far_field_work -= dt * work;
    }
}
