//! The fluxes Q = R P L of particles and images, P = J sigma F^-T, that forces are made of (`force.rs`).

use super::Solid;
use super::images::{Flux, Image};
use super::increment::{Stretch, product};
use super::mat2::{self, Mat2, scaled};
use super::points::TASK;
use super::reference::Reference;
use super::state::State;
use super::sums::{eight, lanes};
use crate::geometry::Geometry;
use crate::simd::{self, LANES, Simd, Task};
use rayon::prelude::*;

/// Images per task.
const IMAGES: usize = 64;

/// What forces need of images besides position and velocity.
#[derive(Debug, Clone, Default)]
pub(super) struct Images {
    /// Deformation gradients of mirror images.
    pub(super) deformation: Vec<Mat2>,
    /// Fluxes of mirror images.
    pub(super) flux: Vec<Mat2>,
    /// Fluxes of open images.
    pub(super) open_flux: Vec<Mat2>,
}

/// The fluxes of the particles of one task.
struct Fluxes<'a> {
    state: &'a State,
    reference: &'a Reference,
    task: usize,
    flux: &'a mut [Mat2],
}

impl Task for Fluxes<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        for (k, flux) in self.flux.chunks_mut(LANES).enumerate() {
            let cluster = self.task * TASK / LANES + k;
            let [a, b, c, d] = fluxes::<S>(self.state, self.reference, cluster);
            let [a, b, c, d] = [a.store(), b.store(), c.store(), d.store()];
            for (l, flux) in flux.iter_mut().enumerate() {
                *flux = [[a[l], b[l]], [c[l], d[l]]];
            }
        }
    }
}

/// Those of a cluster, rows first.
#[inline(always)]
fn fluxes<S: Simd>(state: &State, reference: &Reference, cluster: usize) -> [S; 4] {
    let (stress, count) = eight(&state.stress, cluster);
    let [sxx, syy, sxy] = [
        lanes::<S>(0, count, |l| stress[l].xx),
        lanes::<S>(0, count, |l| stress[l].yy),
        lanes::<S>(0, count, |l| stress[l].xy),
    ];
    let Stretch([xx, xy, yx, yy, hoop]) =
        Stretch::<S>::load(&state.deformation, &state.hoop_stretch, cluster);
    // J F^-T = F_tt cof F, without a quotient.
    let nominal = product([sxx, sxy, sxy, syy], [yy, -yx, -xy, xx]);
    let [a, b, c, d] = product(nominal, reference.own.flux[cluster].load());
    [a * hoop, b * hoop, c * hoop, d * hoop]
}

/// R P of a particle.
fn weighted_nominal(state: &State, reference: &Reference, a: usize) -> Mat2 {
    let (f, s) = (&state.deformation[a], state.stress[a]);
    let cofactor = [[f[1][1], -f[1][0]], [-f[0][1], f[0][0]]];
    let nominal = mat2::product(&[[s.xx, s.xy], [s.xy, s.yy]], &cofactor);
    scaled(&nominal, reference.weight[a] * state.hoop_stretch[a])
}

impl Solid {
    /// Fluxes of particles and images, and the deformation of these.
    pub(super) fn fluxes(&mut self) {
        let (state, reference) = (&self.state, &self.reference);
        let flux = &mut self.scratch.flux;
        flux.resize(state.position.len(), mat2::UNIT);
        (flux.par_chunks_mut(TASK).enumerate()).for_each(|(task, flux)| {
            simd::run(Fluxes {
                state,
                reference,
                task,
                flux,
            });
        });
        self.image_fluxes();
    }

    fn image_fluxes(&mut self) {
        let axisymmetric = self.geometry == Geometry::Axisymmetric;
        let mut images = std::mem::take(&mut self.scratch.images);
        let (state, reference) = (&self.state, &self.reference);
        let (block, surfaces) = (&self.block, &self.surfaces);
        let flux = |image: &Image| {
            let b = image.source as usize;
            let source = Flux {
                flux: weighted_nominal(state, reference, b),
                correction: reference.full_correction[b],
                weight: reference.weight[b],
            };
            source.at_image(image, block, axisymmetric, surfaces)
        };
        let deformation = |image: &Image| {
            let b = image.source as usize;
            let (start, f) = (reference.position[b], state.deformation[b]);
            image.deformation(block, surfaces, start, self.displacement(b), f)
        };
        let mirrors = || reference.mirror_images.par_iter().with_min_len(IMAGES);
        let open = reference.open_images.par_iter().with_min_len(IMAGES);
        mirrors().map(flux).collect_into_vec(&mut images.flux);
        mirrors()
            .map(deformation)
            .collect_into_vec(&mut images.deformation);
        open.map(flux).collect_into_vec(&mut images.open_flux);
        self.scratch.images = images;
    }
}
