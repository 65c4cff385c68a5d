//! Density, velocity gradient and smoothed velocity of the present configuration.

use super::super::mat2::{Mat2, determinant, inverse, product};
use super::super::stress::TASK;
use super::{Present, Solid};
use crate::geometry::Vec2;
use crate::kernel;
use rayon::prelude::*;

impl Present {
    /// Sum of A_b (v_b - v_a) (x) grad W over particles and mirror images, 1/s; with the inverse moment matrix where the
    /// kernel reaches over an open face. `area` belongs to particles and mirror images.
    pub(super) fn velocity_gradient(&self, a: usize, area: &[f64], particles: usize) -> Mat2 {
        let moving = self.moving(particles);
        let va = self.velocity[a];
        let (mut l, mut moment, mut open) = ([[0.0; 2]; 2], [[0.0; 2]; 2], false);
        for &b in self.list.of(a) {
            let b = b as usize;
            let Some((d, distance, h)) = self.pair(a, b) else {
                continue;
            };
            if b >= moving {
                open = true;
                continue;
            }
            let factor = area[b] * kernel::gradient_factor(distance, h);
            for i in 0..2 {
                let dv = self.velocity[b][i] - va[i];
                for j in 0..2 {
                    l[i][j] += dv * factor * d[j];
                    moment[i][j] -= d[i] * factor * d[j];
                }
            }
        }
        if open {
            product(&l, &inverse(&moment))
        } else {
            l
        }
    }
}

impl Solid {
    /// Areas of particles and mirror images by the deformation gradient, m2.
    pub(super) fn stretched_area(&self) -> Vec<f64> {
        let mut area: Vec<f64> = (self.reference.area.iter().zip(&self.state.deformation))
            .map(|(area, f)| area * determinant(f))
            .collect();
        for placed in &self.present.images[..self.present.mirrors] {
            area.push(area[placed.image.source as usize]);
        }
        area
    }

    /// Density, eta and area of particles and images by summation.
    pub(super) fn sum_density(&mut self) {
        let settings = self.published();
        let (present, geometry, n) = (&self.present, self.geometry, self.len());
        let ring = |i: usize| geometry.ring(present.position[i][0].abs());
        let mut mass = self.reference.mass.clone();
        for (k, placed) in present.images.iter().enumerate() {
            let b = placed.image.source as usize;
            mass.push(self.reference.mass[b] * ring(n + k) / ring(b));
        }
        let mut density: Vec<f64> = (0..n)
            .into_par_iter()
            .with_min_len(TASK)
            .map(|a| {
                let h = present.smoothing_length[a];
                let mut sum = mass[a] * kernel::value(0.0, h);
                for &b in present.list.of(a) {
                    if let Some((_, distance, h)) = present.pair(a, b as usize) {
                        sum += mass[b as usize] * kernel::value(distance, h);
                    }
                }
                settings
                    .axis_correction(geometry, present.position[a][0], h)
                    .0
                    * sum
                    / ring(a)
            })
            .collect();
        for placed in &present.images {
            density.push(density[placed.image.source as usize]);
        }
        let eta: Vec<f64> = (0..density.len()).map(|i| ring(i) * density[i]).collect();
        let area = mass.iter().zip(&eta).map(|(m, eta)| m / eta).collect();
        let present = &mut self.present;
        (present.density, present.eta, present.area) = (density, eta, area);
    }

    /// Velocity gradients at the present positions and velocities.
    pub(in crate::solid) fn velocity_gradients(&mut self) {
        self.arrange();
        self.sum_density();
        let (present, n) = (&self.present, self.len());
        self.present.gradient = (0..n)
            .into_par_iter()
            .with_min_len(TASK)
            .map(|a| present.velocity_gradient(a, &present.area, n))
            .collect();
    }

    /// XSPH: adds `share` of the neighbours' relative velocity x `dt` to the positions.
    pub(in crate::solid) fn follow_neighbours(&mut self, share: f64, dt: f64) {
        self.arrange();
        self.sum_density();
        let (present, n) = (&self.present, self.len());
        let moving = present.moving(n);
        let extra: Vec<Vec2> = (0..n)
            .into_par_iter()
            .with_min_len(TASK)
            .map(|a| {
                let mut u = [0.0; 2];
                for &b in present.list.of(a) {
                    let b = b as usize;
                    let Some((_, distance, h)) = present.pair(a, b).filter(|_| b < moving) else {
                        continue;
                    };
                    let mass = present.area[b] * present.eta[b];
                    let mean = 0.5 * (present.eta[a] + present.eta[b]);
                    let k = share * mass / mean * kernel::value(distance, h);
                    let dv = [0, 1].map(|i| present.velocity[b][i] - present.velocity[a][i]);
                    u = [u[0] + k * dv[0], u[1] + k * dv[1]];
                }
                u
            })
            .collect();
        for (x, u) in self.state.position.iter_mut().zip(extra) {
            *x = [x[0] + dt * u[0], x[1] + dt * u[1]];
        }
    }
}
