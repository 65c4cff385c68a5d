//! Compressible liquid: what it is. What its particles do to each other is in [`corrected`] and [`joshi`].
//!
//! A particle is a ring (axisymmetry) or a unit-thickness prism (plane) of liquid with a mass and a volume of its
//! own. Its meridional area A = V/(2 pi r) is the weight of kernel sums; h = 1.3 sqrt(A). In three dimensions the weight is the
//! volume itself, h = 1.3 cbrt(V).

pub mod axis_function;
mod carry;
pub mod corrected;
mod extended;
pub mod far_field;
pub mod gas;
pub mod ghosts;
pub mod joshi;
mod kinematics;
mod moments;
mod momentum;
mod pair;
mod places;
pub mod refinement;
mod shifting;
pub(crate) mod step;

use crate::geometry::{Geometry, dot, length};
use crate::phases::{Phase, Phases};
use corrected::Account;
use erode_physics::eos::Tait;
use far_field::FarField;
use ghosts::{Plane, Wall};
pub use places::Clustering;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// h = SMOOTHING times the spacing: the best of 1.15, 1.3 and 1.5 for bubble collapse.
pub const SMOOTHING: f64 = 1.3;

/// Smallest and largest smoothing length in units of its initial value.
pub const SMOOTHING_RANGE: (f64, f64) = (0.25, 4.0);

/// Liquid body in two or three dimensions: named arrays, one entry per particle.
#[derive(Debug, Clone)]
pub struct Fluid<const D: usize = 2> {
    /// Plane or axisymmetric.
    pub geometry: Geometry,
    /// Equation of state.
    pub eos: Tait,
    /// Centre (r, z), (x, y) or (x, y, z), m.
    pub position: Vec<[f64; D]>,
    /// Velocity, m/s.
    pub velocity: Vec<[f64; D]>,
    /// Rate of velocity, m/s2.
    pub acceleration: Vec<[f64; D]>,
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
    /// Smallest eigenvalue of the moment matrix: 1 inside, about 0.5 at a free surface.
    pub support: Vec<f64>,
    /// Norm of the velocity gradient, 1/s.
    pub strain_rate: Vec<f64>,
    /// Rigid sides without friction: mirrors.
    pub sides: Vec<Plane<D>>,
    /// Particles whose outer side is a far field.
    pub far_field: Vec<FarField<D>>,
    /// Distance from the far side at the start, m; meaningful where there is one.
    pub(crate) side_depth: Vec<f64>,
    /// What the particles do to each other.
    pub formulation: Formulation,
    /// How well particles that follow each other lie together.
    pub clustering: Clustering,
    /// Where each particle comes from.
    pub origin: Vec<refinement::Origin>,
    /// Number that the next particle gets.
    pub next_id: u32,
    /// Gas in its cavities, if there is any.
    pub gas: Option<gas::Gas>,
    /// Pressure of the gas on each particle, Pa; empty without gas.
    pub(crate) gas_pressure: Vec<f64>,
    /// Energy that came and went, and what was counted, since the start.
    pub account: Account,
    /// Memory for the next step.
    sweep: step::Sweep<D>,
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
pub struct Start<'a, const D: usize = 2> {
    /// Plane or axisymmetric.
    pub geometry: Geometry,
    /// Equation of state.
    pub eos: Tait,
    /// Particle centres, m.
    pub position: &'a [[f64; D]],
    /// Meridional areas, m2; volumes in three dimensions, m3.
    pub area: &'a [f64],
    /// Initial pressure, Pa.
    pub pressure: f64,
    /// Initial velocity, m/s.
    pub velocity: [f64; D],
    /// Discrete form.
    pub formulation: Formulation,
}

impl<const D: usize> Fluid<D> {
    /// Liquid in uniform pressure and motion.
    ///
    /// # Panics
    /// If it is axisymmetric in other than two dimensions.
    #[must_use]
    pub fn new(start: &Start<D>) -> Self {
        assert!(
            D == 2 || start.geometry == Geometry::Plane,
            "a liquid in three dimensions has no rings"
        );
        let n = start.position.len();
        let density = start.eos.density(start.pressure);
        let volume: Vec<f64> = (0..n)
            .map(|a| start.geometry.ring(start.position[a][0]) * start.area[a])
            .collect();
        let h: Vec<f64> = (start.area.iter())
            .map(|a| SMOOTHING * spacing::<D>(*a))
            .collect();
        Self {
            geometry: start.geometry,
            eos: start.eos,
            position: start.position.to_vec(),
            velocity: vec![start.velocity; n],
            acceleration: vec![[0.0; D]; n],
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
            clustering: Clustering::default(),
            origin: (0..n as u32)
                .map(|id| refinement::Origin { id, level: 0 })
                .collect(),
            next_id: n as u32,
            gas: None,
            gas_pressure: Vec::new(),
            account: Account::default(),
            sweep: step::Sweep::default(),
        }
    }

    /// Number of particles.
    #[must_use]
    pub fn len(&self) -> usize {
        self.position.len()
    }

    /// One step of `dt` of a liquid on its own between its sides, from `time` on; s. For a liquid without gas: gas follows its
    /// cavities in [`crate::world::World::advance`] alone.
    pub fn step(&mut self, dt: f64, time: f64, clock: &mut Phases) {
        debug_assert!(
            self.gas.is_none(),
            "gas follows its cavities in a world alone"
        );
        let sides = self.sides.clone();
        let walls: Vec<&dyn Wall<D>> = sides.iter().map(|p| p as &dyn Wall<D>).collect();
        clock.start();
        let sweep = self.advance_positions(&walls, dt, clock);
        let ghosts = sweep.ghosts.refresh(self, &walls);
        clock.lap(Phase::Boundaries);
        self.push(sweep, &ghosts, dt, time + dt, clock);
    }

    /// Whether there are no particles.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.position.is_empty()
    }

    /// Density of particle `a`, kg/m3.
    #[inline]
    #[must_use]
    pub fn density(&self, a: usize) -> f64 {
        self.mass[a] / self.volume[a]
    }

    /// Meridional area of particle `a`, m2; its volume in three dimensions, m3.
    #[inline]
    #[must_use]
    pub fn area(&self, a: usize) -> f64 {
        self.volume[a] / self.geometry.ring(self.position[a][0])
    }

    /// Sound speed of particle `a`, m/s.
    #[inline]
    #[must_use]
    pub fn sound_speed(&self, a: usize) -> f64 {
        let (density, pressure) = (self.density(a), self.pressure[a]);
        if pressure > 0.0 {
            self.eos.sound_speed_of(density, pressure)
        } else {
            self.eos.sound_speed_at(density)
        }
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
        let eos = self.eos;
        let cavitating = (self.pressure.par_iter_mut())
            .zip(self.mass.par_iter().zip(&self.volume))
            .with_min_len(PARTICLES_PER_TASK)
            .map(|(p, (mass, volume))| {
                let pressure = eos.pressure(mass / volume);
                *p = pressure.max(0.0);
                u64::from(pressure < 0.0)
            });
        self.account.cavitating += cavitating.sum::<u64>();
    }

    /// Smoothing length from area.
    pub(crate) fn update_smoothing_length(&mut self) {
        let mut new = std::mem::take(&mut self.smoothing_length);
        (new.par_iter_mut()
            .zip(&self.initial_smoothing_length)
            .enumerate())
        .with_min_len(PARTICLES_PER_TASK)
        .for_each(|(a, (new, h0))| {
            let h = SMOOTHING * spacing::<D>(self.area(a));
            *new = h.clamp(SMOOTHING_RANGE.0 * h0, SMOOTHING_RANGE.1 * h0);
        });
        self.smoothing_length = new;
    }

    /// Largest stable time step (s) and the particle that sets it: safety * h/(c + |v|).
    #[must_use]
    pub fn stable_time_step(&self, safety: f64) -> (f64, usize) {
        let of = |a: usize| {
            let c = self.sound_speed(a);
            let speed = length(self.velocity[a]);
            (safety * self.smoothing_length[a] / (c + speed), a)
        };
        // The first of the smallest, whatever is compared first; steps that are not numbers are found elsewhere.
        let smaller = |p: (f64, usize), q: (f64, usize)| {
            if q.0 < p.0 || (q.0 == p.0 && q.1 < p.1) || p.0.is_nan() {
                q
            } else {
                p
            }
        };
        (0..self.len())
            .into_par_iter()
            .with_min_len(PARTICLES_PER_TASK)
            .map(of)
            .reduce(|| (f64::INFINITY, 0), smaller)
    }

    /// Kinetic energy, J.
    #[must_use]
    pub fn kinetic_energy(&self) -> f64 {
        ordered_sum(self.len(), |a| {
            kinetic_energy(self.mass[a], self.velocity[a])
        })
    }

    /// Energy of compression from zero pressure, J.
    #[must_use]
    pub fn compression_energy(&self) -> f64 {
        ordered_sum(self.len(), |a| {
            compression_energy(&self.eos, self.mass[a], self.volume[a])
        })
    }
}

/// Side of the square of this area, of the cube of this volume, m.
pub(crate) fn spacing<const D: usize>(area: f64) -> f64 {
    if D == 2 { area.sqrt() } else { area.cbrt() }
}

fn kinetic_energy<const D: usize>(mass: f64, velocity: [f64; D]) -> f64 {
    0.5 * mass * dot(velocity, velocity)
}

/// From zero pressure; none below.
fn compression_energy(eos: &Tait, mass: f64, volume: f64) -> f64 {
    mass * eos.specific_energy((mass / volume).max(eos.reference_density))
}

/// Fewest particles that are worth a task of their own.
pub(crate) const PARTICLES_PER_TASK: usize = 512;

/// Sum over particles 0 to `n`: blocks of fixed size, added in their order, so that it is the same bits for any number of
/// threads.
pub(crate) fn ordered_sum(n: usize, of: impl Fn(usize) -> f64 + Sync + Send) -> f64 {
    let [sum] = ordered_sums((0..n).into_par_iter().map(|a| [of(a)]));
    sum
}

/// Several such sums in one pass, of the numbers that it makes.
pub(crate) fn ordered_sums<const N: usize>(
    numbers: impl IndexedParallelIterator<Item = [f64; N]>,
) -> [f64; N] {
    sum_of_blocks(numbers.fold_chunks(PARTICLES_PER_TASK, || [0.0; N], add))
}

/// The sums of blocks of [`PARTICLES_PER_TASK`] particles, added in their order.
pub(crate) fn sum_of_blocks<const N: usize>(
    blocks: impl IndexedParallelIterator<Item = [f64; N]>,
) -> [f64; N] {
    let blocks: Vec<[f64; N]> = blocks.collect();
    blocks.into_iter().fold([0.0; N], add)
}

fn add<const N: usize>(sum: [f64; N], x: [f64; N]) -> [f64; N] {
    std::array::from_fn(|i| sum[i] + x[i])
}
