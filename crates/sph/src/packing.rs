//! Filling a shape with particles of graded spacing.

use crate::shapes::Shape;
use serde::{Deserialize, Serialize};

/// Particle spacing as a function of place: `finest` inside `core`, growing by `growth` metres per metre of distance
/// from it, up to `coarsest`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Spacing {
    /// Spacing inside the core, m.
    pub finest: f64,
    /// Largest spacing, m.
    pub coarsest: f64,
    /// Increase of spacing per distance from the core, dimensionless (0.06 is a good value).
    pub growth: f64,
    /// Where the spacing is finest; everywhere when absent.
    pub core: Option<Shape>,
}
