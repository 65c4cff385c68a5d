//! Accelerations of the published form.

use super::super::force::Powers;
use super::super::stress::TASK;
use super::{Present, Settings, Solid};
use crate::fluid::ordered_sum;
use crate::geometry::{Geometry, Vec2};
use crate::kernel;
use erode_physics::Sym3;
use rayon::prelude::*;

/// What the sums over neighbours need besides positions.
struct Forces<'a> {
    present: &'a Present,
    geometry: Geometry,
    /// Stress over density of particles and images, m2/s2.
    specific: Vec<Sym3>,
    settings: Settings,
    wave_speed: f64,
    moving: usize,
}

impl Forces<'_> {
    /// Acceleration and its viscous part, m/s2.
    fn on(&self, a: usize) -> (Vec2, Vec2) {
        let p = self.present;
        let own = self.specific[a];
        let (r, eta) = (p.position[a][0], p.eta[a]);
        let (f1, slope) = (self.settings).axis_correction(self.geometry, r, p.smoothing_length[a]);
        let (mut total, mut viscous) = ([0.0; 2], [0.0; 2]);
        for &b in p.list.of(a) {
            let b = b as usize;
            let Some((d, distance, h)) = p.pair(a, b) else {
                continue;
            };
            let factor = p.area[b] * kernel::gradient_factor(distance, h);
            let g = [factor * d[0], factor * d[1]];
            let s = self.specific[b] + own * (f1 * p.eta[b] / eta);
            total[0] += s.xx * g[0] + s.xy * g[1];
            total[1] += s.xy * g[0] + s.yy * g[1];
            if b < self.moving {
                let friction = 2.0 * p.eta[b] / (eta + p.eta[b]) * self.viscosity(a, b, d, h);
                viscous = [viscous[0] - friction * g[0], viscous[1] - friction * g[1]];
            }
        }
        if self.geometry == Geometry::Axisymmetric {
            total[0] += own.xx * slope / f1 - own.zz / r;
            total[1] += own.xy * slope / f1;
        }
        ([0, 1].map(|i| total[i] + viscous[i]), viscous)
    }

    /// -alpha c mu + beta mu^2 of a pair that approaches, m2/s2.
    fn viscosity(&self, a: usize, b: usize, d: Vec2, h: f64) -> f64 {
        let (va, vb) = (self.present.velocity[a], self.present.velocity[b]);
        let approach = (va[0] - vb[0]) * d[0] + (va[1] - vb[1]) * d[1];
        if approach >= 0.0 {
            return 0.0;
        }
        let mu = h * approach / (d[0] * d[0] + d[1] * d[1] + 0.01 * h * h);
        mu * (self.settings.beta * mu - self.settings.alpha * self.wave_speed)
    }
}

impl Solid {
    /// Accelerations at the present positions, stresses, velocities and pressures.
    pub(in crate::solid) fn present_accelerations(&mut self, settings: &Settings) {
        self.arrange();
        self.press_points();
        self.press_bared();
        self.sum_density();
        self.present_tractions();
        let stress = self.present_stress();
        let forces = Forces {
            specific: (stress.iter().zip(&self.present.density))
                .map(|(s, rho)| *s * (1.0 / rho))
                .collect(),
            present: &self.present,
            geometry: self.geometry,
            settings: *settings,
            wave_speed: (self.material.elastic).longitudinal_speed(self.material.density),
            moving: self.present.moving(self.len()),
        };
        let both: Vec<(Vec2, Vec2)> = (0..self.len())
            .into_par_iter()
            .with_min_len(TASK)
            .map(|a| forces.on(a))
            .collect();
        for (a, (total, _)) in both.iter().enumerate() {
            let here = self.state.removed[a] == 0.0;
            self.state.acceleration[a] = if here { *total } else { [0.0; 2] };
        }
        for (a, force) in &self.scratch.bared {
            let a = *a as usize;
            for (acceleration, f) in self.state.acceleration[a].iter_mut().zip(force) {
                *acceleration += f / self.reference.mass[a];
            }
        }
        let mass = &self.reference.mass;
        let power = |of: &[Vec2]| {
            ordered_sum(both.len(), |a| {
                let viscous = both[a].1;
                mass[a] * (viscous[0] * of[a][0] + viscous[1] * of[a][1])
            })
        };
        self.scratch.powers = Powers {
            viscous: [power(&self.state.velocity), power(&self.state.acceleration)],
            ..Powers::default()
        };
    }
}
