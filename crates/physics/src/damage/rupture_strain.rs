//! Rupture strain, with or without linear loss of the modulus.
//!
//! D = eps_p/eps_u, failed at D = 1                                             (Joshi 2018, eq. 4.8, section 5.4.1)
//! E = (1 - D) E0 where `modulus_loss` is set                                     (text below eq. 4.8)
//!
//! Units: plain numbers. Range: eps_u > 0. The text leaves open what yields: with a yield stress that stays, D = 1 is
//! reached at no finite strain (the elastic strain at yield grows like 1/(1 - D)), so the yield law is that of the sound
//! material under sigma/(1 - D); stress and modulus then fall to zero together at eps_p = eps_u.

use serde::{Deserialize, Serialize};

/// Fails at an equivalent plastic strain.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct RuptureStrain {
    /// eps_u, equivalent plastic strain at failure.
    pub rupture_strain: f64,
    /// Whether modulus and stress fall linearly with damage; otherwise they stay until failure.
    pub modulus_loss: bool,
}

#[cfg(test)]
mod tests {
    use super::super::{Damage, PlasticStep};
    use super::*;

    fn step(increment: f64) -> PlasticStep {
        PlasticStep {
            increment,
            rate: 1e3,
            triaxiality: -2.0,
            temperature: 900.0,
        }
    }

    #[test]
    fn fails_at_the_rupture_strain_whatever_the_path() {
        let law = Damage::RuptureStrain(RuptureStrain {
            rupture_strain: 0.03,
            modulus_loss: true,
        });
        let damage = (0..30).fold(0.0, |d, _| law.after(d, step(1e-3)));
        assert!((damage - 1.0).abs() < 1e-13);
        assert_eq!(law.after(0.4, step(0.0)), 0.4);
        assert!((law.integrity(0.25) - 0.75).abs() < 1e-15);
        assert_eq!(law.integrity(1.2), 0.0);
    }

    #[test]
    fn without_loss_of_modulus_the_material_is_sound_until_it_fails() {
        let law = Damage::RuptureStrain(RuptureStrain {
            rupture_strain: 0.25,
            modulus_loss: false,
        });
        assert_eq!(law.integrity(0.999), 1.0);
        assert!((law.after(0.0, step(0.05)) - 0.2).abs() < 1e-15);
        assert_eq!(Damage::None.after(0.0, step(5.0)), 0.0);
    }
}
