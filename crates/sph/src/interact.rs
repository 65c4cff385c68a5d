//! Who acts on whom: the one table of interactions.

use crate::world::Body;

/// What two bodies do to each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interaction {
    /// The liquid is mirrored at the wall ([`crate::fluid::ghosts`]).
    Mirror,
    /// The liquid is mirrored at the surface of the solid and pushes it ([`crate::interface`]).
    Interface,
    /// They never meet: both are at rest for ever.
    Nothing,
    /// Not built: a world with such a pair is refused.
    Missing(&'static str),
}

/// The table.
#[must_use]
pub fn between(a: &Body, b: &Body) -> Interaction {
    use Body::{Fluid, Solid, Wall};
    match (a, b) {
        (Fluid(_), Wall(_)) | (Wall(_), Fluid(_)) => Interaction::Mirror,
        (Fluid(_), Solid(_)) | (Solid(_), Fluid(_)) => Interaction::Interface,
        (Wall(_), Wall(_)) => Interaction::Nothing,
        (Fluid(_), Fluid(_)) => Interaction::Missing("two liquids that touch"),
        (Solid(_), Solid(_)) => Interaction::Missing("contact between solids"),
        (Solid(_), Wall(_)) | (Wall(_), Solid(_)) => Interaction::Missing("contact of a solid with a wall"),
    }
}
