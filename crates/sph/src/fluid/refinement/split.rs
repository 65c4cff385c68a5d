//! One particle becomes two.
//!
//! The halves lie along the direction in which the liquid is stretched, where particles come to lack. Their areas are equal,
//! V_i = V ring_i/(ring_1 + ring_2). Density and velocity are linear in them, rho_i = rho + grad rho . (x_i - x_V) and
//! v_i = v + grad v (x_i - x_m), about the centres of volume and of mass: mass and momentum are those of the whole. The
//! gradient of the density is that of the pressure, grad p = -rho a, over c^2.

use super::particles::Piece;
use super::target::Wanted;
use crate::fluid::Fluid;
use crate::geometry::{Geometry, Vec2};

/// A particle is halved when the root of its area is this multiple of the wanted spacing. The same for all: where each has
/// a threshold of its own, sizes mix at the surface and the collapse breaks up.
const SPLIT: f64 = 1.2;

/// Distance of the halves from the centre in units of the root of the area: a little more than a quarter, for the gaps are in
/// this direction. (With 0.25 the wall of a collapsing cavity becomes 5 % too slow, with 0.35 it becomes 7 % too fast.)
const OFFSET: f64 = 0.28;

/// Liquid is at rest when its stretch over a particle is slower than this share of the speed of sound.
const AT_REST: f64 = 1e-4;

impl Fluid {
    /// Halves the particles that are too large for the `wanted` spacing (m); returns how many.
    pub(super) fn split(&mut self, wanted: &[Wanted]) -> u64 {
        let mut count = 0;
        for (a, wanted) in wanted.iter().enumerate().take(self.len()) {
            let too_large = self.area(a).sqrt() > SPLIT * wanted.spacing;
            if too_large && !self.far_field[a].is_some() {
                self.halve(a, &wanted.gradient);
                count += 1;
            }
        }
        count
    }

    fn halve(&mut self, a: usize, gradient: &[Vec2; 2]) {
        let places = self.places_of_halves(a, self.direction(a, gradient));
        let pieces = self.halves(a, places, gradient);
        self.origin[a].level += 1;
        let b = self.duplicate(a);
        self.reshape(a, &pieces[0]);
        self.reshape(b, &pieces[1]);
    }

    /// In which the halves lie: that of the greatest stretch; at rest one coordinate after the other.
    fn direction(&self, a: usize, gradient: &[Vec2; 2]) -> Vec2 {
        let (direction, rate) = stretched(gradient);
        let moving = rate * self.area(a).sqrt() > AT_REST * self.eos.sound_speed;
        match self.origin[a].level % 2 {
            _ if moving => direction,
            0 => [0.0, 1.0],
            _ => [1.0, 0.0],
        }
    }

    fn places_of_halves(&self, a: usize, direction: Vec2) -> [Vec2; 2] {
        let x = self.position[a];
        let mut offset = OFFSET * self.area(a).sqrt();
        if self.geometry == Geometry::Axisymmetric {
            // Not nearer to the axis than half way.
            offset = offset.min(0.5 * x[0] / direction[0].abs().max(f64::MIN_POSITIVE));
        }
        [1.0, -1.0].map(|s| [0, 1].map(|i| x[i] + s * offset * direction[i]))
    }

    fn halves(&self, a: usize, places: [Vec2; 2], gradient: &[Vec2; 2]) -> [Piece; 2] {
        let (mass, volume, velocity) = (self.mass[a], self.volume[a], self.velocity[a]);
        let rings = places.map(|x| self.geometry.ring(x[0]));
        let first = volume * rings[0] / (rings[0] + rings[1]);
        let volumes = [first, volume - first];
        let mean = |weights: [f64; 2], total: f64| {
            [0, 1].map(|i| (weights[0] * places[0][i] + weights[1] * places[1][i]) / total)
        };
        let from = |x: Vec2, centre: Vec2| [x[0] - centre[0], x[1] - centre[1]];
        let slope = self.density_gradient(a);
        let d = from(places[0], mean(volumes, volume));
        let density = self.density(a);
        let step = slope[0] * d[0] + slope[1] * d[1];
        let step = self.limited_step(density, step, volumes);
        let first = volumes[0] * (density + step);
        let masses = [first, mass - first];
        let d = from(places[0], mean(masses, mass));
        let v = [0, 1].map(|i| velocity[i] + gradient[i][0] * d[0] + gradient[i][1] * d[1]);
        let rest = [0, 1].map(|i| (mass * velocity[i] - masses[0] * v[i]) / masses[1]);
        let piece = |k: usize, velocity: Vec2| Piece {
            position: places[k],
            velocity,
            mass: masses[k],
            volume: volumes[k],
        };
        [piece(0, v), piece(1, rest)]
    }

    fn density_gradient(&self, a: usize) -> Vec2 {
        let density = self.density(a);
        let c = self.eos.sound_speed_at(density);
        self.acceleration[a].map(|q| -density * q / (c * c))
    }

    /// Step of the density of the first half, such that none of them is below the density at zero pressure.
    fn limited_step(&self, density: f64, step: f64, volumes: [f64; 2]) -> f64 {
        let room = (density - self.eos.reference_density).max(0.0);
        step.clamp(-room, room * volumes[1] / volumes[0])
    }
}

/// Unit vector of the greatest rate of stretch and that rate less the mean, 1/s.
fn stretched(gradient: &[Vec2; 2]) -> (Vec2, f64) {
    let shear = 0.5 * (gradient[0][1] + gradient[1][0]);
    let half = 0.5 * (gradient[0][0] - gradient[1][1]);
    let angle = 0.5 * shear.atan2(half);
    ([angle.cos(), angle.sin()], shear.hypot(half))
}
