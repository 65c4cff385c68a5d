//! Particle spacing as a function of place.

use super::PackingError;
use crate::geometry::Vec2;
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

impl Spacing {
    /// The same spacing everywhere.
    #[must_use]
    pub fn uniform(spacing: f64) -> Self {
        Self {
            finest: spacing,
            coarsest: spacing,
            growth: 0.0,
            core: None,
        }
    }

    /// Spacing at a point, m.
    #[must_use]
    pub fn at(&self, point: Vec2) -> f64 {
        match &self.core {
            None => self.finest,
            Some(core) => (self.finest + self.growth * core.distance(point)).min(self.coarsest),
        }
    }

    pub(super) fn check(&self) -> Result<(), PackingError> {
        let wrong = |what, value, allowed| {
            Err(PackingError::Spacing {
                what,
                value,
                allowed,
            })
        };
        if !(self.finest.is_finite() && self.finest > 0.0) {
            return wrong("the finest spacing", self.finest, "a positive length in m");
        }
        if !(self.coarsest.is_finite() && self.coarsest >= self.finest) {
            return wrong(
                "the coarsest spacing",
                self.coarsest,
                "at least the finest spacing",
            );
        }
        if !(0.0..=0.2).contains(&self.growth) {
            return wrong("the growth of the spacing", self.growth, "0 to 0.2");
        }
        Ok(())
    }
}
