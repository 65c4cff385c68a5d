//! Plane shapes that are filled with particles.

use crate::geometry::Vec2;
use serde::{Deserialize, Serialize};

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
