//! One simulated collapse.

use super::history::{self, Sample};
use crate::validate::Failure;
use crate::validate::materials::water;
use erode_sph::Geometry;
use erode_sph::cavity::{Colour, Window, fronts};
use erode_sph::fluid::corrected::Settings;
use erode_sph::fluid::far_field::FarField;
use erode_sph::fluid::ghosts::{Ghosts, Plane};
use erode_sph::fluid::refinement::Refinement;
use erode_sph::fluid::{Fluid, Formulation, Start};
use erode_sph::packing::{Options, Packing, Spacing, pack};
use erode_sph::shapes::{Region, Shape};
use erode_sph::world::{Body, Named, World};

/// Radius at the start, m.
pub(super) const R0: f64 = 0.095e-3;

/// Sound speed of the reference at zero pressure, m/s.
pub(super) const C0: f64 = 1500.0;

/// Pressure at the start and far away, Pa.
const PRESSURE: f64 = 60e6;

/// Half of the domain; an echo of its sides would arrive after the collapse: (5 + 4) R0 at c > c0 > 5.24 R0.
const DOMAIN: f64 = 5.0 * R0;

/// The finest spacing reaches to this distance.
const CORE: f64 = 1.4 * R0;

/// Growth of the spacing at 30 particles per radius; it scales with 1/n so that the whole family refines.
const GROWTH: f64 = 0.06;

/// Steps between two looks at the cavity: above and below this radius, R/R0.
const LOOK: (u64, u64, f64) = (4, 1, 0.6);

/// More steps mean that the collapse does not end.
const MOST_STEPS: u64 = 100_000;

/// A finished run.
#[derive(Debug, Clone)]
pub(super) struct Collapse {
    pub(super) n: usize,
    /// Particles per radius kept by refinement.
    pub(super) refined: Option<usize>,
    /// At the start and at most.
    pub(super) particles: [usize; 2],
    pub(super) steps: u64,
    pub(super) samples: Vec<Sample>,
}

impl Collapse {
    fn absent(&self, radius: f64) -> Failure {
        let name = self.name();
        Failure::Absent(format!(
            "the run with {name} has no value at R = {radius} R0"
        ))
    }

    /// As in tables.
    pub(super) fn name(&self) -> String {
        match self.refined {
            None => format!("n = {}", self.n),
            Some(kept) => format!("n = {}, refined to {kept} per R", self.n),
        }
    }

    /// Time at a radius (R/R0), s.
    pub(super) fn time_at(&self, radius: f64) -> Result<f64, Failure> {
        history::time_at(&self.samples, radius).ok_or_else(|| self.absent(radius))
    }

    /// Speed of the wall inwards at a radius (R/R0), m/s.
    pub(super) fn speed_at(&self, radius: f64) -> Result<f64, Failure> {
        let speed = history::speed_at(&self.samples, radius);
        speed.map(|v| v * R0).ok_or_else(|| self.absent(radius))
    }

    /// Change of energy that the ledger does not explain, at R = 0.3 R0, in units of the initial energy.
    pub(super) fn ledger_defect(&self) -> Result<f64, Failure> {
        let (start, end) = (self.samples[0], self.at(0.3)?);
        Ok((end.energy + end.balance - start.balance) / start.energy - 1.0)
    }

    /// First sample at or below a radius (R/R0).
    pub(super) fn at(&self, radius: f64) -> Result<&Sample, Failure> {
        history::sample_at(&self.samples, radius).ok_or_else(|| self.absent(radius))
    }
}

/// Smallest radius that `n` particles per radius can resolve, R/R0: the spacing grows as R^(-1/2) while the parcels are
/// drawn towards the centre; with four spacings per radius as the limit this is (4/n)^(2/3).
pub(super) fn resolved_radius(n: usize) -> f64 {
    (4.0 / n as f64).powf(2.0 / 3.0)
}

/// The default packing: lattice in the core, coarser away from it.
fn packed(dx: f64, n: f64) -> Result<Packing, Failure> {
    let region = Region::new(Shape::Rectangle {
        lower: [0.0, -DOMAIN],
        upper: [DOMAIN, DOMAIN],
    })
    .with_hole(Shape::Disc {
        centre: [0.0; 2],
        radius: R0,
    });
    let spacing = Spacing {
        finest: dx,
        coarsest: 8.0 * dx,
        growth: GROWTH * 30.0 / n,
        core: Some(Shape::Rectangle {
            lower: [0.0, -CORE],
            upper: [CORE, CORE],
        }),
    };
    Ok(pack(&region, &spacing, &Options::default())?)
}

fn start(dx: f64, n: f64) -> Result<Fluid, Failure> {
    let packing = packed(dx, n)?;
    let mut f = Fluid::new(&Start {
        geometry: Geometry::Axisymmetric,
        eos: water()?,
        position: &packing.position,
        area: &packing.area,
        pressure: PRESSURE,
        velocity: [0.0; 2],
        formulation: Formulation::Corrected(Settings::default()),
    });
    let far = FarField {
        pressure: PRESSURE,
        step_pressure: PRESSURE,
        ..FarField::NONE
    };
    for normal in [[-1.0, 0.0], [0.0, -1.0], [0.0, 1.0]] {
        let side = Plane {
            normal,
            offset: -DOMAIN,
            speed: 0.0,
        };
        f.open_side(&side, far);
    }
    Ok(f)
}

/// Radius to which a refined run goes, R/R0: a little beyond 0.1, where the speed is judged last.
const REFINED_TO: f64 = 0.085;

/// Halves particles so that `kept` of them lie in the radius that the cavity has now.
fn refinement(kept: usize) -> Refinement {
    Refinement {
        per_radius: kept as f64,
        growth: GROWTH,
        smallest: 0.05 * R0,
    }
}

/// Runs the collapse with `n` particles per radius to a little beyond the smallest resolved radius, at least to 0.27 R0;
/// with refinement to [`REFINED_TO`].
pub(super) fn run(n: usize, refined: Option<usize>) -> Result<Collapse, Failure> {
    let dx = R0 / n as f64;
    let fluid = start(dx, n as f64)?;
    let mut particles = [fluid.len(); 2];
    let name = "water".into();
    let body = Body::Fluid(fluid);
    let mut world = World::new(vec![Named { name, body }], 0.3)?;
    let smallest = match refined {
        None => (0.8 * resolved_radius(n)).min(0.27),
        Some(_) => REFINED_TO,
    };
    let asked = refined.map(refinement);
    let mut samples = vec![look(&world, dx, R0, asked)?];
    let mut radius = samples[0].radius;
    while radius > smallest {
        let steps = if radius > LOOK.2 { LOOK.0 } else { LOOK.1 };
        for _ in 0..steps {
            let dt = world.stable_time_step().0;
            world.advance(dt)?;
            if let Some(asked) = &asked {
                particles[1] = particles[1].max(refine(&mut world, asked, dx, radius * R0));
            }
        }
        let sample = look(&world, dx, radius * R0, asked)?;
        radius = sample.radius;
        samples.push(sample);
        if world.step > MOST_STEPS {
            let problem = format!("no collapse after {MOST_STEPS} steps: radius {radius} R0");
            return Err(Failure::Absent(problem));
        }
    }
    Ok(Collapse {
        n,
        refined,
        particles,
        steps: world.step,
        samples,
    })
}

/// Refines after a step; returns the number of particles. The cavity was of the radius `known` (m) before.
fn refine(world: &mut World, asked: &Refinement, dx: f64, known: f64) -> usize {
    let step = world.step;
    let Some(Body::Fluid(f)) = world.bodies.first_mut().map(|b| &mut b.body) else {
        return 0;
    };
    if Refinement::is_due(step) {
        let found = fronts(f, &[], window(known, dx, 0.5 * dx), asked.smallest);
        f.refine(asked, &found, step);
    }
    f.len()
}

/// Around a cavity of the radius `known` (m).
fn window(known: f64, dx: f64, cell: f64) -> Window {
    let reach = 1.1 * known + 8.0 * dx;
    Window {
        lower: [0.0, -reach],
        upper: [reach, reach],
        cell,
    }
}

/// Size and shape of the cavity, which was of the radius `known` (m) before, and the energies of the water.
fn look(world: &World, dx: f64, known: f64, asked: Option<Refinement>) -> Result<Sample, Failure> {
    let Some(Body::Fluid(f)) = world.bodies.first().map(|b| &b.body) else {
        return Err(Failure::Absent("there is no water".into()));
    };
    // Half of the finest spacing.
    let finest = asked.map_or(dx, |r| dx.min(known / r.per_radius));
    let window = window(known, dx, 0.5 * finest);
    let colour = Colour::new(f, &Ghosts::find(f, &[]), window);
    let cavity = colour.cavities(2).into_iter().next();
    let volume = cavity.map_or(0.0, |c| c.volume);
    let radii = colour.radii([0.0; 2], 16);
    let largest = radii.iter().copied().fold(0.0, f64::max);
    let least = radii.iter().copied().fold(f64::INFINITY, f64::min);
    let radius = (0.75 * volume / std::f64::consts::PI).cbrt();
    let account = &f.account;
    Ok(Sample {
        time: world.time,
        radius: radius / R0,
        roundness: (largest - least) / radius,
        energy: f.kinetic_energy() + f.compression_energy(),
        balance: account.dissipation - account.far_field_work,
    })
}
