//! What the stress update of a step found for eight particles, and how it is booked.

use super::increment::{Plane, Stretch};
use super::points::{Eight, Fields, Law, Laws};
use super::stress::Failure;
use crate::simd::{LANES, Simd};
use erode_physics::Sym3;
use erode_physics::damage::{Damage, PlasticStep};
use erode_physics::return_mapping::radial_return;

/// Plastic flow.
#[derive(Clone, Copy)]
pub(super) struct Flow<T> {
    pub(super) increment: T,
    pub(super) rate: T,
    pub(super) von_mises: T,
    /// Of the deviator of the trial stress.
    pub(super) scale: T,
}

/// What the lanes found.
pub(super) struct Found<'a, S> {
    pub(super) stretch: &'a Stretch<S>,
    pub(super) mean: S,
    /// Of the trial stress.
    pub(super) deviator: Plane<S>,
    /// Its von Mises norm.
    pub(super) trial: S,
    pub(super) volume_ratio: S,
    pub(super) flow: Flow<S>,
    /// Lanes that flow, as bits.
    pub(super) plastic: u8,
    /// Lanes whose return is left to the scalar solver.
    pub(super) unsolved: u8,
}

impl<S: Simd> Found<'_, S> {
    /// Writes the results of all particles of a layer that are still in the body; the first failure.
    #[inline(always)]
    pub(super) fn keep(
        &self,
        f: &mut Fields,
        laws: &Laws,
        law: &Law,
        eight: &Eight,
    ) -> Option<(usize, Failure)> {
        let gone = |l: usize| {
            let a = eight.particle(l);
            laws.removed[a] != 0.0 || laws.layers.index(a) != law.layer
        };
        let right = S::bits(S::splat(0.0).lt(self.volume_ratio)) == u8::MAX;
        let all = eight.count == LANES && !(0..LANES).any(gone);
        if all && right && self.unsolved == 0 && !law.softens() {
            self.keep_all(f, law, eight.start);
            return None;
        }
        let stored = self.stored();
        (0..eight.count)
            .filter(|&l| !gone(l))
            .find_map(|l| stored.keep(f, laws, law, (eight, l)))
    }

    /// The same where all eight lie in the layer and nothing is out of the ordinary: the same bits as one by one.
    #[inline(always)]
    fn keep_all(&self, f: &mut Fields, law: &Law, start: usize) {
        let thermal = law.material.strength.thermal();
        if self.plastic != 0 && (thermal.is_some() || *law.damage != Damage::None) {
            self.heat_and_damage(f, law, start);
        }
        let flow = &self.flow;
        let d = self.deviator;
        let stress = [
            (self.mean + d[0] * flow.scale).store(),
            (self.mean + d[1] * flow.scale).store(),
            (self.mean + d[2] * flow.scale).store(),
            (d[3] * flow.scale).store(),
        ];
        let [xx, xy, yx, yy, hoop] = self.stretch.0;
        let plane = [xx.store(), xy.store(), yx.store(), yy.store()];
        let eight = start..start + LANES;
        for (l, f) in f.deformation[eight.clone()].iter_mut().enumerate() {
            *f = [[plane[0][l], plane[1][l]], [plane[2][l], plane[3][l]]];
        }
        for (l, s) in f.stress[eight.clone()].iter_mut().enumerate() {
            (s.xx, s.yy, s.zz, s.xy) = (stress[0][l], stress[1][l], stress[2][l], stress[3][l]);
        }
        let work = flow.von_mises * flow.increment * self.volume_ratio;
        put(f.hoop_stretch, start, hoop);
        put(f.von_mises, start, flow.von_mises);
        put(f.plastic_strain_rate, start, flow.rate);
        if self.plastic != 0 {
            add(f.plastic_strain, start, flow.increment);
            add(f.plastic_work, start, work);
        }
    }

    /// Temperature and damage of those that flow.
    #[inline(never)]
    fn heat_and_damage(&self, f: &mut Fields, law: &Law, start: usize) {
        let stored = self.stored();
        for l in (0..LANES).filter(|l| self.plastic >> l & 1 == 1) {
            stored.heat_and_damage(f, law, (start + l, l), stored.flow(l), 1.0);
        }
    }

    #[inline(always)]
    fn stored(&self) -> Stored {
        let (d, flow) = (self.deviator, &self.flow);
        let [xx, xy, yx, yy, hoop] = self.stretch.0;
        Stored {
            stretch: [xx.store(), xy.store(), yx.store(), yy.store(), hoop.store()],
            mean: self.mean.store(),
            deviator: [d[0].store(), d[1].store(), d[2].store(), d[3].store()],
            trial: self.trial.store(),
            volume_ratio: self.volume_ratio.store(),
            flow: Flow {
                increment: flow.increment.store(),
                rate: flow.rate.store(),
                von_mises: flow.von_mises.store(),
                scale: flow.scale.store(),
            },
            unsolved: self.unsolved,
        }
    }
}

/// Lanes into eight of an array.
#[inline(always)]
fn put<S: Simd>(all: &mut [f64], start: usize, lanes: S) {
    all[start..start + LANES].copy_from_slice(&lanes.store());
}

#[inline(always)]
fn add<S: Simd>(all: &mut [f64], start: usize, lanes: S) {
    let mut eight = [0.0; LANES];
    eight.copy_from_slice(&all[start..start + LANES]);
    put(all, start, S::load(&eight) + lanes);
}

/// The same as [`Found`], lane by lane.
struct Stored {
    stretch: [[f64; LANES]; 5],
    mean: [f64; LANES],
    deviator: [[f64; LANES]; 4],
    trial: [f64; LANES],
    volume_ratio: [f64; LANES],
    flow: Flow<[f64; LANES]>,
    unsolved: u8,
}

impl Stored {
    fn flow(&self, l: usize) -> Flow<f64> {
        Flow {
            increment: self.flow.increment[l],
            rate: self.flow.rate[l],
            von_mises: self.flow.von_mises[l],
            scale: self.flow.scale[l],
        }
    }

    /// Writes the results of one particle.
    fn keep(
        &self,
        f: &mut Fields,
        laws: &Laws,
        law: &Law,
        (eight, l): (&Eight, usize),
    ) -> Option<(usize, Failure)> {
        let (a, i) = (eight.particle(l), eight.start + l);
        let j = self.volume_ratio[l];
        if j.is_nan() || j <= 0.0 {
            return Some((a, Failure::Inverted(j)));
        }
        let mut flow = self.flow(l);
        if self.unsolved >> l & 1 == 1 {
            match solve_alone(f, law, laws.dt, i, (self.trial[l], j)) {
                Ok(found) => flow = found,
                Err(failure) => return Some((a, failure)),
            }
        }
        let [xx, xy, yx, yy, hoop] = self.stretch.map(|s| s[l]);
        f.deformation[i] = [[xx, xy], [yx, yy]];
        f.hoop_stretch[i] = hoop;
        self.book(f, law, (i, l), flow);
        None
    }

    /// Books the plastic flow of one particle (index in the task, lane), and its damage.
    fn book(&self, f: &mut Fields, law: &Law, (i, l): (usize, usize), flow: Flow<f64>) {
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
        if flow.increment > 0.0 {
            let mean = self.heat_and_damage(f, law, (i, l), flow, sound);
            f.plastic_strain[i] += flow.increment;
            f.plastic_work[i] += mean * (flow.von_mises * flow.increment * j);
        }
        let integrity = law.damage.integrity(f.damage[i]);
        f.stress[i] = stress * integrity;
        f.von_mises[i] = flow.von_mises * integrity;
        if integrity != sound {
            let energy = law.material.elastic.energy_density(stress * j);
            f.damage_work[i] += (sound - integrity) * energy;
        }
    }

    /// Damage and temperature after plastic flow; the mean integrity of the step, which began at `sound`.
    fn heat_and_damage(
        &self,
        f: &mut Fields,
        law: &Law,
        (i, l): (usize, usize),
        flow: Flow<f64>,
        sound: f64,
    ) -> f64 {
        let step = PlasticStep {
            increment: flow.increment,
            rate: flow.rate,
            triaxiality: self.mean[l] / flow.von_mises,
            temperature: f.temperature[i],
        };
        f.damage[i] = law.damage.after(f.damage[i], step);
        let mean = 0.5 * (sound + law.damage.integrity(f.damage[i]));
        if let Some(t) = law.material.strength.thermal() {
            let density = law.material.density / self.volume_ratio[l];
            f.temperature[i] += mean * t.heating(flow.von_mises * flow.increment, density);
        }
        mean
    }
}

/// Flow of one particle by the scalar solver.
#[cold]
fn solve_alone(
    f: &Fields,
    law: &Law,
    dt: f64,
    i: usize,
    (trial, j): (f64, f64),
) -> Result<Flow<f64>, Failure> {
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
