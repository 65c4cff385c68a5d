//! The standard workloads.

use super::BenchError;
use crate::case::Case;
use crate::materials::{Library, Material, Terms};
use crate::run;
use erode_physics::material_point;
use erode_sph::Geometry;
use erode_sph::fluid::ghosts::Plane;
use erode_sph::fluid::{Fluid, Formulation, Start, corrected};
use erode_sph::neighbours::compact_order;
use erode_sph::solid::{Block, Face, Numerics, Setup, Solid};
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
    /// Measured steps.
    pub steps: usize,
    /// Whether it is measured unasked.
    pub usual: bool,
    /// Asked rate of one thread, 1e6 particle-steps/s.
    pub target: Option<f64>,
    /// From the number of particles to a world.
    pub(super) build: fn(usize) -> Result<World, BenchError>,
}

/// What a complete list would have and this version lacks.
pub const ABSENT: [&str; 1] =
    ["3D (liquid and solid): this version has no motion in three dimensions"];

const LIQUID: Workload = Workload {
    name: "liquid-plane",
    description: "water in a square box, plane, swirling at up to 20 m/s",
    particles: 100_000,
    steps: 30,
    usual: true,
    target: Some(8.0),
    build: |n| liquid(Geometry::Plane, n),
};

const LIQUID_RINGS: Workload = Workload {
    name: "liquid-axisymmetric",
    description: "water in a cylinder, axisymmetric, swirling at up to 20 m/s",
    build: |n| liquid(Geometry::Axisymmetric, n),
    ..LIQUID
};

const SOLID: Workload = Workload {
    name: "solid-plane",
    description: "A-2205 steel with Johnson-Cook law, plane strain, total Lagrangian, squeezed until all of it yields",
    steps: 60,
    target: Some(6.0),
    build: |n| solid(Geometry::Plane, n),
    ..LIQUID
};

const MIXTURE: Workload = Workload {
    name: "main-case",
    description: "bubble next to steel, 30 particles per radius: graded liquid and solid with their interface",
    particles: 30,
    steps: 30,
    usual: true,
    target: None,
    build: mixture,
};

/// All workloads.
pub const ALL: [Workload; 8] = [
    LIQUID,
    LIQUID_RINGS,
    SOLID,
    Workload {
        name: "solid-axisymmetric",
        description: "the same steel, axisymmetric",
        build: |n| solid(Geometry::Axisymmetric, n),
        ..SOLID
    },
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

/// Two swirls between rigid walls, which shifting, exchange and dissipation act on.
fn liquid(geometry: Geometry, n: usize) -> Result<World, BenchError> {
    const SPEED: f64 = 20.0;
    let (position, area) = lattice(n);
    let mut fluid = Fluid::new(&Start {
        geometry,
        eos: named("water")?.fluid().map_err(missing)?,
        position: &position,
        area: &vec![area; position.len()],
        pressure: 50e6,
        velocity: [0.0; 2],
        formulation: Formulation::Corrected(corrected::Settings::default()),
    });
    for (v, x) in fluid.velocity.iter_mut().zip(&position) {
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

/// A block that is squeezed along its height at a rate that makes it yield within about ten steps.
fn solid(geometry: Geometry, n: usize) -> Result<World, BenchError> {
    const STRAIN_PER_STEP: f64 = -5e-4;
    let (position, area) = lattice(n);
    let terms = Terms {
        strain_rate: true,
        thermal_softening: false,
    };
    let (density, elastic, strength) = named("steel_a2205")?.solid(terms).map_err(missing)?;
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
        material: material_point::Material {
            elastic,
            strength,
            density,
            temperature: 293.0,
        },
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
