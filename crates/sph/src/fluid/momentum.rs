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
use crate::fluid::moments::{Sym2, apply};
use crate::fluid::pair::{Pair, dot, limited};
use crate::fluid::places;
use crate::fluid::step::Sweep;
use crate::fluid::{Fluid, PARTICLES_PER_TASK};
use crate::geometry::Vec2;
use crate::neighbours::pair_sum::{PairSum, Record, record};
use crate::simd::Simd;
use rayon::prelude::*;

/// Above this eigenvalue of the moment matrix the corrected gradient is used.
const INSIDE: f64 = 0.85;

/// Forces on one particle per unit of its mass, m/s2, and what they come from.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Forces {
    /// Total.
    pub(crate) acceleration: Vec2,
    /// Part of the numerical dissipation.
    pub(crate) dissipation: Vec2,
    /// Part of the walls that can be pushed (the surfaces of solids).
    pub(crate) wall: Vec2,
}

record! {
    /// What the forces read of a particle.
    struct Particle {
        x, y, h, area,
        /// Velocity, m/s.
        u, v,
        pressure,
        /// Half of the density, kg/m3, and of the sound speed, m/s.
        half_density, half_sound_speed,
        /// Half of the velocity gradient, row by row, 1/s.
        half_ux, half_uy, half_vx, half_vy,
        /// Pressure outside a far field, Pa.
        outside,
    }
}

record! {
    /// Sums of A_b grad W times pressures, Pa/m.
    struct Sums {
        pressure_x, pressure_y,
        friction_x, friction_y,
        wall_x, wall_y,
    }
}

/// The law.
struct Law;

/// Memory of the sums.
pub(crate) type Memory = places::Sums<Particle, Sums>;

/// Forces on every particle with velocities `velocity`; `outside` is the far-field pressure of each, Pa.
pub(crate) fn sweep(
    fluid: &Fluid,
    ghosts: &Ghosts,
    velocity: &[Vec2],
    outside: &[f64],
    sweep: &mut Sweep,
) -> Vec<Forces> {
    let (places, kinematics, memory) =
        (&sweep.places, &sweep.kinematics, &mut sweep.memory.momentum);
    let of = |a: usize| particle(fluid, velocity[a], &kinematics[a], outside[a], a);
    places.sum(&Law, ghosts, of, image, memory);
    let forces = |a: usize| {
        let correction = correction(&kinematics[a]);
        memory.results[places.place(a)].forces(correction, fluid.density(a))
    };
    (0..fluid.len())
        .into_par_iter()
        .with_min_len(PARTICLES_PER_TASK)
        .map(forces)
        .collect()
}

fn particle(fluid: &Fluid, [u, v]: Vec2, k: &Kinematics, outside: f64, a: usize) -> Particle {
    let ([x, y], density) = (fluid.position[a], fluid.density(a));
    let [[ux, uy], [vx, vy]] = k.gradient;
    Particle {
        x,
        y,
        h: fluid.smoothing_length[a],
        area: fluid.area(a),
        u,
        v,
        pressure: fluid.pressure[a],
        half_density: 0.5 * density,
        half_sound_speed: 0.5 * fluid.eos.sound_speed_at(density),
        half_ux: 0.5 * ux,
        half_uy: 0.5 * uy,
        half_vx: 0.5 * vx,
        half_vy: 0.5 * vy,
        outside,
    }
}

fn image(plane: &Plane, p: Particle) -> Particle {
    let [x, y] = plane.mirror([p.x, p.y]);
    let [u, v] = plane.mirror_velocity([p.u, p.v]);
    let gradient = [[p.half_ux, p.half_uy], [p.half_vx, p.half_vy]];
    let [[half_ux, half_uy], [half_vx, half_vy]] = plane.mirror_tensor(gradient);
    Particle {
        x,
        y,
        u,
        v,
        half_ux,
        half_uy,
        half_vx,
        half_vy,
        ..p
    }
}

fn correction(k: &Kinematics) -> Sym2 {
    if k.support > INSIDE {
        k.correction
    } else {
        [1.0, 0.0, 1.0]
    }
}

impl Sums {
    fn forces(&self, correction: Sym2, density: f64) -> Forces {
        let scale = |x: f64, y: f64| apply(correction, [x, y]).map(|c| -c / density);
        let pressure = scale(self.pressure_x, self.pressure_y);
        let dissipation = scale(self.friction_x, self.friction_y);
        Forces {
            acceleration: [pressure[0] + dissipation[0], pressure[1] + dissipation[1]],
            dissipation,
            wall: scale(self.wall_x, self.wall_y),
        }
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
        add_pair(sums, a, b);
    }

    /// The image of a particle in the surface of a solid: what it does is done by the solid.
    #[inline(always)]
    fn add_divided<S: Simd>(&self, sums: &mut Sums<S>, a: &Particle<S>, b: &Particle<S>) {
        let (g, q) = add_pair(sums, a, b);
        let all = a.pressure + b.pressure + q;
        sums.wall_x = all.mul_add(g[0], sums.wall_x);
        sums.wall_y = all.mul_add(g[1], sums.wall_y);
    }

    #[inline(always)]
    fn finish<S: Simd>(&self, sums: Sums<S>, _: &Particle<S>) -> Sums<S> {
        sums
    }
}

/// Adds a pair; returns A_b grad W and q_ab.
#[inline(always)]
fn add_pair<S: Simd>(sums: &mut Sums<S>, a: &Particle<S>, b: &Particle<S>) -> ([S; 2], S) {
    let (pair, _) = Pair::new([a.x, a.y, a.h], [b.x, b.y, b.h], S::splat(1.0));
    let factor = b.area * pair.gradient;
    let g = pair.separation.map(|d| factor * d);
    let q = dissipation(&pair, a, b);
    let p = (a.pressure - S::splat(2.0) * a.outside) + b.pressure;
    sums.pressure_x = p.mul_add(g[0], sums.pressure_x);
    sums.pressure_y = p.mul_add(g[1], sums.pressure_y);
    sums.friction_x = q.mul_add(g[0], sums.friction_x);
    sums.friction_y = q.mul_add(g[1], sums.friction_y);
    (g, q)
}

/// q_ab, Pa.
#[inline(always)]
fn dissipation<S: Simd>(pair: &Pair<S>, a: &Particle<S>, b: &Particle<S>) -> S {
    let d = pair.separation;
    let approach = dot([b.u - a.u, b.v - a.v], d) * pair.inverse_distance;
    let jump = approach.max(S::splat(0.0));
    let along_x = dot([a.half_ux + b.half_ux, a.half_uy + b.half_uy], d);
    let along_y = dot([a.half_vx + b.half_vx, a.half_vy + b.half_vy], d);
    let explained = dot([along_x, along_y], d);
    let u = limited(jump, explained.mul_add(pair.inverse_distance, jump));
    let rho = a.half_density + b.half_density;
    let c = a.half_sound_speed + b.half_sound_speed;
    rho * c * u
}
