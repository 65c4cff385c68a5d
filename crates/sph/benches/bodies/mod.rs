//! Small bodies that the benchmarks step: water that swirls, steel that is squeezed until it yields.

use erode_physics::Elastic;
use erode_physics::eos::Tait;
use erode_physics::material_point::Material;
use erode_physics::strength::{JohnsonCook, Strength};
use erode_sph::Geometry;
use erode_sph::fluid::ghosts::Plane;
use erode_sph::fluid::{Fluid, Formulation, Start, corrected};
use erode_sph::geometry::Vec2;
use erode_sph::neighbours::compact_order;
use erode_sph::solid::{Block, Face, Numerics, Setup, Solid, SolidError};
use erode_sph::world::{Body, Named, World, WorldError};

/// Side of the square that is filled, m.
const SIDE: f64 = 1e-3;

/// Centres of the cells of a square of `across` by `across`, in the order in which runs keep particles, and their area.
pub(crate) fn lattice(across: usize) -> (Vec<Vec2>, f64) {
    let dx = SIDE / across as f64;
    let place = |k: usize| [k % across, k / across].map(|i| (i as f64 + 0.5) * dx);
    let position: Vec<Vec2> = (0..across * across).map(place).collect();
    let order = compact_order(&position);
    let sorted = order.iter().map(|&i| position[i as usize]).collect();
    (sorted, dx * dx)
}

/// Water in a box.
///
/// # Errors
/// Never: it is alone.
pub(crate) fn water(across: usize) -> Result<World, WorldError> {
    let (position, area) = lattice(across);
    let mut fluid = Fluid::new(&Start {
        geometry: Geometry::Plane,
        eos: Tait {
            reference_density: 1000.0,
            sound_speed: 1450.0,
            gamma: 7.15,
        },
        position: &position,
        area: &vec![area; position.len()],
        pressure: 50e6,
        velocity: [0.0; 2],
        formulation: Formulation::Corrected(corrected::Settings::default()),
    });
    for (v, x) in fluid.velocity.iter_mut().zip(&position) {
        let [a, b] = x.map(|x| std::f64::consts::TAU * x / SIDE);
        *v = [-20.0 * a.sin() * b.cos(), 20.0 * a.cos() * b.sin()];
    }
    for normal in [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]] {
        fluid.sides.push(Plane {
            normal,
            offset: (normal[0] + normal[1]).min(0.0) * SIDE,
            speed: 0.0,
        });
    }
    alone(Body::Fluid(fluid))
}

/// Steel between two symmetry planes.
///
/// # Errors
/// Never: the block is a right one.
pub(crate) fn steel(across: usize) -> Result<Solid, SolidError> {
    let (position, area) = lattice(across);
    let mut solid = Solid::new(Setup {
        geometry: Geometry::Plane,
        block: Block {
            lower: [0.0; 2],
            upper: [SIDE; 2],
            left: Face::Symmetry,
            right: Face::Traction,
            bottom: Face::Symmetry,
            top: Face::Traction,
        },
        material: Material {
            elastic: Elastic {
                young_modulus: 186e9,
                poisson_ratio: 0.3,
            },
            strength: Strength::JohnsonCook(JohnsonCook {
                a: 508e6,
                b: 832e6,
                n: 0.29,
                c: 0.031,
                reference_rate: 4e-4,
                thermal: None,
            }),
            density: 7800.0,
            temperature: 293.0,
        },
        numerics: Numerics::default(),
        area: vec![area; position.len()],
        position,
    })?;
    let rate = -5e-4 / solid.stable_time_step().dt;
    for (v, x) in solid.state.velocity.iter_mut().zip(&solid.state.position) {
        *v = [0.0, rate * x[1]];
    }
    Ok(solid)
}

/// A world of one body.
///
/// # Errors
/// Never: it is alone.
pub(crate) fn alone(body: Body) -> Result<World, WorldError> {
    let name = "body".to_owned();
    World::new(vec![Named { name, body }], 0.3)
}
