//! A solid between two loads: how much it still moves, and where it lies.

use super::{Face, Side, Solid};
use crate::fluid::ordered_sum;

impl Solid {
    /// Kinetic energy, J (of the whole ring in axisymmetry, per metre in plane strain).
    #[must_use]
    pub fn kinetic(&self) -> f64 {
        ordered_sum(self.len(), |a| self.kinetic_energy(a))
    }

    /// Stops all motion; what that takes is in the ledger as damping.
    pub fn stop(&mut self) {
        self.damp(f64::INFINITY, 1.0);
    }

    /// Makes the absorbing faces free of traction, or absorbing again. A body at rest is free of traction there either way;
    /// but it comes to rest sooner when it need not push against faces that take up motion.
    pub fn open_sides(&mut self, open: bool) {
        for surface in &mut self.surfaces {
            if self.block.face(surface.side) == Face::Absorbing {
                surface.face = if open {
                    Face::Traction
                } else {
                    Face::Absorbing
                };
            }
        }
    }

    /// Time that the fastest wave needs along the longer side, s.
    #[must_use]
    pub fn transit(&self) -> f64 {
        let [width, height] = [0, 1].map(|k| self.block.upper[k] - self.block.lower[k]);
        width.max(height) / self.wave_speed()
    }

    /// Whether nothing holds the body along the second coordinate: a load moves it as a whole.
    #[must_use]
    pub fn floats(&self) -> bool {
        [Side::Bottom, Side::Top].iter().all(|&side| {
            matches!(
                self.block.face(side),
                Face::Free | Face::Traction | Face::Absorbing
            )
        })
    }

    /// Moves the body as a whole along the second coordinate by `distance`, m: neither strain nor stress comes from it.
    pub fn shift(&mut self, distance: f64) {
        for x in &mut self.state.position {
            x[1] += distance;
        }
        self.follow_surfaces();
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Block, Numerics, Setup};
    use super::*;
    use crate::geometry::Geometry;
    use erode_physics::material_point::Material;
    use erode_physics::{Elastic, strength::Strength};

    const SPACING: f64 = 1e-5;

    /// A bar of 40 by 10 particles whose right side absorbs, stretched along by 1e-4.
    fn bar() -> Solid {
        let place = |k: usize| [k % 40, k / 40].map(|i| (i as f64 + 0.5) * SPACING);
        let mut solid = Solid::new(Setup {
            geometry: Geometry::Plane,
            block: Block {
                lower: [0.0; 2],
                upper: [40.0 * SPACING, 10.0 * SPACING],
                left: Face::Symmetry,
                right: Face::Absorbing,
                bottom: Face::Free,
                top: Face::Traction,
            },
            material: Material {
                elastic: Elastic {
                    young_modulus: 200e9,
                    poisson_ratio: 0.3,
                },
                strength: Strength::Elastic,
                density: 7800.0,
                temperature: 293.0,
            },
            numerics: Numerics::default(),
            position: (0..400).map(place).collect(),
            area: vec![SPACING * SPACING; 400],
        })
        .unwrap();
        for x in &mut solid.state.position {
            x[0] *= 1.0001;
        }
        // The stress that belongs to it.
        solid.update_stress(1e-12).unwrap();
        solid.accelerations();
        solid
    }

    /// Half the time free, half with open sides: the ledger closes to 2 % of what was stored, and damping takes the most.
    #[test]
    fn a_bar_comes_to_rest_and_its_ledger_closes() {
        let mut solid = bar();
        let stored = solid.energy_defect();
        assert!(stored > 0.0 && solid.kinetic() == 0.0);
        let dt = solid.stable_time_step().dt;
        let damping = 2.0 / solid.transit();
        let steps = (12.0 * solid.transit() / dt) as usize;
        let mut largest: f64 = 0.0;
        for step in 0..steps {
            solid.open_sides(2 * step > steps);
            solid.step(dt).unwrap();
            solid.damp(damping, dt);
            largest = largest.max(solid.kinetic());
        }
        assert!(largest > 0.05 * stored, "{largest} of {stored}");
        assert!(
            solid.kinetic() < 1e-6 * largest,
            "{} of {largest}",
            solid.kinetic()
        );
        solid.stop();
        assert_eq!(solid.kinetic(), 0.0);
        // A free face without images: 2 % of the energy.
        let open = (solid.energy_defect() - stored) / stored;
        assert!(open.abs() < 0.02, "{open}");
        assert!(solid.energy().elastic < 1e-4 * stored);
    }

    #[test]
    fn a_shift_is_no_strain() {
        let mut solid = bar();
        assert!(solid.floats());
        let (energy, stress) = (solid.energy(), solid.state.stress.clone());
        solid.shift(3e-6);
        solid.update_stress(1e-12).unwrap();
        // Positions are rounded at the 16th digit of 1e-4 m, strains of 1e-4 at the 12th.
        for (a, b) in solid.state.stress.iter().zip(&stress) {
            assert!((a.xx - b.xx).abs() < 1e-9 * 200e9 * 1e-4 + 1.0);
        }
        assert!((solid.energy().elastic / energy.elastic - 1.0).abs() < 1e-6);
        assert!((solid.surface(Side::Top).unwrap().position[0][1] - 1.03e-4).abs() < 1e-9);
        let mut held = bar();
        held.block.bottom = Face::Clamped;
        assert!(!held.floats());
    }
}
