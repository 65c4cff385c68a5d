//! Drag: F = k (u_c - u_b), k in N s/m (Peters and el Moctar 2020, eqs 3.27 to 3.29).
//!
//! Haberman and Morton: k = 3/4 c mu V/(2 R)^2,  c = C_D Re = 24 (1 + 0.197 Re^0.63 + 2.6e-4 Re^1.38)     (3.27, 3.28)
//! gravity:             k = 1/2 C_D rho pi R^2 |u_c - u_b|,  C_D = 8/3 Eo/(Eo + 4)                        (3.29)
//!                      Re = 2 R rho |u_c - u_b|/mu,  Eo = (rho - rho_b) |g| (2 R)^2/sigma
//!
//! Misprints: (3.27) holds |u_c - u_b| once too often and the effective mass instead of that of the bubble; its limit must be
//! Stokes' 6 pi mu R. Range: (3.28) to a few thousand Re (contaminated bubbles, nearly spherical); (3.29) for large
//! bubbles rising in stagnant water.

use super::volume;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// Laws of drag.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum DragLaw {
    /// None.
    Off,
    /// 6 pi mu R: creeping flow around a rigid sphere, Re << 1.
    Stokes,
    /// Of Haberman and Morton 1953.
    HabermanMorton,
    /// Of Darmana, Deen and Kuipers 2006, for bubbles that gravity drives.
    Gravity {
        /// |g|, m/s2.
        gravity: f64,
        /// Surface tension, N/m.
        surface_tension: f64,
        /// Density of the bubble, kg/m3.
        bubble_density: f64,
    },
}

/// Re = 2 R rho speed/mu.
#[must_use]
pub fn reynolds_number(radius: f64, speed: f64, density: f64, viscosity: f64) -> f64 {
    2.0 * radius * density * speed / viscosity
}

/// Eo = (rho - rho_b) g (2 R)^2/sigma.
#[must_use]
pub fn eotvos_number(
    radius: f64,
    density_difference: f64,
    gravity: f64,
    surface_tension: f64,
) -> f64 {
    density_difference * gravity * (2.0 * radius).powi(2) / surface_tension
}

/// Final speed of rise in liquid at rest with the drag of (3.29), m/s (4.10): densities kg/m3, surface tension N/m.
#[must_use]
pub fn terminal_speed(
    radius: f64,
    (density, bubble_density): (f64, f64),
    gravity: f64,
    surface_tension: f64,
) -> f64 {
    let heavy = (density - bubble_density) * gravity * radius;
    ((surface_tension / radius + heavy) / density).sqrt()
}

impl DragLaw {
    /// k (N s/m) at a radius (m) and slip speed (m/s) in liquid of a density (kg/m3) and viscosity (Pa s).
    #[must_use]
    pub fn resistance(&self, radius: f64, speed: f64, density: f64, viscosity: f64) -> f64 {
        match *self {
            Self::Off => 0.0,
            Self::Stokes => 6.0 * PI * viscosity * radius,
            Self::HabermanMorton if viscosity <= 0.0 => 0.0,
            Self::HabermanMorton => {
                let re = reynolds_number(radius, speed, density, viscosity);
                let c = 24.0 * (1.0 + 0.197 * re.powf(0.63) + 2.6e-4 * re.powf(1.38));
                0.75 * c * viscosity * volume(radius) / (2.0 * radius).powi(2)
            }
            Self::Gravity {
                gravity,
                surface_tension,
                bubble_density,
            } => {
                let eo = eotvos_number(radius, density - bubble_density, gravity, surface_tension);
                let c = 8.0 / 3.0 * eo / (eo + 4.0);
                0.5 * c * density * PI * radius * radius * speed
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_reynolds_numbers_give_stokes() {
        let (r, rho, mu) = (1e-5, 1000.0, 1e-3);
        let stokes = 6.0 * PI * mu * r;
        let k = |speed: f64| DragLaw::HabermanMorton.resistance(r, speed, rho, mu);
        assert!((k(0.0) / stokes - 1.0).abs() < 1e-14);
        // Re = 2e-5: 0.197 Re^0.63.
        let excess = k(1e-6) / stokes - 1.0;
        assert!((excess / (0.197 * 2e-5f64.powf(0.63)) - 1.0).abs() < 1e-2);
    }

    /// The force is C_D rho/2 pi R^2 u^2 with C_D = c/Re.
    #[test]
    fn it_is_a_drag_coefficient() {
        let (r, rho, mu, u) = (2e-3, 1000.0, 1e-3, 0.1);
        let re: f64 = 400.0;
        let coefficient = 24.0 / re * (1.0 + 0.197 * re.powf(0.63) + 2.6e-4 * re.powf(1.38));
        let force = 0.5 * coefficient * rho * PI * r * r * u * u;
        let k = DragLaw::HabermanMorton.resistance(r, u, rho, mu);
        assert!((k * u / force - 1.0).abs() < 1e-12);
    }

    /// Drag balances buoyancy at the closed form (4.10); the source prints 0.23686 m/s.
    #[test]
    fn terminal_speed_balances() {
        let (r, rho, light, g, sigma) = (2e-3, 1000.0, 1.0, 9.81, 0.073);
        let u = terminal_speed(r, (rho, light), g, sigma);
        assert!((u - 0.236_855_187_826).abs() < 1e-11);
        let law = DragLaw::Gravity {
            gravity: g,
            surface_tension: sigma,
            bubble_density: light,
        };
        let drag = law.resistance(r, u, rho, 1e-3) * u;
        assert!((drag / ((rho - light) * volume(r) * g) - 1.0).abs() < 1e-12);
    }
}
