//! Second sweep: accelerations.
//!
//! dv_a/dt = -(1/rho_a) G_a sum_b A_b (p_a + p_b + q_ab - 2 p_x) grad W
//!
//! q_ab = rho c u for pairs that approach with speed u: the dissipation of an acoustic Riemann solver, u being what the
//! velocity gradient does not explain (third order in smooth flow). G_a = L_a inside the liquid; near a free surface it is the
//! identity, since the deficit of the plain sum is the condition p = 0 half a spacing outside the first particle. p_x is
//! the pressure outside a far field, zero elsewhere.

use crate::fluid::ghosts::{Ghosts, Plane};
use crate::fluid::kinematics::Kinematics;
use crate::fluid::moments::{Matrix, apply};
use crate::fluid::pair::{Pair, add_scaled, dot, limited, plus, scaled};
use crate::fluid::places;
use crate::fluid::step::Sweep;
use crate::fluid::{Fluid, PARTICLES_PER_TASK};
use crate::neighbours::pair_sum::{PairSum, record};
use crate::simd::Simd;
use rayon::prelude::*;

/// Above this eigenvalue of the moment matrix the corrected gradient is used.
const INSIDE: f64 = 0.85;

/// Forces on one particle per unit of its mass, m/s2, and what they come from.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Forces<const D: usize = 2> {
    /// Total.
    pub(crate) acceleration: [f64; D],
    /// Part of the numerical dissipation.
    pub(crate) dissipation: [f64; D],
    /// Part of the walls that can be pushed (the surfaces of solids).
    pub(crate) wall: [f64; D],
}

record! {
    /// What the forces read of a particle.
    struct Particle {
        position: [T; D],
        h: T,
        area: T,
        /// m/s.
        velocity: [T; D],
        pressure: T,
        /// Half of the density, kg/m3.
        half_density: T,
        /// Half of the sound speed, m/s.
        half_sound_speed: T,
        /// Half of the velocity gradient, 1/s.
        half_gradient: [[T; D]; D],
        /// Pressure outside a far field, Pa.
        outside: T,
    }
}

record! {
    /// Sums of A_b grad W times pressures, Pa/m.
    struct Sums {
        pressure: [T; D],
        friction: [T; D],
        wall: [T; D],
    }
}

/// The law.
struct Law<const D: usize>;

/// Memory of the sums.
pub(crate) type Memory<const D: usize> = places::Sums<Particle<D>, Sums<D>>;

/// Sums over the neighbours of every particle, with velocity and pressure outside (m/s, Pa) as `surroundings` tells them.
pub(crate) fn sweep<const D: usize>(
    fluid: &Fluid<D>,
    ghosts: &Ghosts<D>,
    surroundings: impl Fn(usize) -> ([f64; D], f64) + Sync,
    sweep: &mut Sweep<D>,
) {
    let (places, kinematics) = (&sweep.places, &sweep.memory.kinematics.results);
    let memory = &mut sweep.memory.momentum;
    (places.records(memory).par_iter_mut().enumerate())
        .with_min_len(PARTICLES_PER_TASK)
        .for_each(|(a, record)| *record = particle(fluid, surroundings(a), &kinematics[a], a));
    places.sum(&Law::<D>, ghosts, image, memory);
}

/// Forces on particle `a` with the sums of the last sweep.
pub(crate) fn forces<const D: usize>(fluid: &Fluid<D>, sweep: &Sweep<D>, a: usize) -> Forces<D> {
    let correction = correction(sweep.kinematics(a));
    let sums = &sweep.memory.momentum.results[a];
    sums.forces(correction, fluid.density(a))
}

fn particle<const D: usize>(
    fluid: &Fluid<D>,
    (velocity, outside): ([f64; D], f64),
    k: &Kinematics<D>,
    a: usize,
) -> Particle<D> {
    Particle {
        position: fluid.position[a],
        h: fluid.smoothing_length[a],
        area: fluid.area(a),
        velocity,
        pressure: fluid.pressure[a],
        half_density: 0.5 * fluid.density(a),
        half_sound_speed: 0.5 * fluid.sound_speed(a),
        half_gradient: k.gradient.map(|row| row.map(|x| 0.5 * x)),
        outside,
    }
}

fn image<const D: usize>(plane: &Plane<D>, p: Particle<D>) -> Particle<D> {
    Particle {
        position: plane.mirror(p.position),
        velocity: plane.mirror_velocity(p.velocity),
        half_gradient: plane.mirror_tensor(p.half_gradient),
        ..p
    }
}

/// L inside the liquid, the identity at its surface.
fn correction<const D: usize>(k: &Kinematics<D>) -> Matrix<D> {
    if k.support > INSIDE {
        return k.correction;
    }
    let mut identity = [[0.0; D]; D];
    for (i, row) in identity.iter_mut().enumerate() {
        row[i] = 1.0;
    }
    identity
}

impl<const D: usize> Sums<D> {
    fn forces(&self, correction: Matrix<D>, density: f64) -> Forces<D> {
        let scale = |x: [f64; D]| apply(&correction, x).map(|c| -c / density);
        let pressure = scale(self.pressure);
        let dissipation = scale(self.friction);
        Forces {
            acceleration: std::array::from_fn(|i| pressure[i] + dissipation[i]),
            dissipation,
            wall: scale(self.wall),
        }
    }
}

impl<const D: usize> PairSum for Law<D> {
    type Particle = Particle<D>;
    type Result = Sums<D>;

    #[inline(always)]
    fn add<S: Simd>(&self, sums: &mut Sums<D, S>, a: &Particle<D, S>, b: &Particle<D, S>) {
        add_pair(sums, a, b);
    }

    /// The image of a particle in the surface of a solid: what it does is done by the solid.
    #[inline(always)]
    fn add_divided<S: Simd>(&self, sums: &mut Sums<D, S>, a: &Particle<D, S>, b: &Particle<D, S>) {
        let (g, q) = add_pair(sums, a, b);
        add_scaled(&mut sums.wall, &g, a.pressure + b.pressure + q);
    }

    #[inline(always)]
    fn finish<S: Simd>(&self, sums: Sums<D, S>, _: &Particle<D, S>) -> Sums<D, S> {
        sums
    }
}

/// Adds a pair; returns A_b grad W and q_ab.
#[inline(always)]
fn add_pair<S: Simd, const D: usize>(
    sums: &mut Sums<D, S>,
    a: &Particle<D, S>,
    b: &Particle<D, S>,
) -> ([S; D], S) {
    let (pair, _) = Pair::new(&a.position, &b.position, a.h + b.h, S::splat(1.0));
    let g = scaled(&pair.separation, b.area * pair.gradient);
    let q = dissipation(&pair, a, b);
    let p = (a.pressure - S::splat(2.0) * a.outside) + b.pressure;
    add_scaled(&mut sums.pressure, &g, p);
    add_scaled(&mut sums.friction, &g, q);
    (g, q)
}

/// q_ab, Pa.
#[inline(always)]
fn dissipation<S: Simd, const D: usize>(
    pair: &Pair<S, D>,
    a: &Particle<D, S>,
    b: &Particle<D, S>,
) -> S {
    let d = &pair.separation;
    let (mut jump, mut along) = (*d, *d);
    for k in 0..D {
        jump[k] = b.velocity[k] - a.velocity[k];
        along[k] = dot(&plus(&a.half_gradient[k], &b.half_gradient[k]), d);
    }
    let approach = (dot(&jump, d) * pair.inverse_distance).max(S::splat(0.0));
    let rest = dot(&along, d).mul_add(pair.inverse_distance, approach);
    let u = limited(approach, rest);
    let rho = a.half_density + b.half_density;
    let c = a.half_sound_speed + b.half_sound_speed;
    rho * c * u
}
