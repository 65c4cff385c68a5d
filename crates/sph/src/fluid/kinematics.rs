//! First sweep: moment matrix, velocity gradient, rate of volume, crowding.
//!
//! dV_a/dt = V_a [ sum_b A_b (v_b - v_a) . L_a grad W + v_r/r ] + sum_b 2 pi r_ab A_a A_b (p_a - p_b)/(rho c) (-dW/dx)
//!
//! The first bracket is exact for linear velocities, also at a free surface (without L_a the surface sees half its
//! divergence and the wall of a bubble is 5 to 10 % too fast). The last sum is the volume that the middle state of an acoustic
//! Riemann problem moves between neighbours of unequal pressure; the linear part of the pressure, known from the
//! acceleration (grad p = -rho a), is taken out first, which makes the first-order smoothing third order.

use crate::fluid::ghosts::{Ghosts, Plane};
use crate::fluid::moments::{apply_lanes, inverse, smallest_eigenvalue};
use crate::fluid::pair::{Pair, add_scaled, half_ring, limited, plus, scaled};
use crate::fluid::places::{self, Places};
use crate::fluid::{Fluid, PARTICLES_PER_TASK};
use crate::geometry::Geometry;
use crate::kernel;
use crate::neighbours::pair_sum::{PairSum, record};
use crate::simd::Simd;
use rayon::prelude::*;

/// Strength of the short-range term in the crowding.
const CLUMPING: f64 = 0.2;

record! {
    /// What the sums read of a particle.
    struct Particle {
        position: [T; D],
        h: T,
        area: T,
        /// m/s.
        velocity: [T; D],
        pressure: T,
        /// Half of rho times acceleration, of -grad p, Pa/m.
        half_push: [T; D],
        /// Half of rho c, kg/(m2 s).
        half_impedance: T,
        /// Half of the length of the ring, m.
        half_ring: T,
    }
}

record! {
    /// Sums over the neighbours of one particle that need no other sums.
    struct Kinematics {
        /// Inverse moment matrix L; until all is summed the moment matrix itself, on and above the diagonal.
        correction: [[T; D]; D],
        /// Smallest eigenvalue of the moment matrix.
        support: T,
        /// Velocity gradient, dv_i/dx_j in [i][j], 1/s.
        gradient: [[T; D]; D],
        /// Relative rate of volume by motion, 1/s.
        divergence: T,
        /// Rate of volume by unequal pressure, m3/s.
        exchange: T,
        /// Sum of A_b grad W with a short-range term, 1/m: points to where particles are lacking.
        crowding: [T; D],
    }
}

/// The law.
struct Law<const D: usize> {
    rings: bool,
    /// Strength of the short-range term over the fourth power of W R^D at one spacing.
    clumping: f64,
}

/// Memory of the sums.
pub(crate) type Memory<const D: usize> = places::Sums<Particle<D>, Kinematics<D>>;

/// Kinematics of every particle, in `memory`.
pub(crate) fn sweep<const D: usize>(
    fluid: &Fluid<D>,
    ghosts: &Ghosts<D>,
    places: &Places<D>,
    memory: &mut Memory<D>,
) {
    // W R^D at one spacing, the same for all R.
    let at_spacing = f64::from(1 << D) * kernel::value_in::<D>(1.0 / super::SMOOTHING, 1.0);
    let geometry = fluid.geometry;
    let law = Law::<D> {
        rings: geometry == Geometry::Axisymmetric,
        clumping: CLUMPING / at_spacing.powi(4),
    };
    (places.records(memory).par_iter_mut().enumerate())
        .with_min_len(PARTICLES_PER_TASK)
        .for_each(|(a, record)| *record = particle(fluid, a));
    places.sum(&law, ghosts, |plane, p| image(geometry, plane, p), memory);
}

fn particle<const D: usize>(fluid: &Fluid<D>, a: usize) -> Particle<D> {
    let (position, density) = (fluid.position[a], fluid.density(a));
    Particle {
        position,
        h: fluid.smoothing_length[a],
        area: fluid.area(a),
        velocity: fluid.velocity[a],
        pressure: fluid.pressure[a],
        half_push: fluid.acceleration[a].map(|x| 0.5 * density * x),
        half_impedance: 0.5 * density * fluid.sound_speed(a),
        half_ring: half_ring(fluid.geometry, position[0]),
    }
}

fn image<const D: usize>(geometry: Geometry, plane: &Plane<D>, p: Particle<D>) -> Particle<D> {
    let position = plane.mirror(p.position);
    Particle {
        position,
        velocity: plane.mirror_velocity(p.velocity),
        half_push: plane.mirror_direction(p.half_push),
        half_ring: half_ring(geometry, position[0]),
        ..p
    }
}

impl<const D: usize> PairSum for Law<D> {
    type Particle = Particle<D>;
    type Result = Kinematics<D>;

    #[inline(always)]
    fn add<S: Simd>(&self, sums: &mut Kinematics<D, S>, a: &Particle<D, S>, b: &Particle<D, S>) {
        let impedance = a.half_impedance + b.half_impedance;
        let (pair, inverse_impedance) = Pair::new(&a.position, &b.position, a.h + b.h, impedance);
        let d = &pair.separation;
        let factor = b.area * pair.gradient;
        let g = scaled(d, factor);
        for i in 0..D {
            let jump = b.velocity[i] - a.velocity[i];
            for j in 0..D {
                if j >= i {
                    sums.correction[i][j] = (-d[i]).mul_add(g[j], sums.correction[i][j]);
                }
                sums.gradient[i][j] = jump.mul_add(g[j], sums.gradient[i][j]);
            }
        }
        add_scaled(&mut sums.crowding, &g, self.nearness(&pair));
        let speed = pressure_jump(a, b, d) * inverse_impedance;
        let ring = (a.half_ring + b.half_ring).abs();
        let surface = ring * (factor * pair.distance);
        sums.exchange = (-surface).mul_add(speed, sums.exchange);
    }

    #[inline(always)]
    fn add_divided<S: Simd>(
        &self,
        sums: &mut Kinematics<D, S>,
        a: &Particle<D, S>,
        b: &Particle<D, S>,
    ) {
        self.add(sums, a, b);
    }

    #[inline(always)]
    fn finish<S: Simd>(&self, s: Kinematics<D, S>, a: &Particle<D, S>) -> Kinematics<D, S> {
        let support = smallest_eigenvalue(&s.correction);
        let correction = inverse(&s.correction, support);
        let mut gradient = s.gradient;
        for i in 0..D {
            gradient[i] = apply_lanes(&correction, &s.gradient[i]);
        }
        let mut divergence = gradient[0][0];
        for i in 1..D {
            divergence = divergence + gradient[i][i];
        }
        if self.rings {
            divergence = divergence + a.velocity[0] / a.position[0];
        }
        Kinematics {
            correction,
            support,
            gradient,
            divergence,
            exchange: s.exchange * a.area,
            ..s
        }
    }
}

impl<const D: usize> Law<D> {
    /// 1 + 0.2 (W/W(dx))^4.
    #[inline(always)]
    fn nearness<S: Simd>(&self, pair: &Pair<S, D>) -> S {
        let square = pair.relative_kernel * pair.relative_kernel;
        (square * square).mul_add(S::splat(self.clumping), S::splat(1.0))
    }
}

/// p_a - p_b less its linear part, Pa; exactly antisymmetric.
#[inline(always)]
fn pressure_jump<S: Simd, const D: usize>(a: &Particle<D, S>, b: &Particle<D, S>, d: &[S; D]) -> S {
    let jump = a.pressure - b.pressure;
    let push = plus(&a.half_push, &b.half_push);
    let mut rest = jump;
    for k in (0..D).rev() {
        rest = push[k].mul_add(d[k], rest);
    }
    limited(jump, rest)
}
