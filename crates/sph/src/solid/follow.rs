//! What goes along with the particles: mirror images, and the points of the faces.

use super::blocks::Block;
use super::mat2::Mat2;
use super::sums::{self, Field};
use super::{Formulation, Solid, increment};
use crate::geometry::Vec2;
use crate::simd::{self, LANES, Simd, Task};
use rayon::prelude::*;

/// Clusters at faces, or images, per task.
const TASK: usize = 16;

/// Gradients dv/dX of the particles behind the points of the faces.
struct FaceGradients<'a> {
    /// Their clusters, ascending.
    clusters: &'a [u32],
    gradients: Vec<Block<4>>,
}

impl FaceGradients<'_> {
    fn of(&self, particle: usize) -> Mat2 {
        let cluster = (particle / LANES) as u32;
        let k = self.clusters.partition_point(|c| *c < cluster);
        let [xx, xy, yx, yy] = self.gradients[k].0.map(|lanes| lanes[particle % LANES]);
        [[xx, xy], [yx, yy]]
    }
}

/// The gradients of some clusters.
struct Gradients<'a> {
    solid: &'a Solid,
    clusters: &'a [u32],
    results: &'a mut [Block<4>],
}

impl Task for Gradients<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let reference = &self.solid.reference;
        let velocity = self.solid.velocities();
        for (&cluster, result) in self.clusters.iter().zip(self.results) {
            let cluster = cluster as usize;
            let m = sums::gradient::<S>(&reference.pairs, &velocity, cluster);
            result.store(increment::product(m, reference.own.strain[cluster].load()));
        }
    }
}

impl Solid {
    /// Positions of particles and mirror images.
    pub(super) fn positions(&self) -> Field<'_> {
        Field {
            particles: &self.state.position,
            images: &self.scratch.image_position,
        }
    }

    /// The same of velocities.
    fn velocities(&self) -> Field<'_> {
        Field {
            particles: &self.state.velocity,
            images: &self.scratch.image_velocity,
        }
    }

    /// Brings the positions of mirror images up to those of their particles.
    pub(super) fn place_images(&mut self) {
        let (reference, surfaces, block) = (&self.reference, &self.surfaces, &self.block);
        let position = &self.state.position;
        (reference.mirror_images.par_iter())
            .zip(&reference.image_position)
            .with_min_len(LANES * TASK)
            .map(|(image, place)| {
                let b = image.source as usize;
                let u = [0, 1].map(|k| position[b][k] - reference.position[b][k]);
                let u = image.displacement(block, surfaces, reference.position[b], u);
                [place[0] + u[0], place[1] + u[1]]
            })
            .collect_into_vec(&mut self.scratch.image_position);
    }

    /// The same of their velocities.
    pub(super) fn move_images(&mut self) {
        let (surfaces, velocity) = (&self.surfaces, &self.state.velocity);
        (self.reference.mirror_images.par_iter())
            .with_min_len(LANES * TASK)
            .map(|image| image.velocity(surfaces, velocity[image.source as usize]))
            .collect_into_vec(&mut self.scratch.image_velocity);
    }

    /// Moves the surface points to the present positions and velocities; takes particles out of the neighbour sums that the
    /// state counts as removed.
    pub fn follow_surfaces(&mut self) {
        self.forget_removed();
        if let Formulation::Joshi(_) = self.numerics.formulation {
            return self.arrange();
        }
        self.move_images();
        self.follow_moved_surfaces();
    }

    /// The same with the images where they are.
    pub(super) fn follow_moved_surfaces(&mut self) {
        let clusters = std::mem::take(&mut self.scratch.face_clusters);
        let gradients = self.face_gradients(&clusters);
        let reference = &self.reference;
        for surface in &mut self.surfaces {
            surface.follow_position(reference, &self.state);
            surface.follow_velocity(reference, &self.state, |a| gradients.of(a));
        }
        self.scratch.face_clusters = clusters;
    }

    fn face_gradients<'a>(&self, clusters: &'a [u32]) -> FaceGradients<'a> {
        let mut gradients = vec![Block([[0.0; LANES]; 4]); clusters.len()];
        (clusters.par_chunks(TASK))
            .zip(gradients.par_chunks_mut(TASK))
            .for_each(|(clusters, results)| {
                simd::run(Gradients {
                    solid: self,
                    clusters,
                    results,
                });
            });
        FaceGradients {
            clusters,
            gradients,
        }
    }

    /// Clusters with particles behind the points of faces, ascending.
    pub(super) fn clusters_at_faces(surfaces: &[super::Surface]) -> Vec<u32> {
        let particles = surfaces.iter().flat_map(|s| &s.particle);
        let mut clusters: Vec<u32> = particles.map(|a| (a / LANES) as u32).collect();
        clusters.sort_unstable();
        clusters.dedup();
        clusters
    }

    /// Displacement of a particle in the reference, m.
    pub(super) fn displacement(&self, a: usize) -> Vec2 {
        [0, 1].map(|k| self.state.position[a][k] - self.reference.position[a][k])
    }
}
