//! The region to fill with its straight and curved walls.

use super::{Options, PackingError, Spacing};
use crate::geometry::Vec2;
use crate::shapes::{Region, Shape};

/// A boundary at which particles are mirrored.
#[derive(Debug, Clone)]
pub(super) enum Wall {
    /// The line where coordinate `axis` is `at`; the region lies on the side of `inward` (+1 or -1).
    Line { axis: usize, at: f64, inward: f64 },
    /// The rim of a disc; the region lies inside.
    Rim(Shape),
    /// The rim of a hole; the region lies outside.
    Hole(Shape),
}

impl Wall {
    /// Distance from the wall into the region, m, negative behind it.
    pub(super) fn depth(&self, x: Vec2) -> f64 {
        match self {
            Self::Line { axis, at, inward } => (x[*axis] - at) * inward,
            Self::Rim(shape) => -shape.signed_distance(x),
            Self::Hole(shape) => shape.signed_distance(x),
        }
    }

    /// Whether two walls are lines across the same direction.
    pub(super) fn is_opposite(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Line { axis: a, .. }, Self::Line { axis: b, .. }) => a == b,
            _ => false,
        }
    }

    /// The mirror image.
    pub(super) fn mirror(&self, x: Vec2) -> Vec2 {
        match self {
            Self::Line { axis, at, .. } => {
                let mut image = x;
                image[*axis] = 2.0 * at - x[*axis];
                image
            }
            Self::Rim(shape) | Self::Hole(shape) => shape.mirror(x),
        }
    }
}

/// The region, its outer walls (the axis included) and the holes.
pub(super) struct Domain<'a> {
    pub(super) region: &'a Region,
    pub(super) walls: Vec<Wall>,
    hole_margin: f64,
}

impl<'a> Domain<'a> {
    pub(super) fn new(region: &'a Region, options: &Options) -> Result<Self, PackingError> {
        let line = |axis, at, inward| Wall::Line { axis, at, inward };
        let walls = match &region.shape {
            Shape::Rectangle { lower, upper } => {
                if options.axis && lower[0] < 0.0 {
                    return Err(PackingError::NegativeRadius { lower: lower[0] });
                }
                vec![
                    line(0, lower[0], 1.0),
                    line(0, upper[0], -1.0),
                    line(1, lower[1], 1.0),
                    line(1, upper[1], -1.0),
                ]
            }
            disc @ Shape::Disc { .. } if options.axis => {
                vec![line(0, 0.0, 1.0), Wall::Rim(disc.clone())]
            }
            disc @ Shape::Disc { .. } => vec![Wall::Rim(disc.clone())],
        };
        Ok(Self {
            region,
            walls,
            hole_margin: options.hole_margin,
        })
    }

    /// Smallest and largest coordinates, cut at the axis.
    pub(super) fn bounding_box(&self) -> (Vec2, Vec2) {
        let (mut lower, upper) = self.region.bounding_box();
        for wall in &self.walls {
            if let Wall::Line { axis, at, inward } = wall
                && *inward > 0.0
            {
                lower[*axis] = lower[*axis].max(*at);
            }
        }
        (lower, upper)
    }

    pub(super) fn check_size(&self, spacing: &Spacing) -> Result<(), PackingError> {
        let (lower, upper) = self.bounding_box();
        let extent = (upper[0] - lower[0]).min(upper[1] - lower[1]);
        let coarsest_here = [lower, [upper[0], lower[1]], upper, [lower[0], upper[1]]]
            .map(|corner| spacing.at(corner))
            .into_iter()
            .fold(0.0, f64::max);
        let rows = [(2.0, spacing.finest), (1.0, coarsest_here)];
        match rows
            .into_iter()
            .find(|(n, s)| extent < n * s * (1.0 - 1e-9))
        {
            None => Ok(()),
            Some((rows, spacing)) => Err(PackingError::TooSmall {
                extent,
                rows,
                spacing,
            }),
        }
    }

    /// The outer walls and the rims of the holes.
    pub(super) fn all_walls(&self) -> Vec<Wall> {
        let holes = self.region.holes.iter().cloned().map(Wall::Hole);
        self.walls.iter().cloned().chain(holes).collect()
    }

    /// Distance to the nearest outer wall, m, negative outside.
    pub(super) fn depth(&self, x: Vec2) -> f64 {
        self.walls
            .iter()
            .map(|wall| wall.depth(x))
            .fold(f64::INFINITY, f64::min)
    }

    /// Distance to the nearest hole, m, negative inside.
    pub(super) fn hole_distance(&self, x: Vec2) -> f64 {
        self.region
            .holes
            .iter()
            .map(|hole| hole.signed_distance(x))
            .fold(f64::INFINITY, f64::min)
    }

    /// Whether a particle of this spacing may be placed at `x`.
    pub(super) fn admits(&self, x: Vec2, spacing: f64) -> bool {
        self.depth(x) >= 0.0 && self.hole_distance(x) >= self.hole_margin * spacing
    }
}
