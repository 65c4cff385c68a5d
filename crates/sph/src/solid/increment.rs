//! Strain and trial stress of a step in lanes; the formulas stand in `stress.rs`.

use super::mat2::Mat2;
use super::reference::Reference;
use super::sums::{self, Field, lanes, matrices, vectors};
use crate::simd::Simd;
use erode_physics::Elastic;

/// Where the new deformation gradient comes from.
#[derive(Clone, Copy)]
pub(super) enum Form<'a> {
    /// From the positions of the neighbours in the reference, mirror images among them.
    Reference(Field<'a>),
    /// From the last one by these velocity gradients over a step (s).
    Present(&'a [Mat2], f64),
}

/// What moves the particles.
#[derive(Clone, Copy)]
pub(super) struct Motion<'a> {
    pub(super) form: Form<'a>,
    pub(super) reference: &'a Reference,
    /// Radii now and in the reference, in axisymmetry.
    pub(super) radius: Option<[&'a [[f64; 2]]; 2]>,
}

impl Motion<'_> {
    /// Stretch of a cluster at the present positions.
    #[inline(always)]
    pub(super) fn stretch<S: Simd>(&self, cluster: usize, old: &Stretch<S>) -> Stretch<S> {
        let [xx, xy, yx, yy] = match self.form {
            Form::Reference(position) => {
                let reference = self.reference;
                let m = sums::gradient(&reference.pairs, &position, cluster);
                product(m, reference.own.strain[cluster].load())
            }
            Form::Present(rates, dt) => advanced(old, matrices(rates, cluster), dt),
        };
        let hoop = match self.radius {
            None => S::splat(1.0),
            Some([now, first]) => vectors::<S>(now, cluster)[0] / vectors::<S>(first, cluster)[0],
        };
        Stretch([xx, xy, yx, yy, hoop])
    }
}

#[inline(always)]
pub(super) fn product<S: Simd>(a: [S; 4], b: [S; 4]) -> [S; 4] {
    [
        a[0].mul_add(b[0], a[1] * b[2]),
        a[0].mul_add(b[1], a[1] * b[3]),
        a[2].mul_add(b[0], a[3] * b[2]),
        a[2].mul_add(b[1], a[3] * b[3]),
    ]
}

/// Deformation gradient after `dt` with velocity gradient l: (I - l dt/2) F' = (I + l dt/2) F, for which the strain and spin
/// of [`increment`] are those of l dt exactly.
#[inline(always)]
fn advanced<S: Simd>(old: &Stretch<S>, l: [S; 4], dt: f64) -> [S; 4] {
    let (one, half) = (S::splat(1.0), S::splat(0.5 * dt));
    let [a, b, c, d] = [half * l[0], half * l[1], half * l[2], half * l[3]];
    let inverse = one / (one - a).mul_add(one - d, -(b * c));
    let [xx, xy, yx, yy, _] = old.0;
    let forward = product([one + a, b, c, one + d], [xx, xy, yx, yy]);
    let m = product([one - d, b, c, one - a], forward);
    [
        m[0] * inverse,
        m[1] * inverse,
        m[2] * inverse,
        m[3] * inverse,
    ]
}

/// Plane and hoop parts of a deformation gradient: xx, xy, yx, yy, hoop.
pub(super) struct Stretch<S>(pub(super) [S; 5]);

impl<S: Simd> Stretch<S> {
    /// Of the particles of a cluster, from their arrays.
    #[inline(always)]
    pub(super) fn load(plane: &[Mat2], hoop: &[f64], cluster: usize) -> Self {
        let [xx, xy, yx, yy] = matrices(plane, cluster);
        let (own, count) = sums::eight(hoop, cluster);
        Self([xx, xy, yx, yy, lanes(0, count, |l| own[l])])
    }

    #[inline(always)]
    pub(super) fn volume_ratio(&self, first: S) -> S {
        let [a, b, c, d, hoop] = self.0;
        a.mul_add(d, -(b * c)) * hoop * first
    }
}

/// In-plane and hoop components xx, yy, zz, xy of a symmetric tensor.
pub(super) type Plane<S> = [S; 4];

/// Strain and spin of a step from one stretch to the next.
#[inline(always)]
pub(super) fn increment<S: Simd>(old: &Stretch<S>, new: &Stretch<S>) -> (Plane<S>, S) {
    let half = S::splat(0.5);
    let [mut d, mut m] = [[half; 4]; 2];
    for i in 0..4 {
        d[i] = new.0[i] - old.0[i];
        m[i] = half * (new.0[i] + old.0[i]);
    }
    let inverse = S::splat(1.0) / m[0].mul_add(m[3], -(m[1] * m[2]));
    // (F' - F) times the inverse of the mean.
    let cell = |x: S, p: S, y: S, q: S| x.mul_add(p, -(y * q)) * inverse;
    let xx = cell(d[0], m[3], d[1], m[2]);
    let xy = cell(d[1], m[0], d[0], m[1]);
    let yx = cell(d[2], m[3], d[3], m[2]);
    let yy = cell(d[3], m[0], d[2], m[1]);
    let (h, h_old) = (new.0[4], old.0[4]);
    let hoop = S::splat(2.0) * (h - h_old) / (h + h_old);
    ([xx, yy, hoop, half * (xy + yx)], half * (xy - yx))
}

#[inline(always)]
pub(super) fn times<S: Simd>(t: Plane<S>, factor: S) -> Plane<S> {
    [t[0] * factor, t[1] * factor, t[2] * factor, t[3] * factor]
}

/// Q A Q^T as in [`erode_physics::Sym3::rotated_by_spin`], times a factor.
#[inline(always)]
pub(super) fn rotated<S: Simd>(stress: Plane<S>, spin: S, factor: S) -> Plane<S> {
    let one = S::splat(1.0);
    let half = S::splat(0.5) * spin;
    let square = half * half;
    let scale = one / (one + square);
    let (c, s) = ((one - square) * scale, (half + half) * scale);
    let (cc, ss, cs) = (c * c, s * s, c * s);
    let [xx, yy, zz, xy] = times(stress, factor);
    let twice = (cs + cs) * xy;
    [
        cc.mul_add(xx, ss.mul_add(yy, twice)),
        ss.mul_add(xx, cc.mul_add(yy, -twice)),
        zz,
        cs.mul_add(yy - xx, (cc - ss) * xy),
    ]
}

/// Adds lambda tr(e) I + 2 mu e.
#[inline(always)]
pub(super) fn with_elastic<S: Simd>(
    stress: Plane<S>,
    strain: Plane<S>,
    elastic: &Elastic,
) -> Plane<S> {
    let two_mu = S::splat(2.0 * elastic.shear_modulus());
    let pressure = S::splat(elastic.lame_lambda()) * (strain[0] + strain[1] + strain[2]);
    [
        two_mu.mul_add(strain[0], stress[0] + pressure),
        two_mu.mul_add(strain[1], stress[1] + pressure),
        two_mu.mul_add(strain[2], stress[2] + pressure),
        two_mu.mul_add(strain[3], stress[3]),
    ]
}
