//! Plane shapes that are filled with particles.
//!
//! Distances are signed: negative inside, zero on the boundary, positive outside (m). Normals point outwards.

use crate::geometry::Vec2;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// A region of the (r, z) or (x, y) plane, metres.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Shape {
    /// Rectangle with sides along the axes.
    Rectangle {
        /// Corner with the smallest coordinates.
        lower: Vec2,
        /// Corner with the largest coordinates.
        upper: Vec2,
    },
    /// Disc (a ball in axisymmetry when centred on the axis).
    Disc {
        /// Centre.
        centre: Vec2,
        /// Radius, m.
        radius: f64,
    },
}

impl Shape {
    /// Distance to the boundary, m, negative inside.
    #[must_use]
    pub fn signed_distance(&self, point: Vec2) -> f64 {
        match *self {
            Self::Rectangle { lower, upper } => {
                let d = [0, 1].map(|k| (lower[k] - point[k]).max(point[k] - upper[k]));
                d[0].max(0.0).hypot(d[1].max(0.0)) + d[0].max(d[1]).min(0.0)
            }
            Self::Disc { centre, radius } => {
                (point[0] - centre[0]).hypot(point[1] - centre[1]) - radius
            }
        }
    }

    /// Distance to the shape, m: zero inside.
    #[must_use]
    pub fn distance(&self, point: Vec2) -> f64 {
        self.signed_distance(point).max(0.0)
    }

    /// Whether the point lies inside or on the boundary.
    #[must_use]
    pub fn contains(&self, point: Vec2) -> bool {
        self.signed_distance(point) <= 0.0
    }

    /// Outward unit normal of the boundary point nearest to `point` (the gradient of the signed distance).
    ///
    /// Where several boundary points are equally near (centre of a disc, diagonals of a rectangle) the first
    /// coordinate decides, towards the smaller side.
    #[must_use]
    pub fn normal(&self, point: Vec2) -> Vec2 {
        match *self {
            Self::Rectangle { lower, upper } => rectangle_normal(lower, upper, point),
            Self::Disc { centre, .. } => unit([point[0] - centre[0], point[1] - centre[1]]),
        }
    }

    /// The point mirrored at the tangent of the nearest boundary point.
    #[must_use]
    pub fn mirror(&self, point: Vec2) -> Vec2 {
        let n = self.normal(point);
        let d = 2.0 * self.signed_distance(point);
        [point[0] - d * n[0], point[1] - d * n[1]]
    }

    /// Smallest and largest coordinates.
    #[must_use]
    pub fn bounding_box(&self) -> (Vec2, Vec2) {
        match *self {
            Self::Rectangle { lower, upper } => (lower, upper),
            Self::Disc { centre, radius } => {
                (centre.map(|c| c - radius), centre.map(|c| c + radius))
            }
        }
    }

    /// Area, m2.
    #[must_use]
    pub fn area(&self) -> f64 {
        match *self {
            Self::Rectangle { lower, upper } => (upper[0] - lower[0]) * (upper[1] - lower[1]),
            Self::Disc { radius, .. } => PI * radius * radius,
        }
    }

    /// Area shared with another shape, m2, exact.
    #[must_use]
    pub fn overlap_area(&self, other: &Self) -> f64 {
        match (self, other) {
            (Self::Rectangle { lower, upper }, Self::Rectangle { lower: l, upper: u }) => {
                let side = |k: usize| (upper[k].min(u[k]) - lower[k].max(l[k])).max(0.0);
                side(0) * side(1)
            }
            (Self::Rectangle { lower, upper }, Self::Disc { centre, radius })
            | (Self::Disc { centre, radius }, Self::Rectangle { lower, upper }) => {
                rectangle_disc_area(*lower, *upper, *centre, *radius)
            }
            (
                Self::Disc { centre, radius },
                Self::Disc {
                    centre: c,
                    radius: r,
                },
            ) => lens_area((centre[0] - c[0]).hypot(centre[1] - c[1]), *radius, *r),
        }
    }
}

/// A shape with holes. Holes must not overlap each other; they may reach over the edge of the shape.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Region {
    /// Outer boundary.
    pub shape: Shape,
    /// Parts cut out.
    #[serde(default)]
    pub holes: Vec<Shape>,
}

impl Region {
    /// A shape without holes.
    #[must_use]
    pub fn new(shape: Shape) -> Self {
        Self {
            shape,
            holes: Vec::new(),
        }
    }

    /// The same region with one more hole.
    #[must_use]
    pub fn with_hole(mut self, hole: Shape) -> Self {
        self.holes.push(hole);
        self
    }

    /// Distance to the nearest of all boundaries, m, negative inside (a lower bound where boundaries cross).
    #[must_use]
    pub fn signed_distance(&self, point: Vec2) -> f64 {
        self.holes
            .iter()
            .map(|hole| -hole.signed_distance(point))
            .fold(self.shape.signed_distance(point), f64::max)
    }

    /// Distance to the region, m: zero inside.
    #[must_use]
    pub fn distance(&self, point: Vec2) -> f64 {
        self.signed_distance(point).max(0.0)
    }

    /// Whether the point lies inside the shape and outside of (or on the edge of) all holes.
    #[must_use]
    pub fn contains(&self, point: Vec2) -> bool {
        self.signed_distance(point) <= 0.0
    }

    /// Unit normal of the nearest boundary, pointing out of the region (into a hole if that is nearest).
    #[must_use]
    pub fn normal(&self, point: Vec2) -> Vec2 {
        let mut best = self.shape.signed_distance(point);
        let mut normal = self.shape.normal(point);
        for hole in &self.holes {
            let d = -hole.signed_distance(point);
            if d > best {
                best = d;
                normal = hole.normal(point).map(|n| -n);
            }
        }
        normal
    }

    /// The point mirrored at the nearest boundary.
    #[must_use]
    pub fn mirror(&self, point: Vec2) -> Vec2 {
        let n = self.normal(point);
        let d = 2.0 * self.signed_distance(point);
        [point[0] - d * n[0], point[1] - d * n[1]]
    }

    /// Smallest and largest coordinates.
    #[must_use]
    pub fn bounding_box(&self) -> (Vec2, Vec2) {
        self.shape.bounding_box()
    }

    /// Area, m2, exact for holes that do not overlap each other.
    #[must_use]
    pub fn area(&self) -> f64 {
        let cut: f64 = self
            .holes
            .iter()
            .map(|hole| self.shape.overlap_area(hole))
            .sum();
        self.shape.area() - cut
    }
}

fn unit(v: Vec2) -> Vec2 {
    let length = v[0].hypot(v[1]);
    if length > 0.0 {
        [v[0] / length, v[1] / length]
    } else {
        [-1.0, 0.0]
    }
}

fn rectangle_normal(lower: Vec2, upper: Vec2, point: Vec2) -> Vec2 {
    let nearest = [0, 1].map(|k| point[k].max(lower[k]).min(upper[k]));
    let outside = [point[0] - nearest[0], point[1] - nearest[1]];
    if outside != [0.0, 0.0] {
        return unit(outside);
    }
    let sides = [
        (lower[0] - point[0], [-1.0, 0.0]),
        (point[0] - upper[0], [1.0, 0.0]),
        (lower[1] - point[1], [0.0, -1.0]),
        (point[1] - upper[1], [0.0, 1.0]),
    ];
    let mut best = sides[0];
    for side in sides {
        if side.0 > best.0 {
            best = side;
        }
    }
    best.1
}

/// Area of the part of a disc inside a rectangle: sum over the sides of the area between centre and side, clipped
/// to the disc (Green's theorem; sectors where the side runs outside).
fn rectangle_disc_area(lower: Vec2, upper: Vec2, centre: Vec2, radius: f64) -> f64 {
    let corners = [
        lower,
        [upper[0], lower[1]],
        upper,
        [lower[0], upper[1]],
        lower,
    ]
    .map(|c| [c[0] - centre[0], c[1] - centre[1]]);
    corners
        .windows(2)
        .map(|side| triangle_disc_area(side[0], side[1], radius))
        .sum()
}

/// Signed area of the disc about the origin inside the triangle (origin, a, b).
fn triangle_disc_area(a: Vec2, b: Vec2, radius: f64) -> f64 {
    let along = [b[0] - a[0], b[1] - a[1]];
    let length = along[0].hypot(along[1]);
    if length == 0.0 {
        return 0.0;
    }
    let t = [along[0] / length, along[1] / length];
    let (start, end) = (a[0] * t[0] + a[1] * t[1], b[0] * t[0] + b[1] * t[1]);
    // Signed distance of the origin from the line; the chord inside the disc is [-half, half] along it.
    let offset = a[0] * t[1] - a[1] * t[0];
    let half = (radius * radius - offset * offset).max(0.0).sqrt();
    let angle = |s: f64| s.atan2(offset.abs());
    let sign = if offset < 0.0 { -1.0 } else { 1.0 };
    let sector = |from: f64, to: f64| 0.5 * radius * radius * (angle(to) - angle(from));
    let (from, to) = (start.clamp(-half, half), end.clamp(-half, half));
    let flat = 0.5 * offset.abs() * (to - from);
    let before = sector(start.min(-half), end.min(-half));
    let after = sector(start.max(half), end.max(half));
    sign * (flat + before + after)
}

fn lens_area(distance: f64, a: f64, b: f64) -> f64 {
    if distance >= a + b {
        return 0.0;
    }
    if distance <= (a - b).abs() {
        return PI * a.min(b).powi(2);
    }
    let segment = |r: f64, other: f64| {
        let x = (distance * distance + r * r - other * other) / (2.0 * distance);
        r * r * (x / r).clamp(-1.0, 1.0).acos() - x * (r * r - x * x).max(0.0).sqrt()
    };
    segment(a, b) + segment(b, a)
}

#[cfg(test)]
mod tests;
