//! Total Lagrangian solid: uniform pressure, linear deformation, rigid motion.

use super::{DX, EXACT, ROUND_OFF, largest, lattice};
use crate::validate::Failure;
use crate::validate::check::Check;
use crate::validate::materials::steel;
use erode_physics::Sym3;
use erode_physics::material_point::Material;
use erode_physics::strength::Strength;
use erode_sph::Geometry::{self, Axisymmetric, Plane};
use erode_sph::geometry::Vec2;
use erode_sph::solid::{Block, Face, Numerics, Setup, Solid};

const SIZE: [usize; 2] = [14, 11];

/// Elastic steel on a lattice of spacing `dx`; faces left, right, bottom, top.
pub(super) fn solid(
    geometry: Geometry,
    size: [usize; 2],
    dx: f64,
    faces: [Face; 4],
) -> Result<Solid, Failure> {
    let (density, elastic, _) = steel()?;
    let [left, right, bottom, top] = faces;
    let position = lattice(size, dx);
    Ok(Solid::new(Setup {
        geometry,
        block: Block {
            lower: [0.0; 2],
            upper: size.map(|n| n as f64 * dx),
            left,
            right,
            bottom,
            top,
        },
        material: Material {
            elastic,
            strength: Strength::Elastic,
            density,
            temperature: 293.0,
        },
        numerics: Numerics::default(),
        area: vec![dx * dx; position.len()],
        position,
    })?)
}

/// The left face that belongs to a geometry, free faces elsewhere.
fn free(geometry: Geometry) -> [Face; 4] {
    let left = match geometry {
        Axisymmetric => Face::Axis,
        Plane => Face::Traction,
    };
    [left, Face::Traction, Face::Traction, Face::Traction]
}

pub(super) fn checks() -> Result<Vec<Check>, Failure> {
    Ok(vec![
        uniform_pressure("pressed faces", free(Axisymmetric))?,
        uniform_pressure(
            "rigid sides, pressed top",
            [Face::Axis, Face::Symmetry, Face::Symmetry, Face::Traction],
        )?,
        linear(Axisymmetric, [[1.03, 0.0], [0.0, 0.96]])?,
        linear(Plane, [[1.02, -0.03], [0.05, 0.97]])?,
        rotation()?,
        translation()?,
    ])
}

fn uniform_pressure(kind: &str, faces: [Face; 4]) -> Result<Check, Failure> {
    let p = 1e9;
    let mut s = solid(Axisymmetric, SIZE, DX, faces)?;
    s.state.stress.fill(Sym3::isotropic(-p));
    s.surfaces.iter_mut().for_each(|f| f.pressure.fill(p));
    s.accelerations();
    let scale = p / (s.material.density * DX);
    Ok(Check::absolute(
        format!("solid, uniform pressure, axis and {kind}: acceleration in units of p/(rho dx)"),
        "-",
        (largest(&s.state.acceleration) / scale, 0.0),
        1e-10,
        ROUND_OFF,
    ))
}

fn place(solid: &mut Solid, map: impl Fn(Vec2) -> Vec2) {
    let at = solid.reference.position.iter().map(|x| map(*x));
    solid.state.position = at.collect();
}

/// Deformation gradient and hoop stretch of a linear map.
fn linear(geometry: Geometry, g: [Vec2; 2]) -> Result<Check, Failure> {
    let mut s = solid(geometry, SIZE, DX, free(geometry))?;
    place(&mut s, |x| [0, 1].map(|i| g[i][0] * x[0] + g[i][1] * x[1]));
    s.update_stress(1e-9)?;
    let hoop = if geometry == Axisymmetric {
        g[0][0]
    } else {
        1.0
    };
    let mut worst = 0.0_f64;
    for (f, h) in s.state.deformation.iter().zip(&s.state.hoop_stretch) {
        let plane = (0..2).flat_map(|i| (0..2).map(move |j| (f[i][j] - g[i][j]).abs()));
        worst = plane.fold(worst, f64::max).max((h - hoop).abs());
    }
    let kind = if geometry == Plane { "plane" } else { "axis" };
    Ok(Check::absolute(
        format!(
            "solid, linear deformation, {kind} and free faces: error of the deformation gradient"
        ),
        "-",
        (worst, 0.0),
        1e-10,
        EXACT,
    ))
}

/// Largest component of any stress in units of Young's modulus.
fn stress(s: &Solid) -> f64 {
    let parts = s
        .state
        .stress
        .iter()
        .flat_map(|t| [t.xx, t.yy, t.zz, t.xy, t.xz, t.yz]);
    parts.fold(0.0, |m, c| f64::max(m, c.abs())) / s.material.elastic.young_modulus
}

fn rotation() -> Result<Check, Failure> {
    let mut s = solid(Plane, SIZE, DX, free(Plane))?;
    for step in 1..=20 {
        let (sin, cos) = (0.1 * std::f64::consts::PI * f64::from(step)).sin_cos();
        place(&mut s, |x| {
            [cos * x[0] - sin * x[1], sin * x[0] + cos * x[1]]
        });
        s.update_stress(1e-9)?;
    }
    Ok(Check::absolute(
        "solid, one turn in the plane in 20 steps: stress in units of Young's modulus",
        "-",
        (stress(&s), 0.0),
        1e-10,
        EXACT,
    ))
}

fn translation() -> Result<Check, Failure> {
    let mut s = solid(Axisymmetric, SIZE, DX, free(Axisymmetric))?;
    place(&mut s, |x| [x[0], x[1] + 10.0 * DX]);
    s.update_stress(1e-9)?;
    Ok(Check::absolute(
        "solid, translation along the axis: stress in units of Young's modulus",
        "-",
        (stress(&s), 0.0),
        1e-10,
        EXACT,
    ))
}
