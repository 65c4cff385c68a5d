//! From a checked case to a world of particles.

use super::{RunError, gas, loads};
use crate::case::{self, BodyKind, FluidFormulation, Side, Simulation, SolidFormulation};
use erode_physics::material_point::Material;
use erode_sph::Geometry;
use erode_sph::fluid::far_field::FarField;
use erode_sph::fluid::ghosts::Plane;
use erode_sph::fluid::{Fluid, Formulation, Start, corrected, joshi};
use erode_sph::neighbours::compact_order;
use erode_sph::packing::{Options, Packing, pack};
use erode_sph::shapes::{Region, Shape};
use erode_sph::solid::{self, Block, Face, Layer, Numerics, Setup, Solid};
use erode_sph::world::{Body, Named, World};

/// Room temperature, K: where solids start.
const TEMPERATURE: f64 = 293.0;
/// The safety for which the Courant number of solids is given: `run.safety` scales the steps of all bodies alike.
const USUAL_SAFETY: f64 = 0.3;

/// Fills all bodies with particles and sets what lies at their sides.
///
/// # Errors
/// If a body cannot be filled with its spacing, or needs what this version does not have.
pub fn world(simulation: &Simulation) -> Result<World, RunError> {
    world_with(simulation, |_, _| {})
}

/// The same; `place` may move the particles of a body before it is made of them.
///
/// # Errors
/// As [`world`].
pub(super) fn world_with(
    simulation: &Simulation,
    place: impl Fn(&case::Body, &mut Packing),
) -> Result<World, RunError> {
    let all = simulation.bodies.iter();
    let bodies = all.map(|body| built(simulation, body, |p| place(body, p)));
    let bodies = bodies.collect::<Result<Vec<_>, RunError>>()?;
    let mut world = World::new(bodies, simulation.run.safety)?;
    gas::fill(&mut world, simulation)?;
    loads::prepare(&mut world, simulation)?;
    Ok(world)
}

/// One body, without gas; `place` may move its particles before.
///
/// # Errors
/// As [`world`].
pub(super) fn built(
    simulation: &Simulation,
    body: &case::Body,
    place: impl FnOnce(&mut Packing),
) -> Result<Named, RunError> {
    let mut packing = filled(simulation.geometry, body)?;
    place(&mut packing);
    let built = match &body.kind {
        BodyKind::Fluid(f) => Body::Fluid(fluid(simulation.geometry, body, f, &packing)?),
        BodyKind::Solid(s) => Body::Solid(solid(simulation, body, s, packing)?),
    };
    Ok(Named {
        name: body.name.clone(),
        body: built,
    })
}

/// Particles in cell order.
fn filled(geometry: Geometry, body: &case::Body) -> Result<Packing, RunError> {
    let region = body
        .holes
        .iter()
        .fold(Region::new(body.shape.clone()), |r, hole| {
            r.with_hole(hole.clone())
        });
    let options = Options {
        axis: geometry == Geometry::Axisymmetric,
        ..Options::default()
    };
    let mut packing =
        pack(&region, &body.spacing, &options).map_err(|source| RunError::Packing {
            body: body.name.clone(),
            source,
        })?;
    let order = compact_order(&packing.position);
    let pick = |values: &[f64]| {
        order
            .iter()
            .map(|&i| values[i as usize])
            .collect::<Vec<f64>>()
    };
    packing.area = pick(&packing.area);
    packing.spacing = pick(&packing.spacing);
    packing.position = order
        .iter()
        .map(|&i| packing.position[i as usize])
        .collect();
    Ok(packing)
}

/// The rectangle of a body; only rectangles have sides.
fn rectangle(body: &case::Body) -> Result<([f64; 2], [f64; 2]), RunError> {
    match body.shape {
        Shape::Rectangle { lower, upper } => Ok((lower, upper)),
        Shape::Disc { .. } => Err(RunError::Unsupported {
            body: body.name.clone(),
            what: "a shape other than a rectangle (holes may be discs)".to_owned(),
        }),
    }
}

fn fluid(
    geometry: Geometry,
    body: &case::Body,
    f: &case::Fluid,
    packing: &Packing,
) -> Result<Fluid, RunError> {
    let (lower, upper) = rectangle(body)?;
    let mut fluid = Fluid::new(&Start {
        geometry,
        eos: f.eos,
        position: &packing.position,
        area: &packing.area,
        pressure: f.pressure,
        velocity: f.velocity,
        formulation: formulation(f.formulation),
    });
    let sides = &body.sides;
    let planes = [
        (&sides.left, [1.0, 0.0], lower[0]),
        (&sides.right, [-1.0, 0.0], -upper[0]),
        (&sides.bottom, [0.0, 1.0], lower[1]),
        (&sides.top, [0.0, -1.0], -upper[1]),
    ];
    for (side, normal, offset) in planes {
        let plane = Plane {
            normal,
            offset,
            speed: 0.0,
        };
        match side {
            Side::Rigid => fluid.sides.push(plane),
            Side::NonReflecting { pressure, wave } => {
                let step = wave.map_or(0.0, |w| w.pressure);
                let far = FarField {
                    pressure: *pressure,
                    step_pressure: pressure + step,
                    start: wave.map_or(0.0, |w| w.start),
                    ..FarField::NONE
                };
                fluid.open_side(&plane, far);
            }
            // The axis and interfaces are found by the particles themselves; a free side needs nothing; a case never has
            // a liquid clamped.
            Side::Axis | Side::Free | Side::Clamped | Side::Interface { .. } => {}
        }
    }
    Ok(fluid)
}

fn formulation(f: FluidFormulation) -> Formulation {
    match f {
        FluidFormulation::Corrected { shifting, .. } => {
            Formulation::Corrected(corrected::Settings {
                shifting,
                ..corrected::Settings::default()
            })
        }
        FluidFormulation::Joshi { alpha, beta } => Formulation::Joshi(joshi::Settings {
            alpha,
            beta,
            ..joshi::Settings::default()
        }),
    }
}

/// Numerical constants of a solid; its step scales with `run.safety` as that of a liquid does.
fn numerics(f: SolidFormulation, safety: f64) -> Numerics {
    let usual = Numerics::default();
    let courant = usual.courant * safety / USUAL_SAFETY;
    match f {
        SolidFormulation::TotalLagrangian {
            viscosity,
            hourglass,
            renewal,
        } => Numerics {
            viscosity,
            hourglass,
            renewal,
            courant,
            ..usual
        },
        SolidFormulation::Joshi { alpha, beta, xsph } => Numerics {
            formulation: solid::Formulation::Joshi(solid::updated::Settings {
                alpha,
                beta,
                xsph,
                axis_correction: true,
            }),
            courant,
            ..usual
        },
    }
}

fn solid(
    simulation: &Simulation,
    body: &case::Body,
    s: &case::Solid,
    packing: Packing,
) -> Result<Solid, RunError> {
    let (lower, upper) = rectangle(body)?;
    let face = |side: &Side| match side {
        Side::Axis => Face::Axis,
        Side::Rigid => Face::Symmetry,
        Side::Clamped => Face::Clamped,
        Side::NonReflecting { .. } => Face::Absorbing,
        Side::Free => Face::Free,
        Side::Interface { .. } => Face::Traction,
    };
    let sides = &body.sides;
    // A load acts on a side that is free otherwise.
    let top = if simulation.loads.presses(&body.name) {
        Face::Traction
    } else {
        face(&sides.top)
    };
    let block = Block {
        lower,
        upper,
        left: face(&sides.left),
        right: face(&sides.right),
        bottom: face(&sides.bottom),
        top,
    };
    let material = |elastic, strength, density| Material {
        elastic,
        strength,
        density,
        temperature: TEMPERATURE,
    };
    let layers = s.layers.iter().map(|l| Layer {
        thickness: l.thickness,
        material: material(l.elastic, l.strength, l.density),
        damage: l.damage,
    });
    let setup = Setup {
        geometry: simulation.geometry,
        block,
        material: material(s.elastic, s.strength, s.density),
        numerics: numerics(s.formulation, simulation.run.safety),
        position: packing.position,
        area: packing.area,
    };
    let mut solid = Solid::layered(setup, layers.collect()).map_err(|source| RunError::Solid {
        body: body.name.clone(),
        source,
    })?;
    solid.damage = s.damage;
    solid.state.velocity.fill(s.velocity);
    Ok(solid)
}
