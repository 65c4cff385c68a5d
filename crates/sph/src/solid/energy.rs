//! Energy ledger of a solid.
//!
//! kinetic + elastic + plastic work + damage work + lost + viscous + hourglass + damping
//!     = work of pressure, driven and absorbing faces.
//! The work of a face is taken at its deformed surface points, where the liquid sees it.

use super::{Face, Solid};

/// Energies of a solid, J (of the whole ring in axisymmetry, per metre in plane strain).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Energy {
    /// Kinetic energy.
    pub kinetic: f64,
    /// Elastic energy tau:C^-1:tau/2 of the Kirchhoff stress tau = J sigma, per reference volume.
    pub elastic: f64,
    /// Plastic work, that of lost material included.
    pub plastic_work: f64,
    /// Dissipated by loss of modulus.
    pub damage_work: f64,
}

impl Energy {
    /// Sum of the four.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.kinetic + self.elastic + self.plastic_work + self.damage_work
    }
}

impl Solid {
    /// Energies now.
    #[must_use]
    pub fn energy(&self) -> Energy {
        let mut energy = Energy {
            kinetic: 0.0,
            elastic: 0.0,
            plastic_work: 0.0,
            damage_work: 0.0,
        };
        let s = &self.state;
        for a in 0..self.len() {
            let volume = self.reference.volume[a];
            energy.kinetic += self.kinetic_energy(a);
            energy.elastic += self.elastic_energy(a);
            energy.plastic_work += volume * s.plastic_work[a];
            energy.damage_work += volume * s.damage_work[a];
        }
        energy
    }

    /// Kinetic energy of a particle, J.
    pub(super) fn kinetic_energy(&self, a: usize) -> f64 {
        let v = self.state.velocity[a];
        0.5 * self.reference.mass[a] * (v[0] * v[0] + v[1] * v[1])
    }

    /// Elastic energy of a particle, J: (1 - D) times that of the sound material.
    pub(super) fn elastic_energy(&self, a: usize) -> f64 {
        let kirchhoff = self.state.stress[a] * self.volume_ratio(a);
        let integrity = self.damage_of(a).integrity(self.state.damage[a]);
        let energy = self.material_of(a).elastic.energy_density(kirchhoff);
        if integrity > 0.0 {
            self.reference.volume[a] * energy / integrity
        } else {
            0.0
        }
    }

    /// Energy that the ledger misses, J: what is stored and dissipated less the work of the faces.
    #[must_use]
    pub fn energy_defect(&self) -> f64 {
        let w = self.state.work;
        let lost = w.lost.kinetic + w.lost.elastic;
        self.energy().total() + lost + w.viscous + w.hourglass + w.damping
            - w.pressure
            - w.driving
            - w.absorbing
    }

    /// Adds the work of one step to the ledger, moves the surface points along and takes out what failed; call it after the
    /// closing kick of
    /// a kick-drift-kick step of length `dt` (s), whose velocities make the powers second order in time.
    pub fn account(&mut self, dt: f64) {
        self.follow_surfaces();
        // At the velocities after the closing kick.
        let work_of = |power: [f64; 2]| dt * (power[0] + 0.5 * dt * power[1]);
        let (powers, work) = (self.scratch.powers, &mut self.state.work);
        work.viscous -= work_of(powers.viscous);
        work.hourglass -= work_of(powers.hourglass);
        for surface in &self.surfaces {
            let work = match surface.face {
                Face::Absorbing => &mut self.state.work.absorbing,
                _ => &mut self.state.work.pressure,
            };
            *work += dt * surface.power(false);
            self.state.work.driving += dt * surface.power(true);
        }
        for (a, force) in &self.scratch.bared {
            let v = self.state.velocity[*a as usize];
            self.state.work.pressure += dt * (force[0] * v[0] + force[1] * v[1]);
        }
        self.remove_failed();
    }
}
