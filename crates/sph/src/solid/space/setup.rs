//! What a solid in three dimensions is made from.

use super::SpaceError;
use erode_physics::material_point::Material;
use serde::{Deserialize, Serialize};

/// Numerical constants of the formulation.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Numerics {
    /// Smoothing length in units of the cubic root of the particle's volume; the support radius is twice that.
    pub smoothing_ratio: f64,
    /// Linear artificial viscosity alpha, on approach.
    pub viscosity: f64,
    /// Hourglass stiffness zeta.
    pub hourglass: f64,
    /// Stable step in units of spacing / longitudinal wave speed.
    pub courant: f64,
}

impl Default for Numerics {
    fn default() -> Self {
        Self {
            smoothing_ratio: 1.2,
            viscosity: 0.2,
            hourglass: 0.1,
            courant: 0.4,
        }
    }
}

/// What a solid is made from.
#[derive(Debug, Clone, PartialEq)]
pub struct Setup {
    /// Material.
    pub material: Material,
    /// Numerical constants.
    pub numerics: Numerics,
    /// Reference positions, m.
    pub position: Vec<[f64; 3]>,
    /// Volume of each particle, m3.
    pub volume: Vec<f64>,
}

impl Setup {
    /// Particles at the centres of the cubes with this edge (m) that fill a box from the origin.
    #[must_use]
    pub fn lattice(material: Material, count: [usize; 3], spacing: f64) -> Self {
        let n = count[0] * count[1] * count[2];
        let place = |k: usize| {
            let (row, layer) = (k / count[0], k / (count[0] * count[1]));
            [k % count[0], row % count[1], layer].map(|i| (i as f64 + 0.5) * spacing)
        };
        Self {
            material,
            numerics: Numerics::default(),
            position: (0..n).map(place).collect(),
            volume: vec![spacing.powi(3); n],
        }
    }

    pub(super) fn check(&self) -> Result<(), SpaceError> {
        let (positions, volumes) = (self.position.len(), self.volume.len());
        if positions != volumes || positions == 0 || u32::try_from(positions).is_err() {
            return Err(SpaceError::BadCount { positions, volumes });
        }
        for (particle, (&position, &volume)) in self.position.iter().zip(&self.volume).enumerate() {
            let usable = position.iter().all(|x| x.is_finite());
            if !usable || !volume.is_finite() || volume <= 0.0 {
                return Err(SpaceError::BadParticle {
                    particle,
                    position,
                    volume,
                });
            }
        }
        Ok(())
    }
}
