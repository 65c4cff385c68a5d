//! The standard workloads.

use super::BenchError;
use super::subject::{Liquid, SolidInSpace, Subject};
use crate::case::Case;
use crate::materials::{Library, Material, Terms};
use crate::run;
use erode_physics::material_point;
use erode_sph::Geometry;
use erode_sph::fluid::ghosts::Plane;
use erode_sph::fluid::{Fluid, Formulation, Start, corrected};
use erode_sph::neighbours::compact_order;
use erode_sph::phases::Phases;
use erode_sph::solid::{Block, Face, Numerics, Setup, Solid, space};
use erode_sph::world::{Body, Named, World};
use std::f64::consts::PI;

/// Side of the square that is filled with particles, m.
const SIDE: f64 = 1e-3;

/// What is stepped, and how often.
#[derive(Debug)]
pub struct Workload {
    /// Unique name.
    pub name: &'static str,
    /// In words.
    pub description: &'static str,
    /// Particles; for the mixture particles per radius of the bubble.
    pub particles: usize,
    /// Steps before the measured ones.
    pub warm_up: usize,
    /// Measured steps.
    pub steps: usize,
    /// Whether it is measured unasked.
    pub usual: bool,
    /// Asked rate of one thread, 1e6 particle-steps/s.
    pub target: Option<f64>,
    /// From the number of particles to what is stepped.
    pub(super) build: fn(usize) -> Result<Box<dyn Subject>, BenchError>,
}

const LIQUID: Workload = Workload {
    name: "liquid-plane",
    description: "water in a square box, plane, swirling at up to 20 m/s",
    particles: 100_000,
    warm_up: 12,
    steps: 30,
    usual: true,
    target: Some(8.0),
    build: |n| boxed(liquid(Geometry::Plane, n)),
};

const LIQUID_RINGS: Workload = Workload {
    name: "liquid-axisymmetric",
    description: "water in a cylinder, axisymmetric, swirling at up to 20 m/s",
    build: |n| boxed(liquid(Geometry::Axisymmetric, n)),
    ..LIQUID
};

const SOLID: Workload = Workload {
    name: "solid-plane",
    description: "A-2205 steel with Johnson-Cook law, plane strain, total Lagrangian, squeezed until all of it yields",
    steps: 60,
    target: Some(6.0),
    build: |n| boxed(solid(Geometry::Plane, n)),
    ..LIQUID
};

const LIQUID_GRADED: Workload = Workload {
    name: "liquid-graded",
    description: "the same in the plane, spacing graded 1:8 as in the main case",
    build: |n| boxed(graded_liquid(n)),
    ..LIQUID
};

const LIQUID_SPACE: Workload = Workload {
    name: "liquid-space",
    description: "water in a cube, three dimensions, swirling at up to 20 m/s",
    steps: 10,
    target: Some(2.5),
    build: |n| boxed(liquid_in_space(n)),
    ..LIQUID
};

const SOLID_SPACE: Workload = Workload {
    name: "solid-space",
    description: "the same steel in a cube, three dimensions, drawn out until all of it yields",
    steps: 30,
    target: Some(1.4),
    build: |n| boxed(solid_in_space(n)),
    ..LIQUID
};

const MIXTURE: Workload = Workload {
    name: "main-case",
    description: "bubble next to steel, 30 particles per radius: graded liquid and solid with their interface",
    particles: 30,
    warm_up: 12,
    steps: 30,
    usual: true,
    target: None,
    build: |n| boxed(mixture(n)),
};

/// All workloads.
pub const ALL: [Workload; 14] = [
    LIQUID,
    LIQUID_RINGS,
    LIQUID_GRADED,
    LIQUID_SPACE,
    SOLID,
    Workload {
        name: "solid-axisymmetric",
        description: "the same steel, axisymmetric",
        build: |n| boxed(solid(Geometry::Axisymmetric, n)),
        ..SOLID
    },
    SOLID_SPACE,
    MIXTURE,
    Workload {
        name: "liquid-plane-1m",
        particles: 1_000_000,
        steps: 10,
        usual: false,
        ..LIQUID
    },
    Workload {
        name: "liquid-axisymmetric-1m",
        particles: 1_000_000,
        steps: 10,
        usual: false,
        ..LIQUID_RINGS
    },
    Workload {
        name: "liquid-space-1m",
        particles: 1_000_000,
        warm_up: 4,
        steps: 5,
        usual: false,
        ..LIQUID_SPACE
    },
    Workload {
        name: "liquid-space-4m",
        particles: 4_000_000,
        warm_up: 2,
        steps: 5,
        usual: false,
        ..LIQUID_SPACE
    },
    Workload {
        name: "solid-space-1m",
        particles: 1_000_000,
        steps: 10,
        usual: false,
        ..SOLID_SPACE
    },
    Workload {
        name: "main-case-60",
        description: "bubble next to steel, 60 particles per radius",
        particles: 60,
        steps: 15,
        usual: false,
        ..MIXTURE
    },
];

/// Centres of about `n` cells of a square, in the order in which a run keeps its particles, and their area.
fn lattice(n: usize) -> (Vec<[f64; 2]>, f64) {
    let across = (n as f64).sqrt().round().max(1.0) as usize;
    let dx = SIDE / across as f64;
    let place = |k: usize| [k % across, k / across].map(|i| (i as f64 + 0.5) * dx);
    let position: Vec<[f64; 2]> = (0..across * across).map(place).collect();
    let order = compact_order(&position);
    let sorted = order.iter().map(|&i| position[i as usize]).collect();
    (sorted, dx * dx)
}

fn named(name: &str) -> Result<Material, BenchError> {
    let library = Library::embedded()?;
    let found = library.get(name).cloned();
    found.ok_or_else(|| BenchError::Material(format!("the library has no `{name}`")))
}

fn missing(what: Vec<String>) -> BenchError {
    BenchError::Material(format!("the library does not give {}", what.join(", ")))
}

fn alone(name: &str, body: Body) -> Result<World, BenchError> {
    let name = name.to_owned();
    Ok(World::new(vec![Named { name, body }], 0.3)?)
}

fn boxed(
    subject: Result<impl Subject + 'static, BenchError>,
) -> Result<Box<dyn Subject>, BenchError> {
    Ok(Box::new(subject?))
}

/// Columns of about `n` particles in all, with a spacing that grows from one side of the square to the other by a factor of
/// eight; their areas.
fn graded(n: usize) -> (Vec<[f64; 2]>, Vec<f64>) {
    const RATIO: f64 = 8.0;
    // n = SIDE times the integral of 1/s^2 with s = s0 (1 + (RATIO - 1) x/SIDE).
    let finest = SIDE / (n as f64 * RATIO).sqrt();
    let spacing = |x: f64| finest * (1.0 + (RATIO - 1.0) * x / SIDE);
    let mut edges = vec![0.0];
    let mut x = 0.0;
    while x < SIDE {
        x += spacing(x + 0.5 * spacing(x));
        edges.push(x);
    }
    // The columns fill the square.
    let scale = SIDE / x;
    let (mut position, mut area) = (Vec::new(), Vec::new());
    for ends in edges.windows(2) {
        let (width, middle) = (
            scale * (ends[1] - ends[0]),
            0.5 * scale * (ends[0] + ends[1]),
        );
        let rows = (SIDE / width).round().max(1.0);
        let height = SIDE / rows;
        for j in 0..rows as usize {
            position.push([middle, (j as f64 + 0.5) * height]);
            area.push(width * height);
        }
    }
    let order = compact_order(&position);
    let pick = |i: &u32| (position[*i as usize], area[*i as usize]);
    order.iter().map(pick).unzip()
}

fn graded_liquid(n: usize) -> Result<World, BenchError> {
    let (position, area) = graded(n);
    liquid_of(Geometry::Plane, &position, &area)
}

/// Two swirls between rigid walls, which shifting, exchange and dissipation act on.
pub(super) fn liquid(geometry: Geometry, n: usize) -> Result<World, BenchError> {
    let (position, area) = lattice(n);
    liquid_of(geometry, &position, &vec![area; position.len()])
}

fn liquid_of(geometry: Geometry, position: &[[f64; 2]], area: &[f64]) -> Result<World, BenchError> {
    const SPEED: f64 = 20.0;
    let mut fluid = Fluid::new(&Start {
        geometry,
        eos: named("water")?.fluid().map_err(missing)?,
        position,
        area,
        pressure: 50e6,
        velocity: [0.0; 2],
        formulation: Formulation::Corrected(corrected::Settings::default()),
    });
    for (v, x) in fluid.velocity.iter_mut().zip(position) {
        let [a, b] = x.map(|x| 2.0 * PI * x / SIDE);
        *v = [-SPEED * a.sin() * b.cos(), SPEED * a.cos() * b.sin()];
    }
    let sides = [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]].map(|normal: [f64; 2]| Plane {
        normal,
        offset: (normal[0] + normal[1]).min(0.0) * SIDE,
        speed: 0.0,
    });
    // The axis is found by the particles themselves.
    let first = usize::from(geometry == Geometry::Axisymmetric);
    fluid.sides.extend_from_slice(&sides[first..]);
    alone("liquid", Body::Fluid(fluid))
}

/// The same swirls in a cube, with a speed that varies along the third coordinate.
fn liquid_in_space(n: usize) -> Result<Liquid, BenchError> {
    const SPEED: f64 = 20.0;
    let across = (n as f64).cbrt().round().max(1.0) as usize;
    let dx = SIDE / across as f64;
    let place = |k: usize| [k % across, k / across % across, k / (across * across)];
    let centre = |k: usize| place(k).map(|i| (i as f64 + 0.5) * dx);
    let lattice: Vec<[f64; 3]> = (0..across.pow(3)).map(centre).collect();
    let order = compact_order(&lattice);
    let position: Vec<[f64; 3]> = order.iter().map(|&i| lattice[i as usize]).collect();
    let mut fluid = Fluid::new(&Start {
        geometry: Geometry::Plane,
        eos: named("water")?.fluid().map_err(missing)?,
        position: &position,
        area: &vec![dx.powi(3); position.len()],
        pressure: 50e6,
        velocity: [0.0; 3],
        formulation: Formulation::Corrected(corrected::Settings::default()),
    });
    for (v, x) in fluid.velocity.iter_mut().zip(&position) {
        let [a, b, c] = x.map(|x| 2.0 * PI * x / SIDE);
        let speed = SPEED * c.cos();
        *v = [-speed * a.sin() * b.cos(), speed * a.cos() * b.sin(), 0.0];
    }
    for k in 0..3 {
        for sign in [1.0, -1.0] {
            let mut normal = [0.0; 3];
            normal[k] = sign;
            fluid.sides.push(Plane {
                normal,
                offset: f64::min(sign, 0.0) * SIDE,
                speed: 0.0,
            });
        }
    }
    Ok(Liquid {
        fluid,
        time: 0.0,
        phases: Phases::default(),
    })
}

fn steel() -> Result<material_point::Material, BenchError> {
    let terms = Terms {
        strain_rate: true,
        thermal_softening: false,
    };
    let (density, elastic, strength) = named("steel_a2205")?.solid(terms).map_err(missing)?;
    Ok(material_point::Material {
        elastic,
        strength,
        density,
        temperature: 293.0,
    })
}

/// A cube that is drawn out along its height, and in across, at a rate that makes it yield within about ten steps.
fn solid_in_space(n: usize) -> Result<SolidInSpace, BenchError> {
    const STRAIN_PER_STEP: f64 = 5e-4;
    let across = (n as f64).cbrt().round().max(1.0) as usize;
    let setup = space::Setup::lattice(steel()?, [across; 3], SIDE / across as f64);
    let mut solid = space::SpaceSolid::new(&setup)?;
    drop(setup);
    let rate = STRAIN_PER_STEP / solid.stable_time_step().dt;
    for a in 0..solid.len() {
        let [x, y, z] = solid.reference_position(a);
        let v = [-0.5 * rate * x, -0.5 * rate * y, rate * z];
        solid.state.velocity.set(a, v);
    }
    solid.accelerations(0.0);
    Ok(SolidInSpace {
        solid,
        phases: Phases::default(),
    })
}

/// A block that is squeezed along its height at a rate that makes it yield within about ten steps.
pub(super) fn solid(geometry: Geometry, n: usize) -> Result<World, BenchError> {
    const STRAIN_PER_STEP: f64 = -5e-4;
    let (position, area) = lattice(n);
    let left = if geometry == Geometry::Axisymmetric {
        Face::Axis
    } else {
        Face::Symmetry
    };
    let mut solid = Solid::new(Setup {
        geometry,
        block: Block {
            lower: [0.0; 2],
            upper: [SIDE; 2],
            left,
            right: Face::Traction,
            bottom: Face::Symmetry,
            top: Face::Traction,
        },
        material: steel()?,
        numerics: Numerics::default(),
        area: vec![area; position.len()],
        position,
    })?;
    let rate = STRAIN_PER_STEP / solid.stable_time_step().dt;
    for (v, x) in solid.state.velocity.iter_mut().zip(&solid.state.position) {
        *v = [0.0, rate * x[1]];
    }
    alone("steel", Body::Solid(solid))
}

/// The main case at its start.
fn mixture(per_radius: usize) -> Result<World, BenchError> {
    const CASE: &str = include_str!("../../../../cases/bubble-near-steel/case.toml");
    let resolution = format!("setup.bubble_near_wall.particles_per_radius={per_radius}");
    let simulation = Case::parse("case.toml", CASE, &[resolution]).map_err(run::RunError::Case)?;
    Ok(run::world(&simulation)?)
}
