//! Deformation gradient and stress of a step, eight particles at a time, in three dimensions.
//!
//! The laws are those of `solid/stress.rs`: dL = (F' - F) ((F' + F)/2)^-1, Kirchhoff trial stress Q tau Q^T + lambda tr(dD) I +
//! 2 mu dD with the exact rotation Q of the midpoint spin, radial return of the Cauchy stress. What is kept is the flux
//! Q = tau F^-T M^-1 that the forces need; the stress is taken back from it: tau = Q M F^T.

use super::super::return_in_lanes::{Trial, YieldStress};
use super::super::stress::Failure;
use super::blocks::{Block, Blocks};
use super::lanes::{
    AT, Matrix, Symmetric, Vector, cofactors, determinant, full, product, rotated,
    symmetric_product, times, transposed, von_mises,
};
use super::{Reference, TASK, sums};
use crate::simd::{LANES, Simd, Task};
use erode_physics::material_point::Material;
use erode_physics::return_mapping::radial_return;

/// What the update changes, of the clusters of one task.
pub(super) struct Fields<'a> {
    pub(super) deformation: &'a mut [Block<9>],
    pub(super) flux: &'a mut [Block<9>],
    pub(super) plastic_strain: &'a mut [Block<1>],
    pub(super) plastic_strain_rate: &'a mut [Block<1>],
    pub(super) plastic_work: &'a mut [Block<1>],
}

/// What it needs besides.
pub(super) struct Laws<'a> {
    pub(super) material: &'a Material,
    pub(super) yields: Option<YieldStress>,
    pub(super) dt: f64,
}

/// The update of one task; the failure of its first particle that fails.
pub(super) struct Update<'a> {
    pub(super) reference: &'a Reference,
    pub(super) position: &'a Blocks<3>,
    pub(super) laws: &'a Laws<'a>,
    pub(super) task: usize,
    pub(super) fields: Fields<'a>,
}

impl Task for Update<'_> {
    type Output = Option<(usize, Failure)>;

    #[inline(always)]
    fn run<S: Simd>(mut self) -> Self::Output {
        let mut failed = None;
        for k in 0..self.fields.deformation.len() {
            let cluster = self.task * TASK + k;
            let failure = self.cluster::<S>(k, cluster);
            let failure = failure.map(|(lane, why)| (cluster * LANES + lane, why));
            failed = failed.or(failure);
        }
        failed
    }
}

impl Update<'_> {
    #[inline(always)]
    fn cluster<S: Simd>(&mut self, k: usize, cluster: usize) -> Option<(usize, Failure)> {
        let r = self.reference;
        let sum: Matrix<S> = sums::gradient(&r.list, &r.place, self.position, cluster);
        let m = full(&r.moment.blocks[cluster].load::<S>());
        let cofactors_m = cofactors(&m);
        let inverse_m = S::splat(1.0) / determinant(&m, &cofactors_m);
        let new = product(&times(sum, r.pair_factor::<S>(cluster)), &cofactors_m);
        let new = times(new, inverse_m);
        let old: Matrix<S> = self.fields.deformation[k].load();
        let flux: Matrix<S> = self.fields.flux[k].load();
        let tau = symmetric_product(&product(&flux, &m), &old);
        let cofactors_f = cofactors(&new);
        let j = determinant(&new, &cofactors_f);
        let point = Point {
            tau: trial(&tau, &old, &new, self.laws.material),
            j,
        };
        let count = LANES.min(self.position.len() - cluster * LANES);
        let (tau, failure) = point.returned(&mut self.fields, k, self.laws, count);
        let gradient = product(&cofactors_f, &cofactors_m);
        let flux = product(&full(&tau), &gradient);
        self.fields.deformation[k].store(new);
        self.fields.flux[k].store(times(flux, inverse_m / j));
        failure
    }
}

/// Kirchhoff stress of a step without plastic flow.
#[inline(always)]
fn trial<S: Simd>(
    tau: &Symmetric<S>,
    old: &Matrix<S>,
    new: &Matrix<S>,
    material: &Material,
) -> Symmetric<S> {
    let half = S::splat(0.5);
    let (mut change, mut mean) = (*new, *new);
    for i in 0..9 {
        change[i] = new[i] - old[i];
        mean[i] = half * (new[i] + old[i]);
    }
    let cofactors = cofactors(&mean);
    let inverse = S::splat(1.0) / determinant(&mean, &cofactors);
    let l = times(product(&change, &transposed(&cofactors)), inverse);
    let spin: Vector<S> = [
        half * (l[7] - l[5]),
        half * (l[2] - l[6]),
        half * (l[3] - l[1]),
    ];
    let mut tau = rotated(tau, spin);
    let elastic = &material.elastic;
    let mu = S::splat(elastic.shear_modulus());
    let pressure = S::splat(elastic.lame_lambda()) * (l[0] + l[4] + l[8]);
    for i in 0..3 {
        tau[i] = tau[i] + pressure;
        for j in i..3 {
            // 2 mu D = mu (L + L^T).
            let d = l[3 * i + j] + l[3 * j + i];
            tau[AT[i][j]] = mu.mul_add(d, tau[AT[i][j]]);
        }
    }
    tau
}

/// Eight points with their trial stress.
struct Point<S> {
    tau: Symmetric<S>,
    j: S,
}

impl<S: Simd> Point<S> {
    /// Stress after the return; books the plastic flow.
    #[inline(always)]
    fn returned(
        &self,
        f: &mut Fields,
        k: usize,
        laws: &Laws,
        count: usize,
    ) -> (Symmetric<S>, Option<(usize, Failure)>) {
        let (zero, one) = (S::splat(0.0), S::splat(1.0));
        let mean = (self.tau[0] + self.tau[1] + self.tau[2]) * S::splat(1.0 / 3.0);
        let mut tau = self.tau;
        for normal in &mut tau[..3] {
            *normal = *normal - mean;
        }
        let per_j = one / self.j;
        let size = von_mises(&tau) * per_j;
        let (dt, [strain], [rate], [work]) = (
            S::splat(laws.dt),
            f.plastic_strain[k].load::<S>(),
            f.plastic_strain_rate[k].load::<S>(),
            f.plastic_work[k].load::<S>(),
        );
        let asked = Trial {
            stress: size,
            plastic_strain: strain,
            last_increment: rate * dt,
            softening: softening(laws.material, &f.plastic_work[k]),
            shear_modulus: S::splat(laws.material.elastic.shear_modulus()) * per_j,
            dt,
        };
        let found = asked.solve(laws.yields.as_ref());
        let [mut increment, mut stress] = [found.increment, found.stress];
        let mut failure = inverted(zero.lt(self.j), self.j, count);
        if found.unsolved != 0 && failure.is_none() {
            let lanes = [size, strain, asked.shear_modulus];
            let mut results = [increment.store(), stress.store()];
            let heat = temperatures(laws.material, &f.plastic_work[k]);
            failure = alone(laws, lanes, heat, found.unsolved, count, &mut results);
            [increment, stress] = [S::load(&results[0]), S::load(&results[1])];
        }
        let scale = S::select(zero.lt(increment), stress / size, one);
        f.plastic_strain[k].store([strain + increment]);
        f.plastic_strain_rate[k].store([increment / dt]);
        f.plastic_work[k].store([(stress * increment).mul_add(self.j, work)]);
        let mut tau = times(tau, scale);
        for normal in &mut tau[..3] {
            *normal = *normal + mean;
        }
        (tau, failure)
    }
}

/// The first particle whose volume ratio is not positive.
#[inline(always)]
fn inverted<S: Simd>(positive: S::Mask, j: S, count: usize) -> Option<(usize, Failure)> {
    let lane = S::bits(positive).trailing_ones() as usize;
    (lane < count).then(|| (lane, Failure::Inverted(j.store()[lane])))
}

/// Temperature, K: plastic work heats without conduction.
fn temperatures(material: &Material, work: &Block<1>) -> [f64; LANES] {
    let heating = |w: f64| match material.strength.thermal() {
        Some(t) => t.heating(w, material.density),
        None => 0.0,
    };
    work.0[0].map(|w| material.temperature + heating(w))
}

#[inline(always)]
fn softening<S: Simd>(material: &Material, work: &Block<1>) -> S {
    match material.strength.thermal() {
        None => S::splat(1.0),
        Some(t) => S::load(&temperatures(material, work).map(|heat| t.factor(heat))),
    }
}

/// Plastic increments and stresses of particles that the lanes did not solve, by the scalar solver.
#[cold]
fn alone<S: Simd>(
    laws: &Laws,
    lanes: [S; 3],
    heat: [f64; LANES],
    unsolved: u8,
    count: usize,
    results: &mut [[f64; LANES]; 2],
) -> Option<(usize, Failure)> {
    let [size, strain, shear_modulus] = lanes.map(S::store);
    for l in (0..LANES).filter(|l| unsolved >> l & 1 == 1) {
        let strength = &laws.material.strength;
        match radial_return(
            size[l],
            strain[l],
            laws.dt,
            heat[l],
            shear_modulus[l],
            strength,
        ) {
            Ok(found) => (results[0][l], results[1][l]) = (found.increment, found.yield_stress),
            Err(_) if l >= count => {}
            Err(why) => return Some((l, Failure::Return(why))),
        }
    }
    None
}
