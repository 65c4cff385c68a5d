//! Isotropic linear elasticity.

use serde::{Deserialize, Serialize};

/// Elastic constants of an isotropic solid.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Elastic {
    /// Young's modulus, Pa.
    pub young_modulus: f64,
    /// Poisson's ratio, dimensionless, in (-1, 0.5).
    pub poisson_ratio: f64,
}

impl Elastic {
    /// Shear modulus G = mu, Pa.
    #[must_use]
    pub fn shear_modulus(&self) -> f64 {
        self.young_modulus / (2.0 * (1.0 + self.poisson_ratio))
    }

    /// Bulk modulus K, Pa.
    #[must_use]
    pub fn bulk_modulus(&self) -> f64 {
        self.young_modulus / (3.0 * (1.0 - 2.0 * self.poisson_ratio))
    }

    /// Lame's first constant lambda = K - 2G/3, Pa.
    #[must_use]
    pub fn lame_lambda(&self) -> f64 {
        self.bulk_modulus() - 2.0 / 3.0 * self.shear_modulus()
    }

    /// Longitudinal wave speed sqrt((lambda + 2 mu)/rho), m/s.
    #[must_use]
    pub fn longitudinal_speed(&self, density: f64) -> f64 {
        ((self.lame_lambda() + 2.0 * self.shear_modulus()) / density).sqrt()
    }

    /// Shear wave speed sqrt(mu/rho), m/s.
    #[must_use]
    pub fn shear_speed(&self, density: f64) -> f64 {
        (self.shear_modulus() / density).sqrt()
    }
}
