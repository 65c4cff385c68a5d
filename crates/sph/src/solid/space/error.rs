//! What can go wrong with a solid in three dimensions.

use erode_physics::return_mapping::ReturnError;
use thiserror::Error;

/// Why a solid in three dimensions could not be built or advanced. Particles have their number in the body.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SpaceError {
    /// Array lengths.
    #[error(
        "a solid needs as many volumes as positions, at least one and at most 2^32 - 1; got {positions} and {volumes}"
    )]
    BadCount {
        /// Positions given.
        positions: usize,
        /// Volumes given.
        volumes: usize,
    },
    /// A particle without place or volume.
    #[error(
        "solid particle {particle} at {position:?} m with volume {volume} m3: the position must be finite and the volume \
         positive"
    )]
    BadParticle {
        /// Its index as it was given.
        particle: usize,
        /// Its reference position, m.
        position: [f64; 3],
        /// Its volume, m3.
        volume: f64,
    },
    /// No gradient possible.
    #[error(
        "solid particle {particle} at {position:?} m has neighbours that do not span a gradient; the body needs several \
         particles across in all directions and volumes that match their spacing"
    )]
    TooFewNeighbours {
        /// Its number.
        particle: usize,
        /// Its reference position, m.
        position: [f64; 3],
    },
    /// A particle turned inside out.
    #[error(
        "`deformation` of particle {particle} at {position:?} m is turned inside out (volume ratio {volume_ratio:.3})"
    )]
    Inverted {
        /// Its number.
        particle: usize,
        /// Its position, m.
        position: [f64; 3],
        /// Present over reference volume.
        volume_ratio: f64,
    },
    /// The stress could not be returned.
    #[error("`stress` of particle {particle} at {position:?} m could not be updated: {source}")]
    Return {
        /// Its number.
        particle: usize,
        /// Its position, m.
        position: [f64; 3],
        /// Why.
        source: ReturnError,
    },
    /// A state of another body.
    #[error("the state has {state} particles, the solid {solid}: it belongs to another body")]
    OtherState {
        /// Particles of the state.
        state: usize,
        /// Particles of the body.
        solid: usize,
    },
}
