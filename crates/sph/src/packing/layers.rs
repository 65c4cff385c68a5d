//! Layers of particles around a shape.

use super::domain::Domain;
use super::{Seed, Spacing};
use crate::geometry::Vec2;
use crate::shapes::Shape;
use std::f64::consts::PI;

/// Spacing as a function of the distance d from the shape that the layers surround: finest up to `flat`, then
/// growing.
pub(super) struct Profile {
    flat: f64,
    finest: f64,
    coarsest: f64,
    growth: f64,
}

impl Profile {
    pub(super) fn new(spacing: &Spacing, flat: f64) -> Self {
        Self {
            flat,
            finest: spacing.finest,
            coarsest: spacing.coarsest,
            growth: spacing.growth,
        }
    }

    fn at(&self, d: f64) -> f64 {
        (self.finest + self.growth * (d - self.flat).max(0.0)).min(self.coarsest)
    }

    /// Distance at which the integral of dd/s reaches `n`.
    fn distance(&self, n: f64) -> f64 {
        let beyond = n - self.flat / self.finest;
        if beyond <= 0.0 || self.growth == 0.0 {
            return n * self.finest;
        }
        let to_coarsest = (self.coarsest / self.finest).ln() / self.growth;
        let graded = beyond.min(to_coarsest);
        self.flat
            + self.finest / self.growth * (self.growth * graded).exp_m1()
            + self.coarsest * (beyond - graded)
    }
}

/// Fills the domain outside of `inner` with layers, the first one half a spacing away from it. On each piece of a
/// layer inside the domain the particles are evenly spaced, the first and last half a step from the ends.
pub(super) fn fill(
    domain: &Domain,
    inner: &Shape,
    profile: &Profile,
    spacing: &Spacing,
) -> Vec<Seed> {
    let (lower, upper) = domain.bounding_box();
    let corners = [lower, [upper[0], lower[1]], upper, [lower[0], upper[1]]];
    let farthest = corners
        .iter()
        .map(|&c| inner.distance(c))
        .fold(0.0, f64::max);
    let mut seeds = Vec::new();
    for layer in 0.. {
        let distance = profile.distance(f64::from(layer) + 0.5);
        if distance > farthest {
            break;
        }
        let curve = Offset {
            shape: inner,
            distance,
        };
        curve.place(domain, profile.at(distance), &mut seeds);
    }
    seeds.retain(|seed| domain.admits(seed.position, spacing.at(seed.position)));
    seeds
}

/// Largest radius about `centre` that stays inside the core where that lies inside the domain, m.
pub(super) fn core_radius(domain: &Domain, spacing: &Spacing, centre: Vec2) -> f64 {
    let (lower, upper) = domain.bounding_box();
    let farthest = (upper[0] - lower[0]).hypot(upper[1] - lower[1]);
    match &spacing.core {
        None => farthest,
        Some(Shape::Disc { centre: c, radius }) => {
            radius - (centre[0] - c[0]).hypot(centre[1] - c[1])
        }
        Some(Shape::Rectangle { lower: l, upper: u }) => (0..2)
            .flat_map(|k| {
                let below = (l[k] > lower[k]).then_some(centre[k] - l[k]);
                let above = (u[k] < upper[k]).then_some(u[k] - centre[k]);
                below.into_iter().chain(above)
            })
            .fold(farthest, f64::min),
    }
}

/// The closed curve at a distance from a shape, by arc length from the lower left corner, counter-clockwise.
struct Offset<'a> {
    shape: &'a Shape,
    distance: f64,
}

impl Offset<'_> {
    fn length(&self) -> f64 {
        match self.shape {
            Shape::Disc { radius, .. } => 2.0 * PI * (radius + self.distance),
            Shape::Rectangle { lower, upper } => {
                2.0 * (upper[0] - lower[0] + upper[1] - lower[1]) + 2.0 * PI * self.distance
            }
        }
    }

    fn point(&self, along: f64) -> Vec2 {
        match self.shape {
            Shape::Disc { centre, radius } => {
                let r = radius + self.distance;
                let (sin, cos) = (along / r).sin_cos();
                [centre[0] + r * cos, centre[1] + r * sin]
            }
            Shape::Rectangle { lower, upper } => rounded(*lower, *upper, self.distance, along),
        }
    }

    /// Places particles at steps of about `step` on every piece inside the domain.
    fn place(&self, domain: &Domain, step: f64, seeds: &mut Vec<Seed>) {
        let length = self.length();
        let inside = |t: f64| {
            let x = self.point(t.rem_euclid(length));
            domain.depth(x) >= 0.0 && domain.hole_distance(x) >= 0.0
        };
        let samples = (8.0 * length / step).ceil().max(64.0) as usize;
        let at = |i: usize| i as f64 * length / samples as f64;
        let mut put = |from: f64, to: f64| {
            let n = ((to - from) / step).round();
            for j in 0..n as usize {
                let t = from + (j as f64 + 0.5) * (to - from) / n;
                seeds.push(Seed {
                    position: self.point(t.rem_euclid(length)),
                    area: step * (to - from) / n,
                });
            }
        };
        let Some(first) = (0..samples).find(|&i| !inside(at(i))) else {
            put(0.0, length);
            return;
        };
        let mut entered = None;
        // One sample more than the round trip: where a sample lies on a wall, rounding decides twice.
        for i in first..=first + samples {
            match (inside(at(i)), inside(at(i + 1))) {
                (false, true) => entered = Some(crossing(&inside, at(i), at(i + 1))),
                (true, false) => {
                    if let Some(from) = entered.take() {
                        put(from, crossing(&inside, at(i + 1), at(i)));
                    }
                }
                _ => {}
            }
        }
    }
}

/// Where a curve enters, between a parameter outside and one inside.
fn crossing(inside: &impl Fn(f64) -> bool, mut outer: f64, mut inner: f64) -> f64 {
    for _ in 0..60 {
        let middle = 0.5 * (outer + inner);
        if inside(middle) {
            inner = middle;
        } else {
            outer = middle;
        }
    }
    inner
}

/// Point on the curve at `distance` around a rectangle, by arc length.
fn rounded(lower: Vec2, upper: Vec2, distance: f64, mut along: f64) -> Vec2 {
    let corners = [lower, [upper[0], lower[1]], upper, [lower[0], upper[1]]];
    let directions = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];
    for side in 0..4 {
        let t: Vec2 = directions[side];
        let side_length = if side % 2 == 0 {
            upper[0] - lower[0]
        } else {
            upper[1] - lower[1]
        };
        let c = corners[side];
        if along <= side_length {
            return [
                c[0] + along * t[0] + distance * t[1],
                c[1] + along * t[1] - distance * t[0],
            ];
        }
        along -= side_length;
        let quarter = 0.5 * PI * distance;
        if along <= quarter || side == 3 {
            let (sin, cos) = (along / distance).sin_cos();
            let e = corners[(side + 1) % 4];
            let out = [t[1] * cos + t[0] * sin, -t[0] * cos + t[1] * sin];
            return [e[0] + distance * out[0], e[1] + distance * out[1]];
        }
        along -= quarter;
    }
    lower
}
