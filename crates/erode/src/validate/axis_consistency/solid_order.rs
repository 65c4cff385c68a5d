//! Total Lagrangian solid: order of acceleration in a smooth stress and of the deformation gradient, at the axis.
//!
//! s_rr = S cos(k r) cos(k z), s_tt = s_rr + S (k r)^2/2, s_zz = S cos(k r) sin(k z), s_rz = S k r cos(k z);
//! u_r = U k r cos(k r) sin(k z), u_z = U cos(k z) (1 + (k r)^2).

use super::solid::solid;
use super::{DX, REFINEMENT, order};
use crate::validate::Failure;
use crate::validate::check::Check;
use erode_physics::Sym3;
use erode_sph::Geometry::Axisymmetric;
use erode_sph::geometry::Vec2;
use erode_sph::solid::{Face, Solid};

/// Wave number: the coarsest lattice has 40 particles in the width of pi/K.
const K: f64 = std::f64::consts::PI / (40.0 * DX);
const S: f64 = 1e8;
const U: f64 = 1e-8;
const SIZE: [f64; 2] = [40.0, 40.0];

/// Particles nearer to the axis are judged by themselves, in units of the width.
const NEAR: f64 = 0.25;

const FIRST: &str = "stated order: the second-order error of d(R P)/dR stands over R, which is dx/2 in the first column";
const SECOND: &str =
    "the corrected gradient on a lattice is second order; 0.2 left for what is not yet asymptotic";

pub(super) fn checks() -> Result<Vec<Check>, Failure> {
    let (mut near, mut far, mut rate) = (Vec::new(), Vec::new(), Vec::new());
    for part in REFINEMENT {
        let [at_axis, beyond] = acceleration_errors(part * DX)?;
        near.push(at_axis);
        far.push(beyond);
        rate.push(gradient_error(part * DX)?);
    }
    Ok(vec![
        order(
            "solid's acceleration in a smooth stress, a quarter of the width off the axis",
            &far,
            1.8,
            SECOND,
        ),
        order(
            "solid's acceleration in a smooth stress, at the axis",
            &near,
            0.9,
            FIRST,
        ),
        order(
            "solid's deformation gradient of a smooth displacement",
            &rate,
            1.8,
            SECOND,
        ),
    ])
}

fn at_spacing(dx: f64) -> Result<Solid, Failure> {
    let size = SIZE.map(|n| (n * DX / dx).round() as usize);
    let faces = [Face::Axis, Face::Traction, Face::Traction, Face::Traction];
    solid(Axisymmetric, size, dx, faces)
}

/// Particles at least a quarter of the size away from all faces but the axis, with their places in units of 1/k.
fn inner(s: &Solid) -> Vec<(usize, Vec2)> {
    let [width, height] = SIZE.map(|n| n * DX);
    let inside = |x: Vec2| x[0] < 0.75 * width && (x[1] - 0.5 * height).abs() < 0.25 * height;
    let all = s.reference.position.iter().enumerate();
    all.filter(|(_, x)| inside(**x))
        .map(|(a, x)| (a, x.map(|c| K * c)))
        .collect()
}

/// Largest errors near the axis and beyond, in units of S k/rho.
fn acceleration_errors(dx: f64) -> Result<[f64; 2], Failure> {
    let mut s = at_spacing(dx)?;
    for (a, x) in s.reference.position.iter().enumerate() {
        let [r, z] = x.map(|c| K * c);
        let rr = S * r.cos() * z.cos();
        s.state.stress[a] = Sym3 {
            xx: rr,
            yy: S * r.cos() * z.sin(),
            zz: rr + 0.5 * S * r * r,
            xy: S * r * z.cos(),
            ..Sym3::ZERO
        };
    }
    s.accelerations();
    let scale = S * K / s.material.density;
    let mut worst = [0.0; 2];
    for (a, [r, z]) in inner(&s) {
        let exact = [
            -r.sin() * z.cos() - r * z.sin() - 0.5 * r,
            2.0 * z.cos() + r.cos() * z.cos(),
        ];
        let found = s.state.acceleration[a].map(|c| c / scale);
        let error = (found[0] - exact[0]).hypot(found[1] - exact[1]);
        let zone = usize::from(r > NEAR * K * SIZE[0] * DX);
        worst[zone] = f64::max(worst[zone], error);
    }
    Ok(worst)
}

fn gradient_error(dx: f64) -> Result<f64, Failure> {
    let mut s = at_spacing(dx)?;
    for a in 0..s.len() {
        let [r, z] = s.reference.position[a].map(|c| K * c);
        let u = [r * r.cos() * z.sin(), z.cos() * (1.0 + r * r)];
        let x = &mut s.state.position[a];
        *x = [x[0] + U * u[0], x[1] + U * u[1]];
    }
    s.update_stress(1e-9)?;
    let worst = inner(&s).into_iter().map(|(a, [r, z])| {
        let f = &s.state.deformation[a];
        let exact = [
            [(r.cos() - r * r.sin()) * z.sin(), r * r.cos() * z.cos()],
            [2.0 * r * z.cos(), -z.sin() * (1.0 + r * r)],
        ];
        let unit = |i: usize, j: usize| f64::from(u8::from(i == j));
        let error = |i: usize, j: usize| ((f[i][j] - unit(i, j)) / (U * K) - exact[i][j]).abs();
        error(0, 0)
            .max(error(0, 1))
            .max(error(1, 0))
            .max(error(1, 1))
    });
    Ok(worst.fold(0.0, f64::max))
}
