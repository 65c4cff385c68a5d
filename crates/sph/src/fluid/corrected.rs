//! The corrected formulation: what liquid particles do to each other, as the list of a step.
//!
//! 1. kick by half a step, drift by half a step;
//! 2. ghosts and neighbours; moment matrix, velocity gradient, rate of volume ([`super::kinematics`]);
//! 3. volume; shifting with exchange of volume, mass and momentum ([`super::shifting`]);
//! 4. drift by half a step; pressure;
//! 5. accelerations ([`super::momentum`]); kick by half a step.
//!
//! Second order in time: volume changes with the velocity of the middle of the step at the positions of the middle.

use crate::fluid::Fluid;
use crate::fluid::extended::Extended;
use crate::fluid::ghosts::{Ghosts, Wall};
use crate::fluid::kinematics::{self, Kinematics};
use crate::fluid::{momentum, shifting};
use crate::geometry::Vec2;
use crate::neighbours::Neighbours;
use serde::{Deserialize, Serialize};

/// Numerical settings of the corrected formulation.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Settings {
    /// Strength k of the particle shifting.
    pub shifting: f64,
    /// Largest shifting velocity in units of h |grad v|.
    pub shifting_limit: f64,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            shifting: 10.0,
            shifting_limit: 2.0,
        }
    }
}

/// Room for motion in the neighbour list during the second half of a step, in units of the support.
const SKIN: f64 = 0.1;

/// Below this eigenvalue of the moment matrix a particle lies at a free surface or is a fragment.
const PARTED: f64 = 0.6;

/// Cavitating liquid inside the body swells to this multiple of its volume at zero pressure; beyond, gaps open.
const LARGEST_SWELLING: f64 = 1.5;

/// What the first half of a step hands to the second.
pub(crate) struct Sweep {
    pub(crate) ghosts: Ghosts,
    pub(crate) list: Neighbours,
    pub(crate) kinematics: Vec<Kinematics>,
}

/// Energy that left or entered the liquid otherwise than through its own motion, J; and what was counted.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Account {
    /// Kinetic energy turned into nothing by the Riemann dissipation, by exchange of volume at unequal pressure and by
    /// mixing of shifted volumes.
    pub dissipation: f64,
    /// Work done by the far field.
    pub far_field_work: f64,
    /// Particles mirrored back at the axis.
    pub axis_crossings: u64,
    /// Particles mirrored back at a wall.
    pub wall_crossings: u64,
    /// Particle-steps in which tension was removed.
    pub cavitating: u64,
    /// Particle-steps in which a fragment was kept at its density at zero pressure.
    pub parted: u64,
    /// Exchanges of volume that were cut to the largest share a particle may give.
    pub limited_exchanges: u64,
}

impl Fluid {
    /// Steps 1 to 4: from t to t + dt but for the velocity, which stays at the middle of the step.
    pub(crate) fn move_corrected(&mut self, s: &Settings, walls: &[&dyn Wall], dt: f64) -> Sweep {
        self.kick(0.5 * dt);
        self.drift(0.5 * dt, walls);
        let ghosts = Ghosts::find(self, walls);
        let x = Extended::new(self, &ghosts, &self.velocity);
        let list = Neighbours::build(&x.position, &x.smoothing_length, self.len(), SKIN);
        let kinematics = kinematics::sweep(self, &x, &list);
        self.advance_volume(&kinematics, dt);
        let shift = shifting::velocities(self, &kinematics, s);
        shifting::exchange(self, &ghosts, &list, &shift, dt);
        for (x, d) in self.position.iter_mut().zip(&shift) {
            *x = [x[0] + dt * d[0], x[1] + dt * d[1]];
        }
        self.drift(0.5 * dt, walls);
        self.update_pressure();
        Sweep {
            ghosts,
            list,
            kinematics,
        }
    }

    fn advance_volume(&mut self, kinematics: &[Kinematics], dt: f64) {
        for (a, k) in kinematics.iter().enumerate() {
            self.account.dissipation += dt * self.pressure[a] * k.exchange;
            let relative = k.divergence + k.exchange / self.volume[a];
            self.volume[a] *= (dt * relative).exp();
            self.support[a] = k.support;
            self.keep_fragments_whole(a);
            self.strain_rate[a] = shifting::norm(&k.gradient);
        }
    }

    /// Where the liquid has parted it keeps its density at zero pressure: the void opens between the pieces, not in them.
    /// Inside the liquid a deficit of density stands for bubbles too small to see and is kept up to a limit. Volume
    /// taken here is at zero pressure: no energy is lost with it.
    fn keep_fragments_whole(&mut self, a: usize) {
        let swelling = if self.support[a] < PARTED { 1.0 } else { LARGEST_SWELLING };
        let largest = swelling * self.mass[a] / self.eos.reference_density;
        if self.volume[a] > largest {
            self.volume[a] = largest;
            self.account.parted += 1;
        }
    }

    /// Step 5 without the kick: forces at the end of the step (`time`). Returns the force of the liquid on the surfaces of solids,
    /// N per particle (whole ring).
    pub(crate) fn push_corrected(
        &mut self,
        sweep: &Sweep,
        walls: &[&dyn Wall],
        dt: f64,
        time: f64,
    ) -> Vec<Vec2> {
        let predicted: Vec<Vec2> = (0..self.len())
            .map(|a| [0, 1].map(|i| self.velocity[a][i] + 0.5 * dt * self.acceleration[a][i]))
            .collect();
        let ghosts = sweep.ghosts.refresh(self, walls);
        let x = Extended::new(self, &ghosts, &predicted);
        let outside: Vec<f64> = (0..self.len())
            .map(|a| self.far_field[a].pressure_outside(&self.eos, predicted[a], time))
            .collect();
        let forces = momentum::sweep(self, &x, &outside, sweep);
        let mut reaction = Vec::with_capacity(self.len());
        for (a, f) in forces.iter().enumerate() {
            let (m, v) = (self.mass[a], predicted[a]);
            self.account.dissipation -=
                dt * m * (f.dissipation[0] * v[0] + f.dissipation[1] * v[1]);
            let far = &self.far_field[a];
            let half = 0.5 * self.area(a).sqrt();
            let grad = sweep.kinematics[a].gradient;
            let stretch =
                |i: usize| half * (grad[i][0] * far.normal[0] + grad[i][1] * far.normal[1]);
            let leaving = far.normal[0] * (v[0] + stretch(0)) + far.normal[1] * (v[1] + stretch(1));
            self.account.far_field_work -= dt * outside[a] * leaving * far.face_area;
            self.acceleration[a] = f.acceleration;
            reaction.push([-m * f.wall[0], -m * f.wall[1]]);
        }
        reaction
    }
}
