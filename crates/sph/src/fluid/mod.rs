//! Compressible liquid: what it is. What its particles do to each other is in [`corrected`] and [`joshi`].
//!
//! A particle is a ring (axisymmetry) or a unit-thickness prism (plane) of liquid with a mass and a volume of its
//! own. Its meridional area A = V/(2 pi r) is the weight of kernel sums; h = 1.3 sqrt(A).

pub mod axis_function;
pub mod corrected;
mod extended;
pub mod far_field;
pub mod ghosts;
pub mod joshi;
mod kinematics;
mod moments;
mod momentum;
mod shifting;
pub(crate) mod step;

use crate::geometry::{Geometry, Vec2};
use corrected::Account;
use erode_physics::eos::Tait;
use far_field::FarField;
use ghosts::{Plane, Wall};
use serde::{Deserialize, Serialize};

/// h = SMOOTHING * sqrt(A): the best of 1.15, 1.3 and 1.5 for bubble collapse.
pub const SMOOTHING: f64 = 1.3;

/// Smallest and largest smoothing length in units of its initial value.
pub const SMOOTHING_RANGE: (f64, f64) = (0.25, 4.0);

/// Liquid body: named arrays, one entry per particle.
#[derive(Debug, Clone)]
pub struct Fluid {
    /// Plane or axisymmetric.
    pub geometry: Geometry,
    /// Equation of state.
    pub eos: Tait,
    /// Centre (r, z) or (x, y), m.
    pub position: Vec<Vec2>,
    /// Velocity, m/s.
    pub velocity: Vec<Vec2>,
    /// Rate of velocity, m/s2.
    pub acceleration: Vec<Vec2>,
    /// Mass of the ring, kg (per metre in plane).
    pub mass: Vec<f64>,
    /// Volume of the ring, m3 (per metre in plane).
    pub volume: Vec<f64>,
    /// Pressure, Pa; never below zero: the liquid cavitates instead of carrying tension.
    pub pressure: Vec<f64>,
    /// Smoothing length, m.
    pub smoothing_length: Vec<f64>,
    /// Smoothing length at the start, m.
    pub initial_smoothing_length: Vec<f64>,
    /// Smaller eigenvalue of the moment matrix: 1 inside, about 0.5 at a free surface.
    pub support: Vec<f64>,
    /// Norm of the velocity gradient, 1/s.
    pub strain_rate: Vec<f64>,
    /// Rigid sides without friction: mirrors.
    pub sides: Vec<Plane>,
    /// Particles whose outer side is a far field.
    pub far_field: Vec<FarField>,
    /// Distance from the far side at the start, m; meaningful where there is one.
    pub(crate) side_depth: Vec<f64>,
    /// What the particles do to each other.
    pub formulation: Formulation,
    /// Energy that came and went, and what was counted, since the start.
    pub account: Account,
}

/// Discrete form of the liquid.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Formulation {
    /// Corrected divergence, Riemann pair values, shifting that carries mass.
    Corrected(corrected::Settings),
    /// As published: summation density with f1, artificial viscosity.
    Joshi(joshi::Settings),
}

/// Particles of a liquid at the start.
#[derive(Debug, Clone)]
pub struct Start<'a> {
    /// Plane or axisymmetric.
    pub geometry: Geometry,
    /// Equation of state.
    pub eos: Tait,
    /// Particle centres, m.
    pub position: &'a [Vec2],
    /// Meridional areas, m2.
    pub area: &'a [f64],
    /// Initial pressure, Pa.
    pub pressure: f64,
    /// Initial velocity, m/s.
    pub velocity: Vec2,
    /// Discrete form.
    pub formulation: Formulation,
}

impl Fluid {
    /// Liquid in uniform pressure and motion.
    #[must_use]
    pub fn new(start: &Start) -> Self {
        let n = start.position.len();
        let density = start.eos.density(start.pressure);
        let volume: Vec<f64> = (0..n)
            .map(|a| start.geometry.ring(start.position[a][0]) * start.area[a])
            .collect();
        let h: Vec<f64> = start.area.iter().map(|a| SMOOTHING * a.sqrt()).collect();
        Self {
            geometry: start.geometry,
            eos: start.eos,
            position: start.position.to_vec(),
            velocity: vec![start.velocity; n],
            acceleration: vec![[0.0; 2]; n],
            mass: volume.iter().map(|v| density * v).collect(),
            volume,
            pressure: vec![start.pressure.max(0.0); n],
            smoothing_length: h.clone(),
            initial_smoothing_length: h,
            support: vec![1.0; n],
            strain_rate: vec![0.0; n],
            sides: Vec::new(),
            far_field: vec![FarField::NONE; n],
            side_depth: vec![f64::INFINITY; n],
            formulation: start.formulation,
            account: Account::default(),
        }
    }

    /// Number of particles.
    #[must_use]
    pub fn len(&self) -> usize {
        self.position.len()
    }

    /// Whether there are no particles.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.position.is_empty()
    }

    /// Density of particle `a`, kg/m3.
    #[must_use]
    pub fn density(&self, a: usize) -> f64 {
        self.mass[a] / self.volume[a]
    }

    /// Meridional area of particle `a`, m2.
    #[must_use]
    pub fn area(&self, a: usize) -> f64 {
        self.volume[a] / self.geometry.ring(self.position[a][0])
    }

    /// Area that particle `a` fills with liquid, m2: summation density is low at a free surface, and what is below the
    /// density at zero pressure is void.
    pub(crate) fn filled_area(&self, a: usize) -> f64 {
        match self.formulation {
            Formulation::Corrected(_) => self.area(a),
            Formulation::Joshi(_) => {
                self.area(a) * (self.density(a) / self.eos.reference_density).min(1.0)
            }
        }
    }

    /// Pressure from density, tension removed.
    pub(crate) fn update_pressure(&mut self) {
        for a in 0..self.len() {
            let pressure = self.eos.pressure(self.density(a));
            self.account.cavitating += u64::from(pressure < 0.0);
            self.pressure[a] = pressure.max(0.0);
        }
    }

    /// Smoothing length from area.
    pub(crate) fn update_smoothing_length(&mut self) {
        for a in 0..self.len() {
            let h0 = self.initial_smoothing_length[a];
            let h = SMOOTHING * self.area(a).sqrt();
            self.smoothing_length[a] = h.clamp(SMOOTHING_RANGE.0 * h0, SMOOTHING_RANGE.1 * h0);
        }
    }

    /// v += dt a.
    pub(crate) fn kick(&mut self, dt: f64) {
        for (v, a) in self.velocity.iter_mut().zip(&self.acceleration) {
            v[0] += dt * a[0];
            v[1] += dt * a[1];
        }
    }

    /// x += dt v; a particle that would cross the axis or a wall is mirrored back and counted.
    pub(crate) fn drift(&mut self, dt: f64, walls: &[&dyn Wall]) {
        for a in 0..self.len() {
            let (x, v) = (&mut self.position[a], &mut self.velocity[a]);
            *x = [x[0] + dt * v[0], x[1] + dt * v[1]];
            if self.geometry == Geometry::Axisymmetric && x[0] <= 0.0 {
                *x = [-x[0], x[1]];
                *v = [-v[0], v[1]];
                self.account.axis_crossings += 1;
            }
            for wall in walls {
                if let Some(plane) = wall.plane(*x, 0.0) {
                    *x = plane.mirror(*x);
                    *v = plane.mirror_velocity(*v);
                    self.account.wall_crossings += 1;
                }
            }
        }
    }

    /// Largest stable time step (s) and the particle that sets it: safety * h/(c + |v|).
    #[must_use]
    pub fn stable_time_step(&self, safety: f64) -> (f64, usize) {
        let mut best = (f64::INFINITY, 0);
        for a in 0..self.len() {
            let c = self.eos.sound_speed_at(self.density(a));
            let v = self.velocity[a];
            let dt = safety * self.smoothing_length[a] / (c + v[0].hypot(v[1]));
            if dt < best.0 {
                best = (dt, a);
            }
        }
        best
    }

    /// Kinetic energy, J.
    #[must_use]
    pub fn kinetic_energy(&self) -> f64 {
        (0..self.len())
            .map(|a| {
                0.5 * self.mass[a] * (self.velocity[a][0].powi(2) + self.velocity[a][1].powi(2))
            })
            .sum()
    }

    /// Energy of compression from zero pressure, J.
    #[must_use]
    pub fn compression_energy(&self) -> f64 {
        (0..self.len())
            .map(|a| {
                let rho = self.density(a).max(self.eos.reference_density);
                self.mass[a] * self.eos.specific_energy(rho)
            })
            .sum()
    }
}
