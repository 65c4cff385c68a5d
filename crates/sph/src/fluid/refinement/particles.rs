//! Adding and removing particles: every array of a liquid at once.

use crate::fluid::far_field::FarField;
use crate::fluid::refinement::Origin;
use crate::fluid::{Fluid, SMOOTHING};
use crate::geometry::Vec2;

/// What one of the particles is that come from others; all else is taken over or follows from it.
pub(super) struct Piece {
    pub(super) position: Vec2,
    pub(super) velocity: Vec2,
    pub(super) mass: f64,
    pub(super) volume: f64,
}

impl Fluid {
    /// Gives a particle new contents; its first smoothing length goes with the root of its area.
    pub(super) fn reshape(&mut self, a: usize, piece: &Piece) {
        let before = self.area(a);
        self.position[a] = piece.position;
        self.velocity[a] = piece.velocity;
        self.mass[a] = piece.mass;
        self.volume[a] = piece.volume;
        self.pressure[a] = self.eos.pressure(self.density(a)).max(0.0);
        self.initial_smoothing_length[a] *= (self.area(a) / before).sqrt();
        self.smoothing_length[a] = SMOOTHING * self.area(a).sqrt();
    }

    /// A copy of particle `a` at the end, with a number of its own.
    pub(super) fn duplicate(&mut self, a: usize) -> usize {
        macro_rules! copy {
            ($($array:ident),*) => { $( let value = self.$array[a]; self.$array.push(value); )* };
        }
        copy!(position, velocity, acceleration, mass, volume, pressure);
        copy!(
            smoothing_length,
            initial_smoothing_length,
            support,
            strain_rate
        );
        self.far_field.push(FarField::NONE);
        self.side_depth.push(f64::INFINITY);
        let level = self.origin[a].level;
        self.origin.push(Origin {
            id: self.next_id,
            level,
        });
        self.next_id += 1;
        self.len() - 1
    }

    /// Takes out the particles that are not to `keep`; the others close up.
    pub(super) fn retain(&mut self, keep: &[bool]) {
        macro_rules! retain {
            ($($array:ident),*) => { $( {
                let mut keep = keep.iter();
                self.$array.retain(|_| *keep.next().unwrap_or(&true));
            } )* };
        }
        retain!(position, velocity, acceleration, mass, volume, pressure);
        retain!(
            smoothing_length,
            initial_smoothing_length,
            support,
            strain_rate
        );
        retain!(far_field, side_depth, origin);
        self.sweep.retain_kinematics(keep);
    }
}
