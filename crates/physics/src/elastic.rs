//! Isotropic linear elasticity.

use crate::tensor::Sym3;
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

impl Elastic {
    /// Stress (Pa) of a small strain: lambda tr(e) I + 2 mu e.
    #[must_use]
    pub fn stress(&self, strain: Sym3) -> Sym3 {
        Sym3::isotropic(self.lame_lambda() * strain.trace()) + strain * (2.0 * self.shear_modulus())
    }

    /// Energy per volume (J/m3) stored by a stress: mean^2/(2K) + s:s/(4G).
    #[must_use]
    pub fn energy_density(&self, stress: Sym3) -> f64 {
        let (mean, s) = (stress.mean(), stress.deviator());
        mean * mean / (2.0 * self.bulk_modulus()) + s.double_dot(s) / (4.0 * self.shear_modulus())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEEL: Elastic = Elastic {
        young_modulus: 186e9,
        poisson_ratio: 0.3,
    };

    #[test]
    fn uniaxial_stress_follows_young_and_poisson() {
        let strain = Sym3 {
            xx: 1e-3,
            yy: -3e-4,
            zz: -3e-4,
            ..Sym3::ZERO
        };
        let stress = STEEL.stress(strain);
        assert!((stress.xx / 186e6 - 1.0).abs() < 1e-12);
        assert!(stress.yy.abs() < 1.0 && stress.zz.abs() < 1.0);
        // Energy is half of stress times strain.
        assert!((STEEL.energy_density(stress) / (0.5 * 186e6 * 1e-3) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn wave_speed_of_a2205_is_the_one_of_the_errata() {
        assert!((STEEL.longitudinal_speed(7800.0) - 5666.0).abs() < 1.0);
    }
}
