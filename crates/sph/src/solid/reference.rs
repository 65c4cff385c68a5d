//! Reference configuration: particles, their stored pairs and gradient corrections.
//!
//! Force gradient: L_full = (-sum A X (x) grad W)^-1 over real particles and all images, which on a uniform lattice is
//! the constant 1/1.0105 of the cubic spline. Deformation gradient: L_own, the same over real particles and mirror
//! images only, so that it is exact for linear fields at free faces too.

use super::block::{Block, Reflection, Side};
use super::images::Image;
use super::layers::Materials;
use super::layout::Layout;
use super::mat2::Mat2;
use super::own::Own;
use super::pairs::{Pair, Pairs, Source};
use super::search::Cloud;
use super::{Numerics, SolidError};
use crate::geometry::{Geometry, Vec2};
use crate::simd::LANES;

/// Particles no deeper than this many spacings under a face are its first row.
pub(super) const FIRST_ROW: f64 = 0.75;

/// One open image that acts on a particle.
#[derive(Debug, Clone, Copy)]
pub(super) struct OpenPair {
    /// Index among open images.
    pub(super) image: u32,
    /// X_a - X_b, m.
    pub(super) offset: Vec2,
    /// A_b (dW/dX)/X.
    pub(super) gradient: f64,
}

/// The body as it was at the start.
#[derive(Debug, Clone)]
pub struct Reference {
    /// Position, m.
    pub position: Vec<Vec2>,
    /// Area in the plane of motion, m2.
    pub area: Vec<f64>,
    /// Smoothing length, m.
    pub smoothing_length: Vec<f64>,
    /// Volume of the ring (axisymmetry) or per metre (plane strain) in the first configuration, m3.
    pub volume: Vec<f64>,
    /// Mass, kg.
    pub mass: Vec<f64>,
    /// Volume here over volume in the first configuration: 1 before a renewal.
    pub volume_ratio: Vec<f64>,
    /// Density here, kg/m3.
    pub(super) density: Vec<f64>,
    /// Number of renewals, see `renewal.rs`.
    pub(super) renewals: u32,
    pub(super) first_area: Vec<f64>,
    /// Time in which a longitudinal wave crosses the first spacing, s.
    pub(super) crossing: Vec<f64>,
    pub(super) first_smoothing_length: Vec<f64>,
    /// R in axisymmetry, 1 in plane strain.
    pub(super) weight: Vec<f64>,
    pub(super) mirror_images: Vec<Image>,
    /// Where the mirror images were at the start, m.
    pub(super) image_position: Vec<Vec2>,
    pub(super) open_images: Vec<Image>,
    pub(super) full_correction: Vec<Mat2>,
    pub(super) own_correction: Vec<Mat2>,
    /// See `balance.rs`.
    pub(super) imbalance: Vec<Vec2>,
    /// Particles taken out of all sums, see `failure.rs`.
    pub(super) forgotten: Vec<bool>,
    pub(super) pairs: Pairs,
    pub(super) own: Own,
    open_start: Vec<u32>,
    open_pairs: Vec<OpenPair>,
}

impl Reference {
    pub(super) fn new(
        geometry: Geometry,
        block: &Block,
        materials: Materials,
        numerics: &Numerics,
        layout: Layout,
    ) -> Result<Self, SolidError> {
        let axisymmetric = geometry == Geometry::Axisymmetric;
        let (position, h) = (layout.position, layout.smoothing_length);
        let open = layout.renewals == 0;
        let speed = |a: usize| {
            let material = materials.of(a);
            material.elastic.longitudinal_speed(material.density)
        };
        let (cloud, lists) = Cloud::with_neighbours(block, &position, &h, open);
        let mut reference = Self {
            weight: position
                .iter()
                .map(|x| if axisymmetric { x[0] } else { 1.0 })
                .collect(),
            volume: (layout.mass.iter().enumerate())
                .map(|(a, m)| m / materials.of(a).density)
                .collect(),
            density: (layout.volume_ratio.iter().enumerate())
                .map(|(a, j)| materials.of(a).density / j)
                .collect(),
            mass: layout.mass,
            volume_ratio: layout.volume_ratio,
            renewals: layout.renewals,
            crossing: (layout.first_area.iter().enumerate())
                .map(|(a, area)| area.sqrt() / speed(a))
                .collect(),
            first_area: layout.first_area,
            first_smoothing_length: layout.first_smoothing_length,
            smoothing_length: h,
            mirror_images: Vec::new(),
            image_position: cloud.points[cloud.particles..][..cloud.mirror_images.len()].to_vec(),
            open_images: Vec::new(),
            full_correction: Vec::new(),
            own_correction: Vec::new(),
            imbalance: vec![[0.0; 2]; position.len()],
            forgotten: layout.forgotten,
            pairs: Pairs::default(),
            own: Own::default(),
            open_start: vec![0],
            open_pairs: Vec::new(),
            position,
            area: layout.area,
        };
        for (a, list) in lists.iter().enumerate() {
            reference.add_open_pairs(a, list, &cloud);
        }
        reference.pairs = Pairs::new(&cloud, &lists, numerics.viscosity, |b| {
            reference.source_of_pairs(block, numerics, materials, b)
        });
        reference.mirror_images = cloud.mirror_images;
        reference.open_images = cloud.open_images;
        reference.correct()?;
        reference.own = Own::of(&reference);
        Ok(reference)
    }

    /// Sets what uniform stress leaves in the forces.
    pub(super) fn balance(&mut self, imbalance: Vec<Vec2>) {
        self.imbalance = imbalance;
        self.own = Own::of(self);
    }

    /// Real neighbours and mirror images of a particle.
    pub(super) fn pairs_of(&self, a: usize) -> impl Iterator<Item = Pair> + '_ {
        self.pairs.places_of(a).map(move |k| self.pairs.pair(a, k))
    }

    /// Number of pairs of all particles with their real neighbours and mirror images.
    #[must_use]
    pub fn pairs(&self) -> usize {
        self.pairs.count()
    }

    /// Open images that act on a particle.
    pub(super) fn open_pairs_of(&self, a: usize) -> &[OpenPair] {
        &self.open_pairs[self.open_start[a] as usize..self.open_start[a + 1] as usize]
    }

    /// Particles that, or whose images, are neighbours of a particle or of its images.
    pub(super) fn sources_near(&self, a: usize) -> Vec<usize> {
        let real = self.pairs.places_of(a);
        let real = real.map(|k| self.source(self.pairs.neighbour(k)));
        let open = self.open_pairs_of(a).iter();
        let open = open.map(|p| self.open_images[p.image as usize].source as usize);
        real.chain(open).collect()
    }

    /// The particle behind a neighbour.
    fn source(&self, b: usize) -> usize {
        let n = self.position.len();
        if b < n {
            b
        } else {
            self.mirror_images[b - n].source as usize
        }
    }

    /// Takes the forgotten particles out of the sums over real particles and mirror images near these ones.
    pub(super) fn silence_near(&mut self, near: &[usize]) {
        let clusters = clusters_of(near);
        (self.pairs).silence(&clusters, &self.forgotten, &self.mirror_images);
    }

    /// Brings what sums need up to changed pairs and corrections of these particles.
    pub(super) fn settle(&mut self, changed: &[usize]) {
        let mut own = std::mem::take(&mut self.own);
        for cluster in clusters_of(changed) {
            own.settle(self, cluster);
        }
        self.own = own;
    }

    /// Sets the coefficients of all open pairs of a particle with forgotten ones to zero; of all of them if it is one.
    pub(super) fn silence(&mut self, a: usize) {
        for k in self.open_start[a] as usize..self.open_start[a + 1] as usize {
            let source = self.open_images[self.open_pairs[k].image as usize].source;
            if self.forgotten[a] || self.forgotten[source as usize] {
                self.open_pairs[k].gradient = 0.0;
            }
        }
    }

    /// Lists the open images that act on a particle; `list` are its neighbours.
    fn add_open_pairs(&mut self, a: usize, list: &[u32], cloud: &Cloud) {
        let first_open = cloud.particles + cloud.mirror_images.len();
        for j in list
            .iter()
            .map(|&j| j as usize)
            .filter(|&j| j >= first_open)
        {
            let source = cloud.source[j] as usize;
            let gone = self.forgotten[a] || self.forgotten[source];
            let stored = cloud.stored_gradient(a, j, [self.area[a], self.area[source]]);
            let gradient = f64::from(stored) / self.area[a];
            self.open_pairs.push(OpenPair {
                image: (j - first_open) as u32,
                offset: [0, 1].map(|k| self.position[a][k] - cloud.points[j][k]),
                gradient: if gone { 0.0 } else { gradient },
            });
        }
        self.open_start.push(self.open_pairs.len() as u32);
    }

    /// What the pairs of a particle depend on.
    fn source_of_pairs(
        &self,
        block: &Block,
        numerics: &Numerics,
        materials: Materials,
        b: usize,
    ) -> Source {
        let (material, density) = (materials.of(b), self.density[b]);
        let elastic = &material.elastic;
        let per_density = density / material.density;
        Source {
            area: if self.forgotten[b] { 0.0 } else { self.area[b] },
            weight: self.weight[b],
            impedance: density * elastic.longitudinal_speed(material.density),
            stiffness: numerics.hourglass * elastic.young_modulus * per_density,
            edge: if self.in_first_row(block, b) {
                numerics.edge_viscosity
            } else {
                0.0
            },
        }
    }

    fn in_first_row(&self, block: &Block, a: usize) -> bool {
        self.renewals == 0
            && Side::ALL.into_iter().any(|side| {
                block.reflection(side, self.position[a]) == Some(Reflection::Open)
                    && block.depth(side, self.position[a]) < FIRST_ROW * self.area[a].sqrt()
            })
    }
}

/// Clusters of these particles, ascending.
fn clusters_of(particles: &[usize]) -> Vec<usize> {
    let mut clusters: Vec<usize> = particles.iter().map(|a| a / LANES).collect();
    clusters.sort_unstable();
    clusters.dedup();
    clusters
}
