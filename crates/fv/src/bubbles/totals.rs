//! Sums over a cloud: mass, volume, energy.
//!
//! kinetic of the slip: (m_b + rho V/2) |u_b - u_c|^2/2; with `slip` it exchanges energy with the radius through the last term
//! of (3.36). drag_loss: what drag took from it. Radial energies as in `erode_physics::bubble::Energy`. J, kg, m3; serial sums.

use super::carrier::{Carrier, CarrierError};
use super::cloud::Cloud;
use super::motion::effective_mass;
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
    /// Taken by drag so far, of bubbles present and gone, J.
    pub drag_loss: f64,
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
            lost_mass: self.lost.iter().map(|l| l.mass).sum(),
            drag_loss: self.lost.iter().map(|l| l.drag_loss).sum(),
            ..Totals::default()
        };
        for k in 0..self.len() {
            let flow = carrier.at(self.position[k], self.time)?;
            let slip = sub(flow.velocity, self.velocity[k]);
            let (state, mass) = (&self.state[k], self.mass[k]);
            let ambient = Ambient {
                pressure: flow.pressure,
                ..Ambient::default()
            };
            let m = effective_mass(&settings.forces, mass, state.radius, flow.density);
            sum.mass += mass;
            sum.volume += state.volume();
            sum.slip_energy += 0.5 * m * dot(slip, slip);
            sum.drag_loss += self.drag_loss[k];
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
