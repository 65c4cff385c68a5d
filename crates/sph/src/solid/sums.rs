//! The two sums over stored pairs, eight particles at a time (what is stored: `pairs.rs`; the formulas: `stress.rs`, `force.rs`).
//!
//! What depends on the particle itself alone is taken out of the sums where nothing is lost by it (`own.rs`).

use super::mat2::Mat2;
use super::pairs::Pairs;
use crate::geometry::Vec2;
use crate::simd::{LANES, Simd};
use std::ops::Range;

/// A vector known at particles and at mirror images.
#[derive(Debug, Clone, Copy)]
pub(super) struct Field<'a> {
    pub(super) particles: &'a [Vec2],
    pub(super) images: &'a [Vec2],
}

impl Field<'_> {
    /// At a particle or, counted on, an image.
    pub(super) fn at(&self, b: usize) -> Vec2 {
        match b.checked_sub(self.particles.len()) {
            None => self.particles[b],
            Some(image) => self.images[image],
        }
    }
}

/// What moves, of particles or of images.
#[derive(Debug, Clone, Copy)]
pub(super) struct Moving<'a> {
    /// Position, m.
    pub(super) position: &'a [Vec2],
    /// Velocity, m/s.
    pub(super) velocity: &'a [Vec2],
    /// Deformation gradient.
    pub(super) deformation: &'a [Mat2],
    /// Q = R P L.
    pub(super) flux: &'a [Mat2],
}

// In lanes arrays are written out: what `map` calls may stay outside of the instructions that `simd::run` turns on.

/// One number of each particle of a cluster of `count`; the last one's again where there are fewer than eight.
#[inline(always)]
pub(super) fn lanes<S: Simd>(cluster: usize, count: usize, of: impl Fn(usize) -> f64) -> S {
    let mut x = [0.0; LANES];
    let first = cluster * LANES;
    for (l, x) in x.iter_mut().enumerate() {
        *x = of(first + if count == LANES { l } else { l.min(count - 1) });
    }
    S::load(&x)
}

/// Vectors of the particles of a cluster.
#[inline(always)]
pub(super) fn vectors<S: Simd>(all: &[Vec2], cluster: usize) -> [S; 2] {
    let (own, count) = eight(all, cluster);
    [
        lanes(0, count, |a| own[a][0]),
        lanes(0, count, |a| own[a][1]),
    ]
}

/// Matrices of the particles of a cluster, rows first.
#[inline(always)]
pub(super) fn matrices<S: Simd>(all: &[Mat2], cluster: usize) -> [S; 4] {
    let (own, count) = eight(all, cluster);
    [
        lanes(0, count, |a| own[a][0][0]),
        lanes(0, count, |a| own[a][0][1]),
        lanes(0, count, |a| own[a][1][0]),
        lanes(0, count, |a| own[a][1][1]),
    ]
}

/// The particles of a cluster and their number.
#[inline(always)]
pub(super) fn eight<T>(all: &[T], cluster: usize) -> (&[T], usize) {
    let own = &all[cluster * LANES..];
    let count = own.len().min(LANES);
    (&own[..count], count)
}

#[inline(always)]
fn minus<S: Simd>(own: [S; 2], other: Vec2) -> [S; 2] {
    [own[0] - S::splat(other[0]), own[1] - S::splat(other[1])]
}

#[inline(always)]
fn times<S: Simd>(v: [S; 2], factor: S) -> [S; 2] {
    [v[0] * factor, v[1] * factor]
}

/// A pair in lanes: X_a - X_b, and that times g.
#[inline(always)]
fn offset<S: Simd>(place: [S; 2], other: Vec2, gradient: &[f32; LANES]) -> ([S; 2], [S; 2]) {
    let x = minus(place, other);
    (x, times(x, S::load_single(gradient)))
}

/// sum g (f_b - f_a) (x) X.
#[inline(always)]
pub(super) fn gradient<S: Simd>(pairs: &Pairs, field: &Field, cluster: usize) -> [S; 4] {
    let place = vectors(&pairs.position, cluster);
    let own = vectors(field.particles, cluster);
    let n = field.particles.len();
    let (real, mirrored) = pairs.position.split_at(n);
    let [within, beyond] = pairs.parts(cluster);
    let mut m = [S::splat(0.0); 4];
    add_gradients(
        pairs,
        within,
        (0, real, field.particles),
        (place, own),
        &mut m,
    );
    if !beyond.is_empty() {
        add_gradients(
            pairs,
            beyond,
            (n, mirrored, field.images),
            (place, own),
            &mut m,
        );
    }
    m
}

/// Adds the neighbours at some places in the lists: the first of their kind, their reference positions and field.
#[inline(always)]
fn add_gradients<S: Simd>(
    pairs: &Pairs,
    places: Range<usize>,
    (first, position, field): (usize, &[Vec2], &[Vec2]),
    (place, own): ([S; 2], [S; 2]),
    m: &mut [S; 4],
) {
    let field = &field[..position.len()];
    let neighbours = pairs.neighbours(places.clone());
    for (&b, g) in neighbours.iter().zip(&pairs.gradient[places]) {
        let b = b as usize - first;
        let (_, g) = offset(place, position[b], g);
        let d = [
            S::splat(field[b][0]) - own[0],
            S::splat(field[b][1]) - own[1],
        ];
        m[0] = d[0].mul_add(g[0], m[0]);
        m[1] = d[0].mul_add(g[1], m[1]);
        m[2] = d[1].mul_add(g[0], m[2]);
        m[3] = d[1].mul_add(g[1], m[3]);
    }
}

/// The sums of the force: sum g Q_b X, sum v min(v.x, 0) x, sum e (F_b X - 2 x).
pub(super) struct Forces<S> {
    pub(super) stress: [S; 2],
    pub(super) viscous: [S; 2],
    pub(super) hourglass: [S; 2],
}

/// Particles of a cluster as they are.
struct Own<S> {
    place: [S; 2],
    position: [S; 2],
    velocity: [S; 2],
    /// Viscosity on separation over that on approach.
    separating: S,
}

#[inline(always)]
pub(super) fn forces<S: Simd>(
    pairs: &Pairs,
    particles: &Moving,
    images: &Moving,
    cluster: usize,
) -> Forces<S> {
    if pairs.at_edge[cluster] {
        forces_of::<S, true>(pairs, particles, images, cluster)
    } else {
        forces_of::<S, false>(pairs, particles, images, cluster)
    }
}

#[inline(always)]
fn forces_of<S: Simd, const EDGE: bool>(
    pairs: &Pairs,
    particles: &Moving,
    images: &Moving,
    cluster: usize,
) -> Forces<S> {
    let n = particles.position.len();
    let (_, count) = eight(particles.position, cluster);
    let own = Own {
        place: vectors(&pairs.position, cluster),
        position: vectors(particles.position, cluster),
        velocity: vectors(particles.velocity, cluster),
        separating: lanes(cluster, count, |a| pairs.separating[a]),
    };
    let zero = [S::splat(0.0); 2];
    let mut sums = Forces {
        stress: zero,
        viscous: zero,
        hourglass: zero,
    };
    let [within, beyond] = pairs.parts(cluster);
    add_forces::<S, EDGE>(pairs, within, (0, particles), &own, &mut sums);
    if !beyond.is_empty() {
        add_forces::<S, EDGE>(pairs, beyond, (n, images), &own, &mut sums);
    }
    sums
}

/// Adds the neighbours at some places in the lists, particles or images, the first of which is given.
#[inline(always)]
fn add_forces<S: Simd, const EDGE: bool>(
    pairs: &Pairs,
    places: Range<usize>,
    (first, others): (usize, &Moving),
    own: &Own<S>,
    sums: &mut Forces<S>,
) {
    let n = others.position.len();
    let (position, velocity) = (others.position, &others.velocity[..n]);
    let (deformation, flux) = (&others.deformation[..n], &others.flux[..n]);
    let place = &pairs.position[first..][..n];
    let separating = &pairs.separating[first..][..n];
    let (zero, one, two) = (S::splat(0.0), S::splat(1.0), S::splat(2.0));
    let stored = (pairs.gradient[places.clone()].iter()).zip(&pairs.stabilisers[places.clone()]);
    for (&b, (g, [viscous, stiffness])) in pairs.neighbours(places).iter().zip(stored) {
        let b = b as usize - first;
        let (x, g) = offset(own.place, place[b], g);
        let d = minus(own.position, position[b]);
        let v = minus(own.velocity, velocity[b]);
        let along = v[0].mul_add(d[0], v[1] * d[1]);
        let acting = if EDGE {
            let parting = own.separating.max(S::splat(separating[b]));
            along * S::select(along.lt(zero), one, parting)
        } else {
            along.min(zero)
        };
        let approach = acting * S::load_single(viscous);
        let stiffness = S::load_single(stiffness);
        for i in 0..2 {
            let (q, f) = (flux[b][i], deformation[b][i]);
            sums.stress[i] = g[0].mul_add(S::splat(q[0]), sums.stress[i]);
            sums.stress[i] = g[1].mul_add(S::splat(q[1]), sums.stress[i]);
            sums.viscous[i] = approach.mul_add(d[i], sums.viscous[i]);
            let linear = x[1].mul_add(S::splat(f[1]), d[i] * -two);
            let linear = x[0].mul_add(S::splat(f[0]), linear);
            sums.hourglass[i] = stiffness.mul_add(linear, sums.hourglass[i]);
        }
    }
}
