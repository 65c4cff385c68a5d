//! What can be wrong with a request to fill a region.

use thiserror::Error;

/// Why a region cannot be filled.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum PackingError {
    /// A number of the spacing is out of range.
    #[error(
        "the particle spacing is not usable: {what} is {value:e}, allowed is {allowed}; check `spacing` of the body"
    )]
    Spacing {
        /// Which number.
        what: &'static str,
        /// Its value.
        value: f64,
        /// The allowed range in words.
        allowed: &'static str,
    },
    /// The region is narrower than two finest or one coarse spacing.
    #[error(
        "the region is only {extent:e} m wide, less than {rows} of the particle spacing {spacing:e} m that is reached in it; make the region larger or the spacing finer"
    )]
    TooSmall {
        /// Smallest extent, m.
        extent: f64,
        /// Spacings that must fit.
        rows: f64,
        /// Spacing, m.
        spacing: f64,
    },
    /// The region reaches to negative radii.
    #[error(
        "the region begins at r = {lower:e} m; in axisymmetry a region begins at r = 0 or at a positive radius"
    )]
    NegativeRadius {
        /// Lowest r, m.
        lower: f64,
    },
    /// The core of the spacing lies outside of the region.
    #[error(
        "the core of the particle spacing does not overlap the region; move the core into the region"
    )]
    CoreOutside,
    /// Shells need a disc.
    #[error(
        "concentric shells need a disc as the first hole of the region; add the hole or choose the lattice"
    )]
    NoDisc,
    /// More particles than can be numbered.
    #[error(
        "filling the region needs about {count:e} particles, allowed are 4e9; choose a coarser spacing"
    )]
    TooMany {
        /// Estimated number of particles.
        count: f64,
    },
}
