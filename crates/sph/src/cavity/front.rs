//! Surface of a void as points, with the size of the void.

use super::Colour;
use crate::geometry::{Geometry, Vec2};
use std::f64::consts::PI;

/// A void seen from the liquid.
#[derive(Debug, Clone, PartialEq)]
pub struct Front {
    /// Radius of the ball (of the disc in plane) with the volume of the void, m.
    pub radius: f64,
    /// Cells of the void that lie at its surface, m.
    pub rim: Vec<Vec2>,
}

impl Front {
    /// Distance of a point from the surface, m: zero in it, to about a cell.
    #[must_use]
    pub fn distance(&self, x: Vec2) -> f64 {
        let square = |p: &Vec2| (p[0] - x[0]).powi(2) + (p[1] - x[1]).powi(2);
        let least = self.rim.iter().map(square).fold(f64::INFINITY, f64::min);
        least.sqrt()
    }
}

impl Colour {
    /// The voids of at least `smallest` cells with a positive volume, in the order of their first cells.
    #[must_use]
    pub fn fronts(&self, smallest: usize) -> Vec<Front> {
        let label = self.label();
        let rim = self.rim(&label);
        let count = label.iter().copied().max().unwrap_or(0) as usize;
        let (mut cells, mut volume) = (vec![0; count + 1], vec![0.0; count + 1]);
        let mut points = vec![Vec::new(); count + 1];
        for k in 0..label.len() {
            volume[rim[k] as usize] += self.void(k);
            let own = label[k] as usize;
            cells[own] += 1;
            if own > 0 && self.beside(k).any(|b| label[b] != label[k]) {
                points[own].push(self.centre(k % self.size[0], k / self.size[0]));
            }
        }
        let radius = |volume: f64| match self.geometry {
            Geometry::Axisymmetric => (0.75 * volume / PI).cbrt(),
            // Half a disc lies at x > 0.
            Geometry::Plane => (2.0 * volume / PI).sqrt(),
        };
        (1..=count)
            .filter(|&l| cells[l] >= smallest && volume[l] > 0.0)
            .map(|l| Front {
                radius: radius(volume[l]),
                rim: std::mem::take(&mut points[l]),
            })
            .collect()
    }
}
