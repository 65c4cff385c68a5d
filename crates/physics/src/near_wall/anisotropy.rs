//! Anisotropy of a collapse, and what it says about displacement and jet.
//!
//! I    = 4.789 R_max^3 sqrt(p rho) zeta               Kelvin impulse over growth and collapse
//! zeta = 0.195 gamma^-2                               rigid wall (Supponen et al. 2016; Peters and el Moctar 2020, eq. 3.54)
//! zeta = |grad p| R_max/p                             uniform pressure gradient (Obreschkow et al. 2011)
//! dz/R_max = 2.5 zeta^0.6                             displacement between growth and collapse (eq. 3.53)
//! u_jet = 0.9 sqrt(p/rho)/zeta                        jet speed (Supponen et al. 2016)
//!
//! 4.789 and 0.195 follow from Rayleigh's collapse (see the tests). p: pressure of the liquid less that in the bubble, Pa.
//! Range: the power laws hold for zeta < 0.1 (gamma > 1.4); the jet is weak below 1e-3 and pierces the bubble above 4e-4.

use super::prolongation::driving_speed;

/// zeta gamma^2 near a rigid wall.
pub const WALL_COEFFICIENT: f64 = 0.195;
/// Below this anisotropy jets are weak: they hardly pierce the bubble.
pub const WEAK_LIMIT: f64 = 1e-3;
/// Above this anisotropy jets are strong and the power laws do not hold.
pub const POWER_LAW_LIMIT: f64 = 0.1;
/// Below this anisotropy the jet does not pierce the bubble (Obreschkow et al. 2011).
pub const PIERCING_ANISOTROPY: f64 = 4e-4;

/// Impulse over R^3 sqrt(p rho) zeta.
const IMPULSE: f64 = 4.789;

/// Regimes of jets by anisotropy (Supponen et al. 2016).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum JetRegime {
    /// zeta < 1e-3: stays in the bubble.
    Weak,
    /// 1e-3 to 0.1: pierces the bubble late, seen at the rebound.
    Intermediate,
    /// zeta > 0.1: pierces the bubble early.
    Strong,
}

/// A displacement over the largest radius.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Displacement {
    /// dz/R_max, positive, towards the wall.
    pub over_max_radius: f64,
    /// Whether zeta is in the range of the power law.
    pub in_range: bool,
}

/// Anisotropy at a stand-off (positive) from a rigid wall.
#[must_use]
pub fn anisotropy_of_wall(standoff: f64) -> f64 {
    WALL_COEFFICIENT / (standoff * standoff)
}

/// Anisotropy in a uniform pressure gradient (Pa/m): largest radius in m, driving pressure in Pa.
#[must_use]
pub fn anisotropy_of_gradient(gradient: f64, max_radius: f64, driving_pressure: f64) -> f64 {
    gradient.abs() * max_radius / driving_pressure
}

/// Regime of the jet.
#[must_use]
pub fn jet_regime(anisotropy: f64) -> JetRegime {
    if anisotropy < WEAK_LIMIT {
        JetRegime::Weak
    } else if anisotropy <= POWER_LAW_LIMIT {
        JetRegime::Intermediate
    } else {
        JetRegime::Strong
    }
}

/// Displacement of the centre from the largest radius to the collapse. Beyond the range the law is still evaluated (the
/// erosion model of Peters and el Moctar uses it there), and says so.
#[must_use]
pub fn displacement(anisotropy: f64) -> Displacement {
    Displacement {
        over_max_radius: 2.5 * anisotropy.powf(0.6),
        in_range: anisotropy <= POWER_LAW_LIMIT,
    }
}

/// Kelvin impulse (N s) of growth and collapse: largest radius m, driving pressure Pa, density kg/m3.
#[must_use]
pub fn kelvin_impulse(
    max_radius: f64,
    driving_pressure: f64,
    density: f64,
    anisotropy: f64,
) -> f64 {
    IMPULSE * max_radius.powi(3) * (driving_pressure * density).sqrt() * anisotropy
}

/// Speed (m/s) of the jet when it meets the opposite wall of the bubble, `None` for zeta outside 4e-4 to 0.1.
///
/// At small zeta the law gives speeds beyond the sound speed of water (zeta < 0.006 at 1 bar): compressibility limits them.
#[must_use]
pub fn jet_speed(anisotropy: f64, driving_pressure: f64, density: f64) -> Option<f64> {
    let valid = (PIERCING_ANISOTROPY..=POWER_LAW_LIMIT).contains(&anisotropy);
    valid.then(|| 0.9 * driving_speed(driving_pressure, density) / anisotropy)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// Integral over x from 0 to 1 of f(x), x = cos^2: smooth for powers of x and 1 - x^3.
    fn integral(f: impl Fn(f64, f64) -> f64) -> f64 {
        let n = 400;
        let h = 0.5 * PI / f64::from(n);
        let value = |k: u32| {
            let (s, c) = (h * (f64::from(k) + 0.5)).sin_cos();
            let x = c * c;
            // 1 - x^3 over s^2 is positive and smooth.
            let rest = s * s * (1.0 + x + x * x);
            f(x, rest) * 2.0 * s * c
        };
        (0..n).map(value).sum::<f64>() * h
    }

    /// Buoyancy over the life of a Rayleigh bubble, and the attraction pi rho R^4 R'^2/H^2 of its image.
    #[test]
    fn constants_follow_from_rayleigh() {
        let volume = integral(|x, rest| x.powf(4.5) / rest.sqrt());
        let buoyancy = 2.0 * 4.0 / 3.0 * PI * 1.5f64.sqrt() * volume;
        assert!((buoyancy / IMPULSE - 1.0).abs() < 2e-4, "{buoyancy}");
        let image = integral(|x, rest| x.powf(2.5) * rest.sqrt());
        let wall = 2.0 * PI * (2.0f64 / 3.0).sqrt() * image;
        assert!((wall / buoyancy / WALL_COEFFICIENT - 1.0).abs() < 1e-3);
    }

    #[test]
    fn ranges_are_kept() {
        assert_eq!(jet_regime(anisotropy_of_wall(1.0)), JetRegime::Strong);
        assert_eq!(jet_regime(anisotropy_of_wall(5.0)), JetRegime::Intermediate);
        assert_eq!(jet_regime(anisotropy_of_wall(20.0)), JetRegime::Weak);
        assert!(jet_speed(0.2, 1e5, 1e3).is_none() && jet_speed(1e-4, 1e5, 1e3).is_none());
        assert!((jet_speed(0.1, 1e5, 1e3).unwrap() - 90.0).abs() < 1e-9);
        assert!(!displacement(0.2).in_range && displacement(0.05).in_range);
    }

    /// 2.5 (0.195)^0.6 = 0.93748 at gamma = 1.
    #[test]
    fn displacement_at_the_wall() {
        let d = displacement(anisotropy_of_wall(1.0)).over_max_radius;
        assert!((d - 0.937_477_332).abs() < 1e-9, "{d}");
    }
}
