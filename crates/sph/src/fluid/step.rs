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
use crate::fluid::{Fluid, Formulation, joshi};
use crate::geometry::Vec2;
use crate::neighbours::Neighbours;
use crate::phases::{Phase, Phases};

/// Room for motion in the neighbour list during the second half of a step, in units of the support.
const SKIN: f64 = 0.1;

/// What the first half of a step hands to the second.
pub(crate) struct Sweep {
    pub(crate) ghosts: Ghosts,
    pub(crate) list: Neighbours,
    pub(crate) kinematics: Vec<Kinematics>,
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
        let ghosts = Ghosts::find(self, walls);
        let x = Extended::new(self, &ghosts, &self.velocity);
        clock.lap(Phase::Boundaries);
        let list = Neighbours::build(&x.position, &x.smoothing_length, self.len(), SKIN);
        clock.lap(Phase::List);
        let kinematics = kinematics::sweep(self, &x, &list);
        let sweep = Sweep {
            ghosts,
            list,
            kinematics,
        };
        self.keep_kinematics(&sweep.kinematics);
        let extra = match self.formulation {
            Formulation::Corrected(s) => self.exchange_volume(&s, &sweep, dt),
            Formulation::Joshi(s) => {
                self.advance_far_volume(&sweep.kinematics, dt);
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
        sweep: &Sweep,
        walls: &[&dyn Wall],
        dt: f64,
        time: f64,
        clock: &mut Phases,
    ) -> Vec<Vec2> {
        let predicted: Vec<Vec2> = (0..self.len())
            .map(|a| [0, 1].map(|i| self.velocity[a][i] + 0.5 * dt * self.acceleration[a][i]))
            .collect();
        let ghosts = sweep.ghosts.refresh(self, walls);
        clock.lap(Phase::Boundaries);
        match self.formulation {
            Formulation::Corrected(_) => self.update_smoothing_length(),
            Formulation::Joshi(_) => self.sum_density(&ghosts, sweep),
        }
        self.update_pressure();
        let x = Extended::new(self, &ghosts, &predicted);
        let outside: Vec<f64> = (0..self.len())
            .map(|a| self.far_field[a].pressure_outside(&self.eos, predicted[a], time))
            .collect();
        let forces = match self.formulation {
            Formulation::Corrected(_) => momentum::sweep(self, &x, &outside, sweep),
            Formulation::Joshi(s) => joshi::forces(self, &x, &outside, sweep, &s),
        };
        self.book(&forces, &predicted, &outside, sweep, dt);
        for (a, f) in self.acceleration.iter_mut().zip(&forces) {
            *a = f.acceleration;
        }
        clock.lap(Phase::Sweeps);
        (forces.iter().zip(&self.mass))
            .map(|(f, m)| f.wall.map(|w| -m * w))
            .collect()
    }

    fn keep_kinematics(&mut self, kinematics: &[Kinematics]) {
        for (a, k) in kinematics.iter().enumerate() {
            self.support[a] = k.support;
            self.strain_rate[a] = super::shifting::norm(&k.gradient);
        }
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
        for (a, f) in forces.iter().enumerate() {
            let v = velocity[a];
            self.account.dissipation -=
                dt * self.mass[a] * (f.dissipation[0] * v[0] + f.dissipation[1] * v[1]);
            let far = &self.far_field[a];
            let half = 0.5 * self.area(a).sqrt();
            let grad = sweep.kinematics[a].gradient;
            let stretch =
                |i: usize| half * (grad[i][0] * far.normal[0] + grad[i][1] * far.normal[1]);
            let leaving = far.normal[0] * (v[0] + stretch(0)) + far.normal[1] * (v[1] + stretch(1));
            self.account.far_field_work -= dt * outside[a] * leaving * far.face_area;
        }
    }
}
