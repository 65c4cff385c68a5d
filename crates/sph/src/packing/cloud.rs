//! Particles with their mirror images behind the walls.

use super::domain::{Domain, Wall};
use super::{SMOOTHING, Spacing};
use crate::geometry::Vec2;
use crate::kernel::{self, SUPPORT};
use crate::neighbours::Neighbours;

/// Widening of the pair radius that lets a neighbour list serve several steps.
const SKIN: f64 = 0.15;

/// Distance a particle may move before the list must be built anew, in units of its spacing: two particles may
/// approach by twice that, the skin gives 2.6 x 0.15 = 0.39.
pub(super) const SLACK: f64 = 0.18;

/// Particles, images behind them, and the neighbours of the first ones.
pub(super) struct Cloud {
    walls: Vec<Wall>,
    /// Of each image: the particle or earlier image it mirrors, and the wall.
    image: Vec<(u32, u32)>,
    pub(super) position: Vec<Vec2>,
    pub(super) spacing: Vec<f64>,
    pub(super) area: Vec<f64>,
    neighbours: Neighbours,
}

impl Cloud {
    /// Adds the images and lists the neighbours of the first `rows` particles. Holes mirror only the first `loose`
    /// particles: the others end at a free surface.
    pub(super) fn new(
        domain: &Domain,
        spacing: &Spacing,
        position: Vec<Vec2>,
        area: Vec<f64>,
        loose: usize,
        rows: usize,
    ) -> Self {
        let mut cloud = Self {
            walls: domain.all_walls(),
            image: Vec::new(),
            spacing: position.iter().map(|&x| spacing.at(x)).collect(),
            position,
            area,
            neighbours: Neighbours::default(),
        };
        cloud.add_images(loose);
        let h: Vec<f64> = cloud.spacing.iter().map(|s| SMOOTHING * s).collect();
        cloud.neighbours = Neighbours::build(&cloud.position, &h, rows, SKIN);
        cloud
    }

    /// Mirrors everything at one wall after the other; in a narrow domain, images of images between opposite walls
    /// follow until they are out of reach.
    fn add_images(&mut self, loose: usize) {
        for w in 0..self.walls.len() {
            let mut new = self.mirror_at(w, 0, loose);
            if w == 0 || !self.walls[w].is_opposite(&self.walls[w - 1]) {
                continue;
            }
            let mut other = w - 1;
            while new < self.position.len() {
                new = self.mirror_at(other, new, loose);
                other = if other == w { w - 1 } else { w };
            }
        }
    }

    /// Adds the images at wall `w` of the particles and images from `first` on that reach over it. Returns the index
    /// of the first new image.
    fn mirror_at(&mut self, w: usize, first: usize, loose: usize) -> usize {
        let (n_real, end) = (self.n_real(), self.position.len());
        for i in first..end {
            // The partner may be coarser by the growth over the pair radius.
            let reach = 1.2 * SUPPORT * SMOOTHING * (1.0 + SKIN) * self.spacing[i];
            let wall = &self.walls[w];
            let open = matches!(wall, Wall::Hole(_)) && i >= loose && i < n_real;
            if (0.0..reach).contains(&wall.depth(self.position[i])) && !open {
                self.position.push(wall.mirror(self.position[i]));
                self.spacing.push(self.spacing[i]);
                self.area.push(self.area[i]);
                self.image.push((i as u32, w as u32));
            }
        }
        end
    }

    /// Number of particles without images.
    pub(super) fn n_real(&self) -> usize {
        self.position.len() - self.image.len()
    }

    /// Brings back particles behind a wall and updates spacing and area of the first `loose` ones, then all images.
    pub(super) fn update(&mut self, spacing: &Spacing, loose: usize) {
        for a in 0..loose {
            for wall in &self.walls {
                if wall.depth(self.position[a]) < 0.0 {
                    self.position[a] = wall.mirror(self.position[a]);
                }
            }
            self.spacing[a] = spacing.at(self.position[a]);
            self.area[a] = self.spacing[a].powi(2);
        }
        self.update_images();
    }

    /// Makes all images follow their particles.
    pub(super) fn update_images(&mut self) {
        let n_real = self.n_real();
        for (i, &(parent, wall)) in self.image.iter().enumerate() {
            let (i, parent) = (n_real + i, parent as usize);
            self.position[i] = self.walls[wall as usize].mirror(self.position[parent]);
            self.spacing[i] = self.spacing[parent];
            self.area[i] = self.area[parent];
        }
    }

    /// Sum over the neighbours b of `a` of A_b f(r, h) (x_a - x_b), r the distance, h the pair smoothing length.
    pub(super) fn vector_sum(&self, a: usize, f: impl Fn(f64, f64) -> f64) -> Vec2 {
        let mut sum = [0.0; 2];
        for (b, d, r, h) in self.pairs(a) {
            let weight = self.area[b] * f(r, h);
            sum = [sum[0] + weight * d[0], sum[1] + weight * d[1]];
        }
        sum
    }

    /// sum_b A_b W_ab, the particle itself included.
    pub(super) fn partition(&self, a: usize) -> f64 {
        let own = self.area[a] * kernel::value(0.0, SMOOTHING * self.spacing[a]);
        self.pairs(a)
            .map(|(b, _, r, h)| self.area[b] * kernel::value(r, h))
            .fold(own, |sum, w| sum + w)
    }

    /// Index, x_a - x_b, distance and pair smoothing length of each neighbour.
    pub(super) fn pairs(&self, a: usize) -> impl Iterator<Item = (usize, Vec2, f64, f64)> {
        let (x, s) = (self.position[a], self.spacing[a]);
        self.neighbours.of(a).iter().map(move |&b| {
            let b = b as usize;
            let d = [x[0] - self.position[b][0], x[1] - self.position[b][1]];
            let r = (d[0] * d[0] + d[1] * d[1]).sqrt();
            (b, d, r, 0.5 * SMOOTHING * (s + self.spacing[b]))
        })
    }
}
