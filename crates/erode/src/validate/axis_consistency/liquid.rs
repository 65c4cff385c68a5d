//! Liquid: uniform pressure, linear velocity, rigid motion.

use super::{DX, EXACT, ROUND_OFF, largest, lattice};
use crate::validate::Failure;
use crate::validate::check::Check;
use crate::validate::materials::water;
use erode_sph::Geometry::{self, Axisymmetric, Plane};
use erode_sph::fluid::corrected::Settings;
use erode_sph::fluid::far_field::FarField;
use erode_sph::fluid::{Fluid, Formulation, Start, ghosts};
use erode_sph::geometry::Vec2;
use erode_sph::world::{Body, Named, World};

const SIZE: [usize; 2] = [16, 20];

/// Pa.
const PRESSURE: f64 = 50e6;

/// Liquid on a lattice of spacing `dx`, without sides but the axis.
pub(super) fn liquid(
    geometry: Geometry,
    size: [usize; 2],
    dx: f64,
    pressure: f64,
) -> Result<Fluid, Failure> {
    let position = lattice(size, dx);
    Ok(Fluid::new(&Start {
        geometry,
        eos: water()?,
        area: &vec![dx * dx; position.len()],
        position: &position,
        pressure,
        velocity: [0.0; 2],
        formulation: Formulation::Corrected(Settings {
            // Shifting moves particles on purpose.
            shifting: 0.0,
            ..Settings::default()
        }),
    }))
}

/// The liquid after one step of `dt`.
pub(super) fn advance(mut liquid: Fluid, dt: f64) -> Result<Fluid, Failure> {
    // The particles keep the order of the lattice, by which the checks know them.
    liquid.clustering.stale = false;
    let body = Body::Fluid(liquid);
    let name = "liquid".into();
    let mut world = World::new(vec![Named { name, body }], 0.3)?;
    world.advance(dt)?;
    match world.bodies.remove(0).body {
        Body::Fluid(fluid) => Ok(fluid),
        Body::Solid(_) => Err(Failure::Absent("the liquid became a solid".into())),
    }
}

/// The other three (four) sides of the lattice, normals into the liquid.
pub(super) fn sides(geometry: Geometry, size: [usize; 2], dx: f64) -> Vec<ghosts::Plane> {
    let plane = |normal: Vec2, offset: f64| ghosts::Plane {
        normal,
        offset,
        speed: 0.0,
    };
    let [width, height] = size.map(|n| n as f64 * dx);
    let mut sides = vec![
        plane([-1.0, 0.0], -width),
        plane([0.0, 1.0], 0.0),
        plane([0.0, -1.0], -height),
    ];
    if geometry == Plane {
        sides.push(plane([1.0, 0.0], 0.0));
    }
    sides
}

pub(super) fn checks() -> Result<Vec<Check>, Failure> {
    let mut checks = Vec::new();
    for open in [false, true] {
        checks.push(uniform_pressure(open)?);
    }
    checks.push(linear(Axisymmetric, [[3e5, 0.0], [0.0, -8e5]])?);
    checks.push(linear(Axisymmetric, [[-2e5, 0.0], [0.0, 4e5]])?);
    checks.push(linear(Plane, [[3e5, 1e5], [-4e5, -8e5]])?);
    checks.push(linear(Plane, [[0.0, 5e5], [-5e5, 0.0]])?);
    checks.push(translation()?);
    Ok(checks)
}

fn uniform_pressure(open: bool) -> Result<Check, Failure> {
    let p = PRESSURE;
    let mut f = liquid(Axisymmetric, SIZE, DX, p)?;
    let sides = sides(Axisymmetric, SIZE, DX);
    if open {
        let far = FarField {
            pressure: p,
            step_pressure: p,
            ..FarField::NONE
        };
        sides.iter().for_each(|s| f.open_side(s, far));
    } else {
        f.sides = sides;
    }
    let scale = p / (f.density(0) * DX);
    let f = advance(f, 1e-12)?;
    let kind = if open { "far fields" } else { "rigid sides" };
    Ok(Check::absolute(
        format!("liquid, uniform pressure, axis and {kind}: acceleration in units of p/(rho dx)"),
        "-",
        (largest(&f.acceleration) / scale, 0.0),
        1e-10,
        ROUND_OFF,
    ))
}

/// Rate of volume in the linear field v = g x with free surfaces all around (but the axis).
///
/// The rate is measured over one step of `dt`, in whose middle x' = (1 + g dt/2) x, so v = g (1 + g dt/2)^-1 x'.
fn linear(geometry: Geometry, g: [Vec2; 2]) -> Result<Check, Failure> {
    let dt = 1e-9;
    // Under pressure, since liquid that expands from zero pressure parts instead of getting thinner. No force acts yet:
    // the first half of the step has the acceleration of the start, zero.
    let mut f = liquid(geometry, SIZE, DX, PRESSURE)?;
    f.velocity = f.position.iter().map(|x| apply(&g, *x)).collect();
    let before = f.volume.clone();
    let f = advance(f, dt)?;
    let (rate, norm) = middle_rates(geometry, &g, dt);
    let scale = norm;
    let mut worst = 0.0_f64;
    for (a, old) in before.iter().enumerate() {
        let found = (f.volume[a] / old).ln() / dt;
        worst = worst.max((found - rate).abs() / scale);
        worst = worst.max((f.strain_rate[a] - norm).abs() / scale);
    }
    let what = match (geometry, g[0][0] == 0.0) {
        (Axisymmetric, _) => format!("v_r = {:.0e} r, v_z = {:.0e} z", g[0][0], g[1][1]),
        (Plane, true) => "rigid rotation in the plane".into(),
        (Plane, false) => "all four gradients in the plane".into(),
    };
    Ok(Check::absolute(
        format!(
            "liquid, {what}, free surfaces: rates of volume and strain, error in units of |grad v|"
        ),
        "-",
        (worst, 0.0),
        1e-10,
        EXACT,
    ))
}

fn apply(g: &[Vec2; 2], x: Vec2) -> Vec2 {
    [0, 1].map(|i| g[i][0] * x[0] + g[i][1] * x[1])
}

/// Relative rate of volume and norm of the gradient in the middle of the step.
fn middle_rates(geometry: Geometry, g: &[Vec2; 2], dt: f64) -> (f64, f64) {
    let half = 0.5 * dt;
    let f = [
        [1.0 + half * g[0][0], half * g[0][1]],
        [half * g[1][0], 1.0 + half * g[1][1]],
    ];
    let det = f[0][0] * f[1][1] - f[0][1] * f[1][0];
    let inverse = [
        [f[1][1] / det, -f[0][1] / det],
        [-f[1][0] / det, f[0][0] / det],
    ];
    let at = |i: usize, j: usize| g[i][0] * inverse[0][j] + g[i][1] * inverse[1][j];
    let hoop = if geometry == Axisymmetric {
        at(0, 0)
    } else {
        0.0
    };
    let squares = at(0, 0).powi(2) + at(0, 1).powi(2) + at(1, 0).powi(2) + at(1, 1).powi(2);
    (at(0, 0) + at(1, 1) + hoop, squares.sqrt())
}

fn translation() -> Result<Check, Failure> {
    let (speed, dt) = (100.0, 1e-9);
    let mut f = liquid(Axisymmetric, SIZE, DX, 0.0)?;
    f.velocity.fill([0.0, speed]);
    let f = advance(f, dt)?;
    let scale = f.eos.sound_speed.powi(2) / DX;
    let change = largest(&f.acceleration) / scale;
    Ok(Check::absolute(
        "liquid, translation along the axis: acceleration in units of c^2/dx",
        "-",
        (change, 0.0),
        1e-10,
        EXACT,
    ))
}
