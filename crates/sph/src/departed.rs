//! Liquids that were taken out of a world, and new ones put in: what they had counted and carried stays in the ledger.

use crate::fluid::Fluid;
use crate::fluid::corrected::Account;
use crate::world::{Body, Named, World};
use serde::{Deserialize, Serialize};

/// What left a world with its liquids since the start.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Departed {
    /// Liquids that were taken out.
    pub liquids: u64,
    /// Particles of the last one.
    pub particles: u64,
    /// What they had counted.
    pub account: Account,
    /// Energy that left with them less that which new ones brought (kinetic, compression, gas), J.
    pub energy: f64,
    /// Energy of gas that they had lost before, J.
    pub gas_lost: f64,
    /// Pockets of gas that had closed in them.
    pub gas_closed: u64,
    /// Steps in which the volume of their gas had been cut.
    pub gas_cut: u64,
}

impl Departed {
    fn count(&mut self, fluid: &Fluid) {
        self.liquids += 1;
        self.particles = fluid.len() as u64;
        self.energy += energy(fluid);
        let (sum, one) = (&mut self.account, &fluid.account);
        sum.dissipation += one.dissipation;
        sum.far_field_work += one.far_field_work;
        sum.axis_crossings += one.axis_crossings;
        sum.wall_crossings += one.wall_crossings;
        sum.cavitating += one.cavitating;
        sum.parted += one.parted;
        sum.limited_exchanges += one.limited_exchanges;
        sum.refinement.splits += one.refinement.splits;
        sum.refinement.merges += one.refinement.merges;
        sum.refinement.energy += one.refinement.energy;
        if let Some(gas) = &fluid.gas {
            self.gas_lost += gas.lost;
            self.gas_closed += gas.closed;
            self.gas_cut += gas.cut;
        }
    }
}

/// Energy that a liquid and its gas hold now, J.
fn energy(fluid: &Fluid) -> f64 {
    let gas = fluid
        .gas
        .as_ref()
        .map_or(0.0, crate::fluid::gas::Gas::energy);
    fluid.kinetic_energy() + fluid.compression_energy() + gas
}

impl World {
    /// Takes all liquids out and their pressure off the solids; returns the energy that left, J.
    pub fn take_out_liquids(&mut self) -> f64 {
        let before = self.departed.energy;
        for named in &mut self.bodies {
            match &mut named.body {
                Body::Fluid(f) => self.departed.count(f),
                Body::Solid(s) => {
                    if let Some(top) = s.surface_mut(crate::solid::Side::Top) {
                        top.push(|_| 0.0);
                    }
                }
            }
        }
        self.bodies.retain(|b| matches!(b.body, Body::Solid(_)));
        self.departed.energy - before
    }

    /// Puts a body in before the one at `place`; what it brings is counted.
    pub fn put_in(&mut self, place: usize, named: Named) {
        if let Body::Fluid(f) = &named.body {
            self.departed.energy -= energy(f);
        }
        self.bodies.insert(place, named);
    }
}
