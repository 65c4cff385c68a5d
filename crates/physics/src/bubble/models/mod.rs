//! Laws of the wall, one file each.

mod gilmore;
mod keller_miksis;
mod rayleigh_plesset;
mod switching;
mod tomita_shima;

pub use gilmore::Gilmore;
pub use keller_miksis::KellerMiksis;
pub use rayleigh_plesset::RayleighPlesset;
pub use switching::Switching;
pub use tomita_shima::TomitaShima;

use super::{Ambient, BubbleModel, Gas, Liquid, Wall};
use serde::{Deserialize, Serialize};

/// The laws of this crate, as data (chosen by a case file).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Model {
    /// Incompressible liquid.
    RayleighPlesset(RayleighPlesset),
    /// Compressible to first order in the Mach number.
    KellerMiksis(KellerMiksis),
    /// Compressible with the enthalpy of the liquid.
    Gilmore(Gilmore),
    /// Compressible as in Peters and el Moctar 2020, eq. 3.37.
    TomitaShima(TomitaShima),
    /// Rayleigh-Plesset while the bubble grows, Tomita-Shima while it collapses.
    Switching(Switching),
}

impl BubbleModel for Model {
    fn name(&self) -> &'static str {
        match self {
            Self::RayleighPlesset(model) => model.name(),
            Self::KellerMiksis(model) => model.name(),
            Self::Gilmore(model) => model.name(),
            Self::TomitaShima(model) => model.name(),
            Self::Switching(model) => model.name(),
        }
    }

    #[inline]
    fn acceleration(&self, liquid: &Liquid, gas: &Gas, wall: &Wall, ambient: &Ambient) -> f64 {
        match self {
            Self::RayleighPlesset(model) => model.acceleration(liquid, gas, wall, ambient),
            Self::KellerMiksis(model) => model.acceleration(liquid, gas, wall, ambient),
            Self::Gilmore(model) => model.acceleration(liquid, gas, wall, ambient),
            Self::TomitaShima(model) => model.acceleration(liquid, gas, wall, ambient),
            Self::Switching(model) => model.acceleration(liquid, gas, wall, ambient),
        }
    }

    fn switches(&self) -> bool {
        matches!(self, Self::Switching(_))
    }
}

/// `numerator / factor`, or not a number where the factor of R'' is not positive: the wall outruns the model.
#[inline]
fn solved(numerator: f64, factor: f64) -> f64 {
    if factor > 0.0 {
        numerator / factor
    } else {
        f64::NAN
    }
}
