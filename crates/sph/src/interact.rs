//! Who acts on whom: the one table of interactions.

use crate::world::Body;

/// What two bodies do to each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interaction {
    /// The liquid is mirrored at the surface of the solid and pushes it ([`crate::interface`]).
    Interface,
    /// Not built: a world with such a pair is refused.
    Missing(&'static str),
}

/// The table.
#[must_use]
pub fn between(a: &Body, b: &Body) -> Interaction {
    use Body::{Fluid, Solid};
    match (a, b) {
        (Fluid(_), Solid(_)) | (Solid(_), Fluid(_)) => Interaction::Interface,
        (Fluid(_), Fluid(_)) => Interaction::Missing("two liquids that touch"),
        (Solid(_), Solid(_)) => Interaction::Missing("contact between solids"),
    }
}
