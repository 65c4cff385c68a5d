//! Deformation gradient and stress of a total Lagrangian solid.
//!
//! F_a = sum A_b (x_b - x_a) (x) L_own grad W, F_tt = r/R.
//! Step: dL = (F' - F) ((F' + F)/2)^-1, D and spin its symmetric and skew parts; Kirchhoff stress tau = J sigma by the
//! Jaumann rate, tau_trial = Q tau Q^T + lambda tr(dD) I + 2 mu dD with the exact rotation Q of the midpoint spin
//! (Hughes and Winget 1980), so that a rigid rotation leaves no stress; then radial return of the Cauchy stress.
//!
//! With damage the same is done to the stress of the sound material, tau/(1 - D), and the new D taken off again.
//!
//! The rate is written for tau because tau:C^-1:tau/2 per reference volume is then exactly the stored energy.
//! Units: SI, stress positive in tension. Range: finite rotation, moderate stretch (J > 0).

use super::mat2::{Mat2, UNIT, combine, determinant, inverse, product};
use super::reference::Reference;
use super::{Formulation, Solid, SolidError};
use crate::geometry::{Geometry, Vec2};
use erode_physics::Sym3;
use erode_physics::damage::{Damage, PlasticStep};
use erode_physics::material_point::Material;
use erode_physics::return_mapping::{PointState, return_stress};
use rayon::prelude::*;

/// Particles per task: large enough to hide the cost of a task.
pub(super) const TASK: usize = 256;

/// Gradient sum A_b (f_b - f_a) (x) L_own grad W of a vector known at particles and mirror images.
pub(super) fn gradient(reference: &Reference, field: &[Vec2], a: usize) -> Mat2 {
    let f = field[a];
    let mut m = [[0.0; 2]; 2];
    for p in reference.pairs_of(a) {
        let other = field[p.neighbour as usize];
        let d = [other[0] - f[0], other[1] - f[1]];
        let g = [p.offset[0] * p.gradient, p.offset[1] * p.gradient];
        m[0][0] += d[0] * g[0];
        m[0][1] += d[0] * g[1];
        m[1][0] += d[1] * g[0];
        m[1][1] += d[1] * g[1];
    }
    product(&m, &reference.own_correction[a])
}

/// Everything the stress update changes at one particle.
struct Point<'a> {
    deformation: &'a mut Mat2,
    hoop_stretch: &'a mut f64,
    stress: &'a mut Sym3,
    von_mises: &'a mut f64,
    plastic_strain: &'a mut f64,
    plastic_strain_rate: &'a mut f64,
    plastic_work: &'a mut f64,
    temperature: &'a mut f64,
    damage: &'a mut f64,
    damage_work: &'a mut f64,
}

/// Strain and spin of a step.
struct Increment {
    strain: Sym3,
    spin: f64,
}

fn increment(old: &Mat2, old_hoop: f64, new: &Mat2, new_hoop: f64) -> Increment {
    let middle = combine(old, 0.5, new, 0.5);
    let l = product(&combine(new, 1.0, old, -1.0), &inverse(&middle));
    Increment {
        strain: Sym3 {
            xx: l[0][0],
            yy: l[1][1],
            zz: 2.0 * (new_hoop - old_hoop) / (new_hoop + old_hoop),
            xy: 0.5 * (l[0][1] + l[1][0]),
            ..Sym3::ZERO
        },
        spin: 0.5 * (l[0][1] - l[1][0]),
    }
}

/// Deformation gradient after `dt` with velocity gradient l: (I - l dt/2) F' = (I + l dt/2) F, for which the strain and spin
/// of [`increment`] are those of l dt exactly.
fn advanced(old: &Mat2, l: &Mat2, dt: f64) -> Mat2 {
    let forward = combine(&UNIT, 1.0, l, 0.5 * dt);
    let backward = combine(&UNIT, 1.0, l, -0.5 * dt);
    product(&inverse(&backward), &product(&forward, old))
}

impl Point<'_> {
    fn update(
        self,
        f: Mat2,
        hoop: f64,
        dt: f64,
        (material, law, first): (&Material, &Damage, f64),
    ) -> Result<(), Failure> {
        let old_j = first * determinant(self.deformation) * *self.hoop_stretch;
        let j = first * determinant(&f) * hoop;
        if j.is_nan() || j <= 0.0 {
            return Err(Failure::Inverted(j));
        }
        let step = increment(self.deformation, *self.hoop_stretch, &f, hoop);
        (*self.deformation, *self.hoop_stretch) = (f, hoop);
        let sound = law.integrity(*self.damage);
        let kirchhoff = (*self.stress * (old_j / sound)).rotated_by_spin(step.spin)
            + material.elastic.stress(step.strain);
        let point = PointState {
            plastic_strain: *self.plastic_strain,
            temperature: *self.temperature,
            density: material.density / j,
        };
        let shear_modulus = material.elastic.shear_modulus() / j;
        let plastic = return_stress(
            kirchhoff * (1.0 / j),
            point,
            dt,
            shear_modulus,
            &material.strength,
        )
        .map_err(Failure::Return)?;
        let von_mises = plastic.stress.von_mises();
        *self.damage = law.after(
            *self.damage,
            PlasticStep {
                increment: plastic.increment,
                rate: plastic.increment / dt,
                triaxiality: plastic.stress.mean() / von_mises,
                temperature: *self.temperature,
            },
        );
        let integrity = law.integrity(*self.damage);
        let mean = 0.5 * (sound + integrity);
        *self.stress = plastic.stress * integrity;
        *self.von_mises = von_mises * integrity;
        *self.plastic_strain += plastic.increment;
        *self.plastic_strain_rate = plastic.increment / dt;
        *self.plastic_work += mean * plastic.work * j;
        *self.temperature += mean * plastic.heating;
        *self.damage_work +=
            (sound - integrity) * material.elastic.energy_density(plastic.stress * j);
        Ok(())
    }
}

enum Failure {
    Inverted(f64),
    Return(erode_physics::return_mapping::ReturnError),
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
        let (reference, material, law) = (&self.reference, &self.material, &self.damage);
        let (position, rates) = (&self.scratch.position, &self.present.gradient);
        let axisymmetric = self.geometry == Geometry::Axisymmetric;
        let s = &mut self.state;
        let (place, removed) = (&s.position, &s.removed);
        let failed = (
            &mut s.deformation,
            &mut s.hoop_stretch,
            &mut s.stress,
            &mut s.von_mises,
            &mut s.plastic_strain,
            &mut s.plastic_strain_rate,
            &mut s.plastic_work,
            &mut s.temperature,
            &mut s.damage,
            &mut s.damage_work,
        )
            .into_par_iter()
            .enumerate()
            .with_min_len(TASK)
            .filter(|(a, _)| removed[*a] == 0.0)
            .filter_map(|(a, fields)| {
                let (
                    deformation,
                    hoop_stretch,
                    stress,
                    von_mises,
                    strain,
                    rate,
                    work,
                    temperature,
                    damage,
                    damage_work,
                ) = fields;
                let point = Point {
                    deformation,
                    hoop_stretch,
                    stress,
                    von_mises,
                    plastic_strain: strain,
                    plastic_strain_rate: rate,
                    plastic_work: work,
                    temperature,
                    damage,
                    damage_work,
                };
                let hoop = if axisymmetric {
                    place[a][0] / reference.position[a][0]
                } else {
                    1.0
                };
                let f = match form {
                    Formulation::TotalLagrangian => gradient(reference, position, a),
                    Formulation::Joshi(_) => advanced(point.deformation, &rates[a], dt),
                };
                let laws = (material, law, reference.volume_ratio[a]);
                point.update(f, hoop, dt, laws).err().map(|e| (a, e))
            })
            .min_by_key(|(a, _)| *a);
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
