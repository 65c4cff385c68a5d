//! The pressure of the gas on one particle.

use crate::cavity::Map;
use crate::fluid::Fluid;
use crate::geometry::Vec2;
use crate::kernel;

/// Cells of a map within the support of a particle.
pub(super) struct Reach {
    x: Vec2,
    h: f64,
    from: [usize; 2],
    to: [usize; 2],
}

impl Reach {
    pub(super) fn new(map: &Map, fluid: &Fluid, a: usize) -> Self {
        let (x, h) = (fluid.position[a], fluid.smoothing_length[a]);
        let (w, radius) = (map.window, kernel::SUPPORT * h);
        let cell = |v: f64, k: usize| {
            let cell = (v - w.lower[k]) / w.cell;
            cell.clamp(0.0, map.size[k] as f64) as usize
        };
        Self {
            x,
            h,
            from: [0, 1].map(|k| cell(x[k] - radius, k)),
            to: [0, 1].map(|k| cell(x[k] + radius + w.cell, k)),
        }
    }

    /// Kernel mean of the pressures of the pockets within reach; 0 without any.
    pub(super) fn pressure(&self, map: &Map, pocket_of: &[usize], pressures: &[f64]) -> f64 {
        let (mut sum, mut weight) = (0.0, 0.0);
        for j in self.from[1]..self.to[1] {
            for i in self.from[0]..self.to[0] {
                let pocket = pocket_of[map.label[i + map.size[0] * j] as usize];
                if pocket != 0 {
                    let place = |k: usize, c: usize| {
                        map.window.lower[k] + (c as f64 + 0.5) * map.window.cell
                    };
                    let d = (place(0, i) - self.x[0]).hypot(place(1, j) - self.x[1]);
                    let w = kernel::value(d, self.h);
                    sum += w * pressures[pocket - 1];
                    weight += w;
                }
            }
        }
        if weight > 0.0 { sum / weight } else { 0.0 }
    }
}
