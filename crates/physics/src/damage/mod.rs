//! Damage of metals: when material fails, and what it loses on the way.
//!
//! D grows with plastic strain from 0 (sound) to 1 (failed). Where a law softens, the stress is sigma = (1 - D) sigma', sigma'
//! being that of the sound material at the same strain, with the yield law on sigma' (equivalence of strain).

use serde::{Deserialize, Serialize};

mod johnson_cook;
mod rupture_strain;
pub use johnson_cook::JohnsonCookDamage;
pub use rupture_strain::RuptureStrain;

/// What a damage law reads at a point that yields.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlasticStep {
    /// Increment of equivalent plastic strain.
    pub increment: f64,
    /// Its rate, 1/s.
    pub rate: f64,
    /// Mean stress over von Mises stress, positive in tension.
    pub triaxiality: f64,
    /// Temperature, K.
    pub temperature: f64,
}

/// The damage law of a solid, as data (closed set chosen by the case file).
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Damage {
    /// Never fails.
    #[default]
    None,
    /// Fails at a plastic strain.
    RuptureStrain(RuptureStrain),
    /// Fails at a plastic strain that depends on triaxiality, rate and temperature.
    JohnsonCook(JohnsonCookDamage),
}

impl Damage {
    /// Damage after a plastic step that began at `damage`; at 1 and above the material has failed.
    #[must_use]
    pub fn after(&self, damage: f64, step: PlasticStep) -> f64 {
        if step.increment <= 0.0 {
            return damage;
        }
        match self {
            Self::None => damage,
            Self::RuptureStrain(law) => damage + step.increment / law.rupture_strain,
            Self::JohnsonCook(law) => damage + law.growth(step),
        }
    }

    /// Share of the stress of the sound material that is left, in [0, 1].
    #[must_use]
    pub fn integrity(&self, damage: f64) -> f64 {
        match self {
            Self::RuptureStrain(law) if law.modulus_loss => (1.0 - damage).max(0.0),
            _ => 1.0,
        }
    }
}
