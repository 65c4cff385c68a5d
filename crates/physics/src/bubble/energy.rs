//! The energy of a bubble and the liquid around it.
//!
//! Rayleigh-Plesset times 4 pi rho R^2 R' is the balance d/dt (kinetic + potential + gas) = driven - viscous with
//! - kinetic = 2 pi rho R^3 R'^2, of the liquid;
//! - potential = (p - p_v) V + 4 pi sigma R^2, of the liquid pushed away, the vapour and the surface; p with the slip;
//! - gas: [`Gas::energy`];
//! - viscous: rate 16 pi mu R R'^2; driven: rate V dp/dt.
//!
//! In a compressible model `radiated` takes what that balance leaves over,
//! 4 pi R^2 R' (p_L - p - rho (R R'' + 3/2 R'^2)): work that the wall hands to the liquid beyond the incompressible
//! motion. To first order in R'/c it is the sound power rho V''^2/(4 pi c) plus the rate of a store that is empty when
//! the wall rests, so that over a cycle it is the sound radiated. For Tomita-Shima with e < 1 it also holds
//! the kinetic energy that a wall with evaporation does not give to the liquid.
//! kinetic + potential + gas + viscous + radiated - driven is constant. Units: J.

use super::model::WallPressure;
use super::{Ambient, Gas, Ledger, Liquid, Wall};
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// Energies at an instant, J.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Energy {
    /// Of the liquid in incompressible motion.
    pub kinetic: f64,
    /// Of the liquid pushed away, the vapour and the surface.
    pub potential: f64,
    /// Of the permanent gas, zero at its reference radius.
    pub gas: f64,
    /// Dissipated by viscosity so far.
    pub viscous: f64,
    /// Handed to the compressible liquid so far.
    pub radiated: f64,
    /// Put in by changes of the liquid's pressure so far.
    pub driven: f64,
}

impl Energy {
    /// Energies of a wall in its surroundings, with the integrals so far.
    #[must_use]
    pub fn new(
        liquid: &Liquid,
        gas: &Gas,
        ambient: &Ambient,
        radius: f64,
        wall_velocity: f64,
        ledger: &Ledger,
    ) -> Self {
        let area = 4.0 * PI * radius * radius;
        let excess = ambient.mean_pressure(liquid.density) - liquid.vapour_pressure;
        Self {
            kinetic: 0.5 * liquid.density * area * radius * wall_velocity * wall_velocity,
            potential: excess * area * radius / 3.0 + liquid.surface_tension * area,
            gas: gas.energy(radius),
            viscous: ledger.viscous,
            radiated: ledger.radiated,
            driven: ledger.driven,
        }
    }

    /// What does not change.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.kinetic + self.potential + self.gas + self.viscous + self.radiated - self.driven
    }
}

/// Rates of the ledger, W: viscous, radiated, driven.
#[inline]
pub(super) fn powers(
    liquid: &Liquid,
    gas: &Gas,
    wall: &Wall,
    acceleration: f64,
    ambient: &Ambient,
) -> [f64; 3] {
    let (r, v) = (wall.radius, wall.velocity);
    let area = 4.0 * PI * r * r;
    let push = WallPressure::new(liquid, gas, wall, 1.0).value;
    let left = push
        - ambient.mean_pressure(liquid.density)
        - liquid.density * (r * acceleration + 1.5 * v * v);
    [
        16.0 * PI * liquid.viscosity * r * v * v,
        area * v * left,
        area * r / 3.0 * ambient.mean_pressure_rate(liquid.density),
    ]
}
