//! What changes with time in a solid: everything a checkpoint has to keep.

use super::mat2::{Mat2, UNIT};
use crate::geometry::Vec2;
use erode_physics::Sym3;
use serde::{Deserialize, Serialize};

/// State of the particles, one vector per quantity.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// Position, m.
    pub position: Vec<Vec2>,
    /// Velocity, m/s.
    pub velocity: Vec<Vec2>,
    /// Acceleration, m/s2.
    pub acceleration: Vec<Vec2>,
    /// Deformation gradient dx/dX in the plane of motion.
    pub deformation: Vec<Mat2>,
    /// Stretch out of the plane: r/R in axisymmetry, 1 in plane strain.
    pub hoop_stretch: Vec<f64>,
    /// Cauchy stress, Pa.
    pub stress: Vec<Sym3>,
    /// Von Mises stress, Pa.
    pub von_mises: Vec<f64>,
    /// Equivalent plastic strain.
    pub plastic_strain: Vec<f64>,
    /// Its rate in the last step, 1/s.
    pub plastic_strain_rate: Vec<f64>,
    /// Plastic work per reference volume, J/m3.
    pub plastic_work: Vec<f64>,
    /// Temperature, K.
    pub temperature: Vec<f64>,
    /// Work done so far.
    pub work: Work,
}

/// Work since the start, J (of the whole ring in axisymmetry, per metre in plane strain).
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Work {
    /// Done on the solid by the pressure on its traction faces and by an indenter.
    pub pressure: f64,
    /// Done on the solid by its driven faces.
    #[serde(default)]
    pub driving: f64,
    /// Taken out by mass damping.
    #[serde(default)]
    pub damping: f64,
    /// Done on the solid by its absorbing faces (negative: energy that left).
    pub absorbing: f64,
    /// Dissipated by the artificial viscosity.
    pub viscous: f64,
    /// Stored or dissipated by the hourglass forces.
    pub hourglass: f64,
}

/// View of one state array.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Field<'a> {
    /// One number per particle.
    Scalar(&'a [f64]),
    /// Two components per particle.
    Vector(&'a [Vec2]),
    /// Four components per particle, rows first.
    Matrix(&'a [Mat2]),
    /// Six components per particle.
    Tensor(&'a [Sym3]),
}

impl State {
    pub(super) fn at_rest(position: Vec<Vec2>, temperature: f64) -> Self {
        let n = position.len();
        Self {
            position,
            velocity: vec![[0.0; 2]; n],
            acceleration: vec![[0.0; 2]; n],
            deformation: vec![UNIT; n],
            hoop_stretch: vec![1.0; n],
            stress: vec![Sym3::ZERO; n],
            von_mises: vec![0.0; n],
            plastic_strain: vec![0.0; n],
            plastic_strain_rate: vec![0.0; n],
            plastic_work: vec![0.0; n],
            temperature: vec![temperature; n],
            work: Work::default(),
        }
    }

    /// All arrays with their names.
    #[must_use]
    pub fn fields(&self) -> [(&'static str, Field<'_>); 11] {
        [
            ("position", Field::Vector(&self.position)),
            ("velocity", Field::Vector(&self.velocity)),
            ("acceleration", Field::Vector(&self.acceleration)),
            ("deformation", Field::Matrix(&self.deformation)),
            ("hoop_stretch", Field::Scalar(&self.hoop_stretch)),
            ("stress", Field::Tensor(&self.stress)),
            ("von_mises", Field::Scalar(&self.von_mises)),
            ("plastic_strain", Field::Scalar(&self.plastic_strain)),
            (
                "plastic_strain_rate",
                Field::Scalar(&self.plastic_strain_rate),
            ),
            ("plastic_work", Field::Scalar(&self.plastic_work)),
            ("temperature", Field::Scalar(&self.temperature)),
        ]
    }
}
