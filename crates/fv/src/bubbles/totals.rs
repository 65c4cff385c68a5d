//! Sums over a cloud: mass, volume, energy.
//!
//! Two balances, J:
//! - slip: slip_energy = drive_work - drag_loss - exchange + what bubbles had when they came and took when they went;
//!   slip_energy = (m + rho V/2) |u_b - u|^2/2;
//! - radius: as in `erode_physics::bubble::Energy`, the potential with the slip term where the settings have it.
//!
//! With the slip term the radius receives `exchange`; without it, it does not, and the sum of both is not kept. Serial sums.

use super::carrier::{Carrier, CarrierError};
use super::cloud::Cloud;
use super::motion::{SlipLedger, effective_mass};
use super::settings::Settings;
use crate::vector::{dot, sub};
use erode_physics::bubble::{Ambient, Energy};
use serde::{Deserialize, Serialize};

/// Sums over the bubbles present, and what those that are gone took along.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Totals {
    /// Bubbles present.
    pub bubbles: u64,
    /// Their mass, kg.
    pub mass: f64,
    /// Mass of the bubbles that are gone, kg.
    pub lost_mass: f64,
    /// Volume, m3.
    pub volume: f64,
    /// Kinetic energy of the slip, J.
    pub slip_energy: f64,
    /// What slips gained and lost so far, of bubbles present and gone.
    pub slip_ledger: SlipLedger,
    /// Kinetic energy of the radial motion, J.
    pub radial_kinetic: f64,
    /// Of the liquid pushed away and the surfaces, J.
    pub potential: f64,
    /// Of the gas, J.
    pub gas: f64,
    /// Dissipated by viscosity at the walls, J.
    pub viscous: f64,
    /// Radiated, J.
    pub radiated: f64,
    /// Put in by changes of pressure, J.
    pub driven: f64,
}

impl Cloud {
    /// Sums at the present time, with the flow at the centres.
    ///
    /// # Errors
    /// If a bubble is outside the flow.
    pub fn totals<C: Carrier>(
        &self,
        carrier: &C,
        settings: &Settings,
    ) -> Result<Totals, CarrierError> {
        let mut sum = Totals {
            bubbles: self.len() as u64,
            lost_mass: self.lost.iter().fold(0.0, |sum, l| sum + l.mass),
            ..Totals::default()
        };
        for lost in &self.lost {
            sum.slip_ledger.add(&lost.slip_ledger);
        }
        for k in 0..self.len() {
            let flow = carrier.at(self.position[k], self.time)?;
            let slip = sub(flow.velocity, self.velocity[k]);
            let (state, mass) = (&self.state[k], self.mass[k]);
            let ambient = Ambient {
                pressure: flow.pressure,
                slip_squared: if settings.slip { dot(slip, slip) } else { 0.0 },
                ..Ambient::default()
            };
            let m = effective_mass(&settings.forces, mass, state.radius, flow.density);
            sum.mass += mass;
            sum.volume += state.volume();
            sum.slip_energy += 0.5 * m * dot(slip, slip);
            sum.slip_ledger.add(&self.slip_ledger[k]);
            sum.add_radial(&state.energy(&settings.liquid, &self.gas[k], &ambient));
        }
        Ok(sum)
    }
}

impl Totals {
    fn add_radial(&mut self, e: &Energy) {
        self.radial_kinetic += e.kinetic;
        self.potential += e.potential;
        self.gas += e.gas;
        self.viscous += e.viscous;
        self.radiated += e.radiated;
        self.driven += e.driven;
    }
}
