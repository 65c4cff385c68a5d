//! Size and shape of a cavity in the liquid.
//!
//! The colour c(x) = sum_b A_b w(x - x_b, R_b) is 1 in the liquid and 0 in the void, smeared over the support R = 2 h at the
//! surface; w = 5/(pi R^2) (1 - x^2/R^2)^4, which has the support of the kernel of the liquid and its smoothness, and no root.
//! The integral of 1 - c over the void and its rim is the volume of the void to a small part of a particle, however the
//! particles at the surface are strained (half a spacing inside the first particle is not: a parcel at the surface of a
//! collapsing bubble is stretched along the radius).

mod front;
mod paint;

pub use front::{Front, fronts};

use crate::fluid::Fluid;
use crate::fluid::ghosts::Ghosts;
use crate::geometry::{Geometry, Vec2};
use crate::kernel;
use crate::simd::{self, LANES};
use paint::{BAND, Band, Blot, VoidCells};
use rayon::prelude::*;

/// The part of the plane in which cavities are looked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Window {
    /// Corner with the smallest coordinates, m.
    pub lower: Vec2,
    /// Corner with the largest coordinates, m.
    pub upper: Vec2,
    /// Cell size, m; about half the finest particle spacing.
    pub cell: f64,
}

/// A connected void.
#[derive(Debug, Clone, PartialEq)]
pub struct Cavity {
    /// Volume, m3 (per metre in plane).
    pub volume: f64,
    /// Centroid, m (on the axis for a void that touches it).
    pub centre: Vec2,
    /// Smallest distance from the axis, m; positive for a toroid.
    pub inner_radius: f64,
    /// Lowest and highest second coordinate with colour 1/2, m.
    pub extent: [f64; 2],
    /// The same along the axis; NaN for a void that does not touch it.
    pub axis_extent: [f64; 2],
}

impl Cavity {
    /// Length of the void along the axis, m; zero if it does not touch it.
    #[must_use]
    pub fn gap(&self) -> f64 {
        let gap = self.axis_extent[1] - self.axis_extent[0];
        if gap.is_finite() { gap } else { 0.0 }
    }
}

/// A void of a [`Map`].
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Void {
    /// Volume with its rim, m3.
    pub(crate) volume: f64,
    /// Volume of its cells alone, m3.
    core: f64,
    /// Cells with colour below 1/2.
    pub(crate) cells: usize,
}

/// Voids of a window cell by cell.
#[derive(Debug, Clone)]
pub(crate) struct Map {
    pub(crate) window: Window,
    pub(crate) size: [usize; 2],
    /// Void of each cell, numbered from 1; 0 for none.
    pub(crate) label: Vec<u32>,
    pub(crate) voids: Vec<Void>,
}

/// Colour of every cell of a window.
#[derive(Debug, Clone)]
pub struct Colour {
    window: Window,
    geometry: Geometry,
    size: [usize; 2],
    colour: Vec<f64>,
    reach: usize,
}

impl Colour {
    /// Colour of the liquid and its ghosts.
    #[must_use]
    pub fn new(fluid: &Fluid, ghosts: &Ghosts, window: Window) -> Self {
        let size = [0, 1].map(|k| {
            ((window.upper[k] - window.lower[k]) / window.cell)
                .round()
                .max(1.0) as usize
        });
        let mut colour = Self {
            window,
            geometry: fluid.geometry,
            size,
            colour: vec![0.0; size[0] * size[1]],
            reach: 0,
        };
        let position = ghosts.extend(&fluid.position, |p, x| p.mirror(x));
        let blots: Vec<Blot> = (position.par_iter().enumerate())
            .filter_map(|(i, x)| {
                let a = ghosts.particle(fluid.len(), i);
                let h = fluid.smoothing_length[a];
                Blot::new(&colour, *x, h, || fluid.filled_area(a))
            })
            .collect();
        colour.add(&blots);
        let voids = VoidCells::of(&colour);
        let beside_void = blots.iter().filter(|b| voids.meet(b));
        let widest = beside_void.map(|b| b.h).fold(0.0, f64::max);
        colour.reach = (kernel::SUPPORT * widest / window.cell).ceil() as usize;
        colour
    }

    /// Bands of rows side by side; each cell gets its blots in their order.
    fn add(&mut self, blots: &[Blot]) {
        let (row, eights) = (self.size[0], self.size[0].div_ceil(LANES));
        let mut cells = vec![[0.0; LANES]; eights * self.size[1]];
        let mut bands = vec![Vec::new(); self.size[1].div_ceil(BAND)];
        for (k, blot) in blots.iter().enumerate() {
            for band in blot.bands() {
                bands[band].push(k);
            }
        }
        (cells.par_chunks_mut(eights * BAND).zip(&bands).enumerate()).for_each(
            |(band, (cells, own))| {
                simd::run(Band {
                    colour: self,
                    blots,
                    own,
                    first: band * BAND,
                    cells,
                    eights,
                });
            },
        );
        for (own, eights) in self.colour.chunks_mut(row).zip(cells.chunks(eights)) {
            own.copy_from_slice(&eights.as_flattened()[..row]);
        }
    }

    fn centre(&self, i: usize, j: usize) -> Vec2 {
        let w = self.window;
        [
            w.lower[0] + (i as f64 + 0.5) * w.cell,
            w.lower[1] + (j as f64 + 0.5) * w.cell,
        ]
    }

    /// Void volume of cell k, m3.
    fn void(&self, k: usize) -> f64 {
        let centre = self.centre(k % self.size[0], k / self.size[0]);
        (1.0 - self.colour[k]) * self.window.cell.powi(2) * self.geometry.ring(centre[0])
    }

    /// Voids, largest first. Voids of less than `smallest` cells (noise between particles) are not counted.
    #[must_use]
    pub fn cavities(&self, smallest: usize) -> Vec<Cavity> {
        let label = self.label();
        let count = label.iter().copied().max().unwrap_or(0);
        let mut cells = vec![0usize; count as usize + 1];
        for l in &label {
            cells[*l as usize] += 1;
        }
        let rim = self.rim(&label);
        let mut found: Vec<Cavity> = (1..=count)
            .filter(|l| cells[*l as usize] >= smallest)
            .map(|l| self.measure(&label, &rim, l))
            .collect();
        found.sort_by(|a, b| b.volume.total_cmp(&a.volume));
        found
    }

    /// Connected cells with colour below 1/2, numbered from 1; 0 elsewhere.
    fn label(&self) -> Vec<u32> {
        let mut label = vec![0; self.colour.len()];
        let mut count = 0;
        let mut stack = Vec::new();
        for start in 0..self.colour.len() {
            if self.colour[start] >= 0.5 || label[start] != 0 {
                continue;
            }
            count += 1;
            label[start] = count;
            stack.push(start);
            while let Some(k) = stack.pop() {
                for next in self.beside(k) {
                    if self.colour[next] < 0.5 && label[next] == 0 {
                        label[next] = count;
                        stack.push(next);
                    }
                }
            }
        }
        label
    }

    fn beside(&self, k: usize) -> impl Iterator<Item = usize> {
        let (nx, ny) = (self.size[0], self.size[1]);
        let (i, j) = (k % nx, k / nx);
        [
            (i > 0).then(|| k - 1),
            (i + 1 < nx).then(|| k + 1),
            (j > 0).then(|| k - nx),
            (j + 1 < ny).then(|| k + nx),
        ]
        .into_iter()
        .flatten()
    }

    /// For every cell the void it belongs to or whose rim it is: labels spread over the support of the kernel.
    fn rim(&self, label: &[u32]) -> Vec<u32> {
        let mut rim = label.to_vec();
        let mut front: Vec<usize> = (0..rim.len()).filter(|k| rim[*k] != 0).collect();
        for _ in 0..self.reach {
            let mut next = Vec::new();
            for k in front {
                for b in self.beside(k) {
                    if rim[b] == 0 {
                        rim[b] = rim[k];
                        next.push(b);
                    }
                }
            }
            front = next;
        }
        rim
    }

    /// The voids cell by cell.
    pub(crate) fn map(&self) -> Map {
        let label = self.label();
        let rim = self.rim(&label);
        let count = label.iter().copied().max().unwrap_or(0) as usize;
        let mut voids = vec![Void::default(); count];
        for (k, (&inside, &around)) in label.iter().zip(&rim).enumerate() {
            if around != 0 {
                voids[around as usize - 1].volume += self.void(k);
            }
            if inside != 0 {
                let void = &mut voids[inside as usize - 1];
                void.cells += 1;
                void.core += self.void(k);
            }
        }
        for void in &mut voids {
            void.volume = void.volume.max(void.core);
        }
        Map {
            window: self.window,
            size: self.size,
            label,
            voids,
        }
    }

    fn measure(&self, label: &[u32], rim: &[u32], which: u32) -> Cavity {
        let (mut volume, mut moment) = (0.0, [0.0; 2]);
        let nothing = [f64::INFINITY, f64::NEG_INFINITY];
        let (mut inner, mut extent, mut axis_extent) = (f64::INFINITY, nothing, nothing);
        // The cells of a void belong to its rim.
        for k in (0..rim.len()).filter(|k| rim[*k] == which) {
            let x = self.centre(k % self.size[0], k / self.size[0]);
            let v = self.void(k);
            volume += v;
            moment = [moment[0] + v * x[0], moment[1] + v * x[1]];
            if label[k] == which {
                inner = inner.min(x[0]);
                extent = [extent[0].min(x[1]), extent[1].max(x[1])];
                if k % self.size[0] == 0 {
                    axis_extent = [axis_extent[0].min(x[1]), axis_extent[1].max(x[1])];
                }
            }
        }
        // In plane, x = 0 is the plane of symmetry of a bubble that lies on it.
        let on_axis = inner < self.window.cell && self.window.lower[0] == 0.0;
        let centre = [
            if on_axis { 0.0 } else { moment[0] / volume },
            moment[1] / volume,
        ];
        let axis_extent = if on_axis { axis_extent } else { [f64::NAN; 2] };
        let inner_radius = if on_axis { 0.0 } else { inner };
        Cavity {
            volume,
            centre,
            inner_radius,
            extent,
            axis_extent,
        }
    }

    /// Radius of the void about `centre` along `rays` directions at equal polar angles from the upper pole (m): the radius r
    /// with r^3/3 = integral of (1 - c) s^2 ds along the ray, out to one kernel support behind the surface.
    #[must_use]
    pub fn radii(&self, centre: Vec2, rays: usize) -> Vec<f64> {
        (0..rays)
            .map(|k| {
                let angle = std::f64::consts::PI * (k as f64 + 0.5) / rays as f64;
                self.radius_along(centre, [angle.sin(), angle.cos()])
            })
            .collect()
    }

    fn radius_along(&self, centre: Vec2, direction: Vec2) -> f64 {
        let step = 0.25 * self.window.cell;
        let (mut sum, mut behind) = (0.0, 0.0);
        let mut k = 0.5;
        while behind < self.reach as f64 * self.window.cell {
            let s = k * step;
            let Some(c) = self.at([centre[0] + s * direction[0], centre[1] + s * direction[1]])
            else {
                break;
            };
            sum += (1.0 - c) * s * s * step;
            if c >= 0.5 {
                behind += step;
            }
            k += 1.0;
        }
        (3.0 * sum.max(0.0)).cbrt()
    }

    /// Colour at a point, bilinear between cells; none outside the window.
    fn at(&self, x: Vec2) -> Option<f64> {
        let w = self.window;
        let u = [0, 1].map(|k| (x[k] - w.lower[k]) / w.cell - 0.5);
        if u[1] < 0.0 || u[0] >= (self.size[0] - 1) as f64 || u[1] >= (self.size[1] - 1) as f64 {
            return None;
        }
        let u = [u[0].max(0.0), u[1]];
        let (i, j) = (u[0] as usize, u[1] as usize);
        let (f, g) = (u[0] - i as f64, u[1] - j as f64);
        let c = |i: usize, j: usize| self.colour[i + self.size[0] * j];
        Some(
            (1.0 - g) * ((1.0 - f) * c(i, j) + f * c(i + 1, j))
                + g * ((1.0 - f) * c(i, j + 1) + f * c(i + 1, j + 1)),
        )
    }
}
