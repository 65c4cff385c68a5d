//! The step of a liquid in either formulation.
//!
//! 1. kick by half a step, drift by half a step; ghosts, neighbours, velocity gradients ([`super::kinematics`]);
//! 2. what the formulation moves there: volume and shifting ([`super::corrected`]), or XSPH ([`super::joshi`]);
//! 3. drift by half a step; meanwhile the solids move too;
//! 4. density and pressure; accelerations ([`super::momentum`] or [`super::joshi`]); kick by half a step.
//!
//! Second order in time: volume changes with the velocity of the middle of the step at the positions of the middle.

use crate::fluid::carry::Walls;
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
    /// Shifting velocities, m/s.
    pub(crate) shift: Vec<[f64; D]>,
    pub(crate) momentum: momentum::Memory<D>,
    /// Force on the surfaces of solids by each particle, N (whole ring).
    reaction: Vec<[f64; D]>,
}

impl<const D: usize> Default for Memory<D> {
    fn default() -> Self {
        Self {
            kinematics: kinematics::Memory::default(),
            shifting: shifting::Memory::default(),
            shift: Vec::new(),
            momentum: momentum::Memory::default(),
            reaction: Vec::new(),
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
        &self.memory.kinematics.results[a]
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
        let half = 0.5 * dt;
        let bounds = Walls::new(walls);
        let rate = std::mem::take(&mut self.acceleration);
        self.carry(&bounds, |a, x, v| {
            for i in 0..D {
                v[i] += half * rate[a][i];
                x[i] += half * v[i];
            }
        });
        self.acceleration = rate;
        clock.lap(Phase::Integrate);
        let mut sweep = Sweep::find(self, walls, dt, clock);
        match self.formulation {
            Formulation::Corrected(s) => self.exchange_volume(&s, &mut sweep, dt),
            Formulation::Joshi(s) => {
                self.keep_kinematics(&sweep);
                self.advance_far_volume(&sweep, dt);
                let x = Extended::new(self, &sweep.ghosts, &self.velocity);
                sweep.memory.shift = self.smoothing_velocities(&x, &sweep, s.xsph);
            }
        }
        clock.lap(Phase::Sweeps);
        let shift = &sweep.memory.shift;
        self.carry(&bounds, |a, x, v| {
            for i in 0..D {
                x[i] += dt * shift[a][i];
                x[i] += half * v[i];
            }
        });
        clock.lap(Phase::Integrate);
        sweep
    }

    /// Step 4: forces at the end of the step (`time`), with the ghosts where they are then, and the kick.
    pub(crate) fn push(
        &mut self,
        mut sweep: Sweep<D>,
        ghosts: &Ghosts<D>,
        dt: f64,
        time: f64,
        clock: &mut Phases,
    ) {
        match self.formulation {
            Formulation::Corrected(_) => self.update_smoothing_length(),
            Formulation::Joshi(_) => {
                self.sum_density(ghosts, &sweep);
                self.update_pressure();
            }
        }
        let fluid = &*self;
        let surroundings =
            |a: usize| fluid.surroundings(a, fluid.velocity[a], fluid.acceleration[a], dt, time);
        match self.formulation {
            Formulation::Corrected(_) => {
                momentum::sweep(self, ghosts, surroundings, &mut sweep);
                self.kick(momentum::forces, &mut sweep, dt, time);
            }
            Formulation::Joshi(s) => {
                let (predicted, outside): (Vec<_>, Vec<_>) =
                    (0..self.len()).into_par_iter().map(surroundings).unzip();
                let x = Extended::new(self, ghosts, &predicted);
                let forces = joshi::forces(self, &x, &outside, &sweep, &s);
                self.kick(|_, _, a| forces[a], &mut sweep, dt, time);
            }
        }
        self.sweep = sweep;
        clock.lap(Phase::Sweeps);
    }

    /// Force of each particle on the surfaces of solids in the last step, N (whole ring).
    pub(crate) fn reaction(&self) -> &[[f64; D]] {
        &self.sweep.memory.reaction
    }

    /// Velocity of particle `a` at the end of a step of `dt`, at `time`, from that at its middle and the last acceleration; and
    /// the pressure outside of it, of its far field or of the gas beside it, Pa.
    fn surroundings(
        &self,
        a: usize,
        velocity: [f64; D],
        rate: [f64; D],
        dt: f64,
        time: f64,
    ) -> ([f64; D], f64) {
        let v = std::array::from_fn(|i| velocity[i] + 0.5 * dt * rate[i]);
        let far = &self.far_field[a];
        let outside = if far.is_some() {
            far.pressure_outside(&self.eos, v, time)
        } else {
            self.gas_pressure.get(a).copied().unwrap_or(0.0)
        };
        (v, outside)
    }

    /// v += a dt/2 with the new accelerations; dissipation and work of the far field go to the account, forces on surfaces to
    /// the memory of the sweep.
    fn kick(
        &mut self,
        forces: impl Fn(&Self, &Sweep<D>, usize) -> Forces<D> + Sync,
        sweep: &mut Sweep<D>,
        dt: f64,
        time: f64,
    ) {
        let mut velocity = std::mem::take(&mut self.velocity);
        let mut acceleration = std::mem::take(&mut self.acceleration);
        let mut reaction = std::mem::take(&mut sweep.memory.reaction);
        reaction.resize(self.len(), [0.0; D]);
        let (fluid, found) = (&*self, &*sweep);
        let works = (velocity.par_iter_mut().zip(&mut acceleration))
            .zip(&mut reaction)
            .enumerate()
            .map(|(a, ((v, rate), reaction))| {
                let (predicted, outside) = fluid.surroundings(a, *v, *rate, dt, time);
                let f = forces(fluid, found, a);
                *rate = f.acceleration;
                for (v, rate) in v.iter_mut().zip(f.acceleration) {
                    *v += 0.5 * dt * rate;
                }
                let mass = fluid.mass[a];
                *reaction = f.wall.map(|w| -mass * w);
                let dissipation = mass * dot(f.dissipation, predicted);
                let leaving = fluid.far_field_power(a, predicted, outside, found);
                [dissipation, leaving]
            });
        let [dissipation, leaving] = ordered_sums(works);
        (self.velocity, self.acceleration) = (velocity, acceleration);
        sweep.memory.reaction = reaction;
        self.account.dissipation -= dt * dissipation;
        self.account.far_field_work -= dt * leaving;
    }

    /// Power (W) of particle `a` with this velocity on the pressure outside of its far field.
    fn far_field_power(&self, a: usize, velocity: [f64; D], outside: f64, sweep: &Sweep<D>) -> f64 {
        let far = &self.far_field[a];
        if !far.is_some() {
            return 0.0;
        }
        let half = 0.5 * spacing::<D>(self.area(a));
        let gradient = sweep.kinematics(a).gradient;
        let stretch = gradient.map(|row| half * dot(row, far.normal));
        let speed = dot(
            far.normal,
            std::array::from_fn(|i| velocity[i] + stretch[i]),
        );
        outside * speed * far.face_area
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
}
