//! Motion of particles, and what stops it: the axis and walls mirror back what would cross them.

use crate::fluid::ghosts::{Shadow, Wall};
use crate::fluid::{Fluid, PARTICLES_PER_TASK};
use crate::geometry::Geometry;
use rayon::prelude::*;

/// Walls, with what tells at once that a particle is far from them.
pub(crate) struct Walls<'a, const D: usize> {
    walls: Vec<(&'a dyn Wall<D>, Option<Shadow>)>,
}

impl<'a, const D: usize> Walls<'a, D> {
    pub(crate) fn new(walls: &[&'a dyn Wall<D>]) -> Self {
        Self {
            walls: walls.iter().map(|w| (*w, w.shadow())).collect(),
        }
    }

    /// Those that may be nearer than `reach` to one of the points.
    pub(crate) fn beside(&self, points: &[[f64; D]], reach: f64) -> Self {
        let (mut lower, mut upper) = ([f64::INFINITY; D], [f64::NEG_INFINITY; D]);
        for x in points {
            for k in 0..D {
                lower[k] = lower[k].min(x[k]);
                upper[k] = upper[k].max(x[k]);
            }
        }
        let may_be_near = |(wall, _): &&(&dyn Wall<D>, _)| !wall.is_clear(lower, upper, reach);
        Self {
            walls: self.walls.iter().filter(may_be_near).copied().collect(),
        }
    }

    /// Whether one of them is nearer than `reach` to a point.
    pub(crate) fn is_near(&self, x: [f64; D], reach: f64) -> bool {
        self.walls.iter().any(|(wall, shadow)| {
            !shadow.is_some_and(|s| s.is_clear(x, reach)) && wall.is_near(x, reach)
        })
    }
}

impl<const D: usize> Fluid<D> {
    /// Moves every particle as `advance` says (from particle, position, velocity); one that would cross the axis or a wall is
    /// mirrored back and counted.
    pub(crate) fn carry(
        &mut self,
        walls: &Walls<D>,
        advance: impl Fn(usize, &mut [f64; D], &mut [f64; D]) + Sync,
    ) {
        let axis = self.geometry == Geometry::Axisymmetric;
        let crossings = (self.position.par_chunks_mut(PARTICLES_PER_TASK))
            .zip(self.velocity.par_chunks_mut(PARTICLES_PER_TASK))
            .enumerate()
            .map(|(block, (position, velocity))| {
                for (i, (x, v)) in position.iter_mut().zip(&mut *velocity).enumerate() {
                    advance(block * PARTICLES_PER_TASK + i, x, v);
                }
                let walls = walls.beside(position, 0.0);
                let mut crossings = [0, 0];
                for (x, v) in position.iter_mut().zip(velocity) {
                    mirror_back(axis, &walls, x, v, &mut crossings);
                }
                crossings
            })
            .reduce(|| [0; 2], |a, b| [a[0] + b[0], a[1] + b[1]]);
        self.account.axis_crossings += crossings[0];
        self.account.wall_crossings += crossings[1];
    }
}

/// Mirrors a particle that has crossed the axis or one of the walls, and counts it.
fn mirror_back<const D: usize>(
    axis: bool,
    walls: &Walls<D>,
    x: &mut [f64; D],
    v: &mut [f64; D],
    crossings: &mut [u64; 2],
) {
    if axis && x[0] <= 0.0 {
        x[0] = -x[0];
        v[0] = -v[0];
        crossings[0] += 1;
    }
    for (wall, shadow) in &walls.walls {
        if shadow.is_some_and(|s| s.is_clear(*x, 0.0)) {
            continue;
        }
        if let Some(plane) = wall.plane(*x, 0.0) {
            *x = plane.mirror(*x);
            *v = plane.mirror_velocity(*v);
            crossings[1] += 1;
        }
    }
}
