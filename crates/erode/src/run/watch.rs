//! The watch for instabilities: what no liquid or metal can do, and what is told about it.

use super::monitor::Record;
use super::{RunError, probes};
use crate::case::Bubble;
use crate::output::{OutputError, RunPaths, write_failure};
use erode_sph::fluid::Fluid;
use erode_sph::geometry::Vec2;
use erode_sph::solid::Solid;
use erode_sph::world::{Body, Limiter, World, WorldError};
use rayon::prelude::*;

/// A step shorter than this share of the first one is a collapse of the calculation.
const SHORTEST_STEP: f64 = 1e-4;

/// Density of a liquid in units of the one at rest: below, it is a void; above, no pressure of a collapse can press it so.
const DENSITY_RANGE: (f64, f64) = (0.02, 4.0);

/// Largest speed in a liquid in units of its sound speed at rest: ten times that of the fastest jets.
const FASTEST_LIQUID: f64 = 20.0;

/// Largest speed in a metal in units of its longitudinal wave speed: the strain that comes with it is of order one.
const FASTEST_METAL: f64 = 1.0;

/// Largest energy from or to nowhere, in units of what went in or of the energy of the bubble, whichever is more (at the
/// very start next to nothing went in). A sound run of a few particles per radius stays three times below.
const LARGEST_DRIFT: f64 = 0.3;

/// Something that cannot be: what, and where (m).
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Finding {
    what: String,
    position: Vec2,
}

/// A step that is too short to go on with.
#[must_use]
pub(crate) fn short_step(dt: f64, first: f64, limiter: &Limiter) -> Option<Finding> {
    // Written so that a step that is not a number counts as well.
    let fine = dt > SHORTEST_STEP * first;
    (!fine).then(|| Finding {
        what: format!(
            "the stable time step of particle {} fell to {dt:.3e} s, below {SHORTEST_STEP:.0e} of the first one ({first:.3e} s)",
            limiter.particle
        ),
        position: limiter.position,
    })
}

/// A step that failed, unless it is the setup that is wrong.
///
/// # Errors
/// The error itself when it is none of the calculation.
pub(crate) fn failed_step(error: WorldError, limiter: &Limiter) -> Result<Finding, RunError> {
    let position = match &error {
        WorldError::NotFinite { position, .. } => Some(*position),
        WorldError::Solid { source, .. } => source.position(),
        WorldError::Missing { .. } => return Err(error.into()),
    };
    // Without a place of its own, the particle that limits the step is the best guess.
    let position = position
        .filter(|x| x[0].is_finite() && x[1].is_finite())
        .unwrap_or(limiter.position);
    Ok(Finding {
        what: error.to_string(),
        position,
    })
}

/// A state that no body can have.
#[must_use]
pub(crate) fn implausible(world: &World) -> Option<Finding> {
    world.bodies.iter().find_map(|named| match &named.body {
        Body::Fluid(f) => implausible_liquid(f, &named.name),
        Body::Solid(s) => implausible_metal(s, &named.name),
    })
}

/// A ledger that does not close by far: a growth that is too slow to be seen in single particles.
#[must_use]
pub(crate) fn open_ledger(
    world: &World,
    record: &Record,
    bubble: Option<&Bubble>,
) -> Option<Finding> {
    // Without a bubble nothing tells how much energy is much at the start.
    let energy = record.initial_volume * bubble?.driving_pressure;
    let share = record.energy_drift / record.energy_scale.max(energy);
    if share.abs() <= LARGEST_DRIFT {
        return None;
    }
    let (where_to_look, position) = fastest(world)?;
    let what = format!(
        "`energy_residual` is {:+.3e} J, {:+.1} % of the energy put in (plausible: up to {:.0} %); the fastest: {where_to_look}",
        record.energy_drift,
        100.0 * share,
        100.0 * LARGEST_DRIFT
    );
    Some(Finding { what, position })
}

/// The particle that moves fastest in units of the wave speed of its body, in words, and its place.
fn fastest(world: &World) -> Option<(String, Vec2)> {
    let all = world.bodies.iter().flat_map(|named| {
        let (position, velocity, wave) = match &named.body {
            Body::Fluid(f) => (&f.position, &f.velocity, f.eos.sound_speed),
            Body::Solid(s) => (&s.state.position, &s.state.velocity, wave_speed(s)),
        };
        let particles = position.iter().zip(velocity).enumerate();
        particles.map(move |(a, (x, v))| {
            (
                v[0].hypot(v[1]) / wave,
                v[0].hypot(v[1]),
                a,
                &named.name,
                *x,
            )
        })
    });
    let (_, speed, particle, body, x) = all.max_by(|a, b| a.0.total_cmp(&b.0))?;
    Some((
        told("velocity", particle, body, x, &format!("{speed:.4e} m/s")),
        x,
    ))
}

fn wave_speed(s: &Solid) -> f64 {
    s.wave_speed()
}

fn implausible_liquid(f: &Fluid, body: &str) -> Option<Finding> {
    let particles = (0..f.len()).into_par_iter().with_min_len(1024);
    particles.find_map_first(|a| {
        let (density, position) = (f.density(a), f.position[a]);
        let ratio = density / f.eos.reference_density;
        if !(ratio > DENSITY_RANGE.0 && ratio < DENSITY_RANGE.1) {
            let (low, high) = DENSITY_RANGE;
            let value = format!(
                "{density:.4e} kg/m3, {ratio:.3} times that at rest (plausible: {low} to {high})"
            );
            return Some(Finding {
                what: told("density", a, body, position, &value),
                position,
            });
        }
        too_fast(
            f.velocity[a],
            FASTEST_LIQUID,
            f.eos.sound_speed,
            "sound speed",
        )
        .map(|value| Finding {
            what: told("velocity", a, body, position, &value),
            position,
        })
    })
}

fn implausible_metal(s: &Solid, body: &str) -> Option<Finding> {
    let wave = wave_speed(s);
    let particles = (0..s.len()).into_par_iter().with_min_len(1024);
    particles.find_map_first(|a| {
        let position = s.state.position[a];
        too_fast(
            s.state.velocity[a],
            FASTEST_METAL,
            wave,
            "longitudinal wave speed",
        )
        .map(|value| Finding {
            what: told("velocity", a, body, position, &value),
            position,
        })
    })
}

/// The speed in words if it is more than `factor` times that of a wave.
fn too_fast(v: Vec2, factor: f64, wave: f64, name: &str) -> Option<String> {
    let speed = (v[0] * v[0] + v[1] * v[1]).sqrt();
    (speed > factor * wave).then(|| {
        format!(
            "{speed:.4e} m/s, {:.1} times the {name} (plausible: up to {factor})",
            speed / wave
        )
    })
}

fn told(field: &str, particle: usize, body: &str, x: Vec2, value: &str) -> String {
    format!(
        "`{field}` of particle {particle} in body `{body}` at r = {:.4e} m, z = {:.4e} m is {value}",
        x[0], x[1]
    )
}

/// The step in which a calculation failed.
pub(crate) struct Step<'a> {
    pub(crate) dt: f64,
    pub(crate) limiter: &'a Limiter,
    /// Time step / stable time step asked for.
    pub(crate) safety: f64,
    /// How far around the place particles are of interest, m.
    pub(crate) radius: f64,
}

impl Finding {
    /// The error that tells of it; the particles around the place go to `failure.vtu`.
    #[must_use]
    pub(crate) fn into_error(self, world: &World, step: &Step<'_>, paths: &RunPaths) -> RunError {
        let pictures = match self.write_surroundings(world, step.radius, paths) {
            Ok(names) => format!("the particles around the place are in {names}"),
            Err(e) => format!("the particles around the place could not be written: {e}"),
        };
        let (limiter, p) = (step.limiter, step.limiter.position);
        let named = &world.bodies[limiter.body].name;
        RunError::Unstable {
            what: self.what,
            time: world.time,
            step: world.step,
            dt: step.dt,
            limiter: format!(
                "{} (particle {} in body `{named}` at r = {:.4e} m, z = {:.4e} m)",
                limiter.reason, limiter.particle, p[0], p[1]
            ),
            causes: format!(
                "{}\n  {pictures}; the last good checkpoint is kept",
                causes(step.safety)
            ),
        }
    }

    /// Names of the files, one for each body.
    fn write_surroundings(
        &self,
        world: &World,
        radius: f64,
        paths: &RunPaths,
    ) -> Result<String, OutputError> {
        let mut names = Vec::new();
        for (i, named) in world.bodies.iter().enumerate() {
            let name = if i == 0 {
                "failure.vtu".to_owned()
            } else {
                format!("failure_{}.vtu", named.name)
            };
            let snapshot = probes::snapshot(&named.body, world.time);
            write_failure(
                &paths.failure().with_file_name(&name),
                &snapshot,
                [self.position[0], self.position[1], 0.0],
                radius,
            )?;
            names.push(name);
        }
        Ok(names.join(", "))
    }
}

/// Above this safety a time step is the likely cause of an instability.
const USUAL_SAFETY: f64 = 0.3;

fn causes(safety: f64) -> String {
    let others = "too few particles across the jet, or a load beyond the range of the material";
    if safety > USUAL_SAFETY {
        let factor = safety / USUAL_SAFETY;
        format!(
            "likely cause: the time step is {factor:.1} times the usual one (run.safety = {safety}; {USUAL_SAFETY} is usual); \
             otherwise {others}"
        )
    } else {
        format!(
            "likely causes: {others}; a smaller step (run.safety is {safety}) tells whether it is the step"
        )
    }
}
