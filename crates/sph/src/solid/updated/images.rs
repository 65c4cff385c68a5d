//! Images of the present configuration: mirror images in fixed faces, open images in moving ones.

use super::super::block::Reflection;
use super::super::images::{Step, wall_at};
use super::super::{Block, Face, Side, Solid, Surface, absorbing};
use crate::fluid::ghosts::Plane;
use crate::geometry::Vec2;
use erode_physics::Sym3;

/// Place of removed particles and their images: no pair finds them there.
const NOWHERE: Vec2 = [f64::NAN; 2];

/// Tangent plane of a face at a point, with the outward normal of the body.
fn tangent_plane(block: &Block, surface: &Surface, j: usize) -> Plane {
    let normal = outward_normal(block, surface, j);
    let x = surface.position[j];
    Plane {
        normal,
        offset: normal[0] * x[0] + normal[1] * x[1],
        speed: 0.0,
    }
}

/// Outward unit normal of a face at a point: of its deformed line where pressure acts, of the reference elsewhere.
fn outward_normal(block: &Block, surface: &Surface, j: usize) -> Vec2 {
    let (axis, along) = (surface.side.normal_axis(), 1 - surface.side.normal_axis());
    let mut normal = [0.0; 2];
    normal[axis] = surface.side.sign();
    let x = &surface.position;
    if surface.face == Face::Absorbing || x.len() < 2 {
        return normal;
    }
    // Beyond the end at a mirror face lies the image of the last point.
    let beyond = |end: usize, side: Side| {
        if block.face(side).mirrors() {
            block.reflect(side, x[end])
        } else {
            x[end]
        }
    };
    let (first, last) = match along {
        0 => (Side::Left, Side::Right),
        _ => (Side::Bottom, Side::Top),
    };
    let before = if j == 0 { beyond(0, first) } else { x[j - 1] };
    let after = if j + 1 == x.len() {
        beyond(j, last)
    } else {
        x[j + 1]
    };
    let t = [after[0] - before[0], after[1] - before[1]];
    let length = t[0].hypot(t[1]);
    normal[axis] = surface.side.sign() * t[along] / length;
    normal[along] = -surface.side.sign() * t[axis] / length;
    normal
}

/// Stress beyond a face with outward normal n and traction t: s' n = 2 t - s n, the other components kept.
fn odd_traction(s: Sym3, n: Vec2, t: Vec2) -> Sym3 {
    let m = [-n[1], n[0]];
    let (sn, sm) = (
        [s.xx * n[0] + s.xy * n[1], s.xy * n[0] + s.yy * n[1]],
        [s.xx * m[0] + s.xy * m[1], s.xy * m[0] + s.yy * m[1]],
    );
    let dot = |a: Vec2, b: Vec2| a[0] * b[0] + a[1] * b[1];
    let (nn, nm, mm) = (
        2.0 * dot(t, n) - dot(sn, n),
        2.0 * dot(t, m) - dot(sn, m),
        dot(sm, m),
    );
    Sym3 {
        xx: nn * n[0] * n[0] + 2.0 * nm * n[0] * m[0] + mm * m[0] * m[0],
        yy: nn * n[1] * n[1] + 2.0 * nm * n[1] * m[1] + mm * m[1] * m[1],
        xy: nn * n[0] * n[1] + nm * (n[0] * m[1] + n[1] * m[0]) + mm * m[0] * m[1],
        ..s
    }
}

/// Reflects a point in a face that is not open, where its prescribed motion has taken it.
fn reflect(block: &Block, surfaces: &[Surface], step: Step, source: u32, point: Vec2) -> Vec2 {
    let mut x = block.reflect(step.side, point);
    if step.how != Reflection::Mirror {
        let n = step.side.normal_axis();
        x[n] += 2.0 * wall_at(surfaces, step.side, source).displacement[n];
    }
    x
}

impl Solid {
    /// Positions and velocities of particles and mirror images.
    pub(super) fn place_moving(&mut self) {
        let (present, state, block) = (&mut self.present, &self.state, &self.block);
        let (start, surfaces) = (&self.reference.position, &self.surfaces);
        present.position.clone_from(&state.position);
        for (x, removed) in present.position.iter_mut().zip(&state.removed) {
            if *removed != 0.0 {
                *x = NOWHERE;
            }
        }
        present.velocity.clone_from(&state.velocity);
        for placed in &present.images[..present.mirrors] {
            let b = placed.image.source as usize;
            let image = placed.image;
            let u = [0, 1].map(|i| present.position[b][i] - start[b][i]);
            let u = image.displacement(block, surfaces, start[b], u);
            let x = image.place(block, start[b]);
            present.position.push([x[0] + u[0], x[1] + u[1]]);
            let v = image.velocity(surfaces, state.velocity[b]);
            present.velocity.push(v);
        }
    }

    /// Positions of open images: mirrored in the tangent plane of each open face, then in the fixed faces.
    pub(super) fn place_open(&mut self) {
        let (present, block, surfaces) = (&mut self.present, &self.block, &self.surfaces);
        for placed in &present.images[present.mirrors..] {
            let mut x = present.position[placed.image.source as usize];
            for (s, j) in placed.point.into_iter().flatten() {
                x = tangent_plane(block, &surfaces[s], j).mirror(x);
            }
            let source = placed.image.source;
            let fixed = placed.image.steps().filter(|s| !s.is_open());
            x = fixed.fold(x, |x, s| reflect(block, surfaces, s, source, x));
            present.position.push(x);
        }
    }

    /// Tractions of the faces now: pressure along the present normal, or what lets waves leave.
    pub(super) fn present_tractions(&mut self) {
        let (block, state, material) = (&self.block, &self.state, &self.material);
        for surface in &mut self.surfaces {
            for j in 0..surface.particle.len() {
                let a = surface.particle[j];
                let n = outward_normal(block, surface, j);
                surface.traction[j] = if surface.face == Face::Absorbing {
                    absorbing::traction(material, surface, state.stress[a], state.velocity[a])
                } else if surface.driven[j] {
                    let s = state.stress[a];
                    [s.xx * n[0] + s.xy * n[1], s.xy * n[0] + s.yy * n[1]]
                } else {
                    [0, 1].map(|i| surface.contact[j][i] - surface.pressure[j] * n[i])
                };
            }
        }
    }

    /// Stress of every particle and image, Pa.
    pub(super) fn present_stress(&self) -> Vec<Sym3> {
        let mut stress = self.state.stress.clone();
        for placed in &self.present.images {
            let mut s = self.state.stress[placed.image.source as usize];
            for (k, j) in placed.point.into_iter().flatten() {
                let surface = &self.surfaces[k];
                let normal = outward_normal(&self.block, surface, j);
                s = odd_traction(s, normal, surface.traction[j]);
            }
            let flips = |s: &Step| matches!(s.how, Reflection::Mirror | Reflection::Slip);
            if placed.image.steps().filter(flips).count() == 1 {
                s.xy = -s.xy;
            }
            stress.push(s);
        }
        stress
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mean_of_both_sides_carries_the_traction() {
        let s = Sym3 {
            xx: 3.0,
            yy: -1.0,
            zz: 0.4,
            xy: 0.7,
            ..Sym3::ZERO
        };
        let (n, t) = ([0.6, 0.8], [-2.0, 0.3]);
        let mean = (s + odd_traction(s, n, t)) * 0.5;
        let found = [
            mean.xx * n[0] + mean.xy * n[1],
            mean.xy * n[0] + mean.yy * n[1],
        ];
        assert!((found[0] - t[0]).abs() + (found[1] - t[1]).abs() < 1e-14);
        let pressure = odd_traction(Sym3::isotropic(-5.0), n, n.map(|n| -5.0 * n));
        let gap = pressure - Sym3::isotropic(-5.0);
        assert!(gap.double_dot(gap) < 1e-28);
    }
}
