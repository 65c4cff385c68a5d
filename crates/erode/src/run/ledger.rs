//! The energy ledger of a world.
//!
//! liquid (kinetic + compression) + gas + solid (kinetic + elastic + plastic work) + dissipation + lost
//!     = start + work of the boundaries

use erode_sph::world::{Body, World};

/// Energies now and what came and went since the start, J.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Ledger {
    /// Kinetic energy of liquids.
    pub liquid_kinetic: f64,
    /// Compression of liquids.
    pub liquid_compression: f64,
    /// Gas in cavities, with what was lost of it.
    pub gas: f64,
    /// Kinetic energy of solids.
    pub solid_kinetic: f64,
    /// Elastic energy of solids.
    pub solid_elastic: f64,
    /// Plastic work in solids.
    pub plastic_work: f64,
    /// Numerical dissipation in liquids.
    pub liquid_dissipation: f64,
    /// Dissipation by viscosity, hourglass forces and damage in solids, and what damping took out.
    pub solid_dissipation: f64,
    /// Kinetic and elastic energy of material that failed and was removed.
    pub solid_lost: f64,
    /// Work of the far fields on liquids, of absorbing and driven faces and of loads on solids. (The pressure of a liquid on
    /// a solid is no boundary.) Less what left with liquids that
    /// were taken out.
    pub boundary_work: f64,
    /// What left with liquids that were taken out, less what new ones brought: part of the above.
    pub taken_out: f64,
}

impl Ledger {
    /// The ledger of a world.
    #[must_use]
    pub fn of(world: &World) -> Self {
        let mut l = Self::default();
        let gone = &world.departed;
        l.gas += gone.gas_lost;
        l.liquid_dissipation += gone.account.dissipation;
        l.boundary_work += gone.account.far_field_work - gone.energy;
        l.taken_out = gone.energy;
        let wet =
            gone.liquids > 0 || (world.bodies.iter()).any(|b| matches!(b.body, Body::Fluid(_)));
        for named in &world.bodies {
            match &named.body {
                Body::Fluid(f) => {
                    l.liquid_kinetic += f.kinetic_energy();
                    l.liquid_compression += f.compression_energy();
                    l.gas += f.gas.as_ref().map_or(0.0, |g| g.energy() + g.lost);
                    l.liquid_dissipation += f.account.dissipation;
                    l.boundary_work += f.account.far_field_work;
                }
                Body::Solid(s) => {
                    let (e, w) = (s.energy(), s.state.work);
                    l.solid_kinetic += e.kinetic;
                    l.solid_elastic += e.elastic;
                    l.plastic_work += e.plastic_work;
                    l.solid_dissipation += w.viscous + w.hourglass + w.damping + e.damage_work;
                    l.solid_lost += w.lost.kinetic + w.lost.elastic;
                    l.boundary_work += w.absorbing + w.driving;
                    if !wet {
                        l.boundary_work += w.pressure;
                    }
                }
            }
        }
        l
    }

    /// Energy stored and dissipated less the work of the boundaries: constant if nothing is lost.
    #[must_use]
    pub fn balance(&self) -> f64 {
        self.liquid_kinetic
            + self.liquid_compression
            + self.gas
            + self.solid_kinetic
            + self.solid_elastic
            + self.plastic_work
            + self.liquid_dissipation
            + self.solid_dissipation
            + self.solid_lost
            - self.boundary_work
    }

    /// Names and values, as in `history.csv` and `summary.json`.
    #[must_use]
    pub fn entries(&self) -> [(&'static str, f64); 10] {
        [
            ("energy_liquid_kinetic", self.liquid_kinetic),
            ("energy_liquid_compression", self.liquid_compression),
            ("energy_gas", self.gas),
            ("energy_solid_kinetic", self.solid_kinetic),
            ("energy_solid_elastic", self.solid_elastic),
            ("energy_plastic_work", self.plastic_work),
            ("energy_liquid_dissipation", self.liquid_dissipation),
            ("energy_solid_dissipation", self.solid_dissipation),
            ("energy_solid_lost", self.solid_lost),
            ("energy_boundary_work", self.boundary_work),
        ]
    }
}
