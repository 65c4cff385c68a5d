//! Stored pairs of the reference configuration, in clusters of eight particles that share a list of neighbours.
//!
//! A cluster is eight particles that follow each other: a body whose particles stand in `neighbours::compact_order` has lists of
//! about 44 neighbours where one particle has 20. The particles of a cluster stand side by side in the lanes; each neighbour of any
//! of them is taken once, for all eight. Stored per lane is all that a pair has of its own, zero where the neighbour is out of
//! reach, with X = X_a - X_b and the signed radius R (1 in plane strain):
//!
//! g = A_a A_b (dW/dX)/X,  v = g/X^2 alpha h min(rho0 c_l) (|R_a| + |R_b|)/2,  e = A_a A_b W/X^2 zeta min(E) (|R_a| + |R_b|)/4
//!
//! They are kept in single precision. Each is the same number from both sides of a pair, so that it is just another kernel, by
//! 1e-7 of its value: forces stay opposite to each other and corrected gradients exact.

use super::images::Image;
use super::search::Cloud;
use crate::geometry::Vec2;
use crate::kernel;
use crate::simd::LANES;
use rayon::prelude::*;
use std::ops::Range;

/// One neighbour of a particle: real or a mirror image.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pair {
    /// Index among particles, then mirror images.
    pub(super) neighbour: u32,
    /// X_a - X_b, m.
    pub(super) offset: Vec2,
    /// A_b (dW/dX)/X: times `offset` it is A_b grad_a W.
    pub(super) gradient: f64,
    /// Coefficient of the viscous acceleration on approach times the density, see `force.rs`.
    pub(super) viscous: f64,
    /// The same on separation.
    pub(super) separating: f64,
    /// Coefficient of the hourglass acceleration times the density, see `force.rs`.
    pub(super) hourglass: f64,
}

/// Everything about a particle or its image that its pairs depend on.
#[derive(Debug, Clone, Copy)]
pub(super) struct Source {
    /// 0 when taken out, m2.
    pub(super) area: f64,
    /// R in axisymmetry, 1 in plane strain.
    pub(super) weight: f64,
    /// Density times longitudinal wave speed, kg/(m2 s).
    pub(super) impedance: f64,
    /// Hourglass stiffness zeta E, Pa.
    pub(super) stiffness: f64,
    /// Viscosity of pairs with this particle on separation: not 0 in the first row of an open face.
    pub(super) edge: f64,
}

/// The pairs of all particles.
#[derive(Debug, Clone, Default)]
pub(super) struct Pairs {
    particles: usize,
    /// Where the list of each cluster starts.
    start: Vec<u32>,
    /// Where the mirror images in it start.
    beyond: Vec<u32>,
    neighbour: Vec<u32>,
    /// g.
    pub(super) gradient: Vec<[f32; LANES]>,
    /// v and e.
    pub(super) stabilisers: Vec<[[f32; LANES]; 2]>,
    /// Reference positions of particles, then of mirror images, m.
    pub(super) position: Vec<Vec2>,
    /// Viscosity on separation of pairs with each of them over that on approach.
    pub(super) separating: Vec<f64>,
    /// Whether some pair of a cluster has a viscosity on separation.
    pub(super) at_edge: Vec<bool>,
    /// Area times R of each particle: what coefficients are divided by.
    size: Vec<[f64; 2]>,
}

impl Pairs {
    /// Pairs from the neighbours of each particle; `source` tells about particles and their images, `viscosity` is the least on
    /// approach.
    pub(super) fn new(
        cloud: &Cloud,
        lists: &[Vec<u32>],
        viscosity: f64,
        source: impl Fn(usize) -> Source,
    ) -> Self {
        let real = cloud.particles + cloud.mirror_images.len();
        let points: Vec<Source> = (cloud.source[..real].iter())
            .map(|&b| source(b as usize))
            .collect();
        let first: Vec<usize> = (0..cloud.particles).step_by(LANES).collect();
        let build = |&a: &usize| List::new(cloud, lists, &points, viscosity, a);
        let parts: Vec<List> = first.par_iter().with_min_len(64).map(build).collect();
        let size = |s: &Source| [s.area, s.area * s.weight];
        let mut pairs = Self {
            particles: cloud.particles,
            start: vec![0],
            position: cloud.points[..real].to_vec(),
            separating: points.iter().map(|s| share(s.edge, viscosity)).collect(),
            size: points[..cloud.particles].iter().map(size).collect(),
            ..Self::default()
        };
        for part in parts {
            let mirrored = part
                .neighbour
                .partition_point(|&b| (b as usize) < cloud.particles);
            pairs.beyond.push((pairs.neighbour.len() + mirrored) as u32);
            pairs.neighbour.extend(part.neighbour);
            pairs.gradient.extend(part.gradient);
            pairs.stabilisers.extend(part.stabilisers);
            pairs.start.push(pairs.neighbour.len() as u32);
        }
        pairs.at_edge = (0..pairs.clusters()).map(|c| pairs.is_at_edge(c)).collect();
        pairs
    }

    /// Number of clusters.
    pub(super) fn clusters(&self) -> usize {
        self.particles.div_ceil(LANES)
    }

    fn is_at_edge(&self, cluster: usize) -> bool {
        let own = (cluster * LANES..self.particles).take(LANES);
        let others = self.range(cluster).map(|k| self.neighbour(k));
        own.chain(others).any(|b| self.separating[b] != 0.0)
    }

    /// Places in the lists that belong to a cluster.
    fn range(&self, cluster: usize) -> Range<usize> {
        self.start[cluster] as usize..self.start[cluster + 1] as usize
    }

    /// Those of the real neighbours, then those of the mirror images.
    #[inline(always)]
    pub(super) fn parts(&self, cluster: usize) -> [Range<usize>; 2] {
        let all = self.range(cluster);
        let middle = self.beyond[cluster] as usize;
        [all.start..middle, middle..all.end]
    }

    /// Neighbours at places in the lists.
    #[inline(always)]
    pub(super) fn neighbours(&self, places: Range<usize>) -> &[u32] {
        &self.neighbour[places]
    }

    /// Places in the lists where the neighbours of a particle stand.
    pub(super) fn places_of(&self, a: usize) -> impl Iterator<Item = usize> + '_ {
        self.range(a / LANES)
            .filter(move |&k| self.gradient[k][a % LANES] != 0.0)
    }

    /// Particle or mirror image at a place in the lists.
    pub(super) fn neighbour(&self, place: usize) -> usize {
        self.neighbour[place] as usize
    }

    /// The pair of a particle with the neighbour at a place in the lists.
    pub(super) fn pair(&self, a: usize, place: usize) -> Pair {
        let (lane, b) = (a % LANES, self.neighbour(place));
        let [area, ring] = self.size[a].map(|x| if x == 0.0 { 0.0 } else { 1.0 / x });
        let [viscous, hourglass] = self.stabilisers[place].map(|s| f64::from(s[lane]) * ring);
        Pair {
            neighbour: b as u32,
            offset: [0, 1].map(|k| self.position[a][k] - self.position[b][k]),
            gradient: f64::from(self.gradient[place][lane]) * area,
            viscous,
            separating: viscous * self.separating[a].max(self.separating[b]),
            hourglass: 2.0 * hourglass,
        }
    }

    /// Number of pairs of all particles.
    pub(super) fn count(&self) -> usize {
        (0..self.particles).map(|a| self.places_of(a).count()).sum()
    }

    /// Takes the particles marked, and their images, out of the sums of these clusters.
    pub(super) fn silence(&mut self, clusters: &[usize], forgotten: &[bool], images: &[Image]) {
        for &cluster in clusters {
            for k in self.range(cluster) {
                let b = self.neighbour(k);
                let source = match b.checked_sub(self.particles) {
                    None => b,
                    Some(image) => images[image].source as usize,
                };
                let own = forgotten[cluster * LANES..].iter().take(LANES);
                for (lane, own) in own.enumerate() {
                    if *own || forgotten[source] {
                        self.gradient[k][lane] = 0.0;
                        self.stabilisers[k][0][lane] = 0.0;
                        self.stabilisers[k][1][lane] = 0.0;
                    }
                }
            }
        }
    }
}

/// Viscosity on separation over that on approach.
fn share(edge: f64, viscosity: f64) -> f64 {
    if edge == 0.0 {
        0.0
    } else {
        edge / edge.max(viscosity)
    }
}

impl Cloud {
    /// Square of the distance (m2) and smoothing length (m) of a pair.
    fn distance(&self, a: usize, j: usize) -> (f64, f64) {
        let offset = [0, 1].map(|k| self.points[a][k] - self.points[j][k]);
        let square = offset[0] * offset[0] + offset[1] * offset[1];
        let h = 0.5 * (self.smoothing_length[a] + self.smoothing_length[j]);
        (square, h)
    }

    /// g of a pair of particles with these areas, as precise as the stored ones: images on one side of a particle balance
    /// neighbours on the other.
    pub(super) fn stored_gradient(&self, a: usize, j: usize, areas: [f64; 2]) -> f32 {
        let (square, h) = self.distance(a, j);
        (areas[0] * areas[1] * kernel::gradient_factor(square.sqrt(), h)) as f32
    }
}

/// The list of one cluster.
struct List {
    neighbour: Vec<u32>,
    gradient: Vec<[f32; LANES]>,
    stabilisers: Vec<[[f32; LANES]; 2]>,
}

impl List {
    /// `first` is the first particle of the cluster.
    fn new(
        cloud: &Cloud,
        lists: &[Vec<u32>],
        points: &[Source],
        viscosity: f64,
        first: usize,
    ) -> Self {
        let members = first..cloud.particles.min(first + LANES);
        let all = members.clone().flat_map(|a| &lists[a]).copied();
        let mut neighbour: Vec<u32> = all.filter(|&j| (j as usize) < points.len()).collect();
        neighbour.sort_unstable();
        neighbour.dedup();
        let mut list = Self {
            gradient: vec![[0.0; LANES]; neighbour.len()],
            stabilisers: vec![[[0.0; LANES]; 2]; neighbour.len()],
            neighbour,
        };
        for k in 0..list.neighbour.len() {
            let j = list.neighbour[k] as usize;
            for a in members.clone().filter(|&a| a != j) {
                let (one, other) = (&points[a], &points[j]);
                let (square, h) = cloud.distance(a, j);
                let areas = one.area * other.area;
                let ring = 0.5 * (one.weight + other.weight);
                let alpha = one.edge.max(other.edge).max(viscosity);
                let impedance = one.impedance.min(other.impedance);
                let stiffness = one.stiffness.min(other.stiffness);
                let slope = kernel::gradient_factor(square.sqrt(), h) / square;
                let value = kernel::value(square.sqrt(), h) / square;
                let lane = a - first;
                list.gradient[k][lane] = cloud.stored_gradient(a, j, [one.area, other.area]);
                list.stabilisers[k][0][lane] =
                    (areas * slope * (alpha * h * impedance * ring)) as f32;
                list.stabilisers[k][1][lane] = (0.5 * areas * value * (stiffness * ring)) as f32;
            }
        }
        list
    }
}
