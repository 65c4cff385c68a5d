//! Where liquid meets metal: the surface of a solid as a moving wall of the liquid, and the liquid's push on it.
//!
//! The liquid is mirrored in the tangent of the surface, with its normal velocity reversed about that of the surface:
//! no penetration, free slip. The force that the ghosts exert on each liquid particle is handed back, equal and
//! opposite, to the surface as a pressure spread with a kernel along the surface; its sum is kept to rounding.

use crate::fluid::ghosts::{Plane, Shadow, Wall};
use crate::geometry::{Geometry, Vec2};
use crate::solid::Surface;
use rayon::prelude::*;

/// Upper surface of a solid: points in ascending first coordinate.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SurfaceLine {
    /// Points of the deformed surface, m.
    pub position: Vec<Vec2>,
    /// Velocity of the points, m/s.
    pub velocity: Vec<Vec2>,
    /// Width that each point stands for, m.
    pub width: Vec<f64>,
    /// Area that each point stands for (of the whole ring in axisymmetry, per metre in plane), m2.
    pub area: Vec<f64>,
}

impl SurfaceLine {
    /// The upper face of a solid as it is now.
    #[must_use]
    pub fn of(surface: &Surface) -> Self {
        Self {
            position: surface.position.clone(),
            velocity: surface.velocity.clone(),
            width: surface.width.clone(),
            area: surface.area.clone(),
        }
    }

    /// Index of the segment that holds `r` and the place in it, clamped to the ends.
    fn locate(&self, r: f64) -> (usize, f64) {
        let last = self.position.len().saturating_sub(2);
        let i = self
            .position
            .partition_point(|p| p[0] <= r)
            .saturating_sub(1)
            .min(last);
        let (a, b) = (self.position[i], self.position[i + 1]);
        (i, ((r - a[0]) / (b[0] - a[0])).clamp(0.0, 1.0))
    }

    /// Pushes of the liquid as pressure at each point, Pa. `force` are forces (N) of liquid particles on the surface at
    /// `position`, `reach` the widths over which they are spread.
    #[must_use]
    pub fn pressure(
        &self,
        geometry: Geometry,
        position: &[Vec2],
        force: &[Vec2],
        reach: &[f64],
    ) -> Vec<f64> {
        let mut pressure = vec![0.0; self.position.len()];
        let pushes: Vec<(usize, Vec<f64>)> = (0..position.len())
            .into_par_iter()
            .with_min_len(256)
            .filter(|a| force[*a] != [0.0; 2])
            .map(|a| self.spread(geometry, position[a], force[a], reach[a]))
            .collect();
        for (first, shares) in pushes {
            for (k, p) in shares.iter().enumerate() {
                pressure[first + k] += p;
            }
        }
        pressure
    }

    /// First point and the pressures that one force gives to it and the following ones.
    fn spread(&self, geometry: Geometry, x: Vec2, force: Vec2, reach: f64) -> (usize, Vec<f64>) {
        let (i, f) = self.locate(x[0]);
        let normal = self.normal(i);
        let push = -(force[0] * normal[0] + force[1] * normal[1]);
        let near = self.width[i].max(self.width[i + 1]);
        let reach = reach.max(near);
        let first = self
            .position
            .partition_point(|p| p[0] <= x[0] - 2.0 * reach);
        let last = self.position.partition_point(|p| p[0] < x[0] + 2.0 * reach);
        let share = |k: usize| match geometry {
            Geometry::Plane => bell(self.position[k][0] - x[0], reach),
            Geometry::Axisymmetric => ring_bell(self.position[k][0], x[0], reach),
        };
        let sum: f64 = (first..last).map(|k| share(k) * self.area[k]).sum();
        if sum > 0.0 {
            return (
                first,
                (first..last).map(|k| push * share(k) / sum).collect(),
            );
        }
        let k = if f < 0.5 { i } else { i + 1 };
        (k, vec![push / self.area[k]])
    }

    /// Upward unit normal of a segment.
    fn normal(&self, i: usize) -> Vec2 {
        let (a, b) = (self.position[i], self.position[i + 1]);
        let t = [b[0] - a[0], b[1] - a[1]];
        let length = t[0].hypot(t[1]);
        [-t[1] / length, t[0] / length]
    }
}

/// (1 - (d / 2 reach)^2)^2, zero from d = 2 `reach` on.
fn bell(d: f64, reach: f64) -> f64 {
    (1.0 - (0.5 * d / reach).powi(2)).max(0.0).powi(2)
}

/// Mean of [`bell`] between a point at `r` and all points of the ring at `s`: symmetric in both, and its integral over the
/// plane is the same for every `r`. So a uniform pressure stays uniform at the axis too, where a bell of r - s does not.
///
/// With d^2 = r^2 + s^2 - 2 r s cos t the bell is (a + b cos t)^2, integrated in closed form where a + b cos t > 0.
fn ring_bell(r: f64, s: f64, reach: f64) -> f64 {
    let scale = 0.25 / (reach * reach);
    let a = 1.0 - (r * r + s * s) * scale;
    let b = 2.0 * r * s * scale;
    if a + b <= 0.0 {
        return 0.0;
    }
    let t = if b > 0.0 {
        (-a / b).clamp(-1.0, 1.0).acos()
    } else {
        std::f64::consts::PI
    };
    let integral = a * a * t + 2.0 * a * b * t.sin() + 0.5 * b * b * (t + t.sin() * t.cos());
    (integral / std::f64::consts::PI).max(0.0)
}

impl Wall for SurfaceLine {
    fn plane(&self, x: Vec2, reach: f64) -> Option<Plane> {
        let (i, f) = self.locate(x[0]);
        let normal = self.normal(i);
        let p = self.position[i];
        let offset = normal[0] * p[0] + normal[1] * p[1];
        let mix = |k: usize| (1.0 - f) * self.velocity[i][k] + f * self.velocity[i + 1][k];
        let speed = normal[0] * mix(0) + normal[1] * mix(1);
        let plane = Plane {
            normal,
            offset,
            speed,
        };
        (plane.distance(x) < reach).then_some(plane)
    }

    fn is_surface(&self) -> bool {
        true
    }

    fn shadow(&self) -> Option<Shadow> {
        let (first, last) = (self.position.first()?, self.position.last()?);
        let cosine = (0..self.position.len() - 1)
            .map(|i| self.normal(i)[1])
            .fold(1.0, f64::min);
        let top = self
            .position
            .iter()
            .fold(f64::NEG_INFINITY, |t, x| t.max(x[1]));
        // A wall that overhangs casts none.
        (cosine > 0.0).then_some(Shadow {
            ends: [first[0], last[0]],
            top,
            cosine,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flat(n: usize, w: f64) -> SurfaceLine {
        SurfaceLine {
            position: (0..n).map(|i| [(i as f64 + 0.5) * w, 0.0]).collect(),
            velocity: vec![[0.0, 2.0]; n],
            width: vec![w; n],
            area: (0..n)
                .map(|i| Geometry::Axisymmetric.ring((i as f64 + 0.5) * w) * w)
                .collect(),
        }
    }

    #[test]
    fn pressure_keeps_the_force() {
        let s = flat(40, 0.1);
        let geometry = Geometry::Axisymmetric;
        let x: Vec<Vec2> = (0..7).map(|k| [0.02 + 0.37 * f64::from(k), 0.05]).collect();
        let f: Vec<Vec2> = (0..7).map(|k| [0.3, -1.0 - f64::from(k)]).collect();
        let p = s.pressure(geometry, &x, &f, &[0.13; 7]);
        let felt: f64 = p.iter().zip(&s.area).map(|(p, area)| p * area).sum();
        let given: f64 = f.iter().map(|f| -f[1]).sum();
        assert!((felt / given - 1.0).abs() < 1e-13);
    }

    #[test]
    fn a_uniform_pressure_arrives_uniform_at_the_axis() {
        let s = flat(40, 0.1);
        let geometry = Geometry::Axisymmetric;
        // Particles at half the spacing of the surface, out of step with it, each pushing with 3 Pa times its ring.
        let x: Vec<Vec2> = (0..60)
            .map(|i| [(f64::from(i) + 0.5) * 0.06, 0.05])
            .collect();
        let f: Vec<Vec2> = x
            .iter()
            .map(|x| [0.0, -3.0 * geometry.ring(x[0]) * 0.06])
            .collect();
        let p = s.pressure(geometry, &x, &f, &[0.13; 60]);
        // The sums over particles and points replace integrals of a smooth bell about 4 points wide: 1 %.
        for (k, p) in p.iter().take(30).enumerate() {
            assert!(
                (p / 3.0 - 1.0).abs() < 0.01,
                "point {k}: {p} Pa instead of 3 Pa"
            );
        }
    }

    #[test]
    fn ring_bell_is_the_mean_over_the_angle_and_symmetric() {
        for (r, s) in [(0.0, 0.1), (0.07, 0.15), (0.3, 0.4), (2.0, 2.1)] {
            let mean: f64 = (0..20_000)
                .map(|i| {
                    let t = std::f64::consts::PI * (f64::from(i) + 0.5) / 20_000.0;
                    bell((r * r + s * s - 2.0 * r * s * t.cos()).sqrt(), 0.13)
                })
                .sum::<f64>()
                / 20_000.0;
            assert!((ring_bell(r, s, 0.13) - mean).abs() < 1e-6, "{r} {s}");
            assert!((ring_bell(r, s, 0.13) - ring_bell(s, r, 0.13)).abs() < 1e-12);
        }
    }

    #[test]
    fn a_particle_is_mirrored_about_the_moving_surface() {
        let plane = flat(40, 0.1).plane([1.03, 0.05], 0.1).unwrap();
        assert!((plane.mirror([1.03, 0.05])[1] + 0.05).abs() < 1e-15);
        assert!((plane.mirror_velocity([1.0, -3.0])[1] - 7.0).abs() < 1e-13);
        assert!(flat(40, 0.1).plane([1.03, 0.2], 0.1).is_none());
    }
}
