//! The rectangle a solid fills in its reference configuration, and what acts on its four faces.

use super::SolidError;
use crate::geometry::{Geometry, Vec2};
use serde::{Deserialize, Serialize};

/// A face of the rectangle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Side {
    /// Smallest first coordinate.
    Left,
    /// Largest first coordinate.
    Right,
    /// Smallest second coordinate.
    Bottom,
    /// Largest second coordinate.
    Top,
}

impl Side {
    /// All four, in the order of their declaration.
    pub const ALL: [Self; 4] = [Self::Left, Self::Right, Self::Bottom, Self::Top];

    /// Coordinate (0 or 1) along the normal of the face.
    #[must_use]
    pub fn normal_axis(self) -> usize {
        match self {
            Self::Left | Self::Right => 0,
            Self::Bottom | Self::Top => 1,
        }
    }

    /// Sign of the outward normal on its axis.
    #[must_use]
    pub fn sign(self) -> f64 {
        match self {
            Self::Left | Self::Bottom => -1.0,
            Self::Right | Self::Top => 1.0,
        }
    }
}

/// What acts on a face.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Face {
    /// Axis of rotation at r = 0: mirrored with a signed radius.
    Axis,
    /// Rigid wall without friction (a roller): mirrored.
    Symmetry,
    /// Rigid wall to which the body is bonded.
    Clamped,
    /// Moved as the caller says, see [`super::Surface::drive`].
    Driven(Driven),
    /// Pressure given by the caller, zero at first.
    Traction,
    /// Nothing acts, ever: without images force and strain use the same gradients, so that energy is kept without
    /// viscosity (not around an axis, whose images are not adjoint: a body with an axis needs the usual viscosity). A wave in a bar six particles in radius is 1.7 % slow with it, with a traction face 0.5 %.
    Free,
    /// Waves leave (see `absorbing.rs`).
    Absorbing,
}

/// A face with prescribed motion.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Driven {
    /// What happens along the face.
    pub tangential: Tangential,
    /// The part of the face that is driven, as first and last coordinate along it in the reference (m); the rest has
    /// pressure given by the caller. None: the whole face.
    pub part: Option<[f64; 2]>,
}

/// Motion along a driven face.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Tangential {
    /// Free of shear: only the normal component is prescribed.
    Free,
    /// Both components are prescribed.
    Bonded,
}

/// How a particle is continued beyond a face.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Reflection {
    /// Mirrored: normal motion and shear change sign.
    Mirror,
    /// The same about a prescribed normal motion.
    Slip,
    /// All motion changes sign about a prescribed one; the stress is even.
    Bonded,
    /// Only the traction is known.
    Open,
}

impl Face {
    /// Whether nothing can be prescribed on the face, so that it has no surface points.
    #[must_use]
    pub fn mirrors(self) -> bool {
        matches!(self, Self::Axis | Self::Symmetry | Self::Clamped)
    }
}

/// Reference rectangle with its four faces.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Block {
    /// Corner with the smallest coordinates, m.
    pub lower: Vec2,
    /// Corner with the largest coordinates, m.
    pub upper: Vec2,
    /// Condition on [`Side::Left`].
    pub left: Face,
    /// Condition on [`Side::Right`].
    pub right: Face,
    /// Condition on [`Side::Bottom`].
    pub bottom: Face,
    /// Condition on [`Side::Top`].
    pub top: Face,
}

impl Block {
    /// Condition on a face.
    #[must_use]
    pub fn face(&self, side: Side) -> Face {
        match side {
            Side::Left => self.left,
            Side::Right => self.right,
            Side::Bottom => self.bottom,
            Side::Top => self.top,
        }
    }

    /// How a particle with reference position `point` is continued beyond a face; not at all beyond a free one.
    pub(super) fn reflection(&self, side: Side, point: Vec2) -> Option<Reflection> {
        Some(match self.face(side) {
            Face::Free => return None,
            Face::Axis | Face::Symmetry => Reflection::Mirror,
            Face::Clamped => Reflection::Bonded,
            Face::Traction | Face::Absorbing => Reflection::Open,
            Face::Driven(driven) => {
                let along = point[1 - side.normal_axis()];
                match (driven.part, driven.tangential) {
                    (Some([from, to]), _) if !(from..=to).contains(&along) => Reflection::Open,
                    (_, Tangential::Free) => Reflection::Slip,
                    (_, Tangential::Bonded) => Reflection::Bonded,
                }
            }
        })
    }

    /// Coordinate of a face along its normal axis, m.
    #[must_use]
    pub fn coordinate(&self, side: Side) -> f64 {
        match side {
            Side::Left | Side::Bottom => self.lower[side.normal_axis()],
            Side::Right | Side::Top => self.upper[side.normal_axis()],
        }
    }

    /// Distance of a point inside from a face, m.
    #[must_use]
    pub fn depth(&self, side: Side, point: Vec2) -> f64 {
        (self.coordinate(side) - point[side.normal_axis()]) * side.sign()
    }

    /// Reflects a point in a face.
    #[must_use]
    pub fn reflect(&self, side: Side, mut point: Vec2) -> Vec2 {
        let axis = side.normal_axis();
        point[axis] = 2.0 * self.coordinate(side) - point[axis];
        point
    }

    /// Checks the rectangle and its conditions.
    ///
    /// # Errors
    /// If it is empty, not finite, crosses the axis, or has an axis where there is none.
    pub fn check(&self, geometry: Geometry) -> Result<(), SolidError> {
        let error = |why: &str| {
            Err(SolidError::BadBlock {
                block: Box::new(*self),
                why: why.to_owned(),
            })
        };
        let size = [0, 1].map(|i| self.upper[i] - self.lower[i]);
        if !size.iter().all(|s| s.is_finite() && *s > 0.0) {
            return error("its upper corner must lie above and to the right of its lower corner");
        }
        if [self.right, self.bottom, self.top].contains(&Face::Axis) {
            return error("only its left face can be the axis");
        }
        if geometry == Geometry::Axisymmetric {
            if self.lower[0] < 0.0 {
                return error("in axisymmetry r must not be negative");
            }
            if (self.lower[0] == 0.0) != (self.left == Face::Axis) {
                return error("its left face must be the axis exactly when it lies at r = 0");
            }
        } else if self.left == Face::Axis {
            return error("plane strain has no axis; use a symmetry face");
        }
        self.check_driven()
    }

    /// A driven part must lie on its face, and a driven face must leave its neighbours their own conditions.
    fn check_driven(&self) -> Result<(), SolidError> {
        let bad = |why: String| {
            Err(SolidError::BadBlock {
                block: Box::new(*self),
                why,
            })
        };
        for side in Side::ALL {
            let Face::Driven(driven) = self.face(side) else {
                continue;
            };
            let along = 1 - side.normal_axis();
            let (first, last) = (self.lower[along], self.upper[along]);
            if let Some([from, to]) = driven.part
                && !(first <= from && from < to && to <= last)
            {
                return bad(format!(
                    "the driven part of its {side:?} face from {from} m to {to} m must lie on the face, which goes from \
                     {first} m to {last} m"
                ));
            }
            let ends = match along {
                0 => [(Side::Left, first), (Side::Right, last)],
                _ => [(Side::Bottom, first), (Side::Top, last)],
            };
            for (end, at) in ends {
                let reached = driven.part.is_none_or(|[from, to]| from <= at && at <= to);
                if reached && matches!(self.face(end), Face::Driven(_)) {
                    return bad(format!(
                        "its {side:?} and {end:?} faces are both driven up to the corner they share, where they may \
                         contradict each other; drive only part of one of them"
                    ));
                }
            }
        }
        Ok(())
    }
}
