//! Deformation gradient and stress of a total Lagrangian solid.
//!
//! F_a = sum A_b (x_b - x_a) (x) L_own grad W, F_tt = r/R.
//! Step (`points.rs`): dL = (F' - F) ((F' + F)/2)^-1, D and spin its symmetric and skew parts; Kirchhoff stress tau = J sigma by the
//! Jaumann rate, tau_trial = Q tau Q^T + lambda tr(dD) I + 2 mu dD with the exact rotation Q of the midpoint spin
//! (Hughes and Winget 1980), so that a rigid rotation leaves no stress; then radial return of the Cauchy stress.
//!
//! With damage the same is done to the stress of the sound material, tau/(1 - D), and the new D taken off again.
//!
//! The rate is written for tau because tau:C^-1:tau/2 per reference volume is then exactly the stored energy.
//! Units: SI, stress positive in tension. Range: finite rotation, moderate stretch (J > 0).

use super::mat2::{Mat2, product};
use super::reference::Reference;
use super::sums::Field;
use super::{Formulation, Solid, SolidError};
use erode_physics::return_mapping::ReturnError;

/// Particles per task: large enough to hide the cost of a task.
pub(super) const TASK: usize = 256;

/// Gradient sum A_b (f_b - f_a) (x) L_own grad W of a vector known at particles and mirror images.
pub(super) fn gradient(reference: &Reference, field: &Field, a: usize) -> Mat2 {
    let f = field.at(a);
    let mut m = [[0.0; 2]; 2];
    for p in reference.pairs_of(a) {
        let other = field.at(p.neighbour as usize);
        let d = [other[0] - f[0], other[1] - f[1]];
        let g = [p.offset[0] * p.gradient, p.offset[1] * p.gradient];
        m[0][0] += d[0] * g[0];
        m[0][1] += d[0] * g[1];
        m[1][0] += d[1] * g[0];
        m[1][1] += d[1] * g[1];
    }
    product(&m, &reference.own_correction[a])
}

/// Why the stress of a particle could not be updated.
pub(super) enum Failure {
    /// Its volume ratio is not positive.
    Inverted(f64),
    /// The radial return failed.
    Return(ReturnError),
}

impl Solid {
    /// Brings deformation and stress to the present positions; `dt` is the time (s) since they were last there.
    ///
    /// # Errors
    /// If a pressure is set on a free face, the reference cannot be renewed where that is asked for, a particle is turned
    /// inside out or the stress cannot be returned to the yield surface; the particle with the smallest index is named. The
    /// state is then not usable any more.
    pub fn update_stress(&mut self, dt: f64) -> Result<(), SolidError> {
        self.check_free_faces()?;
        let form = self.numerics.formulation;
        match form {
            Formulation::TotalLagrangian => self.place_images(),
            Formulation::Joshi(_) => self.velocity_gradients(),
        }
        let failed = self.update_points(dt);
        match failed {
            None => self.renew_if_stretched(),
            Some((particle, Failure::Inverted(volume_ratio))) => Err(SolidError::Inverted {
                particle,
                position: self.state.position[particle],
                volume_ratio,
            }),
            Some((particle, Failure::Return(source))) => Err(SolidError::Return {
                particle,
                position: self.state.position[particle],
                source,
            }),
        }
    }
}
