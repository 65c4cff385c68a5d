//! What changes with time in a solid: everything a checkpoint has to keep.

use super::mat2::{Mat2, UNIT};
use super::renewal::Base;
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
    /// Damage: 0 sound, 1 failed.
    pub damage: Vec<f64>,
    /// Energy dissipated by loss of modulus per reference volume, J/m3.
    pub damage_work: Vec<f64>,
    /// 0 in the body, [`FAILED`] taken out by damage, [`LOOSE`] taken out because too little held it.
    pub removed: Vec<f64>,
    /// The reference configuration after a renewal.
    #[serde(default)]
    pub base: Option<Base>,
    /// Work done so far.
    pub work: Work,
}

/// In `removed`: the damage law says so.
pub const FAILED: f64 = 1.0;
/// In `removed`: too few neighbours are left to span a gradient.
pub const LOOSE: f64 = 2.0;

/// What was taken out of the body since the start; energies J (of the whole ring, or per metre in plane strain).
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Lost {
    /// Particles that failed.
    pub failed: u64,
    /// Particles that came loose.
    pub loose: u64,
    /// Mass, kg.
    pub mass: f64,
    /// Momentum along the second coordinate, kg m/s.
    pub momentum: f64,
    /// Kinetic energy carried away.
    pub kinetic: f64,
    /// Elastic energy carried away.
    pub elastic: f64,
    /// Plastic work done in it before; also part of the plastic work of the body's ledger.
    pub plastic_work: f64,
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
    /// Taken out of the body.
    #[serde(default)]
    pub lost: Lost,
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
            damage: vec![0.0; n],
            damage_work: vec![0.0; n],
            removed: vec![0.0; n],
            base: None,
            work: Work::default(),
        }
    }

    /// All arrays with their names.
    #[must_use]
    pub fn fields(&self) -> [(&'static str, Field<'_>); 14] {
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
            ("damage", Field::Scalar(&self.damage)),
            ("damage_work", Field::Scalar(&self.damage_work)),
            ("removed", Field::Scalar(&self.removed)),
        ]
    }
}
