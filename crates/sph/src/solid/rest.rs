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
