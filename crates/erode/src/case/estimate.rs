//! Size and cost of a case before it runs.

use super::{
    body::Built,
    error::Findings,
    simulation::{Body, BodyKind, Refinement, Side, Simulation},
};
use erode_sph::{
    Geometry,
    packing::{SMOOTHING, estimate_count},
    shapes::Region,
};

/// Memory of one particle with its neighbours and the states kept for checkpoints, bytes.
pub const BYTES_PER_PARTICLE: f64 = 2000.0;
/// Assumed speed, particles times steps per second of wall time: the main case on two cores with AVX-512 (8105 particles, 4173
/// steps, 20 s, see docs/performance.md). The published forms take several times as long.
pub const PARTICLE_STEPS_PER_SECOND: f64 = 1.6e6;

/// Memory taken for granted where the system does not tell, bytes.
const ASSUMED_MEMORY: f64 = 64e9;

/// Size and cost of a case.
#[derive(Debug, Clone, PartialEq)]
pub struct Estimate {
    /// Particles of each body, in the order of the bodies.
    pub particles: Vec<f64>,
    /// Memory, bytes.
    pub memory: f64,
    /// Time step, s.
    pub step: f64,
    /// Body that limits the step.
    pub limited_by: String,
    /// Number of steps.
    pub steps: f64,
    /// Wall time, s.
    pub wall_time: f64,
    /// Where a liquid is refined most, if one is; steps and times above are those without it.
    pub refined: Option<Refined>,
}

/// The finest that refinement makes of a liquid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Refined {
    /// What is asked for.
    pub asked: Refinement,
    /// Spacing at the smallest radius that is followed, m.
    pub spacing: f64,
    /// Time step there, s.
    pub step: f64,
}

/// Estimates size and cost.
#[must_use]
pub fn estimate(simulation: &Simulation) -> Estimate {
    let geometry = simulation.geometry;
    let particles: Vec<f64> = simulation
        .bodies
        .iter()
        .map(|b| particles(b, geometry))
        .collect();
    let total: f64 = particles.iter().sum();
    let step_of = |b: &Body| step(b, b.spacing.finest, simulation);
    let mut limit = (f64::INFINITY, "");
    for body in &simulation.bodies {
        if step_of(body) < limit.0 {
            limit = (step_of(body), &body.name);
        }
    }
    let steps = (duration(simulation) / limit.0).ceil();
    #[allow(clippy::cast_precision_loss)]
    let steps = simulation
        .run
        .max_steps
        .map_or(steps, |m| steps.min(m as f64));
    Estimate {
        memory: total * BYTES_PER_PARTICLE,
        step: limit.0,
        limited_by: limit.1.to_owned(),
        steps,
        wall_time: total * steps / PARTICLE_STEPS_PER_SECOND,
        refined: refined(simulation),
        particles,
    }
}

fn step(body: &Body, spacing: f64, simulation: &Simulation) -> f64 {
    simulation.run.safety * SMOOTHING * spacing / wave_speed(body, simulation)
}

fn refined(simulation: &Simulation) -> Option<Refined> {
    let bubble = simulation.bubble?;
    simulation.bodies.iter().find_map(|body| {
        let BodyKind::Fluid(fluid) = &body.kind else {
            return None;
        };
        let asked = fluid.refinement()?;
        let spacing = asked.smallest * bubble.radius / asked.per_radius;
        Some(Refined {
            asked,
            spacing,
            step: step(body, spacing, simulation),
        })
    })
}

/// Simulated time of the whole run, s: of a sequence that of all impacts, with settling as long as a body needs whose motion
/// falls at half the rate of the damping.
#[must_use]
pub fn duration(simulation: &Simulation) -> f64 {
    let Some(i) = &simulation.impacts else {
        return simulation.run.end_time;
    };
    let settling = (-2.0 * i.settling.residual.ln() / i.settling.damping).min(i.settling.longest);
    i.bubbles.iter().map(|b| b.duration + settling).sum()
}

/// About how many particles fill a body.
#[must_use]
pub fn particles(body: &Body, geometry: Geometry) -> f64 {
    let region = Region {
        shape: body.shape.clone(),
        holes: body.holes.clone(),
    };
    estimate_count(&region, &body.spacing, geometry == Geometry::Axisymmetric)
}

/// Fastest signal to expect, m/s: the longitudinal wave of a solid; in a liquid the sound speed at the largest
/// pressure that is put in, and the flow that comes with it.
fn wave_speed(body: &Body, simulation: &Simulation) -> f64 {
    match &body.kind {
        BodyKind::Solid(s) => {
            let layers = s.layers.iter();
            let layers = layers.map(|l| l.elastic.longitudinal_speed(l.density));
            let own = s.elastic.longitudinal_speed(s.density);
            layers.fold(own, f64::max) + s.velocity[0].hypot(s.velocity[1])
        }
        BodyKind::Fluid(f) => {
            let waves = super::body::named(&body.sides).map(|(_, side)| match side {
                Side::NonReflecting { pressure, wave } => {
                    pressure + wave.map_or(0.0, |w| w.pressure)
                }
                _ => 0.0,
            });
            let driving = simulation.bubble.map_or(0.0, |b| b.driving_pressure);
            let highest = waves
                .into_iter()
                .fold(f.pressure.max(driving), f64::max)
                .max(0.0);
            let density = f.eos.density(highest);
            f.eos.sound_speed_at(density)
                + f.eos.riemann_integral(density)
                + f.velocity[0].hypot(f.velocity[1])
        }
    }
}

/// A case that cannot fit in memory is refused before it starts.
pub(crate) fn check_memory(bodies: &[Built], geometry: Geometry, findings: &mut Findings) {
    let counts: Vec<f64> = bodies
        .iter()
        .map(|b| particles(&b.body, geometry))
        .collect();
    let total: f64 = counts.iter().sum();
    let need = total * BYTES_PER_PARTICLE;
    let (available, how) =
        available_memory().map_or((ASSUMED_MEMORY, "assumed"), |m| (m, "available"));
    if need <= available {
        return;
    }
    let largest = (0..bodies.len()).max_by(|a, b| counts[*a].total_cmp(&counts[*b]));
    if let Some(i) = largest {
        let message = format!(
            "this resolution cannot fit in memory: about {total:.2e} particles need {}, {} are {how}",
            bytes(need),
            bytes(available)
        );
        // The particle number grows with the square of the resolution.
        let factor = (need / available).sqrt();
        let help = format!(
            "make it coarser by a factor of {:.1} or more, or grade the spacing more",
            factor * 1.05
        );
        findings.error(bodies[i].resolution, message, "too fine", help);
    }
}

/// A size for people.
#[must_use]
pub fn bytes(x: f64) -> String {
    match x {
        x if x >= 1e12 => format!("{:.1} TB", x / 1e12),
        x if x >= 1e9 => format!("{:.1} GB", x / 1e9),
        _ => format!("{:.0} MB", x / 1e6),
    }
}

/// Memory that can still be had, bytes; unknown outside Linux.
fn available_memory() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/meminfo").ok()?;
    let line = text.lines().find_map(|l| l.strip_prefix("MemAvailable:"))?;
    let machine = line.trim().strip_suffix("kB")?.trim().parse::<f64>().ok()? * 1024.0;
    let limit = std::fs::read_to_string("/sys/fs/cgroup/memory.max")
        .ok()
        .and_then(|t| t.trim().parse().ok());
    Some(limit.map_or(machine, |l: f64| l.min(machine)))
}
