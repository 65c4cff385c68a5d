//! Ghosts: liquid particles mirrored at the axis, at rigid sides and at the surface of a solid.
//!
//! A ghost has the area and pressure of its source; velocity along the mirror is kept, across it reversed about the
//! speed of the mirror. In this way the axis, a wall and a moving metal surface need no case of their own in the sums.

use crate::fluid::carry::Walls;
use crate::fluid::{Fluid, PARTICLES_PER_TASK};
use crate::geometry::{Geometry, dot};
use rayon::prelude::*;

/// A plane (a line in plane motion) in which particles are mirrored.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plane<const D: usize = 2> {
    /// Unit normal pointing into the liquid.
    pub normal: [f64; D],
    /// n . x on the plane, m.
    pub offset: f64,
    /// Speed of the plane along its normal, m/s.
    pub speed: f64,
}

impl<const D: usize> Plane<D> {
    /// The axis of rotation.
    const AXIS: Self = {
        let mut normal = [0.0; D];
        normal[0] = 1.0;
        Self {
            normal,
            offset: 0.0,
            speed: 0.0,
        }
    };

    /// Distance of a point from the plane, positive on the liquid side.
    #[inline]
    #[must_use]
    pub fn distance(&self, x: [f64; D]) -> f64 {
        dot(self.normal, x) - self.offset
    }

    #[inline]
    fn reflect(&self, x: [f64; D], about: f64) -> [f64; D] {
        let d = dot(self.normal, x) - about;
        std::array::from_fn(|k| x[k] - 2.0 * d * self.normal[k])
    }

    /// Mirror image of a point.
    #[inline]
    #[must_use]
    pub fn mirror(&self, x: [f64; D]) -> [f64; D] {
        self.reflect(x, self.offset)
    }

    /// Mirror image of a direction (shifting, acceleration).
    #[inline]
    #[must_use]
    pub fn mirror_direction(&self, d: [f64; D]) -> [f64; D] {
        self.reflect(d, 0.0)
    }

    /// Mirror image of a tensor, Q g Q with Q = 1 - 2 n n.
    #[inline]
    #[must_use]
    pub fn mirror_tensor(&self, g: [[f64; D]; D]) -> [[f64; D]; D] {
        let column = |m: &[[f64; D]; D], j: usize| m.map(|row| row[j]);
        let columns = std::array::from_fn(|j| self.mirror_direction(column(&g, j)));
        std::array::from_fn(|i| self.mirror_direction(column(&columns, i)))
    }

    /// Mirror image of a velocity.
    #[inline]
    #[must_use]
    pub fn mirror_velocity(&self, v: [f64; D]) -> [f64; D] {
        self.reflect(v, self.speed)
    }
}

/// A wall of the liquid: finds the tangent plane nearest to a point.
pub trait Wall<const D: usize = 2>: Sync {
    /// Tangent plane at the foot of `x`; none when `x` is farther away than `reach`.
    fn plane(&self, x: [f64; D], reach: f64) -> Option<Plane<D>>;

    /// Whether there is such a plane.
    fn is_near(&self, x: [f64; D], reach: f64) -> bool {
        self.plane(x, reach).is_some()
    }

    /// Whether it belongs to a body that the liquid pushes.
    fn is_surface(&self) -> bool {
        false
    }

    /// Whether no point between `lower` and `upper` can be nearer than `reach`, if that can be told at once.
    fn is_clear(&self, lower: [f64; D], upper: [f64; D], reach: f64) -> bool {
        let _ = (lower, upper, reach);
        false
    }

    /// Where it surely is not, if that can be told at once.
    fn shadow(&self) -> Option<Shadow> {
        None
    }
}

/// A strip in which a wall is never higher than `top`, in plane and axisymmetric motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shadow {
    /// Range of the first coordinate, m.
    pub ends: [f64; 2],
    /// Largest second coordinate of the wall, m.
    pub top: f64,
    /// Cosine of its steepest slope.
    pub cosine: f64,
}

impl Shadow {
    /// Whether the tangent at the foot of `x` is surely farther away than `reach`.
    #[must_use]
    pub fn is_clear<const D: usize>(&self, x: [f64; D], reach: f64) -> bool {
        let inside = x[0] >= self.ends[0] && x[0] <= self.ends[1];
        inside && (x[1] - self.top) * self.cosine > reach
    }
}

impl<const D: usize> Wall<D> for Plane<D> {
    fn plane(&self, x: [f64; D], reach: f64) -> Option<Self> {
        self.is_near(x, reach).then_some(*self)
    }

    fn is_near(&self, x: [f64; D], reach: f64) -> bool {
        self.distance(x) < reach
    }

    fn is_clear(&self, lower: [f64; D], upper: [f64; D], reach: f64) -> bool {
        let toward = |k: usize| {
            if self.normal[k] > 0.0 {
                lower[k]
            } else {
                upper[k]
            }
        };
        self.distance(std::array::from_fn(toward)) >= reach
    }
}

/// Sources and planes of all ghosts; entry k is particle `n + k` of the extended arrays.
#[derive(Debug, Clone)]
pub struct Ghosts<const D: usize = 2> {
    /// Particle (or earlier ghost) that is mirrored.
    pub source: Vec<u32>,
    /// Plane in which it is mirrored.
    pub plane: Vec<Plane<D>>,
    /// Wall that made the ghost or its source (index into the list of walls); `AXIS` for the axis alone.
    pub wall: Vec<u32>,
    /// Whether that wall belongs to a body that the liquid pushes.
    pub surface: Vec<bool>,
}

/// Marks ghosts made by the symmetry axis.
pub const AXIS: u32 = u32::MAX;

/// A particle is mirrored when nearer than this many smoothing lengths: support 2 plus room for graded spacing.
const REACH: f64 = 2.5;

impl<const D: usize> Default for Ghosts<D> {
    fn default() -> Self {
        Self {
            source: Vec::new(),
            plane: Vec::new(),
            wall: Vec::new(),
            surface: Vec::new(),
        }
    }
}

impl<const D: usize> Ghosts<D> {
    /// Finds all ghosts of a liquid between `walls`; those of the axis come last and mirror wall ghosts too.
    #[must_use]
    pub fn find(fluid: &Fluid<D>, walls: &[&dyn Wall<D>]) -> Self {
        let mut ghosts = Self::default();
        let candidates = near_walls(fluid, walls);
        for (w, wall) in walls.iter().enumerate() {
            for &a in &candidates {
                let a = a as usize;
                if let Some(plane) =
                    wall.plane(fluid.position[a], REACH * fluid.smoothing_length[a])
                {
                    ghosts.push(a, plane, w as u32, wall.is_surface());
                }
            }
        }
        ghosts.mirror_corners(fluid, walls);
        if fluid.geometry == Geometry::Axisymmetric {
            ghosts.mirror_axis(fluid);
        }
        ghosts
    }

    /// Particles and the ghosts so far, mirrored at the axis.
    fn mirror_axis(&mut self, fluid: &Fluid<D>) {
        let n = fluid.len();
        let near = |x: [f64; D], h: f64| x[0] < REACH * h;
        let places = fluid.position.par_iter().zip(&fluid.smoothing_length);
        let own: Vec<usize> = (places.enumerate())
            .with_min_len(PARTICLES_PER_TASK)
            .filter(|(_, (x, h))| near(**x, **h))
            .map(|(a, _)| a)
            .collect();
        let walls = self.source.len();
        let mut images: Vec<[f64; D]> = Vec::with_capacity(walls);
        for (&source, plane) in self.source.iter().zip(&self.plane) {
            let x = match (source as usize).checked_sub(n) {
                None => fluid.position[source as usize],
                Some(k) => images[k],
            };
            images.push(plane.mirror(x));
        }
        for a in own {
            self.push(a, Plane::AXIS, AXIS, false);
        }
        for (k, x) in images.into_iter().enumerate() {
            let h = fluid.smoothing_length[self.particle(n, n + k)];
            if near(x, h) {
                self.push(n + k, Plane::AXIS, self.wall[k], self.surface[k]);
            }
        }
    }

    fn push(&mut self, source: usize, plane: Plane<D>, wall: u32, surface: bool) {
        self.surface.push(surface);
        self.source.push(source as u32);
        self.plane.push(plane);
        self.wall.push(wall);
    }

    /// Ghosts of the first walls, mirrored once more in later walls, fill the edges and corners.
    fn mirror_corners(&mut self, fluid: &Fluid<D>, walls: &[&dyn Wall<D>]) {
        let n = fluid.len();
        let mut k = 0;
        // Images of images in a third wall are found on the way.
        while k < self.source.len() {
            let a = self.particle(n, n + k);
            let reach = REACH * fluid.smoothing_length[a];
            for (w, wall) in walls.iter().enumerate().skip(self.wall[k] as usize + 1) {
                if let Some(plane) = wall.plane(fluid.position[a], reach) {
                    let surface = self.surface[k] || wall.is_surface();
                    self.push(n + k, plane, w as u32, surface);
                }
            }
            k += 1;
        }
    }

    /// The same ghosts with the planes where the walls are now.
    #[must_use]
    pub fn refresh(&self, fluid: &Fluid<D>, walls: &[&dyn Wall<D>]) -> Self {
        let mut ghosts = self.clone();
        for k in 0..ghosts.source.len() {
            let a = self.particle(fluid.len(), fluid.len() + k);
            if self.plane[k] == Plane::AXIS {
                continue;
            }
            let wall = walls[self.wall[k] as usize];
            if let Some(plane) = wall.plane(fluid.position[a], f64::INFINITY) {
                ghosts.plane[k] = plane;
            }
        }
        ghosts
    }

    /// Whether extended index `i` is a ghost at the surface of a body that the liquid pushes.
    #[inline]
    #[must_use]
    pub fn is_surface(&self, n: usize, i: usize) -> bool {
        i >= n && self.surface[i - n]
    }

    /// Particle at the root of extended index `i`.
    #[must_use]
    pub fn particle(&self, n: usize, mut i: usize) -> usize {
        while i >= n {
            i = self.source[i - n] as usize;
        }
        i
    }

    /// Real values followed by those of the ghosts, each made from its source by `image`.
    pub fn extend<T: Copy>(&self, real: &[T], image: impl Fn(&Plane<D>, T) -> T) -> Vec<T> {
        let mut all = Vec::with_capacity(real.len() + self.source.len());
        all.extend_from_slice(real);
        for (source, plane) in self.source.iter().zip(&self.plane) {
            all.push(image(plane, all[*source as usize]));
        }
        all
    }

    /// As [`Self::extend`] for values that mirroring does not change.
    pub fn extend_even<T: Copy>(&self, real: &[T]) -> Vec<T> {
        self.extend(real, |_, value| value)
    }
}

/// Particles that some of the walls may mirror.
fn near_walls<const D: usize>(fluid: &Fluid<D>, walls: &[&dyn Wall<D>]) -> Vec<u32> {
    let walls = Walls::new(walls);
    let blocks: Vec<Vec<u32>> = (fluid.position.par_chunks(PARTICLES_PER_TASK))
        .zip(fluid.smoothing_length.par_chunks(PARTICLES_PER_TASK))
        .enumerate()
        .map(|(block, (position, h))| {
            let largest = h.iter().copied().fold(0.0, f64::max);
            let walls = walls.beside(position, REACH * largest);
            let near = |i: &usize| walls.is_near(position[*i], REACH * h[*i]);
            let first = block * PARTICLES_PER_TASK;
            let near = (0..h.len()).filter(near);
            near.map(|i| (first + i) as u32).collect()
        })
        .collect();
    blocks.concat()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A box is clear of a plane when all of its corners are, and no sooner.
    #[test]
    fn a_box_is_clear_when_its_nearest_corner_is() {
        for angle in 0..24 {
            let angle = 0.26 * f64::from(angle);
            let plane = Plane {
                normal: [angle.cos(), angle.sin()],
                offset: 0.3,
                speed: 0.0,
            };
            let (lower, upper) = ([-0.7, 0.2], [0.4, 1.1]);
            let corners = [lower, upper, [lower[0], upper[1]], [upper[0], lower[1]]];
            let nearest = corners.map(|x| plane.distance(x));
            let nearest = nearest.into_iter().fold(f64::INFINITY, f64::min);
            assert!(plane.is_clear(lower, upper, nearest));
            assert!(!plane.is_clear(lower, upper, nearest + 1e-12));
        }
    }
}
