//! One block under a Gaussian velocity that stays on.

use crate::validate::Failure;
use crate::validate::materials::steel;
use crate::validate::steel_lattice::Lattice;
use erode_physics::damage::{Damage, RuptureStrain};
use erode_physics::load::gaussian_one_percent;
use erode_sph::Geometry;
use erode_sph::solid::{Driven, Face, Formulation, Side, Solid, Tangential};

const SIZE: [f64; 2] = [1e-3, 0.8e-3];
const RUPTURE_STRAIN: f64 = 0.03;
/// Velocity of the top on the axis, m/s: strain rates of some 1e3 1/s, as in the source.
const SPEED: f64 = 1.0;
/// s: a pit of 18 um (at the 6 um of figure 5.5 the strain under R = 0.4 mm is 0.02, below failure).
pub(super) const DURATION: f64 = 18e-6;
/// Depth of the pit at which strains are compared along the line, m.
const PIT: f64 = 6e-6;
/// Height of the line and how far it goes: figure 5.4, line AB.
const LINE: f64 = 0.68e-3;
const LINE_END: f64 = 0.9e-3;
/// The velocity rises over this time, s, not to start with a shock.
const RISE: f64 = 0.5e-6;

/// What is pressed.
#[derive(Debug, Clone, Copy)]
pub(super) struct Case {
    radius_um: u32,
    rate: bool,
    spacing: f64,
}

/// What came out.
#[derive(Debug, Clone)]
pub(super) struct Pressed {
    /// (time, lost mass).
    pub(super) lost: Vec<[f64; 2]>,
    /// (r, plastic strain) on the line at the pit of comparison.
    pub(super) line: Vec<[f64; 2]>,
    /// Largest of these.
    pub(super) line_strain: f64,
    /// Largest plastic strain rate before the first loss, 1/s.
    pub(super) strain_rate: f64,
    /// Particles that came loose over all lost.
    pub(super) loose: f64,
    pub(super) mass_error: f64,
    pub(super) missed: f64,
}

impl Case {
    pub(super) fn new(radius_um: u32, rate: bool, spacing: f64) -> Self {
        Self {
            radius_um,
            rate,
            spacing,
        }
    }

    /// Radius and spacing.
    pub(super) fn name(&self) -> String {
        let radius = f64::from(self.radius_um) * 1e-3;
        format!("R {radius} mm, {:.0} um", self.spacing * 1e6)
    }

    pub(super) fn title(&self) -> String {
        format!(
            "{}, C0 {}",
            self.name(),
            if self.rate { 0.031 } else { 0.0 }
        )
    }

    fn lattice(&self) -> Lattice {
        let top = Driven {
            tangential: Tangential::Bonded,
            part: None,
        };
        Lattice {
            geometry: Geometry::Axisymmetric,
            size: SIZE,
            spacing: self.spacing,
            faces: [
                Face::Axis,
                Face::Symmetry,
                Face::Symmetry,
                Face::Driven(top),
            ],
            formulation: Formulation::TotalLagrangian,
        }
    }

    fn build(&self) -> Result<Solid, Failure> {
        let mut solid = self.lattice().build()?;
        if self.rate {
            solid.material.strength = steel()?.2;
        }
        solid.damage = Damage::RuptureStrain(RuptureStrain {
            rupture_strain: RUPTURE_STRAIN,
            modulus_loss: false,
        });
        Ok(solid)
    }

    pub(super) fn run(&self) -> Result<Pressed, Failure> {
        let mut solid = self.build()?;
        let mass = solid.mass();
        let steps = (DURATION / solid.stable_time_step().dt).ceil();
        let dt = DURATION / steps;
        let radius = f64::from(self.radius_um) * 1e-6;
        let mut line = Vec::new();
        let (mut lost, mut strain_rate) = (vec![[0.0; 2]], 0.0_f64);
        for step in 1..=steps as u64 {
            let time = step as f64 * dt;
            let [depth, speed] = motion(time);
            if let Some(top) = solid.surface_mut(Side::Top) {
                top.drive(|x| {
                    let share = gaussian_one_percent(x[0], radius);
                    [[0.0, -depth * share], [0.0, -speed * share]]
                });
            }
            solid.step(dt)?;
            if line.is_empty() && depth >= PIT {
                line = self
                    .lattice()
                    .line(LINE, LINE_END, |k| solid.state.plastic_strain[k]);
            }
            if step % 16 == 0 {
                lost.push([time, solid.state.work.lost.mass]);
                if solid.state.work.lost.mass == 0.0 && time > 2.0 * RISE {
                    strain_rate = largest(&solid.state.plastic_strain_rate).max(strain_rate);
                }
            }
        }
        let (work, gone) = (solid.state.work, solid.state.work.lost);
        Ok(Pressed {
            lost,
            line_strain: line.iter().fold(0.0, |m: f64, p| m.max(p[1])),
            line,
            strain_rate,
            loose: gone.loose as f64 / (gone.loose + gone.failed) as f64,
            mass_error: (solid.mass() + gone.mass) / mass - 1.0,
            missed: solid.energy_defect() / work.driving,
        })
    }
}

/// Depth and velocity of the pit.
pub(super) fn motion(time: f64) -> [f64; 2] {
    let x = (time / RISE).min(1.0);
    let depth = SPEED * (RISE * x * x * x * (1.0 - 0.5 * x) + (time - RISE).max(0.0));
    [depth, SPEED * x * x * (3.0 - 2.0 * x)]
}

fn largest(values: &[f64]) -> f64 {
    values.iter().copied().fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn velocity_is_the_derivative_of_the_depth() {
        for time in [0.1e-6, 0.3e-6, 0.499e-6, 0.6e-6, 5e-6] {
            let d = 1e-10;
            let slope = (motion(time + d)[0] - motion(time - d)[0]) / (2.0 * d);
            assert!((slope - motion(time)[1]).abs() < 1e-5);
        }
    }
}
