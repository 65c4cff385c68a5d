//! Which point of a face a particle belongs to, and how its traction is scaled (see `surface.rs`).

use super::SolidError;
use super::block::{Block, Face, Reflection};
use super::images::Image;
use super::mat2::apply;
use super::reference::Reference;
use super::surface::Surface;
use crate::geometry::{Geometry, Vec2};

/// Whether a face moves a particle that is continued beyond it in this way.
pub(super) fn drives(how: Option<Reflection>) -> bool {
    matches!(how, Some(Reflection::Slip | Reflection::Bonded))
}

/// What tractions can be scaled by.
const SCALES: std::ops::Range<f64> = 0.2..5.0;

impl Surface {
    /// Between which points the particles reflected in a driven part lie.
    pub(super) fn find_feet(
        &mut self,
        block: &Block,
        reference: &Reference,
    ) -> Result<(), SolidError> {
        if !matches!(self.face, Face::Driven(_)) {
            return Ok(());
        }
        let along = 1 - self.side.normal_axis();
        if !self.driven.contains(&true) {
            return Err(SolidError::NothingDriven { side: self.side });
        }
        let at = |j: usize| self.reference_position[j][along];
        for (b, position) in reference.position.iter().enumerate() {
            if !drives(block.reflection(self.side, *position)) {
                continue;
            }
            let x = position[along];
            let near = self.nearest(x, along, &reference.position, true)? as usize;
            let first = if x < at(near) { near.max(1) - 1 } else { near };
            let next = first + 1;
            self.point_of_particle[b] = near as u32;
            if next < self.driven.len() && self.driven[first] && self.driven[next] {
                self.point_of_particle[b] = first as u32;
                self.share_of_next[b] = ((x - at(first)) / (at(next) - at(first))).clamp(0.0, 1.0);
            }
        }
        Ok(())
    }

    /// Assigns the sources of open images to points and sets the scales.
    pub(super) fn share_out(
        &mut self,
        geometry: Geometry,
        block: &Block,
        reference: &Reference,
    ) -> Result<(), SolidError> {
        let along = 1 - self.side.normal_axis();
        let mut point = std::mem::take(&mut self.point_of_particle);
        for image in reference.open_images.iter().filter(|i| self.opens(i)) {
            let b = image.source as usize;
            let x = reference.position[b][along];
            point[b] = self.nearest(x, along, &reference.position, false)?;
        }
        self.point_of_particle = point;
        let scale = self.scales(geometry, block, reference);
        for (j, &scale) in scale.iter().enumerate() {
            if !self.driven[j] && !SCALES.contains(&scale) {
                return Err(SolidError::UnevenFace {
                    side: self.side,
                    position: self.reference_position[j],
                    share: 1.0 / scale,
                });
            }
        }
        self.scale = scale;
        Ok(())
    }

    /// Sets the scales anew after particles were taken out. A point beneath which too little is left loses its hold: it
    /// transmits nothing any more.
    pub(super) fn share_out_again(
        &mut self,
        geometry: Geometry,
        block: &Block,
        reference: &Reference,
    ) {
        if matches!(self.face, Face::Driven(_) | Face::Free) {
            return;
        }
        self.scale = self.scales(geometry, block, reference);
        for (j, scale) in self.scale.iter_mut().enumerate() {
            self.holds[j] = SCALES.contains(scale) && !reference.forgotten[self.particle[j]];
            if !self.holds[j] {
                *scale = 0.0;
            }
        }
    }

    fn opens(&self, image: &Image) -> bool {
        image.steps().any(|s| s.side == self.side && s.is_open())
    }

    /// Area of each point's strip over what its traction acts on; 1 at driven points.
    fn scales(&self, geometry: Geometry, block: &Block, reference: &Reference) -> Vec<f64> {
        let axis = self.side.normal_axis();
        let mut share = vec![0.0; self.particle.len()];
        let acts = |i: u32| self.opens(&reference.open_images[i as usize]);
        for a in 0..reference.position.len() {
            for p in reference.open_pairs_of(a).iter().filter(|p| acts(p.image)) {
                let image = reference.open_images[p.image as usize];
                let b = image.source as usize;
                let l = image.turn_matrix(reference.full_correction[b]);
                let normal = apply(&l, p.offset)[axis] * p.gradient * self.side.sign();
                let radius = if axis == 0 {
                    block.coordinate(self.side)
                } else {
                    reference.position[b][0]
                };
                let ring = geometry.ring(radius);
                share[self.point_of_particle[b] as usize] +=
                    2.0 * reference.area[a] * normal * ring;
            }
        }
        let of_point = |j: usize| {
            if self.driven[j] {
                1.0
            } else {
                self.area[j] / share[j]
            }
        };
        (0..share.len()).map(of_point).collect()
    }

    /// Driven or other point nearest to coordinate `x` along the face; `position` are the reference positions of the
    /// particles.
    pub(super) fn nearest(
        &self,
        x: f64,
        along: usize,
        position: &[Vec2],
        driven: bool,
    ) -> Result<u32, SolidError> {
        let at = |j: usize| position[self.particle[j]][along];
        let n = self.particle.len();
        if n == 0 {
            return Err(SolidError::NoSurface { side: self.side });
        }
        let after = self.particle.partition_point(|&i| position[i][along] < x);
        let j = if after == 0 {
            0
        } else if after == n || x - at(after - 1) <= at(after) - x {
            after - 1
        } else {
            after
        };
        let fits = |i: &usize| self.driven[*i] == driven;
        let found = (j..n).find(fits).into_iter().chain((0..j).rfind(fits));
        found
            .min_by_key(|i| i.abs_diff(j))
            .map(|i| i as u32)
            .ok_or(SolidError::NoSurface { side: self.side })
    }
}
