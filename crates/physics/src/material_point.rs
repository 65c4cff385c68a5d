//! A material point driven along simple paths of logarithmic strain at a constant rate.
//!
//! Uniaxial strain: only e_xx is not zero (shock loading). Uniaxial stress: only sigma_xx is not zero (tensile test).
//! Each step is what a particle of a solid does: elastic trial stress, then [`return_stress`].
//!
//! Units: Pa, 1/s, K, kg/m3. First order in the number of steps for laws with a rate, exact in it without.

use crate::elastic::Elastic;
use crate::return_mapping::{PointState, ReturnError, return_stress};
use crate::strength::Strength;
use crate::tensor::Sym3;
use thiserror::Error;

/// A material at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// Elastic constants.
    pub elastic: Elastic,
    /// Yield law.
    pub strength: Strength,
    /// Density, kg/m3 (for the heating by plastic work).
    pub density: f64,
    /// Temperature at the start, K.
    pub temperature: f64,
}

/// A path of loading at constant strain rate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Path {
    /// Axial strain at the end, negative in compression.
    pub final_strain: f64,
    /// Size of the axial strain rate, 1/s.
    pub rate: f64,
    /// Number of equal steps.
    pub steps: u32,
}

/// One point of the answer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PathPoint {
    /// Axial logarithmic strain.
    pub strain: f64,
    /// Axial stress, Pa.
    pub stress: f64,
    /// Von Mises stress, Pa.
    pub von_mises: f64,
    /// Equivalent plastic strain.
    pub plastic_strain: f64,
    /// Temperature, K.
    pub temperature: f64,
}

/// Why a path stopped.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum PathError {
    /// The path itself makes no sense.
    #[error(
        "a strain path needs a finite strain, a positive rate and at least one step; got {0:?}"
    )]
    BadPath(Path),
    /// The stress update failed.
    #[error(transparent)]
    Return(#[from] ReturnError),
    /// The lateral strain that leaves the sides free was not found.
    #[error(
        "no lateral strain leaves the sides free at axial strain {strain}: {lateral_stress} Pa remain"
    )]
    SidesNotFree {
        /// Axial strain, at the failed step.
        strain: f64,
        /// Lateral stress left, Pa.
        lateral_stress: f64,
    },
}

#[derive(Clone, Copy)]
struct State {
    stress: Sym3,
    plastic_strain: f64,
    temperature: f64,
}

impl Material {
    fn step(&self, s: State, axial: f64, lateral: f64, dt: f64) -> Result<State, ReturnError> {
        let strain = Sym3 {
            xx: axial,
            yy: lateral,
            zz: lateral,
            ..Sym3::ZERO
        };
        let point = PointState {
            plastic_strain: s.plastic_strain,
            temperature: s.temperature,
            density: self.density,
        };
        let trial = s.stress + self.elastic.stress(strain);
        let p = return_stress(
            trial,
            point,
            dt,
            self.elastic.shear_modulus(),
            &self.strength,
        )?;
        Ok(State {
            stress: p.stress,
            plastic_strain: s.plastic_strain + p.increment,
            temperature: s.temperature + p.heating,
        })
    }

    fn walk(
        &self,
        path: Path,
        mut advance: impl FnMut(State, f64, f64) -> Result<State, PathError>,
    ) -> Result<Vec<PathPoint>, PathError> {
        if !path.final_strain.is_finite()
            || path.rate.is_nan()
            || path.rate <= 0.0
            || path.steps == 0
        {
            return Err(PathError::BadPath(path));
        }
        let increment = path.final_strain / f64::from(path.steps);
        let dt = increment.abs() / path.rate;
        let mut state = State {
            stress: Sym3::ZERO,
            plastic_strain: 0.0,
            temperature: self.temperature,
        };
        let mut points = Vec::with_capacity(path.steps as usize);
        for i in 1..=path.steps {
            state = advance(state, increment, dt)?;
            points.push(PathPoint {
                strain: increment * f64::from(i),
                stress: state.stress.xx,
                von_mises: state.stress.von_mises(),
                plastic_strain: state.plastic_strain,
                temperature: state.temperature,
            });
        }
        Ok(points)
    }

    /// Lateral increment for which the sides carry no stress, by the secant method.
    fn free_sides(&self, state: State, axial: f64, dt: f64) -> Result<State, PathError> {
        let tolerance = 1e-10 * self.elastic.young_modulus * axial.abs();
        let (mut x0, mut x1) = (-self.elastic.poisson_ratio * axial, -0.5 * axial);
        let mut f0 = self.step(state, axial, x0, dt)?.stress.yy;
        let mut next = self.step(state, axial, x1, dt)?;
        for _ in 0..50 {
            let f1 = next.stress.yy;
            if f1.abs() <= tolerance {
                return Ok(next);
            }
            let x2 = x1 - f1 * (x1 - x0) / (f1 - f0);
            (x0, f0, x1) = (x1, f1, x2);
            next = self.step(state, axial, x1, dt)?;
        }
        Err(PathError::SidesNotFree {
            strain: axial,
            lateral_stress: next.stress.yy,
        })
    }
}

/// Stress along a path of uniaxial strain, one point per step.
///
/// # Errors
/// If the path makes no sense or the stress update fails.
pub fn uniaxial_strain_path(material: &Material, path: Path) -> Result<Vec<PathPoint>, PathError> {
    material.walk(path, |state, axial, dt| {
        Ok(material.step(state, axial, 0.0, dt)?)
    })
}

/// Stress along a path of uniaxial stress (free sides), one point per step.
///
/// # Errors
/// If the path makes no sense, the stress update fails or the sides cannot be made free.
pub fn uniaxial_stress_path(material: &Material, path: Path) -> Result<Vec<PathPoint>, PathError> {
    material.walk(path, |state, axial, dt| {
        material.free_sides(state, axial, dt)
    })
}
