//! The switching of Peters and el Moctar 2020, section 3.3: eq. 3.36 while the bubble grows, eq. 3.37 while it
//! collapses. The law changes where R' = 0, located exactly, and not with the sign at the last step.
//!
//! Known weakness: the rebound is not damped by radiation, so its radius is 50 to 65 % larger than that of the
//! compressible models.

use super::{RayleighPlesset, TomitaShima};
use crate::bubble::{Ambient, BubbleModel, Gas, Liquid, Phase, Wall};
use serde::{Deserialize, Serialize};

/// Rayleigh-Plesset in growth, Tomita-Shima in collapse.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Switching {
    /// The law of the collapse.
    pub collapse: TomitaShima,
}

impl BubbleModel for Switching {
    fn name(&self) -> &'static str {
        "switching"
    }

    #[inline]
    fn acceleration(&self, liquid: &Liquid, gas: &Gas, wall: &Wall, ambient: &Ambient) -> f64 {
        match wall.phase {
            Phase::Growth => RayleighPlesset.acceleration(liquid, gas, wall, ambient),
            Phase::Collapse => self.collapse.acceleration(liquid, gas, wall, ambient),
        }
    }

    fn switches(&self) -> bool {
        true
    }
}
