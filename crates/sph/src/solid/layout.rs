//! What a reference configuration is built from.

use super::Numerics;
use super::layers::Materials;
use super::mat2::{determinant, largest_stretch};
use super::reference::Reference;
use super::renewal::Base;
use crate::geometry::{Geometry, Vec2};

/// What a reference configuration is built from.
pub(super) struct Layout {
    pub(super) position: Vec<Vec2>,
    pub(super) area: Vec<f64>,
    pub(super) smoothing_length: Vec<f64>,
    pub(super) mass: Vec<f64>,
    pub(super) renewals: u32,
    pub(super) volume_ratio: Vec<f64>,
    pub(super) first_area: Vec<f64>,
    pub(super) first_smoothing_length: Vec<f64>,
    pub(super) forgotten: Vec<bool>,
}

impl Layout {
    /// The first configuration.
    pub(super) fn first(
        geometry: Geometry,
        materials: Materials,
        numerics: &Numerics,
        position: Vec<Vec2>,
        area: Vec<f64>,
    ) -> Self {
        let volume = position.iter().zip(&area);
        let volume = volume.map(|(x, a)| a * geometry.ring(x[0]));
        let h = area.iter().map(|a| numerics.smoothing_ratio * a.sqrt());
        let h: Vec<f64> = h.collect();
        Self {
            mass: (volume.enumerate())
                .map(|(a, v)| v * materials.of(a).density)
                .collect(),
            renewals: 0,
            volume_ratio: vec![1.0; position.len()],
            first_area: area.clone(),
            first_smoothing_length: h.clone(),
            forgotten: vec![false; position.len()],
            smoothing_length: h,
            position,
            area,
        }
    }

    /// Areas and smoothing lengths of a renewed reference.
    pub(super) fn renewed(base: &Base, old: &Reference, removed: &[f64]) -> Self {
        let n = base.position.len();
        let area = (0..n)
            .map(|a| old.first_area[a] * determinant(&base.deformation[a]))
            .collect();
        let smoothing_length = (0..n)
            .map(|a| old.first_smoothing_length[a] * largest_stretch(&base.deformation[a]))
            .collect();
        Self {
            position: base.position.clone(),
            area,
            smoothing_length,
            mass: old.mass.clone(),
            renewals: base.renewals,
            volume_ratio: (0..n)
                .map(|a| determinant(&base.deformation[a]) * base.hoop_stretch[a])
                .collect(),
            first_area: old.first_area.clone(),
            first_smoothing_length: old.first_smoothing_length.clone(),
            forgotten: removed.iter().map(|r| *r != 0.0).collect(),
        }
    }
}
