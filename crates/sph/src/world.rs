//! The bodies of a simulation and the order of a step (the picture of it: docs/step.md).

use crate::departed::Departed;
use crate::fluid::ghosts::{Plane, Wall};
use crate::fluid::step::Sweep;
use crate::fluid::{Fluid, PARTICLES_PER_TASK};
use crate::geometry::Vec2;
use crate::interact::{Interaction, between};
use crate::interface::SurfaceLine;
use crate::phases::{Phase, Phases};
use crate::solid::{Side, Solid, SolidError};
use rayon::prelude::*;
use thiserror::Error;

/// A body: the closed set of what can take part.
#[derive(Debug, Clone)]
#[allow(clippy::large_enum_variant)] // a world has a handful of bodies
pub enum Body {
    /// Compressible liquid.
    Fluid(Fluid),
    /// Elastic-plastic metal; its top face meets the liquid.
    Solid(Solid),
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
    /// Step of a liquid as a fraction of h over wave speed.
    pub safety: f64,
    /// What left with liquids that were taken out.
    pub departed: Departed,
    /// Where the time of the steps went.
    pub phases: Phases,
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
    /// In words.
    pub reason: &'static str,
}

/// Why a world could not be built or advanced.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum WorldError {
    /// A pair of bodies that the table of interactions does not have.
    #[error("bodies `{first}` and `{second}` would need {what}, which this version does not have")]
    Missing {
        /// Name of a body.
        first: String,
        /// Name of the other.
        second: String,
        /// What is missing.
        what: &'static str,
    },
    /// A number that is not finite.
    #[error(
        "`{field}` of particle {particle} in body `{body}` is not a number at r = {:.4e} m, z = {:.4e} m",
        position[0],
        position[1]
    )]
    NotFinite {
        /// Body.
        body: String,
        /// Particle.
        particle: usize,
        /// Field.
        field: &'static str,
        /// Last known place, m.
        position: Vec2,
    },
    /// The solid failed.
    #[error("body `{body}`: {source}")]
    Solid {
        /// Body.
        body: String,
        /// Cause.
        source: SolidError,
    },
}

impl World {
    /// A world at rest.
    ///
    /// # Errors
    /// If two of the bodies would do to each other what the table of interactions does not have.
    pub fn new(bodies: Vec<Named>, safety: f64) -> Result<Self, WorldError> {
        for (i, a) in bodies.iter().enumerate() {
            for b in &bodies[i + 1..] {
                if let Interaction::Missing(what) = between(&a.body, &b.body) {
                    let (first, second) = (a.name.clone(), b.name.clone());
                    return Err(WorldError::Missing {
                        first,
                        second,
                        what,
                    });
                }
            }
        }
        Ok(Self {
            bodies,
            time: 0.0,
            step: 0,
            safety,
            departed: Departed::default(),
            phases: Phases::default(),
        })
    }

    /// Largest stable step (s) and what sets it.
    #[must_use]
    pub fn stable_time_step(&self) -> (f64, Limiter) {
        let mut best = (
            f64::INFINITY,
            Limiter {
                body: 0,
                particle: 0,
                position: [0.0; 2],
                reason: "nothing",
            },
        );
        for (i, named) in self.bodies.iter().enumerate() {
            let (dt, particle, position, reason) = match &named.body {
                Body::Fluid(f) => {
                    let (dt, a) = f.stable_time_step(self.safety);
                    (dt, a, f.position[a], "sound and motion in the liquid")
                }
                Body::Solid(s) => {
                    let limit = s.stable_time_step();
                    (
                        limit.dt,
                        limit.particle,
                        s.state.position[limit.particle],
                        limit.reason,
                    )
                }
            };
            if dt < best.0 {
                best = (
                    dt,
                    Limiter {
                        body: i,
                        particle,
                        position,
                        reason,
                    },
                );
            }
        }
        best
    }

    /// One step of `dt` seconds.
    ///
    /// # Errors
    /// If a solid particle turns inside out, a stress cannot be returned to the yield surface, or a number is not finite.
    pub fn advance(&mut self, dt: f64) -> Result<(), WorldError> {
        // Inside the pool of threads parallel loops begin at once; from outside each of them would have to be handed over.
        rayon::scope(|_| self.advance_all(dt))
    }

    fn advance_all(&mut self, dt: f64) -> Result<(), WorldError> {
        self.phases.start();
        self.each_solid(|s, clock| {
            s.kick_and_drift(0.5 * dt, 0.5 * dt);
            clock.lap(Phase::Integrate);
            s.follow_surfaces();
            clock.lap(Phase::Boundaries);
            Ok(())
        })?;
        let sweeps = self.move_liquids(dt);
        self.each_solid(|s, clock| {
            s.drift(0.5 * dt);
            clock.lap(Phase::Integrate);
            s.update_stress(dt)?;
            clock.lap(Phase::Sweeps);
            s.follow_surfaces();
            clock.lap(Phase::Boundaries);
            Ok(())
        })?;
        self.push_liquids(sweeps, dt);
        self.each_solid(|s, clock| {
            s.accelerations();
            clock.lap(Phase::Sweeps);
            s.kick(0.5 * dt);
            s.account(dt);
            clock.lap(Phase::Integrate);
            Ok(())
        })?;
        self.time += dt;
        self.step += 1;
        let finite = self.check_finite();
        self.phases.lap(Phase::Integrate);
        finite
    }

    fn each_solid(
        &mut self,
        mut f: impl FnMut(&mut Solid, &mut Phases) -> Result<(), SolidError>,
    ) -> Result<(), WorldError> {
        for named in &mut self.bodies {
            if let Body::Solid(s) = &mut named.body {
                f(s, &mut self.phases).map_err(|source| WorldError::Solid {
                    body: named.name.clone(),
                    source,
                })?;
            }
        }
        Ok(())
    }

    fn move_liquids(&mut self, dt: f64) -> Vec<Sweep> {
        let lines = wetted_lines(&self.bodies);
        let clock = &mut self.phases;
        let fluids = self.bodies.iter_mut().filter_map(|b| {
            if let Body::Fluid(f) = &mut b.body {
                Some(f)
            } else {
                None
            }
        });
        fluids
            .map(|f| {
                let sides = f.sides.clone();
                f.advance_positions(&walls(&sides, &lines), dt, clock)
            })
            .collect()
    }

    /// Forces on the liquids; their push on the solids.
    fn push_liquids(&mut self, sweeps: Vec<Sweep>, dt: f64) {
        if sweeps.is_empty() {
            // Without a liquid the pressures are those that the caller set.
            return;
        }
        let lines = wetted_lines(&self.bodies);
        let mut pressures: Vec<Vec<f64>> =
            lines.iter().map(|l| vec![0.0; l.position.len()]).collect();
        let (time, clock) = (self.time + dt, &mut self.phases);
        let fluids = self.bodies.iter_mut().filter_map(|b| {
            if let Body::Fluid(f) = &mut b.body {
                Some(f)
            } else {
                None
            }
        });
        for (f, sweep) in fluids.zip(sweeps) {
            let sides = f.sides.clone();
            let walls = walls(&sides, &lines);
            let ghosts = sweep.ghosts.refresh(f, &walls);
            f.follow_gas(&ghosts);
            clock.lap(Phase::Boundaries);
            f.push(sweep, &ghosts, dt, time, clock);
            for (line, sum) in lines.iter().zip(&mut pressures) {
                let push =
                    line.pressure(f.geometry, &f.position, f.reaction(), &f.smoothing_length);
                sum.iter_mut().zip(push).for_each(|(s, p)| *s += p);
                if let Some(gas) = &f.gas {
                    let push = gas.pressure_on(line);
                    sum.iter_mut().zip(push).for_each(|(s, p)| *s += p);
                }
            }
            clock.lap(Phase::Boundaries);
        }
        let mut pressures = pressures.into_iter();
        for named in &mut self.bodies {
            if let Body::Solid(s) = &mut named.body
                && let Some(surface) = s.surface_mut(Side::Top)
                && let Some(pressure) = pressures.next()
            {
                surface.pressure = pressure;
            }
        }
    }

    /// Every position and velocity is a finite number: also for what is done between steps.
    ///
    /// # Errors
    /// The first one that is not.
    pub fn check_finite(&self) -> Result<(), WorldError> {
        for named in &self.bodies {
            let (position, velocity) = match &named.body {
                Body::Fluid(f) => (&f.position, &f.velocity),
                Body::Solid(s) => (&s.state.position, &s.state.velocity),
            };
            let finite = |&(x, v): &(&Vec2, &Vec2)| (x[0] + x[1] + v[0] + v[1]).is_finite();
            let all = |(x, v): (&[Vec2], &[Vec2])| x.iter().zip(v).all(|p| finite(&p));
            let tasks = (position.par_chunks(PARTICLES_PER_TASK))
                .zip(velocity.par_chunks(PARTICLES_PER_TASK));
            if tasks.all(all) {
                continue;
            }
            if let Some(particle) = position.iter().zip(velocity).position(|p| !finite(&p)) {
                let x = position[particle];
                let field = if (x[0] + x[1]).is_finite() {
                    "velocity"
                } else {
                    "position"
                };
                return Err(WorldError::NotFinite {
                    body: named.name.clone(),
                    particle,
                    field,
                    position: x,
                });
            }
        }
        Ok(())
    }
}

/// Surfaces that wet the liquids, in the order of the bodies.
fn wetted_lines(bodies: &[Named]) -> Vec<SurfaceLine> {
    let solids = bodies.iter().filter_map(|b| {
        if let Body::Solid(s) = &b.body {
            Some(s)
        } else {
            None
        }
    });
    solids
        .filter_map(|s| s.surface(Side::Top))
        .map(SurfaceLine::of)
        .collect()
}

/// Walls of one liquid: its rigid sides, then the surfaces.
fn walls<'a>(sides: &'a [Plane], lines: &'a [SurfaceLine]) -> Vec<&'a dyn Wall> {
    let planes = sides.iter().map(|p| p as &dyn Wall);
    planes.chain(lines.iter().map(|l| l as &dyn Wall)).collect()
}
