//! Particle shifting that carries mass: keeps particles evenly spaced while the flow strains them.
//!
//! Shifting velocity d = -k h^2 |grad v| sum A_b (1 + 0.2 (W/W(dx))^4) grad W, tied to the strain rate because the disorder
//! comes from strain. A particle that moves relative to the liquid exchanges volume with its neighbours,
//! q_ab = 2 pi r_ab A_a A_b (d_a + d_b) . grad W, antisymmetric; mass and momentum go with the volume, upwind. Uniform
//! density stays uniform and mass is conserved to rounding wherever both images of a pair exist.
//!
//! The areas A drift apart in strong strain, first at the axis, where a small change of r is a large change of A = V/(2 pi r);
//! unequal weights then spoil the sums. The same exchange therefore also levels the sizes of neighbours,
//! q_ab += 10 |grad v| 2 pi r_ab A_a A_b W 2 (A_b - A_a)/(A_a + A_b). (Without it the pressure along the axis of a jet is noisy by
//! 20 %, and particles near the axis swell to many times their size.)

use crate::fluid::corrected::Settings;
use crate::fluid::ghosts::Plane;
use crate::fluid::kinematics::Kinematics;
use crate::fluid::pair::{Pair, dot, half_ring};
use crate::fluid::places::{self, Places};
use crate::fluid::step::Sweep;
use crate::fluid::{Fluid, PARTICLES_PER_TASK, ordered_sum};
use crate::geometry::{Geometry, Vec2};
use crate::neighbours::pair_sum::{PairSum, Record, record};
use crate::simd::Simd;
use rayon::prelude::*;

/// Below this eigenvalue of the moment matrix a particle lies at a free surface and is not moved across it.
const SURFACE: f64 = 0.6;

/// A particle gives at most this share of its volume per step.
const LARGEST_SHARE: f64 = 0.1;

/// Rate of levelling of areas in units of |grad v|; 3 and 20 serve as well.
const LEVELLING: f64 = 10.0;

/// Shifting velocity of a particle with smoothing length `h`, m/s.
pub(crate) fn velocity(h: f64, k: &Kinematics, s: &Settings) -> Vec2 {
    let strain = norm(&k.gradient);
    let mut d = [0, 1].map(|i| -s.shifting * h * h * strain * k.crowding[i]);
    let size = length(k.crowding);
    if k.support < SURFACE && size > 0.0 {
        let n = k.crowding.map(|c| c / size);
        let along = d[0] * n[0] + d[1] * n[1];
        d = [d[0] - along * n[0], d[1] - along * n[1]];
    }
    let limit = s.shifting_limit * h * strain;
    let speed = length(d);
    if speed > limit {
        d.map(|c| c * limit / speed)
    } else {
        d
    }
}

fn length(x: Vec2) -> f64 {
    (x[0] * x[0] + x[1] * x[1]).sqrt()
}

/// Frobenius norm of a velocity gradient, 1/s.
pub(crate) fn norm(g: &[Vec2; 2]) -> f64 {
    (g[0][0].powi(2) + g[0][1].powi(2) + g[1][0].powi(2) + g[1][1].powi(2)).sqrt()
}

record! {
    /// What the exchange reads of a particle.
    struct Particle {
        x, y, h, area,
        /// Shifting velocity, m/s.
        shift_x, shift_y,
        /// Rate of levelling, 1/s.
        levelling,
        density,
        /// Half of the length of the ring, m.
        half_ring,
        /// Velocity, m/s.
        u, v,
        /// Part of what it would give that it may give.
        share,
    }
}

record! {
    /// What a particle gets in one step.
    struct Gain {
        volume, mass, momentum_x, momentum_y,
        /// Volume that it would give if it may give all, m3 (negative).
        given,
    }
}

/// The law.
struct Exchange {
    dt: f64,
}

/// Memory of the sums.
pub(crate) type Memory = places::Sums<Particle, Gain>;

/// Moves volume, mass and momentum between neighbours for one step of shifting with velocities `shift`.
pub(crate) fn exchange(fluid: &mut Fluid, sweep: &mut Sweep, shift: &[Vec2], dt: f64) {
    let (ghosts, places, memory) = (&sweep.ghosts, &sweep.places, &mut sweep.memory.shifting);
    let law = Exchange { dt };
    let geometry = fluid.geometry;
    let image = |plane: &Plane, p| image(geometry, plane, p);
    places.sum(
        &law,
        ghosts,
        |a| particle(fluid, shift, a, 1.0),
        image,
        memory,
    );
    let given = |a: usize| -memory.results[places.place(a)].given;
    let limited = (0..fluid.len())
        .into_par_iter()
        .with_min_len(PARTICLES_PER_TASK)
        .filter(|a| given(*a) > LARGEST_SHARE * fluid.volume[*a])
        .count();
    if limited > 0 {
        let share = |a: usize| {
            let given = given(a).max(f64::MIN_POSITIVE);
            (LARGEST_SHARE * fluid.volume[a] / given).min(1.0)
        };
        let share: Vec<f64> = (0..fluid.len()).map(share).collect();
        places.sum(
            &law,
            ghosts,
            |a| particle(fluid, shift, a, share[a]),
            image,
            memory,
        );
    }
    fluid.account.limited_exchanges += limited as u64;
    fluid.take(&memory.results, places);
}

impl Fluid {
    /// Volume, mass and velocity with what was gained; kinetic energy lost in the mixing goes to the account.
    fn take(&mut self, gains: &[Gain], places: &Places) {
        let eos = self.eos;
        let loss: Vec<f64> = (self.velocity.par_iter_mut())
            .zip(&mut self.mass)
            .zip(&mut self.volume)
            .enumerate()
            .with_min_len(PARTICLES_PER_TASK)
            .map(|(a, ((velocity, mass), volume))| {
                let gain = &gains[places.place(a)];
                let before = super::energy(&eos, *mass, *volume, *velocity);
                let m = *mass + gain.mass;
                let momentum = [gain.momentum_x, gain.momentum_y];
                *velocity = [0, 1].map(|i| (*mass * velocity[i] + momentum[i]) / m);
                *mass = m;
                *volume += gain.volume;
                before - super::energy(&eos, *mass, *volume, *velocity)
            })
            .collect();
        self.account.dissipation += ordered_sum(loss.len(), |a| loss[a]);
    }
}

fn particle(fluid: &Fluid, shift: &[Vec2], a: usize, share: f64) -> Particle {
    let ([x, y], [u, v], [shift_x, shift_y]) = (fluid.position[a], fluid.velocity[a], shift[a]);
    Particle {
        x,
        y,
        h: fluid.smoothing_length[a],
        area: fluid.area(a),
        shift_x,
        shift_y,
        levelling: LEVELLING * fluid.strain_rate[a],
        density: fluid.density(a),
        half_ring: half_ring(fluid.geometry, x),
        u,
        v,
        share,
    }
}

fn image(geometry: Geometry, plane: &Plane, p: Particle) -> Particle {
    let [x, y] = plane.mirror([p.x, p.y]);
    let [u, v] = plane.mirror_velocity([p.u, p.v]);
    let [shift_x, shift_y] = plane.mirror_direction([p.shift_x, p.shift_y]);
    Particle {
        x,
        y,
        u,
        v,
        shift_x,
        shift_y,
        half_ring: half_ring(geometry, x),
        ..p
    }
}

impl PairSum for Exchange {
    type Particle = Particle;
    type Result = Gain;
    type Sums<S: Simd> = Gain<S>;

    #[inline(always)]
    fn zero<S: Simd>() -> Gain<S> {
        Gain::default().splat()
    }

    #[inline(always)]
    fn add<S: Simd>(&self, sums: &mut Gain<S>, a: &Particle<S>, b: &Particle<S>) {
        let zero = S::splat(0.0);
        let flow = self.flow(a, b);
        sums.given = sums.given + flow.min(zero);
        let from_b = zero.lt(flow);
        let upwind = |a: S, b: S| S::select(from_b, b, a);
        let volume = flow * upwind(a.share, b.share);
        let mass = volume * upwind(a.density, b.density);
        sums.volume = sums.volume + volume;
        sums.mass = sums.mass + mass;
        sums.momentum_x = mass.mul_add(upwind(a.u, b.u), sums.momentum_x);
        sums.momentum_y = mass.mul_add(upwind(a.v, b.v), sums.momentum_y);
    }

    /// A curved surface mirrors each particle in a plane of its own: images of a pair do not match, mass would leak.
    #[inline(always)]
    fn add_divided<S: Simd>(&self, _: &mut Gain<S>, _: &Particle<S>, _: &Particle<S>) {}

    #[inline(always)]
    fn finish<S: Simd>(&self, sums: Gain<S>, _: &Particle<S>) -> Gain<S> {
        sums
    }
}

impl Exchange {
    /// Volume (m3) from b to a; exactly antisymmetric.
    #[inline(always)]
    fn flow<S: Simd>(&self, a: &Particle<S>, b: &Particle<S>) -> S {
        let both = a.area + b.area;
        let (pair, inverse_both) = Pair::new([a.x, a.y, a.h], [b.x, b.y, b.h], both);
        let shift = [a.shift_x + b.shift_x, a.shift_y + b.shift_y];
        let along = dot(shift, pair.separation) * pair.gradient;
        // Twice the mean rate, 2 |grad v| times LEVELLING.
        let rate = (a.levelling + b.levelling) * pair.kernel;
        let difference = (b.area - a.area) * inverse_both;
        let ring = (a.half_ring + b.half_ring).abs() * S::splat(self.dt);
        ring * (a.area * b.area) * rate.mul_add(difference, along)
    }
}
