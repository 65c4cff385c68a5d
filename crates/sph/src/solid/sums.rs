//! The two sums over stored pairs, eight particles at a time (the layout: `pairs.rs`; the formulas: `stress.rs`, `force.rs`).

use super::mat2::Mat2;
use super::pairs::{Entry, Pairs};
use crate::geometry::Vec2;
use crate::simd::{self, LANES, Simd, Task};
use rayon::prelude::*;

/// Clusters per task: large enough to hide the cost of a task.
const CLUSTERS: usize = 32;

/// A 2x2 matrix of each particle of a cluster, rows first.
pub(super) type Matrices = [[f64; LANES]; 4];

/// What moves: one entry per particle, then per mirror image.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Moving {
    /// Position, m.
    pub(super) position: Vec2,
    /// Velocity, m/s.
    pub(super) velocity: Vec2,
    /// Half the deformation gradient.
    pub(super) half_deformation: Mat2,
    /// R P L.
    pub(super) flux: Mat2,
}

/// Sums of the accelerations of a cluster: force of the stress sum_b A_b (R_a P_a L_a + R_b P_b L_b) grad W, then viscous and
/// hourglass acceleration times two densities.
pub(super) type Forces = [[f64; LANES]; 6];

/// sum A_b (f_b - f_a) (x) grad W, without correction, of a field known at particles and mirror images.
pub(super) fn gradients(pairs: &Pairs, field: &[Vec2], result: &mut Vec<Matrices>) {
    result.resize(pairs.clusters(), [[0.0; LANES]; 4]);
    (result.par_chunks_mut(CLUSTERS).enumerate()).for_each(|(task, result)| {
        simd::run(Gradients {
            pairs,
            field,
            first: task * CLUSTERS,
            result,
        });
    });
}

/// The sums of [`Forces`].
pub(super) fn forces(pairs: &Pairs, moving: &[Moving], result: &mut Vec<Forces>) {
    result.resize(pairs.clusters(), [[0.0; LANES]; 6]);
    (result.par_chunks_mut(CLUSTERS).enumerate()).for_each(|(task, result)| {
        simd::run(ForceSums {
            pairs,
            moving,
            first: task * CLUSTERS,
            result,
        });
    });
}

struct Gradients<'a> {
    pairs: &'a Pairs,
    field: &'a [Vec2],
    first: usize,
    result: &'a mut [Matrices],
}

impl Task for Gradients<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        for (k, result) in self.result.iter_mut().enumerate() {
            *result = store(gradient::<S>(self.pairs, self.field, self.first + k));
        }
    }
}

#[inline(always)]
fn gradient<S: Simd>(pairs: &Pairs, field: &[Vec2], cluster: usize) -> [S; 4] {
    let place = place::<S>(pairs, cluster);
    let own: [S; 2] = [
        pairs.lanes(cluster, |a| field[a][0]),
        pairs.lanes(cluster, |a| field[a][1]),
    ];
    let mut m = [S::splat(0.0); 4];
    for entry in pairs.entries(cluster) {
        let (_, gw) = offset_and_gradient(place, &entry);
        let other = field[entry.neighbour];
        let d = [S::splat(other[0]) - own[0], S::splat(other[1]) - own[1]];
        m = [
            d[0].mul_add(gw[0], m[0]),
            d[0].mul_add(gw[1], m[1]),
            d[1].mul_add(gw[0], m[2]),
            d[1].mul_add(gw[1], m[3]),
        ];
    }
    m
}

/// X_a - X_b with A_b (dW/dX)/X^3, and A_b grad_a W.
#[inline(always)]
fn offset_and_gradient<S: Simd>(place: [S; 2], entry: &Entry) -> (([S; 2], S), [S; 2]) {
    let x = minus(place, entry.fixed.position);
    let square = x[0].mul_add(x[0], x[1] * x[1]);
    let cubed = S::load_single(entry.gradient) * S::splat(entry.fixed.area);
    let factor = cubed * square;
    ((x, cubed), [factor * x[0], factor * x[1]])
}

struct ForceSums<'a> {
    pairs: &'a Pairs,
    moving: &'a [Moving],
    first: usize,
    result: &'a mut [Forces],
}

impl Task for ForceSums<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        for (k, result) in self.result.iter_mut().enumerate() {
            *result = store(force::<S>(self.pairs, self.moving, self.first + k));
        }
    }
}

/// What the pairs of a cluster need of its own particles.
struct Own<S> {
    place: [S; 2],
    position: [S; 2],
    velocity: [S; 2],
    half_deformation: [S; 4],
    flux: [S; 4],
    half_length: S,
    edge: S,
    impedance: S,
    stiffness: S,
    /// 1/R.
    inverse_weight: S,
}

impl<S: Simd> Own<S> {
    #[inline(always)]
    fn new(pairs: &Pairs, moving: &[Moving], cluster: usize) -> Self {
        let fixed = &pairs.fixed;
        Self {
            place: place(pairs, cluster),
            position: [
                pairs.lanes(cluster, |a| moving[a].position[0]),
                pairs.lanes(cluster, |a| moving[a].position[1]),
            ],
            velocity: [
                pairs.lanes(cluster, |a| moving[a].velocity[0]),
                pairs.lanes(cluster, |a| moving[a].velocity[1]),
            ],
            half_deformation: matrix(pairs, cluster, |a| &moving[a].half_deformation),
            flux: matrix(pairs, cluster, |a| &moving[a].flux),
            half_length: pairs.lanes(cluster, |a| fixed[a].half_length),
            edge: pairs.lanes(cluster, |a| fixed[a].edge),
            impedance: pairs.lanes(cluster, |a| fixed[a].impedance),
            stiffness: pairs.lanes(cluster, |a| fixed[a].stiffness),
            inverse_weight: S::splat(1.0) / pairs.lanes(cluster, |a| fixed[a].weight),
        }
    }

    /// (1 + R_b/R_a) min(Z_a, Z_b) and the same of the stiffness: twice the weights of the stabilisers.
    #[inline(always)]
    fn weights(&self, entry: &Entry) -> (S, S) {
        let by_ring = S::splat(entry.fixed.weight).mul_add(self.inverse_weight, S::splat(1.0));
        (
            by_ring * self.impedance.min(S::splat(entry.fixed.impedance)),
            by_ring * self.stiffness.min(S::splat(entry.fixed.stiffness)),
        )
    }
}

// In lanes arrays are written out: what `map` calls may stay outside of the instructions that `simd::run` turns on.

/// Reference positions of the particles of a cluster.
#[inline(always)]
fn place<S: Simd>(pairs: &Pairs, cluster: usize) -> [S; 2] {
    [
        pairs.lanes(cluster, |a| pairs.fixed[a].position[0]),
        pairs.lanes(cluster, |a| pairs.fixed[a].position[1]),
    ]
}

/// A matrix of each particle of a cluster, rows first.
#[inline(always)]
fn matrix<'a, S: Simd>(pairs: &Pairs, cluster: usize, of: impl Fn(usize) -> &'a Mat2) -> [S; 4] {
    [
        pairs.lanes(cluster, |a| of(a)[0][0]),
        pairs.lanes(cluster, |a| of(a)[0][1]),
        pairs.lanes(cluster, |a| of(a)[1][0]),
        pairs.lanes(cluster, |a| of(a)[1][1]),
    ]
}

#[inline(always)]
fn minus<S: Simd>(own: [S; 2], other: Vec2) -> [S; 2] {
    [own[0] - S::splat(other[0]), own[1] - S::splat(other[1])]
}

/// A row of the sum of two matrices.
#[inline(always)]
fn plus<S: Simd>(own: &[S; 4], row: usize, other: &Mat2) -> [S; 2] {
    [
        own[2 * row] + S::splat(other[row][0]),
        own[2 * row + 1] + S::splat(other[row][1]),
    ]
}

#[inline(always)]
fn store<S: Simd, const N: usize>(lanes: [S; N]) -> [[f64; LANES]; N] {
    let mut numbers = [[0.0; LANES]; N];
    for (numbers, lanes) in numbers.iter_mut().zip(lanes) {
        *numbers = lanes.store();
    }
    numbers
}

#[inline(always)]
fn force<S: Simd>(pairs: &Pairs, moving: &[Moving], cluster: usize) -> [S; 6] {
    let own = Own::<S>::new(pairs, moving, cluster);
    let viscosity = S::splat(pairs.viscosity);
    let zero = S::splat(0.0);
    let (mut stress, mut viscous, mut hourglass) = ([zero; 2], [zero; 2], [zero; 2]);
    for entry in pairs.entries(cluster) {
        let other = &moving[entry.neighbour];
        let ((x, cubed), gw) = offset_and_gradient(own.place, &entry);
        let d = minus(own.position, other.position);
        let v = minus(own.velocity, other.velocity);
        let (impedance, stiffness) = own.weights(&entry);
        let along = v[0].mul_add(d[0], v[1] * d[1]);
        let edge = own.edge.max(S::splat(entry.fixed.edge));
        let alpha = S::select(along.lt(zero), edge.max(viscosity), edge);
        let length = own.half_length + S::splat(entry.fixed.half_length);
        let approach = alpha * length * (cubed * impedance) * along;
        let stiffness = S::load_single(entry.value) * S::splat(entry.fixed.area) * stiffness;
        for i in 0..2 {
            let q = plus(&own.flux, i, &other.flux);
            let f = plus(&own.half_deformation, i, &other.half_deformation);
            stress[i] = q[0].mul_add(gw[0], q[1].mul_add(gw[1], stress[i]));
            viscous[i] = approach.mul_add(d[i], viscous[i]);
            let linear = f[0].mul_add(x[0], f[1].mul_add(x[1], -d[i]));
            hourglass[i] = stiffness.mul_add(linear, hourglass[i]);
        }
    }
    [
        stress[0],
        stress[1],
        viscous[0],
        viscous[1],
        hourglass[0],
        hourglass[1],
    ]
}
