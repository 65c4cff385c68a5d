//! The sums over pairs of a solid in three dimensions, eight particles at a time (`blocks.rs`, `list.rs`).
//!
//! With X = X_a - X_b of the reference, x = x_a - x_b, v = v_a - v_b and the weights of `weight.rs`:
//!
//! M_a = k_a sum A_b s^3 X (x) X,  F_a = k_a sum A_b s^3 x (x) X M_a^-1  (exact for linear fields)
//!
//! dv_a/dt = -k_a/rho0 sum A_b s^3 (Q_a + Q_b) X, Q = P M^-1, P = J sigma F^-T: the adjoint of the strain, so that energy is kept
//!   - alpha c_l n_v m_a sum A_b^2 s^5 min(v.x, 0) x               viscosity on approach
//!   + zeta E/rho0 n_h m_a sum A_b^2 s^5 R ((F_a + F_b)/2 X - x)   hourglass penalty, zero for every linear field
//!
//! The laws are those of `solid/force.rs`. What depends on a alone is taken out of the sums: they need no matrices of a.

use super::blocks::{Block, Blocks};
use super::lanes::{Matrix, Symmetric, Vector, apply, dot, times};
use super::list::List;
use crate::simd::{LANES, Simd};

/// Set bits of lanes, the lowest first.
struct Lanes(u8);

impl Iterator for Lanes {
    type Item = usize;

    #[inline(always)]
    fn next(&mut self) -> Option<usize> {
        if self.0 == 0 {
            return None;
        }
        let lane = self.0.trailing_zeros() as usize % LANES;
        self.0 &= self.0 - 1;
        Some(lane)
    }
}

/// A pair: reference offset X, and s = R^2 - X^2, not below zero.
struct Pair<S> {
    offset: Vector<S>,
    radius: S,
    s: S,
    share: S,
}

impl<S: Simd> Pair<S> {
    /// `own`: position, smoothing length and share of the particles of a cluster.
    #[inline(always)]
    fn new(own: &[S; 5], other: &Block<5>, lane: usize) -> Self {
        let offset = minus([own[0], own[1], own[2]], other, lane);
        let radius = own[3] + other.broadcast(3, lane);
        let [x, y, z] = offset;
        let s = (-x).mul_add(x, (-y).mul_add(y, (-z).mul_add(z, radius * radius)));
        Self {
            offset,
            radius,
            s: s.max(S::splat(0.0)),
            share: other.broadcast(4, lane),
        }
    }

    /// A_b s^3, and A_b^2 s^5.
    #[inline(always)]
    fn weights(&self) -> [S; 2] {
        let square = self.s * self.s * self.share;
        let cube = square * self.s;
        [cube, cube * square]
    }
}

#[inline(always)]
fn minus<S: Simd, const N: usize>(own: Vector<S>, other: &Block<N>, lane: usize) -> Vector<S> {
    [
        own[0] - other.broadcast(0, lane),
        own[1] - other.broadcast(1, lane),
        own[2] - other.broadcast(2, lane),
    ]
}

/// sum A_b s^3 X (x) X.
#[inline(always)]
pub(super) fn moment<S: Simd>(list: &List, place: &Blocks<5>, cluster: usize) -> Symmetric<S> {
    let own: [S; 5] = place.blocks[cluster].load();
    let mut m = [S::splat(0.0); 6];
    for (n, lanes) in list.of(cluster) {
        for l in Lanes(lanes) {
            let pair = Pair::new(&own, &place.blocks[n], l);
            let [x, y, z] = pair.offset;
            let [gx, gy, gz] = times(pair.offset, pair.weights()[0]);
            m[0] = gx.mul_add(x, m[0]);
            m[1] = gy.mul_add(y, m[1]);
            m[2] = gz.mul_add(z, m[2]);
            m[3] = gx.mul_add(y, m[3]);
            m[4] = gx.mul_add(z, m[4]);
            m[5] = gy.mul_add(z, m[5]);
        }
    }
    m
}

/// sum A_b s^3 x (x) X of a vector x: the difference a - b is taken.
#[inline(always)]
pub(super) fn gradient<S: Simd>(
    list: &List,
    place: &Blocks<5>,
    field: &Blocks<3>,
    cluster: usize,
) -> Matrix<S> {
    let own: [S; 5] = place.blocks[cluster].load();
    let x: Vector<S> = field.blocks[cluster].load();
    let mut m = [S::splat(0.0); 9];
    for (n, lanes) in list.of(cluster) {
        let (place, field) = (&place.blocks[n], &field.blocks[n]);
        for l in Lanes(lanes) {
            let pair = Pair::new(&own, place, l);
            let g = times(pair.offset, pair.weights()[0]);
            let d = minus(x, field, l);
            for i in 0..3 {
                for j in 0..3 {
                    m[3 * i + j] = d[i].mul_add(g[j], m[3 * i + j]);
                }
            }
        }
    }
    m
}

/// What forces are made of.
#[derive(Clone, Copy)]
pub(super) struct Moving<'a> {
    pub(super) position: &'a Blocks<3>,
    pub(super) velocity: &'a Blocks<3>,
    pub(super) deformation: &'a Blocks<9>,
    pub(super) flux: &'a Blocks<9>,
}

/// The sums of the acceleration without what stands before them.
pub(super) struct Forces<S> {
    pub(super) stress: Vector<S>,
    pub(super) viscous: Vector<S>,
    pub(super) hourglass: Vector<S>,
}

#[inline(always)]
pub(super) fn forces<S: Simd>(
    list: &List,
    place: &Blocks<5>,
    moving: &Moving,
    cluster: usize,
) -> Forces<S> {
    let own: [S; 5] = place.blocks[cluster].load();
    let x: Vector<S> = moving.position.blocks[cluster].load();
    let v: Vector<S> = moving.velocity.blocks[cluster].load();
    let zero = S::splat(0.0);
    // Sums of Q_b X, F_b X - 2 x and of X alone, with their weights.
    let (mut stress, mut viscous, mut hourglass) = ([zero; 3], [zero; 3], [zero; 3]);
    let (mut first, mut second) = ([zero; 3], [zero; 3]);
    for (n, lanes) in list.of(cluster) {
        let place = &place.blocks[n];
        let (position, velocity) = (&moving.position.blocks[n], &moving.velocity.blocks[n]);
        let (f, q) = (&moving.deformation.blocks[n], &moving.flux.blocks[n]);
        for l in Lanes(lanes) {
            let pair = Pair::new(&own, place, l);
            let [weight, damper] = pair.weights();
            let stiffness = damper * pair.radius;
            let g = times(pair.offset, weight);
            let h = times(pair.offset, stiffness);
            let d = minus(x, position, l);
            let approach = dot(minus(v, velocity, l), d).min(zero) * damper;
            let twice = -(stiffness + stiffness);
            for i in 0..3 {
                first[i] = first[i] + g[i];
                second[i] = second[i] + h[i];
                for j in 0..3 {
                    stress[i] = q.broadcast::<S>(3 * i + j, l).mul_add(g[j], stress[i]);
                    hourglass[i] = f.broadcast::<S>(3 * i + j, l).mul_add(h[j], hourglass[i]);
                }
                hourglass[i] = twice.mul_add(d[i], hourglass[i]);
                viscous[i] = approach.mul_add(d[i], viscous[i]);
            }
        }
    }
    let q = apply(&moving.flux.blocks[cluster].load(), first);
    let f = apply(&moving.deformation.blocks[cluster].load(), second);
    let half = S::splat(0.5);
    for i in 0..3 {
        stress[i] = stress[i] + q[i];
        hourglass[i] = (hourglass[i] + f[i]) * half;
    }
    Forces {
        stress,
        viscous,
        hourglass,
    }
}
