//! The stress update of a step at each particle, eight at a time; the formulas stand in `stress.rs`.

use super::layers::Layers;
use super::mat2::Mat2;
use super::return_in_lanes::{Returned, Trial, YieldStress};
use super::stress::{Failure, advanced, summed};
use super::{Formulation, Solid};
use crate::geometry::Geometry;
use crate::simd::{self, LANES, Simd, Task};
use erode_physics::Sym3;
use erode_physics::damage::{Damage, PlasticStep};
use erode_physics::material_point::Material;
use erode_physics::return_mapping::radial_return;
use rayon::prelude::*;

/// Particles per task: large enough to hide the cost of a task; a multiple of the lanes.
const TASK: usize = 32 * LANES;

/// What the update changes, of the particles of one task.
struct Fields<'a> {
    deformation: &'a mut [Mat2],
    hoop_stretch: &'a mut [f64],
    stress: &'a mut [Sym3],
    von_mises: &'a mut [f64],
    plastic_strain: &'a mut [f64],
    plastic_strain_rate: &'a mut [f64],
    plastic_work: &'a mut [f64],
    temperature: &'a mut [f64],
    damage: &'a mut [f64],
    damage_work: &'a mut [f64],
}

/// What it needs besides.
struct Laws<'a> {
    /// Of the body, then of its layers.
    laws: Vec<Law<'a>>,
    layers: &'a Layers,
    removed: &'a [f64],
    /// Volume here over volume in the first configuration.
    first: &'a [f64],
    dt: f64,
}

/// What one material does.
struct Law<'a> {
    material: &'a Material,
    yields: Option<YieldStress>,
    damage: &'a Damage,
}

impl<'a> Law<'a> {
    fn of(material: &'a Material, damage: &'a Damage) -> Self {
        Self {
            material,
            yields: YieldStress::of(&material.strength),
            damage,
        }
    }
}

impl Solid {
    /// Updates all particles; the failure of the one with the smallest index.
    pub(super) fn update_points(&mut self, dt: f64) -> Option<(usize, Failure)> {
        let (reference, scratch) = (&self.reference, &self.scratch);
        let (form, rates) = (self.numerics.formulation, &self.present.gradient);
        let axisymmetric = self.geometry == Geometry::Axisymmetric;
        let s = &mut self.state;
        let place = &s.position;
        let layers = self.layers.list().iter();
        let laws = Laws {
            laws: std::iter::once(Law::of(&self.material, &self.damage))
                .chain(layers.map(|l| Law::of(&l.material, &l.damage)))
                .collect(),
            layers: &self.layers,
            removed: &s.removed,
            first: &reference.volume_ratio,
            dt,
        };
        let hoop = |a: usize| {
            if axisymmetric {
                place[a][0] / reference.position[a][0]
            } else {
                1.0
            }
        };
        let gradient = |a: usize, old: &Mat2| match form {
            Formulation::TotalLagrangian => summed(reference, &scratch.gradients, a),
            Formulation::Joshi(_) => advanced(old, &rates[a], dt),
        };
        let tasks = (
            s.deformation.par_chunks_mut(TASK),
            s.hoop_stretch.par_chunks_mut(TASK),
            s.stress.par_chunks_mut(TASK),
            s.von_mises.par_chunks_mut(TASK),
            s.plastic_strain.par_chunks_mut(TASK),
            s.plastic_strain_rate.par_chunks_mut(TASK),
            s.plastic_work.par_chunks_mut(TASK),
            s.temperature.par_chunks_mut(TASK),
            s.damage.par_chunks_mut(TASK),
            s.damage_work.par_chunks_mut(TASK),
        );
        let failures = tasks.into_par_iter().enumerate().filter_map(|(task, f)| {
            let fields = Fields {
                deformation: f.0,
                hoop_stretch: f.1,
                stress: f.2,
                von_mises: f.3,
                plastic_strain: f.4,
                plastic_strain_rate: f.5,
                plastic_work: f.6,
                temperature: f.7,
                damage: f.8,
                damage_work: f.9,
            };
            simd::run(Update {
                fields,
                laws: &laws,
                first: task * TASK,
                gradient: &gradient,
                hoop: &hoop,
            })
        });
        failures.min_by_key(|(a, _)| *a)
    }
}

struct Update<'a, G, H> {
    fields: Fields<'a>,
    laws: &'a Laws<'a>,
    first: usize,
    gradient: &'a G,
    hoop: &'a H,
}

impl<G, H> Task for Update<'_, G, H>
where
    G: Fn(usize, &Mat2) -> Mat2,
    H: Fn(usize) -> f64,
{
    type Output = Option<(usize, Failure)>;

    #[inline(always)]
    fn run<S: Simd>(mut self) -> Self::Output {
        let mut failed = None;
        let count = self.fields.hoop_stretch.len();
        for start in (0..count).step_by(LANES) {
            let eight = Eight {
                start,
                count: LANES.min(count - start),
                first: self.first,
            };
            let mut new = [[0.0; LANES]; 5];
            for l in 0..eight.count {
                let a = eight.particle(l);
                let f = (self.gradient)(a, &self.fields.deformation[start + l]);
                let cells = [f[0][0], f[0][1], f[1][0], f[1][1], (self.hoop)(a)];
                for (new, cell) in new.iter_mut().zip(cells) {
                    new[l] = cell;
                }
            }
            let found = eight.update_all::<S>(&mut self.fields, self.laws, &new);
            failed = failed.or(found);
        }
        failed
    }
}

/// Eight neighbouring particles of a task; fewer at the end.
#[derive(Clone, Copy)]
struct Eight {
    /// Index in the task.
    start: usize,
    count: usize,
    /// First particle of the task.
    first: usize,
}

/// Plane and hoop parts of a deformation gradient: xx, xy, yx, yy, hoop.
struct Stretch<S>([S; 5]);

impl<S: Simd> Stretch<S> {
    #[inline(always)]
    fn volume_ratio(&self, first: S) -> S {
        let [a, b, c, d, hoop] = self.0;
        a.mul_add(d, -(b * c)) * hoop * first
    }
}

/// In-plane and hoop components xx, yy, zz, xy of a symmetric tensor.
type Plane<S> = [S; 4];

/// Strain and spin of a step from one stretch to the next.
#[inline(always)]
fn increment<S: Simd>(old: &Stretch<S>, new: &Stretch<S>) -> (Plane<S>, S) {
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
fn times<S: Simd>(t: Plane<S>, factor: S) -> Plane<S> {
    [t[0] * factor, t[1] * factor, t[2] * factor, t[3] * factor]
}

/// Q A Q^T as in [`Sym3::rotated_by_spin`], times a factor.
#[inline(always)]
fn rotated<S: Simd>(stress: Plane<S>, spin: S, factor: S) -> Plane<S> {
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
fn with_elastic<S: Simd>(stress: Plane<S>, strain: Plane<S>, lambda: f64, mu: f64) -> Plane<S> {
    let two_mu = S::splat(2.0 * mu);
    let pressure = S::splat(lambda) * (strain[0] + strain[1] + strain[2]);
    [
        two_mu.mul_add(strain[0], stress[0] + pressure),
        two_mu.mul_add(strain[1], stress[1] + pressure),
        two_mu.mul_add(strain[2], stress[2] + pressure),
        two_mu.mul_add(strain[3], stress[3]),
    ]
}

impl Eight {
    fn particle(&self, lane: usize) -> usize {
        self.first + self.start + lane
    }

    /// One number of each particle; the last one's again where there are fewer.
    #[inline(always)]
    fn lanes<S: Simd>(&self, of: impl Fn(usize) -> f64) -> S {
        let mut x = [0.0; LANES];
        for (l, x) in x.iter_mut().enumerate() {
            *x = of(self.start + l.min(self.count - 1));
        }
        S::load(&x)
    }

    /// Stress, plastic flow and damage of these particles; the first failure.
    ///
    /// Each of their materials takes all eight and keeps the results of its own particles: no particle's result depends on
    /// who stands beside it.
    #[inline(always)]
    fn update_all<S: Simd>(
        &self,
        f: &mut Fields,
        laws: &Laws,
        new: &[[f64; LANES]; 5],
    ) -> Option<(usize, Failure)> {
        if laws.laws.len() == 1 {
            return self.update::<S>(f, laws, 0, new);
        }
        let mut failed: Option<(usize, Failure)> = None;
        for layer in 0..laws.laws.len() {
            if (0..self.count).any(|l| laws.layers.index(self.particle(l)) == layer)
                && let Some(found) = self.update::<S>(f, laws, layer, new)
                && failed.as_ref().is_none_or(|(a, _)| found.0 < *a)
            {
                failed = Some(found);
            }
        }
        failed
    }

    /// The same for the particles of one material.
    #[inline(always)]
    fn update<S: Simd>(
        &self,
        f: &mut Fields,
        laws: &Laws,
        layer: usize,
        new: &[[f64; LANES]; 5],
    ) -> Option<(usize, Failure)> {
        let one = S::splat(1.0);
        let law = &laws.laws[layer];
        let elastic = &law.material.elastic;
        let old = Stretch([
            self.lanes(|i| f.deformation[i][0][0]),
            self.lanes(|i| f.deformation[i][0][1]),
            self.lanes(|i| f.deformation[i][1][0]),
            self.lanes(|i| f.deformation[i][1][1]),
            self.lanes::<S>(|i| f.hoop_stretch[i]),
        ]);
        let next = Stretch([
            S::load(&new[0]),
            S::load(&new[1]),
            S::load(&new[2]),
            S::load(&new[3]),
            S::load(&new[4]),
        ]);
        let first = self.lanes(|i| laws.first[self.first + i]);
        let (old_j, j) = (old.volume_ratio(first), next.volume_ratio(first));
        let (strain, spin) = increment(&old, &next);
        let sound: S = self.lanes(|i| law.damage.integrity(f.damage[i]));
        let stress = [
            self.lanes(|i| f.stress[i].xx),
            self.lanes(|i| f.stress[i].yy),
            self.lanes(|i| f.stress[i].zz),
            self.lanes(|i| f.stress[i].xy),
        ];
        let (lambda, mu) = (elastic.lame_lambda(), elastic.shear_modulus());
        let kirchhoff = with_elastic(rotated(stress, spin, old_j / sound), strain, lambda, mu);
        let per_j = one / j;
        let trial = times(kirchhoff, per_j);
        let mean = (trial[0] + trial[1] + trial[2]) * S::splat(1.0 / 3.0);
        let dev = [trial[0] - mean, trial[1] - mean, trial[2] - mean, trial[3]];
        let square = dev[0].mul_add(dev[0], dev[1].mul_add(dev[1], dev[2] * dev[2]));
        let square = (dev[3] + dev[3]).mul_add(dev[3], square);
        let size = (S::splat(1.5) * square).sqrt();
        let dt = S::splat(laws.dt);
        let returned = Trial {
            stress: size,
            plastic_strain: self.lanes(|i| f.plastic_strain[i]),
            last_increment: self.lanes::<S>(|i| f.plastic_strain_rate[i]) * dt,
            softening: self.softening(f, law),
            shear_modulus: S::splat(mu) * per_j,
            dt,
        }
        .solve(law.yields.as_ref());
        let plastic = S::splat(0.0).lt(returned.increment);
        let scale = S::select(plastic, returned.stress / size, one);
        let point = Found {
            scale: scale.store(),
            rate: (returned.increment / dt).store(),
            mean: mean.store(),
            deviator: [
                dev[0].store(),
                dev[1].store(),
                dev[2].store(),
                dev[3].store(),
            ],
            trial: size.store(),
            volume_ratio: j.store(),
            increment: returned.increment.store(),
            stress: returned.stress.store(),
        };
        self.keep(f, laws, layer, new, &point, &returned)
    }

    #[inline(always)]
    fn softening<S: Simd>(&self, f: &Fields, law: &Law) -> S {
        match law.material.strength.thermal() {
            None => S::splat(1.0),
            Some(t) => self.lanes(|i| t.factor(f.temperature[i])),
        }
    }

    /// Writes the results of all particles of a layer that are still in the body.
    #[inline(always)]
    fn keep<S: Simd>(
        &self,
        f: &mut Fields,
        laws: &Laws,
        layer: usize,
        new: &[[f64; LANES]; 5],
        point: &Found,
        returned: &Returned<S>,
    ) -> Option<(usize, Failure)> {
        let law = &laws.laws[layer];
        for (l, i) in (self.start..self.start + self.count).enumerate() {
            let a = self.first + i;
            if laws.removed[a] != 0.0 || laws.layers.index(a) != layer {
                continue;
            }
            let j = point.volume_ratio[l];
            if j.is_nan() || j <= 0.0 {
                return Some((a, Failure::Inverted(j)));
            }
            let mut flow = Flow {
                increment: point.increment[l],
                rate: point.rate[l],
                von_mises: point.stress[l],
                scale: point.scale[l],
            };
            if returned.unsolved >> l & 1 == 1 {
                match solve_alone(f, law, laws.dt, i, (point.trial[l], j)) {
                    Ok(found) => flow = found,
                    Err(failure) => return Some((a, failure)),
                }
            }
            f.deformation[i] = [[new[0][l], new[1][l]], [new[2][l], new[3][l]]];
            f.hoop_stretch[i] = new[4][l];
            point.flow(f, law, (i, l), flow);
        }
        None
    }
}

/// Plastic flow of one particle.
#[derive(Clone, Copy)]
struct Flow {
    increment: f64,
    rate: f64,
    von_mises: f64,
    /// Of the deviator of the trial stress.
    scale: f64,
}

/// Flow of one particle by the scalar solver.
#[cold]
fn solve_alone(
    f: &Fields,
    law: &Law,
    dt: f64,
    i: usize,
    (trial, j): (f64, f64),
) -> Result<Flow, Failure> {
    let shear_modulus = law.material.elastic.shear_modulus() / j;
    let strength = &law.material.strength;
    let (strain, heat) = (f.plastic_strain[i], f.temperature[i]);
    let found = radial_return(trial, strain, dt, heat, shear_modulus, strength);
    let found = found.map_err(Failure::Return)?;
    let plastic = found.increment > 0.0;
    Ok(Flow {
        increment: found.increment,
        rate: found.increment / dt,
        von_mises: found.yield_stress,
        scale: if plastic {
            found.yield_stress / trial
        } else {
            1.0
        },
    })
}

/// What the lanes found for eight particles.
struct Found {
    mean: [f64; LANES],
    /// xx, yy, zz, xy of the deviator of the trial stress.
    deviator: [[f64; LANES]; 4],
    /// Its von Mises norm.
    trial: [f64; LANES],
    /// See [`Flow`].
    scale: [f64; LANES],
    rate: [f64; LANES],
    volume_ratio: [f64; LANES],
    increment: [f64; LANES],
    stress: [f64; LANES],
}

impl Found {
    /// Books the plastic flow of one particle (index in the task, lane), and its damage.
    #[inline(always)]
    fn flow(&self, f: &mut Fields, law: &Law, (i, l): (usize, usize), flow: Flow) {
        let (increment, von_mises) = (flow.increment, flow.von_mises);
        let [xx, yy, zz, xy] = self.deviator.map(|d| d[l] * flow.scale);
        let stress = Sym3 {
            xx: self.mean[l] + xx,
            yy: self.mean[l] + yy,
            zz: self.mean[l] + zz,
            xy,
            ..Sym3::ZERO
        };
        let j = self.volume_ratio[l];
        f.plastic_strain_rate[i] = flow.rate;
        let sound = law.damage.integrity(f.damage[i]);
        if increment > 0.0 {
            f.damage[i] = law.damage.after(
                f.damage[i],
                PlasticStep {
                    increment,
                    rate: flow.rate,
                    triaxiality: self.mean[l] / von_mises,
                    temperature: f.temperature[i],
                },
            );
            let work = von_mises * increment;
            let mean = 0.5 * (sound + law.damage.integrity(f.damage[i]));
            f.plastic_strain[i] += increment;
            f.plastic_work[i] += mean * work * j;
            if let Some(t) = law.material.strength.thermal() {
                f.temperature[i] += mean * t.heating(work, law.material.density / j);
            }
        }
        let integrity = law.damage.integrity(f.damage[i]);
        f.stress[i] = stress * integrity;
        f.von_mises[i] = von_mises * integrity;
        if integrity != sound {
            let energy = law.material.elastic.energy_density(stress * j);
            f.damage_work[i] += (sound - integrity) * energy;
        }
    }
}
