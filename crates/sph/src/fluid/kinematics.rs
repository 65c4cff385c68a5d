//! First sweep: moment matrix, velocity gradient, rate of volume, crowding.
//!
//! dV_a/dt = V_a [ sum_b A_b (v_b - v_a) . L_a grad W + v_r/r ] + sum_b 2 pi r_ab A_a A_b (p_a - p_b)/(rho c) (-dW/dx)
//!
//! The first bracket is exact for linear velocities, also at a free surface (without L_a the surface sees half its
//! divergence and the wall of a bubble is 5 to 10 % too fast). The last sum is the volume that the middle state of an acoustic
//! Riemann problem moves between neighbours of unequal pressure; the linear part of the pressure, known from the
//! acceleration (grad p = -rho a), is taken out first, which makes the first-order smoothing third order.

use crate::fluid::ghosts::{Ghosts, Plane};
use crate::fluid::moments::{Sym2, apply_lanes, inverse, smaller_eigenvalue};
use crate::fluid::pair::{Pair, half_ring, limited};
use crate::fluid::places::{self, Places};
use crate::fluid::{Fluid, PARTICLES_PER_TASK};
use crate::geometry::{Geometry, Vec2};
use crate::kernel;
use crate::neighbours::pair_sum::{PairSum, Record, record};
use crate::simd::Simd;
use rayon::prelude::*;

/// Sums over the neighbours of one particle that need no other sums.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Kinematics {
    /// Inverse moment matrix L.
    pub(crate) correction: Sym2,
    /// Smaller eigenvalue of the moment matrix.
    pub(crate) support: f64,
    /// Velocity gradient, dv_i/dx_j in [i][j], 1/s.
    pub(crate) gradient: [Vec2; 2],
    /// Relative rate of volume by motion, 1/s.
    pub(crate) divergence: f64,
    /// Rate of volume by unequal pressure, m3/s.
    pub(crate) exchange: f64,
    /// Sum of A_b grad W with a short-range term, 1/m: points to where particles are lacking.
    pub(crate) crowding: Vec2,
}

/// Strength of the short-range term in the crowding.
const CLUMPING: f64 = 0.2;

record! {
    /// What the sums read of a particle.
    struct Particle {
        x, y, h, area,
        /// Velocity, m/s.
        u, v,
        pressure,
        /// Half of rho times acceleration, of -grad p, Pa/m.
        half_push_x, half_push_y,
        /// Half of rho c, kg/(m2 s).
        half_impedance,
        /// Half of the length of the ring, m.
        half_ring,
    }
}

record! {
    /// What comes out.
    struct Sums {
        /// Moment matrix, then its inverse.
        xx, xy, yy,
        support,
        /// Velocity gradient, row by row.
        ux, uy, vx, vy,
        divergence, exchange,
        crowding_x, crowding_y,
    }
}

/// The law.
struct Law {
    rings: bool,
    /// Strength of the short-range term over the fourth power of W R^2 at one spacing.
    clumping: f64,
}

/// Memory of the sums.
pub(crate) type Memory = places::Sums<Particle, Sums>;

/// Kinematics of every particle.
pub(crate) fn sweep(
    fluid: &Fluid,
    ghosts: &Ghosts,
    places: &Places,
    memory: &mut Memory,
    kinematics: &mut Vec<Kinematics>,
) {
    // W R^2 at one spacing, the same for all R.
    let at_spacing = 4.0 * kernel::value(1.0 / super::SMOOTHING, 1.0);
    let geometry = fluid.geometry;
    let law = Law {
        rings: geometry == Geometry::Axisymmetric,
        clumping: CLUMPING / at_spacing.powi(4),
    };
    places.sum(
        &law,
        ghosts,
        |a| particle(fluid, a),
        |plane, p| image(geometry, plane, p),
        memory,
    );
    (0..fluid.len())
        .into_par_iter()
        .with_min_len(PARTICLES_PER_TASK)
        .map(|a| Kinematics::from(&memory.results[places.place(a)]))
        .collect_into_vec(kinematics);
}

fn particle(fluid: &Fluid, a: usize) -> Particle {
    let ([x, y], [u, v]) = (fluid.position[a], fluid.velocity[a]);
    let (density, acceleration) = (fluid.density(a), fluid.acceleration[a]);
    Particle {
        x,
        y,
        h: fluid.smoothing_length[a],
        area: fluid.area(a),
        u,
        v,
        pressure: fluid.pressure[a],
        half_push_x: 0.5 * density * acceleration[0],
        half_push_y: 0.5 * density * acceleration[1],
        half_impedance: 0.5 * density * fluid.eos.sound_speed_at(density),
        half_ring: half_ring(fluid.geometry, x),
    }
}

fn image(geometry: Geometry, plane: &Plane, p: Particle) -> Particle {
    let [x, y] = plane.mirror([p.x, p.y]);
    let [u, v] = plane.mirror_velocity([p.u, p.v]);
    let [half_push_x, half_push_y] = plane.mirror_direction([p.half_push_x, p.half_push_y]);
    Particle {
        x,
        y,
        u,
        v,
        half_push_x,
        half_push_y,
        half_ring: half_ring(geometry, x),
        ..p
    }
}

impl PairSum for Law {
    type Particle = Particle;
    type Result = Sums;
    type Sums<S: Simd> = Sums<S>;

    #[inline(always)]
    fn zero<S: Simd>() -> Sums<S> {
        Sums::default().splat()
    }

    #[inline(always)]
    fn add<S: Simd>(&self, sums: &mut Sums<S>, a: &Particle<S>, b: &Particle<S>) {
        let impedance = a.half_impedance + b.half_impedance;
        let (pair, inverse_impedance) = Pair::new([a.x, a.y, a.h], [b.x, b.y, b.h], impedance);
        let d = pair.separation;
        let factor = b.area * pair.gradient;
        let g = d.map(|d| factor * d);
        sums.xx = (-d[0]).mul_add(g[0], sums.xx);
        sums.xy = (-d[0]).mul_add(g[1], sums.xy);
        sums.yy = (-d[1]).mul_add(g[1], sums.yy);
        let (du, dv) = (b.u - a.u, b.v - a.v);
        sums.ux = du.mul_add(g[0], sums.ux);
        sums.uy = du.mul_add(g[1], sums.uy);
        sums.vx = dv.mul_add(g[0], sums.vx);
        sums.vy = dv.mul_add(g[1], sums.vy);
        let near = self.nearness(&pair);
        sums.crowding_x = near.mul_add(g[0], sums.crowding_x);
        sums.crowding_y = near.mul_add(g[1], sums.crowding_y);
        let speed = pressure_jump(a, b, d) * inverse_impedance;
        let ring = (a.half_ring + b.half_ring).abs();
        let surface = ring * (factor * pair.distance);
        sums.exchange = (-surface).mul_add(speed, sums.exchange);
    }

    #[inline(always)]
    fn add_divided<S: Simd>(&self, sums: &mut Sums<S>, a: &Particle<S>, b: &Particle<S>) {
        self.add(sums, a, b);
    }

    #[inline(always)]
    fn finish<S: Simd>(&self, s: Sums<S>, a: &Particle<S>) -> Sums<S> {
        let moments = [s.xx, s.xy, s.yy];
        let correction = inverse(moments);
        let [ux, uy] = apply_lanes(correction, [s.ux, s.uy]);
        let [vx, vy] = apply_lanes(correction, [s.vx, s.vy]);
        let plane = ux + vy;
        Sums {
            xx: correction[0],
            xy: correction[1],
            yy: correction[2],
            support: smaller_eigenvalue(moments),
            ux,
            uy,
            vx,
            vy,
            divergence: if self.rings { plane + a.u / a.x } else { plane },
            exchange: s.exchange * a.area,
            ..s
        }
    }
}

impl Law {
    /// 1 + 0.2 (W/W(dx))^4.
    #[inline(always)]
    fn nearness<S: Simd>(&self, pair: &Pair<S>) -> S {
        let square = pair.relative_kernel * pair.relative_kernel;
        (square * square).mul_add(S::splat(self.clumping), S::splat(1.0))
    }
}

/// p_a - p_b less its linear part, Pa; exactly antisymmetric.
#[inline(always)]
fn pressure_jump<S: Simd>(a: &Particle<S>, b: &Particle<S>, d: [S; 2]) -> S {
    let jump = a.pressure - b.pressure;
    let push = [a.half_push_x + b.half_push_x, a.half_push_y + b.half_push_y];
    limited(jump, push[0].mul_add(d[0], push[1].mul_add(d[1], jump)))
}

impl From<&Sums> for Kinematics {
    fn from(s: &Sums) -> Self {
        Self {
            correction: [s.xx, s.xy, s.yy],
            support: s.support,
            gradient: [[s.ux, s.uy], [s.vx, s.vy]],
            divergence: s.divergence,
            exchange: s.exchange,
            crowding: [s.crowding_x, s.crowding_y],
        }
    }
}
