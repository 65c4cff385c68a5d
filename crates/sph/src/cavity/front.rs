//! Surface of a void as points, with the size of the void.

use super::{Colour, Window};
use crate::fluid::Fluid;
use crate::fluid::ghosts::{Ghosts, Wall};
use crate::geometry::{Geometry, Vec2};
use std::f64::consts::PI;

/// Voids of fewer cells are gaps between particles.
const FEWEST_CELLS: usize = 8;

/// Cells per radius that a void is measured with at least.
const CELLS_PER_RADIUS: f64 = 20.0;

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

    /// Box around the surface, m.
    #[must_use]
    pub fn extent(&self) -> [Vec2; 2] {
        let all = |k: usize| self.rim.iter().map(move |x| x[k]);
        let lower = [0, 1].map(|k| all(k).fold(f64::INFINITY, f64::min));
        let upper = [0, 1].map(|k| all(k).fold(f64::NEG_INFINITY, f64::max));
        [lower, upper]
    }
}

/// The voids of a liquid between `walls` in a part of the plane. When the largest is small for the cells of the window,
/// they are looked at again with finer ones, unless its radius is less than `smallest` (m).
#[must_use]
pub fn fronts(fluid: &Fluid, walls: &[&dyn Wall], window: Window, smallest: f64) -> Vec<Front> {
    let ghosts = Ghosts::find(fluid, walls);
    let found = Colour::new(fluid, &ghosts, window).fronts(FEWEST_CELLS);
    let Some(largest) = found.iter().max_by(|p, q| p.radius.total_cmp(&q.radius)) else {
        return found;
    };
    let cell = largest.radius / CELLS_PER_RADIUS;
    if cell >= window.cell || largest.radius < smallest {
        return found;
    }
    let margin = 4.0 * window.cell + largest.radius;
    let all = |k: usize, side: usize| found.iter().map(move |f| f.extent()[side][k]);
    let lower = |k| all(k, 0).fold(f64::INFINITY, f64::min) - margin;
    let upper = |k| all(k, 1).fold(f64::NEG_INFINITY, f64::max) + margin;
    let zoomed = Window {
        lower: [0, 1].map(|k| lower(k).max(window.lower[k])),
        upper: [0, 1].map(|k| upper(k).min(window.upper[k])),
        cell,
    };
    Colour::new(fluid, &ghosts, zoomed).fronts(FEWEST_CELLS)
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fluid::corrected::Settings;
    use crate::fluid::{Formulation, Start};
    use erode_physics::eos::Tait;

    /// Liquid on a square lattice of spacing `dx` around a ball of radius 1 at the origin.
    fn around_a_ball(dx: f64) -> Fluid {
        let n = (3.0 / dx) as i32;
        let at = |i: i32| (f64::from(i) + 0.5) * dx;
        let position: Vec<Vec2> = (0..n)
            .flat_map(|i| (-n..n).map(move |j| [at(i), at(j)]))
            .filter(|x| x[0].hypot(x[1]) > 1.0)
            .collect();
        Fluid::new(&Start {
            geometry: Geometry::Axisymmetric,
            eos: Tait {
                reference_density: 1000.0,
                sound_speed: 1500.0,
                gamma: 7.0,
            },
            area: &vec![dx * dx; position.len()],
            position: &position,
            pressure: 0.0,
            velocity: [0.0; 2],
            formulation: Formulation::Corrected(Settings::default()),
        })
    }

    #[test]
    fn a_ball_has_its_radius_and_distances() {
        let fluid = around_a_ball(0.05);
        for cell in [0.025, 0.2] {
            let window = Window {
                lower: [0.0, -2.0],
                upper: [2.0, 2.0],
                cell,
            };
            let found = fronts(&fluid, &[], window, 0.0);
            assert_eq!(found.len(), 1);
            // A lattice cut by a circle has the volume of the ball to about 1 %.
            assert!((found[0].radius - 1.0).abs() < 0.01, "{}", found[0].radius);
            // The surface is smeared over the kernel and seen to a cell, which is at most 1/20 after the closer look.
            for x in [[1.5, 0.0], [0.0, 1.5], [1.2, 1.6]] {
                let exact = f64::hypot(x[0], x[1]) - 1.0;
                assert!((found[0].distance(x) - exact).abs() < 0.05, "{x:?}");
            }
        }
    }

    #[test]
    fn voids_that_are_too_small_are_not_looked_at_closer() {
        let fluid = around_a_ball(0.05);
        let window = Window {
            lower: [0.0, -2.0],
            upper: [2.0, 2.0],
            cell: 0.1,
        };
        let cells = |smallest| fronts(&fluid, &[], window, smallest)[0].rim.len();
        let coarse = Colour::new(&fluid, &Ghosts::find(&fluid, &[]), window).fronts(FEWEST_CELLS);
        assert_eq!(cells(1.1), coarse[0].rim.len());
        // Twice as fine, twice as many at the surface.
        assert!(cells(0.9) as f64 > 1.8 * cells(1.1) as f64);
    }

    #[test]
    fn liquid_without_voids_has_no_front() {
        let fluid = around_a_ball(0.05);
        let window = Window {
            lower: [1.2, -0.5],
            upper: [2.2, 0.5],
            cell: 0.025,
        };
        assert!(fronts(&fluid, &[], window, 0.0).is_empty());
    }
}
