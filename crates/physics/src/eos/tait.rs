//! Tait equation of state of a liquid.
//!
//! p = B ((rho/rho0)^gamma - 1), B = rho0 c0^2 / gamma      (Joshi 2018, eq. 6.6)
//!
//! Units: Pa, kg/m3, m/s. Range: rho > 0; water up to a few GPa with gamma = 7.

use serde::{Deserialize, Serialize};

/// Constants of the Tait equation.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Tait {
    /// Density at zero pressure, kg/m3.
    pub reference_density: f64,
    /// Sound speed at zero pressure, m/s.
    pub sound_speed: f64,
    /// Exponent, dimensionless.
    pub gamma: f64,
}

impl Tait {
    /// B, Pa.
    #[inline]
    fn modulus(&self) -> f64 {
        self.reference_density * self.sound_speed * self.sound_speed / self.gamma
    }

    /// Pressure (Pa) at a density (kg/m3).
    #[inline]
    #[must_use]
    pub fn pressure(&self, density: f64) -> f64 {
        self.modulus() * (power(density / self.reference_density, self.gamma) - 1.0)
    }

    /// Density (kg/m3) at a pressure (Pa) above -B.
    #[inline]
    #[must_use]
    pub fn density(&self, pressure: f64) -> f64 {
        self.reference_density * (pressure / self.modulus() + 1.0).powf(1.0 / self.gamma)
    }

    /// Sound speed (m/s) at a density: c^2 = dp/drho.
    #[inline]
    #[must_use]
    pub fn sound_speed_at(&self, density: f64) -> f64 {
        self.sound_speed * power(density / self.reference_density, 0.5 * (self.gamma - 1.0))
    }

    /// The same from the pressure (Pa) that goes with the density, c^2 = gamma (p + B)/rho: without a power.
    #[inline]
    #[must_use]
    pub fn sound_speed_of(&self, density: f64, pressure: f64) -> f64 {
        (self.gamma * (pressure + self.modulus()) / density).sqrt()
    }

    /// Energy (J/kg) stored by compression from zero pressure: integral of p/rho^2 drho.
    #[inline]
    #[must_use]
    pub fn specific_energy(&self, density: f64) -> f64 {
        let x = density / self.reference_density;
        self.modulus() / self.reference_density
            * ((power(x, self.gamma - 1.0) - 1.0) / (self.gamma - 1.0) + 1.0 / x - 1.0)
    }

    /// The same from the pressure (Pa) that goes with the density: without a power.
    #[inline]
    #[must_use]
    pub fn specific_energy_of(&self, density: f64, pressure: f64) -> f64 {
        let (b, rest) = (self.modulus(), self.reference_density / density);
        let power = (pressure / b + 1.0) * rest;
        b / self.reference_density * ((power - 1.0) / (self.gamma - 1.0) + rest - 1.0)
    }

    /// Velocity change (m/s) across a simple wave from zero pressure to `density`:
    /// integral of c/rho drho = 2 (c - c0)/(gamma - 1).
    #[inline]
    #[must_use]
    pub fn riemann_integral(&self, density: f64) -> f64 {
        2.0 * (self.sound_speed_at(density) - self.sound_speed) / (self.gamma - 1.0)
    }

    /// Pressure (Pa) at which [`Self::riemann_integral`] has the given value (m/s).
    #[inline]
    #[must_use]
    pub fn pressure_of_riemann_integral(&self, integral: f64) -> f64 {
        let c = self.sound_speed + 0.5 * (self.gamma - 1.0) * integral;
        let density =
            self.reference_density * (c / self.sound_speed).powf(2.0 / (self.gamma - 1.0));
        self.pressure(density)
    }
}

/// x^n; by multiplication where n is a small whole number, as it is for water: ten times faster.
#[inline]
fn power(x: f64, n: f64) -> f64 {
    let mut whole = n as u32;
    if f64::from(whole) != n || whole > 16 {
        return x.powf(n);
    }
    let (mut square, mut product) = (x, 1.0);
    while whole > 0 {
        if whole % 2 == 1 {
            product *= square;
        }
        square *= square;
        whole /= 2;
    }
    product
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_agree() {
        for n in [0.0, 1.0, 3.0, 6.0, 7.0, 7.15, 16.0, 17.0, -2.0, 0.5] {
            for x in [0.5, 1.0, 1.3, 4.0_f64] {
                assert!((power(x, n) / x.powf(n) - 1.0).abs() < 1e-14, "{x}^{n}");
            }
        }
    }

    const WATER: Tait = Tait {
        reference_density: 1000.0,
        sound_speed: 1500.0,
        gamma: 7.0,
    };

    #[test]
    fn sound_speed_is_the_slope_of_pressure() {
        for rho in [900.0, 1000.0, 1100.0, 1300.0] {
            let d = 1e-3;
            let slope = (WATER.pressure(rho + d) - WATER.pressure(rho - d)) / (2.0 * d);
            let c = WATER.sound_speed_at(rho);
            assert!((slope / (c * c) - 1.0).abs() < 1e-7);
        }
    }

    #[test]
    fn a_known_pressure_saves_the_power() {
        let eos = Tait {
            gamma: 7.15,
            ..WATER
        };
        for rho in [1000.0, 1001.0, 1100.0, 1800.0] {
            let p = eos.pressure(rho);
            let (c, e) = (eos.sound_speed_at(rho), eos.specific_energy(rho));
            assert!((eos.sound_speed_of(rho, p) / c - 1.0).abs() < 1e-14);
            // Two numbers of the size of B/rho0 leave what is small beside them.
            assert!((eos.specific_energy_of(rho, p) - e).abs() < 1e-14 * c * c);
        }
    }

    #[test]
    fn density_inverts_pressure_and_energy_integrates_it() {
        let rho = WATER.density(60e6);
        assert!((WATER.pressure(rho) / 60e6 - 1.0).abs() < 1e-12);
        let (n, mut e) = (20_000, 0.0);
        let d = (rho - 1000.0) / f64::from(n);
        for i in 0..n {
            let r = 1000.0 + (f64::from(i) + 0.5) * d;
            e += WATER.pressure(r) / (r * r) * d;
        }
        assert!((WATER.specific_energy(rho) / e - 1.0).abs() < 1e-6);
    }

    #[test]
    fn riemann_integral_inverts_and_matches_acoustics() {
        let rho = WATER.density(1e5);
        let du = WATER.riemann_integral(rho);
        assert!((du / (1e5 / (1000.0 * 1500.0)) - 1.0).abs() < 1e-3);
        assert!((WATER.pressure_of_riemann_integral(du) / 1e5 - 1.0).abs() < 1e-8);
    }
}
