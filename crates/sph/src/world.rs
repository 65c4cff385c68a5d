//! The bodies of a simulation and the order of a step.

use crate::fluid::ghosts::{Plane, Wall};
use crate::fluid::{Fluid, Formulation};
use crate::geometry::Vec2;

/// A body: the closed set of what can take part.
#[derive(Debug, Clone)]
pub enum Body {
    /// Compressible liquid.
    Fluid(Fluid),
    /// Frictionless rigid wall at rest.
    Wall(Plane),
}

/// A body with the name the user gave it.
#[derive(Debug, Clone)]
pub struct Named {
    /// Unique name.
    pub name: String,
    /// The body.
    pub body: Body,
}

/// Everything that moves.
#[derive(Debug, Clone)]
pub struct World {
    /// Bodies in the order of the case.
    pub bodies: Vec<Named>,
    /// Simulated time, s.
    pub time: f64,
    /// Steps done.
    pub step: u64,
    /// Step as a fraction of h over wave speed.
    pub safety: f64,
}

/// What set the time step.
#[derive(Debug, Clone, PartialEq)]
pub struct Limiter {
    /// Index of the body.
    pub body: usize,
    /// Particle.
    pub particle: usize,
    /// Its place, m.
    pub position: Vec2,
}

impl World {
    /// Largest stable step (s) and what sets it.
    #[must_use]
    pub fn stable_time_step(&self) -> (f64, Limiter) {
        let mut best = (f64::INFINITY, Limiter { body: 0, particle: 0, position: [0.0; 2] });
        for (i, named) in self.bodies.iter().enumerate() {
            let (dt, particle, position) = match &named.body {
                Body::Fluid(f) => {
                    let (dt, a) = f.stable_time_step(self.safety);
                    (dt, a, f.position[a])
                }
                Body::Wall(_) => continue,
            };
            if dt < best.0 {
                best = (dt, Limiter { body: i, particle, position });
            }
        }
        best
    }

    /// One step of `dt` seconds.
    pub fn advance(&mut self, dt: f64) {
        let planes: Vec<Plane> = self
            .bodies
            .iter()
            .filter_map(|b| if let Body::Wall(p) = &b.body { Some(*p) } else { None })
            .collect();
        let walls: Vec<&dyn Wall> = planes.iter().map(|p| p as &dyn Wall).collect();
        for named in &mut self.bodies {
            if let Body::Fluid(f) = &mut named.body {
                let Formulation::Corrected(s) = f.formulation;
                let sweep = f.move_corrected(&s, &walls, dt);
                f.push_corrected(&sweep, &walls, dt, self.time + dt);
                f.kick(0.5 * dt);
            }
        }
        self.time += dt;
        self.step += 1;
    }
}
