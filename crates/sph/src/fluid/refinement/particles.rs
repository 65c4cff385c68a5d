//! Adding and removing particles: every array of a liquid at once.

use crate::fluid::far_field::FarField;
use crate::fluid::refinement::Origin;
use crate::fluid::{Clustering, Fluid, SMOOTHING};
use crate::geometry::Vec2;
use rayon::prelude::*;

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

    /// Other particles than those of the start, as a checkpoint knows them: where they come from, their first smoothing length
    /// (m), and the number that the next one gets. Far fields stay with the particles that have them. All else is to be set.
    pub fn take_origins(&mut self, origin: Vec<Origin>, initial_h: &[f64], next_id: u32) {
        let at_start = |o: &Origin| (o.level == 0).then_some(o.id as usize);
        let far = |o: &Origin| at_start(o).and_then(|a| self.far_field.get(a).copied());
        let depth = |o: &Origin| at_start(o).and_then(|a| self.side_depth.get(a).copied());
        let far_field = origin.iter().map(|o| far(o).unwrap_or(FarField::NONE));
        let side_depth = origin.iter().map(|o| depth(o).unwrap_or(f64::INFINITY));
        (self.far_field, self.side_depth) = (far_field.collect(), side_depth.collect());
        self.position.resize(origin.len(), [0.0; 2]);
        self.initial_smoothing_length = initial_h.to_vec();
        self.clustering = Clustering::default();
        (self.origin, self.next_id) = (origin, next_id);
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
    }
}

impl<const D: usize> Fluid<D> {
    /// Puts the particles in another order: place i is taken by particle `order[i]`. The pressure of the gas on them is found anew in
    /// every step.
    pub(crate) fn arrange(&mut self, order: &[u32]) {
        fn arranged<T: Copy + Send + Sync>(values: &[T], order: &[u32]) -> Vec<T> {
            order.par_iter().map(|&a| values[a as usize]).collect()
        }
        if (order.iter().enumerate()).all(|(i, a)| i == *a as usize) {
            return;
        }
        macro_rules! arrange {
            ($($array:ident),*) => { $( self.$array = arranged(&self.$array, order); )* };
        }
        arrange!(position, velocity, acceleration, mass, volume, pressure);
        arrange!(
            smoothing_length,
            initial_smoothing_length,
            support,
            strain_rate
        );
        arrange!(far_field, side_depth, origin);
    }
}
