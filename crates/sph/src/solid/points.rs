//! The stress update of a step at each particle, eight at a time; the formulas stand in `stress.rs`.

use super::flow::{Flow, Found};
use super::increment::{Form, Motion, Stretch, increment, rotated, times, with_elastic};
use super::layers::Layers;
use super::mat2::Mat2;
use super::return_in_lanes::{Trial, YieldStress};
use super::stress::Failure;
use super::sums::{Field, lanes};
use super::{Formulation, Solid};
use crate::geometry::Geometry;
use crate::simd::{self, LANES, Simd, Task};
use erode_physics::Sym3;
use erode_physics::damage::Damage;
use erode_physics::material_point::Material;
use rayon::prelude::*;

/// Particles per task: large enough to hide the cost of a task; a multiple of the lanes.
pub(super) const TASK: usize = 32 * LANES;

/// What the update changes, of the particles of one task.
pub(super) struct Fields<'a> {
    pub(super) deformation: &'a mut [Mat2],
    pub(super) hoop_stretch: &'a mut [f64],
    pub(super) stress: &'a mut [Sym3],
    pub(super) von_mises: &'a mut [f64],
    pub(super) plastic_strain: &'a mut [f64],
    pub(super) plastic_strain_rate: &'a mut [f64],
    pub(super) plastic_work: &'a mut [f64],
    pub(super) temperature: &'a mut [f64],
    pub(super) damage: &'a mut [f64],
    pub(super) damage_work: &'a mut [f64],
}

/// What it needs besides.
pub(super) struct Laws<'a> {
    /// Of the body, then of its layers.
    laws: Vec<Law<'a>>,
    pub(super) layers: &'a Layers,
    pub(super) removed: &'a [f64],
    /// Volume here over volume in the first configuration.
    first: &'a [f64],
    pub(super) dt: f64,
}

/// What one material does.
pub(super) struct Law<'a> {
    pub(super) material: &'a Material,
    yields: Option<YieldStress>,
    pub(super) damage: &'a Damage,
    /// Number of the layer.
    pub(super) layer: usize,
}

impl Law<'_> {
    /// Whether damage takes something off the stress.
    pub(super) fn softens(&self) -> bool {
        matches!(self.damage, Damage::RuptureStrain(law) if law.modulus_loss)
    }
}

impl Solid {
    /// Updates all particles; the failure of the one with the smallest index.
    pub(super) fn update_points(&mut self, dt: f64) -> Option<(usize, Failure)> {
        let reference = &self.reference;
        let s = &mut self.state;
        let motion = Motion {
            form: match self.numerics.formulation {
                Formulation::TotalLagrangian => Form::Reference(Field {
                    particles: &s.position,
                    images: &self.scratch.image_position,
                }),
                Formulation::Joshi(_) => Form::Present(&self.present.gradient, dt),
            },
            reference,
            radius: match self.geometry {
                Geometry::Axisymmetric => Some([&s.position, &reference.position]),
                Geometry::Plane => None,
            },
        };
        let layers = self.layers.list().iter();
        let own = std::iter::once((&self.material, &self.damage));
        let all = own.chain(layers.map(|l| (&l.material, &l.damage)));
        let laws = Laws {
            laws: (all.enumerate())
                .map(|(layer, (material, damage))| Law {
                    material,
                    yields: YieldStress::of(&material.strength),
                    damage,
                    layer,
                })
                .collect(),
            layers: &self.layers,
            removed: &s.removed,
            first: &reference.volume_ratio,
            dt,
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
                motion: &motion,
            })
        });
        failures.min_by_key(|(a, _)| *a)
    }
}

struct Update<'a> {
    fields: Fields<'a>,
    laws: &'a Laws<'a>,
    first: usize,
    motion: &'a Motion<'a>,
}

impl Task for Update<'_> {
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
            let f = &self.fields;
            let old = Stretch::<S>::load(f.deformation, f.hoop_stretch, start / LANES);
            let new = self.motion.stretch((self.first + start) / LANES, &old);
            let found = eight.update_all(&mut self.fields, self.laws, &old, &new);
            failed = failed.or(found);
        }
        failed
    }
}

/// Eight particles of a task that follow each other; fewer at the end.
#[derive(Clone, Copy)]
pub(super) struct Eight {
    /// Index in the task.
    pub(super) start: usize,
    pub(super) count: usize,
    /// First particle of the task.
    first: usize,
}

impl Eight {
    pub(super) fn particle(&self, lane: usize) -> usize {
        self.first + self.start + lane
    }

    /// One number of each particle, by index in the task.
    #[inline(always)]
    fn lanes<S: Simd>(&self, of: impl Fn(usize) -> f64) -> S {
        lanes(self.start / LANES, self.count, of)
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
        old: &Stretch<S>,
        new: &Stretch<S>,
    ) -> Option<(usize, Failure)> {
        let mut failed: Option<(usize, Failure)> = None;
        for law in &laws.laws {
            let concerns = |l: usize| laws.layers.index(self.particle(l)) == law.layer;
            if (laws.laws.len() == 1 || (0..self.count).any(concerns))
                && let Some(found) = self.update::<S>(f, laws, law, old, new)
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
        law: &Law,
        old: &Stretch<S>,
        new: &Stretch<S>,
    ) -> Option<(usize, Failure)> {
        let one = S::splat(1.0);
        let elastic = &law.material.elastic;
        let first = self.lanes(|i| laws.first[self.first + i]);
        let (old_j, j) = (old.volume_ratio(first), new.volume_ratio(first));
        let (strain, spin) = increment(old, new);
        let sound = match law.softens() {
            true => old_j / self.lanes(|i| law.damage.integrity(f.damage[i])),
            false => old_j,
        };
        let stress = [
            self.lanes(|i| f.stress[i].xx),
            self.lanes(|i| f.stress[i].yy),
            self.lanes(|i| f.stress[i].zz),
            self.lanes(|i| f.stress[i].xy),
        ];
        let kirchhoff = with_elastic(rotated(stress, spin, sound), strain, elastic);
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
            shear_modulus: S::splat(elastic.shear_modulus()) * per_j,
            dt,
        }
        .solve(law.yields.as_ref());
        let plastic = S::splat(0.0).lt(returned.increment);
        let found = Found {
            stretch: new,
            mean,
            deviator: dev,
            trial: size,
            volume_ratio: j,
            flow: Flow {
                increment: returned.increment,
                rate: returned.increment / dt,
                von_mises: returned.stress,
                scale: S::select(plastic, returned.stress / size, one),
            },
            plastic: S::bits(plastic),
            unsolved: returned.unsolved,
        };
        found.keep(f, laws, law, self)
    }

    #[inline(always)]
    fn softening<S: Simd>(&self, f: &Fields, law: &Law) -> S {
        match law.material.strength.thermal() {
            None => S::splat(1.0),
            Some(t) => self.lanes(|i| t.factor(f.temperature[i])),
        }
    }
}
