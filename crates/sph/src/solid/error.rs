//! What can go wrong with a solid.

use super::block::{Block, Face, Side};
use crate::geometry::Vec2;
use erode_physics::return_mapping::ReturnError;
use thiserror::Error;

/// Why a solid could not be built or advanced.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SolidError {
    /// The reference rectangle makes no sense.
    #[error("the block of the solid {block:?} is not usable: {why}")]
    BadBlock {
        /// The block.
        block: Box<Block>,
        /// The rule it breaks.
        why: String,
    },
    /// The layers do not fit.
    #[error("the layers of the solid are not usable: {why}")]
    BadLayers {
        /// The rule they break.
        why: String,
    },
    /// Array lengths.
    #[error(
        "a solid needs as many areas as positions and at least one; got {positions} and {areas}"
    )]
    BadCount {
        /// Positions given.
        positions: usize,
        /// Areas given.
        areas: usize,
    },
    /// A particle outside the block or without area.
    #[error(
        "solid particle {particle} at {position:?} m with area {area} m2: it must lie inside the block, not on a face, \
         and have a positive area"
    )]
    BadParticle {
        /// Its index.
        particle: usize,
        /// Its reference position, m.
        position: Vec2,
        /// Its area, m2.
        area: f64,
    },
    /// No gradient possible.
    #[error(
        "solid particle {particle} at {position:?} m has {neighbours} neighbours, which do not span a gradient; the \
         body needs several particles across and areas that match their spacing"
    )]
    TooFewNeighbours {
        /// Its index.
        particle: usize,
        /// Its reference position, m.
        position: Vec2,
        /// Neighbours and mirror images found.
        neighbours: usize,
    },
    /// Nothing can act on a free face.
    #[error(
        "a pressure of {pressure} Pa is set on the {side:?} face, which is free; a face that can be pressed on is a traction \
         face"
    )]
    PressureOnFreeFace {
        /// The face.
        side: Side,
        /// Pressure set, Pa.
        pressure: f64,
    },
    /// The reference configuration cannot be renewed.
    #[error(
        "the reference configuration cannot be renewed: {why} ({side:?} face); all faces must be free, without pressure or \
         indenter, symmetric or the axis"
    )]
    NotRenewable {
        /// The face.
        side: Side,
        /// What is in the way.
        why: String,
    },
    /// No particle near a face.
    #[error(
        "no particle lies within three quarters of its spacing of the {side:?} face of the solid"
    )]
    NoSurface {
        /// The face.
        side: Side,
    },
    /// A load beside the body.
    #[error(
        "the load of half width {half_width} m at {centre} m on the {side:?} face does not act on the body: its centre must \
         lie on the face, which goes from {} m to {} m, and its half width must be positive",
        face[0],
        face[1]
    )]
    LoadOutside {
        /// The face.
        side: Side,
        /// Centre along the face, m.
        centre: f64,
        /// Half width, m.
        half_width: f64,
        /// Ends of the face, m.
        face: [f64; 2],
    },
    /// A load on a face whose condition leaves no room for one.
    #[error(
        "no load can act on the {side:?} face, which is {face:?}; it needs a face with given pressure or motion"
    )]
    NotLoadable {
        /// The face.
        side: Side,
        /// Its condition.
        face: Face,
    },
    /// An indenter that cannot press on the body.
    #[error("the indenter is not usable: {why}")]
    BadIndenter {
        /// The rule it breaks.
        why: String,
    },
    /// A driven part without points.
    #[error(
        "no point of the {side:?} face lies in its driven part; the part must hold at least one particle of the first row"
    )]
    NothingDriven {
        /// The face.
        side: Side,
    },
    /// A face whose particles cannot carry the traction.
    #[error(
        "the particles under the {side:?} face near {position:?} m take up {share} of its traction, not about 1: the \
         first rows must follow the face, half a spacing beneath it"
    )]
    UnevenFace {
        /// The face.
        side: Side,
        /// Point of the face, m.
        position: Vec2,
        /// Share transmitted before scaling.
        share: f64,
    },
    /// A particle turned inside out.
    #[error(
        "`deformation` of particle {particle} at r = {:.4e} m, z = {:.4e} m is turned inside out (volume ratio \
         {volume_ratio:.3})",
        position[0],
        position[1]
    )]
    Inverted {
        /// Its index.
        particle: usize,
        /// Its position, m.
        position: Vec2,
        /// Present over reference volume.
        volume_ratio: f64,
    },
    /// The stress could not be returned.
    #[error(
        "`stress` of particle {particle} at r = {:.4e} m, z = {:.4e} m could not be updated: {source}",
        position[0],
        position[1]
    )]
    Return {
        /// Its index.
        particle: usize,
        /// Its position, m.
        position: Vec2,
        /// Why.
        source: ReturnError,
    },
}

impl SolidError {
    /// Where a calculation failed, m; none for errors of the setup.
    #[must_use]
    pub fn position(&self) -> Option<Vec2> {
        match self {
            Self::Inverted { position, .. } | Self::Return { position, .. } => Some(*position),
            _ => None,
        }
    }
}
