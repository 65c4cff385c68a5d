//! Particle shifting that carries mass: keeps particles evenly spaced while the flow strains them.
//!
//! Shifting velocity d = -k h^2 |grad v| sum A_b (1 + 0.2 (W/W(dx))^4) grad W, tied to the strain rate because the disorder
//! comes from strain. A particle that moves relative to the liquid exchanges volume with its neighbours,
//! q_ab = 2 pi r_ab A_a A_b (d_a + d_b) . grad W, antisymmetric; mass and momentum go with the volume, upwind. Uniform
//! density stays uniform and mass is conserved to rounding wherever both images of a pair exist.
//!
//! The areas A drift apart in strong strain, first at the axis, where a small change of r is a large change of A = V/(2 pi r);
//! unequal weights then spoil the sums. The same exchange therefore also levels the sizes of neighbours,
//! q_ab += 10 |grad v| 2 pi r_ab A_a A_b W 2 (S_b - S_a)/(S_a + S_b), S = A/A_0. (Without it the pressure along the axis of a jet is
//! noisy by 20 %, and particles near the axis swell to many times their size.) A_0 is the area at the start, shared out by a
//! halving: neighbours that are meant to differ in size (graded spacing, halves beside wholes) are not levelled. (Levelling the
//! areas themselves, halves at the surface of a cavity drew volume from the wholes behind them: of a collapsing bubble 0.9 % of
//! its volume filled with liquid from nowhere, and the wall was 6 % too fast meanwhile.)

use crate::fluid::corrected::Settings;
use crate::fluid::ghosts::Plane;
use crate::fluid::kinematics::Kinematics;
use crate::fluid::moments::Matrix;
use crate::fluid::pair::{Pair, dot, half_ring, plus};
use crate::fluid::places;
use crate::fluid::step::Sweep;
use crate::fluid::{Fluid, PARTICLES_PER_TASK, compression_energy, kinetic_energy, sum_of_blocks};
use crate::geometry::{self, Geometry, length};
use crate::neighbours::pair_sum::{PairSum, record};
use crate::simd::Simd;
use rayon::prelude::*;
use std::sync::atomic::{AtomicU64, Ordering};

/// Below this eigenvalue of the moment matrix a particle lies at a free surface and is not moved across it.
const SURFACE: f64 = 0.6;

/// A particle gives at most this share of its volume per step.
const LARGEST_SHARE: f64 = 0.1;

/// Rate of levelling of areas in units of |grad v|; 3 and 20 serve as well.
const LEVELLING: f64 = 10.0;

/// Shifting velocity of a particle with smoothing length `h` and the norm `strain` of its velocity gradient, m/s.
#[inline]
pub(crate) fn velocity<const D: usize>(
    h: f64,
    strain: f64,
    k: &Kinematics<D>,
    s: &Settings,
) -> [f64; D] {
    let mut d = k.crowding.map(|c| -s.shifting * h * h * strain * c);
    let size = length(k.crowding);
    if k.support < SURFACE && size > 0.0 {
        let n = k.crowding.map(|c| c / size);
        let along = geometry::dot(d, n);
        d = std::array::from_fn(|i| d[i] - along * n[i]);
    }
    let limit = s.shifting_limit * h * strain;
    let speed = length(d);
    if speed > limit {
        d.map(|c| c * limit / speed)
    } else {
        d
    }
}

/// Frobenius norm of a velocity gradient, 1/s.
#[inline]
pub(crate) fn norm<const D: usize>(g: &Matrix<D>) -> f64 {
    g.iter().flatten().map(|x| x * x).sum::<f64>().sqrt()
}

record! {
    /// What the exchange reads of a particle.
    struct Particle {
        position: [T; D],
        h: T,
        area: T,
        /// Area in units of that of the start (of the halves after a halving).
        size: T,
        /// Shifting velocity, m/s.
        shift: [T; D],
        /// Rate of levelling, 1/s.
        levelling: T,
        density: T,
        /// Half of the length of the ring, m.
        half_ring: T,
        /// m/s.
        velocity: [T; D],
        /// Part of what it would give that it may give.
        share: T,
    }
}

record! {
    /// What a particle gets in one step.
    struct Gain {
        volume: T,
        mass: T,
        momentum: [T; D],
        /// Volume that it would give if it may give all, m3 (negative).
        given: T,
    }
}

/// The law.
struct Exchange<const D: usize> {
    dt: f64,
}

/// Memory of the sums.
pub(crate) type Memory<const D: usize> = places::Sums<Particle<D>, Gain<D>>;

/// Moves volume, mass and momentum between neighbours for one step of shifting; the records of the particles are there.
pub(crate) fn exchange<const D: usize>(fluid: &mut Fluid<D>, sweep: &mut Sweep<D>, dt: f64) {
    let (ghosts, places, memory) = (&sweep.ghosts, &sweep.places, &mut sweep.memory.shifting);
    let law = Exchange::<D> { dt };
    let geometry = fluid.geometry;
    let image = |plane: &Plane<D>, p| image(geometry, plane, p);
    places.sum(&law, ghosts, image, memory);
    let most = |a: usize| LARGEST_SHARE * fluid.volume[a];
    let particles = (0..fluid.len())
        .into_par_iter()
        .with_min_len(PARTICLES_PER_TASK);
    let given = |a: usize| -memory.results[a].given;
    let limited = particles.clone().filter(|a| given(*a) > most(*a)).count();
    if limited > 0 {
        let given: Vec<f64> = particles.map(given).collect();
        let limit = |a: usize, p: &mut Particle<D>| {
            let limited = given[a] > most(a);
            if limited {
                p.share = most(a) / given[a];
            }
            limited
        };
        places.sum_again(&law, ghosts, limit, image, memory);
    }
    fluid.account.limited_exchanges += limited as u64;
    fluid.take(&memory.results);
}

impl<const D: usize> Fluid<D> {
    /// Volume, mass and velocity with what was gained, and the pressure that goes with them; energy lost in the mixing goes to
    /// the account.
    fn take(&mut self, gains: &[Gain<D>]) {
        let eos = self.eos;
        let cavitating = AtomicU64::new(0);
        let losses = (self.velocity.par_chunks_mut(PARTICLES_PER_TASK))
            .zip(self.mass.par_chunks_mut(PARTICLES_PER_TASK))
            .zip(self.volume.par_chunks_mut(PARTICLES_PER_TASK))
            .zip(self.pressure.par_chunks_mut(PARTICLES_PER_TASK))
            .zip(gains.par_chunks(PARTICLES_PER_TASK))
            .map(|((((velocity, mass), volume), pressure), gains)| {
                let (mut loss, mut below) = (0.0, 0);
                for (i, gain) in gains.iter().enumerate().take(mass.len()) {
                    let before = kinetic_energy(mass[i], velocity[i])
                        + compression_energy(&eos, mass[i], volume[i]);
                    let m = mass[i] + gain.mass;
                    for (v, momentum) in velocity[i].iter_mut().zip(gain.momentum) {
                        *v = (mass[i] * *v + momentum) / m;
                    }
                    mass[i] = m;
                    volume[i] += gain.volume;
                    // Below the density at rest there is neither pressure nor energy.
                    let density = m / volume[i];
                    let stress = eos.pressure(density);
                    pressure[i] = stress.max(0.0);
                    below += u64::from(stress < 0.0);
                    let stored =
                        eos.specific_energy_of(density.max(eos.reference_density), pressure[i]);
                    loss += before - kinetic_energy(m, velocity[i]) - m * stored;
                }
                cavitating.fetch_add(below, Ordering::Relaxed);
                [loss]
            });
        let [loss] = sum_of_blocks(losses);
        self.account.dissipation += loss;
        self.account.cavitating += cavitating.into_inner();
    }
}

impl<const D: usize> Particle<D> {
    /// Particle `a` of this volume (m3), norm of the velocity gradient (1/s) and shifting velocity (m/s).
    #[inline]
    pub(crate) fn new(
        fluid: &Fluid<D>,
        a: usize,
        volume: f64,
        strain_rate: f64,
        shift: [f64; D],
    ) -> Self {
        let position = fluid.position[a];
        let area = volume / fluid.geometry.ring(position[0]);
        Self {
            position,
            h: fluid.smoothing_length[a],
            area,
            size: area / fluid.initial_smoothing_length[a].powi(D as i32),
            shift,
            levelling: LEVELLING * strain_rate,
            density: fluid.mass[a] / volume,
            half_ring: half_ring(fluid.geometry, position[0]),
            velocity: fluid.velocity[a],
            share: 1.0,
        }
    }
}

fn image<const D: usize>(geometry: Geometry, plane: &Plane<D>, p: Particle<D>) -> Particle<D> {
    let position = plane.mirror(p.position);
    Particle {
        position,
        velocity: plane.mirror_velocity(p.velocity),
        shift: plane.mirror_direction(p.shift),
        half_ring: half_ring(geometry, position[0]),
        ..p
    }
}

impl<const D: usize> PairSum for Exchange<D> {
    type Particle = Particle<D>;
    type Result = Gain<D>;

    #[inline(always)]
    fn add<S: Simd>(&self, sums: &mut Gain<D, S>, a: &Particle<D, S>, b: &Particle<D, S>) {
        let zero = S::splat(0.0);
        let flow = self.flow(a, b);
        sums.given = sums.given + flow.min(zero);
        let from_b = zero.lt(flow);
        let volume = flow * S::select(from_b, b.share, a.share);
        let mass = volume * S::select(from_b, b.density, a.density);
        sums.volume = sums.volume + volume;
        sums.mass = sums.mass + mass;
        for k in 0..D {
            let velocity = S::select(from_b, b.velocity[k], a.velocity[k]);
            sums.momentum[k] = mass.mul_add(velocity, sums.momentum[k]);
        }
    }

    /// A curved surface mirrors each particle in a plane of its own: images of a pair do not match, mass would leak.
    #[inline(always)]
    fn add_divided<S: Simd>(&self, _: &mut Gain<D, S>, _: &Particle<D, S>, _: &Particle<D, S>) {}

    #[inline(always)]
    fn finish<S: Simd>(&self, sums: Gain<D, S>, _: &Particle<D, S>) -> Gain<D, S> {
        sums
    }
}

impl<const D: usize> Exchange<D> {
    /// Volume (m3) from b to a; exactly antisymmetric.
    #[inline(always)]
    fn flow<S: Simd>(&self, a: &Particle<D, S>, b: &Particle<D, S>) -> S {
        let both = a.size + b.size;
        let (pair, inverse_both) = Pair::new(&a.position, &b.position, a.h + b.h, both);
        let along = dot(&plus(&a.shift, &b.shift), &pair.separation) * pair.gradient;
        // Twice the mean rate, 2 |grad v| times LEVELLING.
        let rate = (a.levelling + b.levelling) * pair.kernel;
        let difference = (b.size - a.size) * inverse_both;
        let ring = (a.half_ring + b.half_ring).abs() * S::splat(self.dt);
        ring * (a.area * b.area) * rate.mul_add(difference, along)
    }
}
