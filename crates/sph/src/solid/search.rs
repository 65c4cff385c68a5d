//! Search of the reference neighbours: particles and images within the support of the mean smoothing length.

use super::block::Block;
use super::images::{Image, all_images};
use crate::geometry::Vec2;
use crate::kernel::SUPPORT;
use rayon::prelude::*;

/// Particles, then mirror images, then open images, as points.
pub(super) struct Cloud {
    pub(super) points: Vec<Vec2>,
    pub(super) source: Vec<u32>,
    pub(super) smoothing_length: Vec<f64>,
    pub(super) particles: usize,
    pub(super) mirror_images: Vec<Image>,
    pub(super) open_images: Vec<Image>,
}

impl Cloud {
    /// Particles with exactly those images that some particle sees (without `open` only mirror images), and the neighbours
    /// of each particle, ascending.
    pub(super) fn with_neighbours(
        block: &Block,
        position: &[Vec2],
        h: &[f64],
        open: bool,
    ) -> (Self, Vec<Vec<u32>>) {
        let largest = h.iter().fold(0.0, |m: f64, &x| m.max(x));
        // A particle at depth d sees an image of b at depth d_b if d + d_b is within the pair's support.
        let reach: Vec<f64> = h.iter().map(|h| 0.5 * SUPPORT * (h + largest)).collect();
        let mut images = all_images(block, position, &reach);
        images.retain(|i| open || i.is_mirror());
        let all = Self::new(block, position, h, images);
        let lists = all.neighbours();
        let mut used = vec![false; all.points.len()];
        for &j in lists.iter().flatten() {
            used[j as usize] = true;
        }
        let images = (all.mirror_images.iter().chain(&all.open_images))
            .zip(&used[all.particles..])
            .filter(|(_, used)| **used)
            .map(|(image, _)| *image)
            .collect();
        let kept = Self::new(block, position, h, images);
        let mut rename = Vec::with_capacity(used.len());
        let mut next = 0;
        for (j, used) in used.into_iter().enumerate() {
            rename.push(next);
            next += u32::from(used || j < all.particles);
        }
        let renamed = |list: Vec<u32>| list.into_iter().map(|j| rename[j as usize]).collect();
        (kept, lists.into_iter().map(renamed).collect())
    }

    fn new(block: &Block, position: &[Vec2], h: &[f64], images: Vec<Image>) -> Self {
        let (mirror_images, open_images): (Vec<_>, Vec<_>) =
            images.into_iter().partition(Image::is_mirror);
        let mut points = position.to_vec();
        let mut source: Vec<u32> = (0..position.len() as u32).collect();
        for image in mirror_images.iter().chain(&open_images) {
            points.push(image.place(block, position[image.source as usize]));
            source.push(image.source);
        }
        Self {
            smoothing_length: source.iter().map(|&i| h[i as usize]).collect(),
            points,
            source,
            particles: position.len(),
            mirror_images,
            open_images,
        }
    }

    fn neighbours(&self) -> Vec<Vec<u32>> {
        let h = &self.smoothing_length;
        let largest = h.iter().fold(0.0, |m: f64, &x| m.max(x));
        let smallest = h.iter().fold(f64::INFINITY, |m: f64, &x| m.min(x));
        let grid = Grid::new(&self.points, SUPPORT * smallest);
        let of_particle = |a: usize| {
            let mut list = Vec::new();
            grid.visit(self.points[a], 0.5 * SUPPORT * (h[a] + largest), |j| {
                let b = j as usize;
                let reach = 0.5 * SUPPORT * (h[a] + h[b]);
                let d = [0, 1].map(|k| self.points[a][k] - self.points[b][k]);
                if b != a && d[0] * d[0] + d[1] * d[1] < reach * reach {
                    list.push(j);
                }
            });
            list.sort_unstable();
            list
        };
        (0..self.particles)
            .into_par_iter()
            .with_min_len(64)
            .map(of_particle)
            .collect()
    }
}

/// Points sorted into square cells.
struct Grid {
    lower: Vec2,
    cell: f64,
    size: [usize; 2],
    start: Vec<u32>,
    index: Vec<u32>,
}

impl Grid {
    fn new(points: &[Vec2], wanted: f64) -> Self {
        let mut lower = [f64::INFINITY; 2];
        let mut upper = [f64::NEG_INFINITY; 2];
        for p in points {
            for k in 0..2 {
                lower[k] = lower[k].min(p[k]);
                upper[k] = upper[k].max(p[k]);
            }
        }
        // At most about four cells per point, whatever the grading.
        let extent = (upper[0] - lower[0]) * (upper[1] - lower[1]);
        let cell = wanted.max(0.5 * (extent / points.len() as f64).sqrt());
        let size = [0, 1].map(|k| ((upper[k] - lower[k]) / cell) as usize + 1);
        let mut grid = Self {
            lower,
            cell,
            size,
            start: vec![0; size[0] * size[1] + 1],
            index: vec![0; points.len()],
        };
        let place: Vec<usize> = points
            .iter()
            .map(|p| grid.column(p[0], 0) + size[0] * grid.column(p[1], 1))
            .collect();
        for &c in &place {
            grid.start[c + 1] += 1;
        }
        for c in 0..size[0] * size[1] {
            grid.start[c + 1] += grid.start[c];
        }
        let mut next = grid.start.clone();
        for (i, &c) in place.iter().enumerate() {
            grid.index[next[c] as usize] = i as u32;
            next[c] += 1;
        }
        grid
    }

    fn column(&self, x: f64, axis: usize) -> usize {
        (((x - self.lower[axis]) / self.cell).max(0.0) as usize).min(self.size[axis] - 1)
    }

    fn visit(&self, centre: Vec2, radius: f64, mut see: impl FnMut(u32)) {
        let range =
            |k: usize| self.column(centre[k] - radius, k)..=self.column(centre[k] + radius, k);
        for row in range(1) {
            for column in range(0) {
                let c = column + self.size[0] * row;
                for &j in &self.index[self.start[c] as usize..self.start[c + 1] as usize] {
                    see(j);
                }
            }
        }
    }
}
