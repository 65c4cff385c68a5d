//! Energy, momentum and ledger of a solid in three dimensions.
//!
//! kinetic + elastic + plastic work + viscous + hourglass = work of what holds and drives particles.

use super::super::Energy;
use super::SpaceSolid;
use serde::{Deserialize, Serialize};

/// Work since the start, J.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Work {
    /// Dissipated by the artificial viscosity.
    pub viscous: f64,
    /// Stored or dissipated by the hourglass forces.
    pub hourglass: f64,
    /// Done on the solid by what holds or drives its particles.
    pub driving: f64,
}

impl SpaceSolid {
    /// Energies now, J.
    #[must_use]
    pub fn energy(&self) -> Energy {
        let mut energy = Energy {
            kinetic: 0.0,
            elastic: 0.0,
            plastic_work: 0.0,
            damage_work: 0.0,
        };
        for a in 0..self.len() {
            let volume = self.volume(a);
            let v = self.state.velocity.get(a);
            let square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
            let elastic = &self.material.elastic;
            energy.kinetic += 0.5 * self.material.density * volume * square;
            energy.elastic += volume * elastic.energy_density(self.kirchhoff_stress(a));
            energy.plastic_work += volume * self.state.plastic_work.get(a)[0];
        }
        energy
    }

    /// Energy that the ledger misses, J.
    #[must_use]
    pub fn energy_defect(&self) -> f64 {
        let w = &self.state.work;
        self.energy().total() + w.viscous + w.hourglass - w.driving
    }

    /// Momentum, kg m/s, and angular momentum about the origin, kg m2/s.
    #[must_use]
    pub fn momentum(&self) -> [[f64; 3]; 2] {
        let mut sum = [[0.0; 3]; 2];
        for a in 0..self.len() {
            let mass = self.material.density * self.volume(a);
            let (x, v) = (self.state.position.get(a), self.state.velocity.get(a));
            for i in 0..3 {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                sum[0][i] += mass * v[i];
                sum[1][i] += mass * (x[j] * v[k] - x[k] * v[j]);
            }
        }
        sum
    }
}
