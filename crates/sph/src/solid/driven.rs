//! Tractions of driven faces: the forces of the images beyond them.

use super::Solid;
use super::flux::Images;
use super::mat2::{Mat2, apply, combine};
use super::pairs::Pair;
use super::reference::Reference;
use super::surface::Surface;
use crate::geometry::Vec2;

/// A pair through which a driven face acts.
#[derive(Debug, Clone, Copy)]
pub(super) struct DrivenPair {
    particle: u32,
    /// Where it stands in the lists of `pairs.rs`.
    place: u32,
    surface: u32,
    point: u32,
}

impl DrivenPair {
    /// All of them.
    pub(super) fn all(reference: &Reference, surfaces: &[Surface]) -> Vec<Self> {
        let n = reference.position.len();
        let mut driven = Vec::new();
        for (surface, face) in surfaces.iter().enumerate() {
            for particle in 0..n {
                for place in reference.pairs.places_of(particle) {
                    let neighbour = reference.pairs.neighbour(place);
                    let Some(image) = neighbour.checked_sub(n) else {
                        continue;
                    };
                    let image = reference.mirror_images[image];
                    if image.beyond(face.side) {
                        driven.push(Self {
                            particle: particle as u32,
                            place: place as u32,
                            surface: surface as u32,
                            point: face.foot(image.source) as u32,
                        });
                    }
                }
            }
        }
        driven
    }
}

/// Position, velocity, deformation gradient and flux of an image.
struct Moved {
    position: Vec2,
    velocity: Vec2,
    deformation: Mat2,
    flux: Mat2,
}

impl Solid {
    /// Tractions of the driven points: the forces of the images beyond them per reference area.
    pub(super) fn driven_tractions(&mut self) {
        for surface in &mut self.surfaces {
            for j in (0..surface.area.len()).filter(|&j| surface.driven[j]) {
                surface.traction[j] = [0.0; 2];
            }
        }
        let driven = std::mem::take(&mut self.scratch.driven);
        for d in &driven {
            let (a, j) = (d.particle as usize, d.point as usize);
            let pair = self.reference.pairs.pair(a, d.place as usize);
            let acceleration = self.acceleration_by(a, &pair);
            let surface = &mut self.surfaces[d.surface as usize];
            let share = self.reference.mass[a] / surface.area[j];
            for (t, acceleration) in surface.traction[j].iter_mut().zip(acceleration) {
                *t += share * acceleration;
            }
        }
        self.scratch.driven = driven;
    }

    fn image(&self, k: usize) -> Moved {
        let (
            scratch,
            Images {
                deformation, flux, ..
            },
        ) = (&self.scratch, &self.scratch.images);
        Moved {
            position: scratch.image_position[k],
            velocity: scratch.image_velocity[k],
            deformation: deformation[k],
            flux: flux[k],
        }
    }

    /// Acceleration of a particle by a mirror image.
    fn acceleration_by(&self, a: usize, p: &Pair) -> Vec2 {
        let (state, reference) = (&self.state, &self.reference);
        let other = self.image(p.neighbour as usize - reference.position.len());
        let g = [p.offset[0] * p.gradient, p.offset[1] * p.gradient];
        let d = [0, 1].map(|i| state.position[a][i] - other.position[i]);
        let v = [0, 1].map(|i| state.velocity[a][i] - other.velocity[i]);
        let along = v[0] * d[0] + v[1] * d[1];
        let per_density = 1.0 / reference.density[a];
        let viscous = if along < 0.0 { p.viscous } else { p.separating };
        let approach = per_density * along * viscous;
        let stiffness = per_density * p.hourglass;
        let (q, f) = (
            combine(&self.scratch.flux[a], 1.0, &other.flux, 1.0),
            combine(&state.deformation[a], 0.5, &other.deformation, 0.5),
        );
        let (force, linear) = (apply(&q, g), apply(&f, p.offset));
        let scale = per_density / reference.weight[a];
        [0, 1].map(|i| force[i] * scale + approach * d[i] + stiffness * (linear[i] - d[i]))
    }
}
