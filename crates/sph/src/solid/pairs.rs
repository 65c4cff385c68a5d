//! Stored pairs of the reference configuration, in clusters of eight particles that share a list of neighbours.
//!
//! The particles of a cluster stand side by side in the lanes; each neighbour of any of them is taken once, for all eight.
//! Stored per lane are (dW/dX)/X^3 and W/X^2 of the pair, zero where the neighbour is out of reach; all else follows from the
//! reference values of the particles. A cluster is a compact patch (the body is halved along its longer side until eight are
//! left), so that lists are short: about 45 neighbours where one particle has 20.
//!
//! The two kernel values are kept in single precision, in units of the smallest smoothing length: they are the same number
//! from both sides of a pair, so that it is just another kernel, by 1e-7 of its value; forces stay opposite to each other
//! and corrected gradients exact.
//!
//! A particle taken out of the body has area 0 here.

use super::images::Image;
use super::patches;
use super::search::Cloud;
use crate::geometry::Vec2;
use crate::kernel;
use crate::simd::{LANES, Simd};
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

/// What pairs need of a particle or a mirror image.
#[derive(Debug, Clone, Copy)]
#[repr(align(64))]
pub(super) struct Fixed {
    /// Position, m.
    pub(super) position: Vec2,
    /// Area, 0 when taken out, in the unit of the stored gradients.
    pub(super) area: f64,
    /// Half the smoothing length, m.
    pub(super) half_length: f64,
    /// R in axisymmetry, 1 in plane strain.
    pub(super) weight: f64,
    /// Density times longitudinal wave speed, kg/(m2 s).
    pub(super) impedance: f64,
    /// Hourglass stiffness zeta E, Pa, in the unit of the stored values.
    pub(super) stiffness: f64,
    /// Viscosity of pairs with this particle on separation: not 0 in the first row of an open face.
    pub(super) edge: f64,
}

/// Everything about a particle or mirror image that its pairs depend on.
#[derive(Debug, Clone, Copy)]
pub(super) struct Source {
    pub(super) area: f64,
    pub(super) weight: f64,
    pub(super) impedance: f64,
    pub(super) stiffness: f64,
    pub(super) edge: f64,
}

/// The pairs of all particles.
#[derive(Debug, Clone, Default)]
pub(super) struct Pairs {
    /// Particles of each cluster; the last one is filled up with its last particle.
    members: Vec<[u32; LANES]>,
    /// Cluster and lane of each particle: LANES cluster + lane.
    slot: Vec<u32>,
    /// Where the list of each cluster starts.
    start: Vec<u32>,
    neighbour: Vec<u32>,
    gradient: Vec<[f32; LANES]>,
    value: Vec<[f32; LANES]>,
    pub(super) fixed: Vec<Fixed>,
    /// Least viscosity on approach.
    pub(super) viscosity: f64,
}

/// One entry in the list of a cluster.
pub(super) struct Entry<'a> {
    pub(super) neighbour: usize,
    pub(super) fixed: &'a Fixed,
    pub(super) gradient: &'a [f32; LANES],
    pub(super) value: &'a [f32; LANES],
}

impl Pairs {
    /// Pairs from the neighbours of each particle; `source` tells about particles and their images.
    pub(super) fn new(
        cloud: &Cloud,
        lists: &[Vec<u32>],
        viscosity: f64,
        source: impl Fn(usize) -> Source,
    ) -> Self {
        let real = cloud.particles + cloud.mirror_images.len();
        let h = &cloud.smoothing_length;
        let unit = cloud.unit();
        let fixed = |j: usize| {
            let s = source(cloud.source[j] as usize);
            Fixed {
                position: cloud.points[j],
                area: s.area * unit.powi(-6),
                half_length: 0.5 * h[j],
                weight: s.weight,
                impedance: s.impedance,
                stiffness: s.stiffness * unit.powi(2),
                edge: s.edge,
            }
        };
        let members = patches(&cloud.points[..cloud.particles]);
        let mut slot = vec![0; cloud.particles];
        for (k, &a) in members.as_flattened().iter().enumerate().rev() {
            slot[a as usize] = k as u32;
        }
        let parts: Vec<List> = (members.par_iter().with_min_len(64))
            .map(|m| List::new(cloud, lists, m, real, unit))
            .collect();
        let mut pairs = Self {
            members,
            slot,
            start: vec![0],
            fixed: (0..real).map(fixed).collect(),
            viscosity,
            ..Self::default()
        };
        for part in parts {
            pairs.neighbour.extend(part.neighbour);
            pairs.gradient.extend(part.gradient);
            pairs.value.extend(part.value);
            pairs.start.push(pairs.neighbour.len() as u32);
        }
        pairs
    }

    /// Number of clusters.
    pub(super) fn clusters(&self) -> usize {
        self.members.len()
    }

    /// Cluster and lane of a particle.
    pub(super) fn slot(&self, a: usize) -> (usize, usize) {
        let k = self.slot[a] as usize;
        (k / LANES, k % LANES)
    }

    /// Places in the lists that belong to a cluster.
    fn range(&self, cluster: usize) -> Range<usize> {
        self.start[cluster] as usize..self.start[cluster + 1] as usize
    }

    /// The list of a cluster.
    #[inline(always)]
    pub(super) fn entries(&self, cluster: usize) -> impl Iterator<Item = Entry<'_>> {
        let range = self.range(cluster);
        let stored = self.gradient[range.clone()].iter();
        let stored = stored.zip(&self.value[range.clone()]);
        (self.neighbour[range].iter().zip(stored)).map(|(&b, (gradient, value))| Entry {
            neighbour: b as usize,
            fixed: &self.fixed[b as usize],
            gradient,
            value,
        })
    }

    /// One number of each particle of a cluster.
    #[inline(always)]
    pub(super) fn lanes<S: Simd>(&self, cluster: usize, of: impl Fn(usize) -> f64) -> S {
        let mut x = [0.0; LANES];
        for (x, &a) in x.iter_mut().zip(&self.members[cluster]) {
            *x = of(a as usize);
        }
        S::load(&x)
    }

    /// Places in the lists where the neighbours of a particle stand.
    pub(super) fn places_of(&self, a: usize) -> impl Iterator<Item = usize> + '_ {
        let (cluster, lane) = self.slot(a);
        self.range(cluster)
            .filter(move |&k| self.gradient[k][lane] != 0.0)
    }

    /// Particle or mirror image at a place in the lists.
    pub(super) fn neighbour(&self, place: usize) -> usize {
        self.neighbour[place] as usize
    }

    /// The pair of a particle with the neighbour at a place in the lists.
    pub(super) fn pair(&self, a: usize, place: usize) -> Pair {
        let (_, lane) = self.slot(a);
        let (own, other) = (&self.fixed[a], &self.fixed[self.neighbour(place)]);
        let offset = [0, 1].map(|k| own.position[k] - other.position[k]);
        let square = offset[0] * offset[0] + offset[1] * offset[1];
        let there = f64::from(u8::from(own.area != 0.0));
        let cubed = there * f64::from(self.gradient[place][lane]) * other.area;
        let mean = there * 0.5 * (1.0 + other.weight / own.weight);
        let impedance = mean * own.impedance.min(other.impedance);
        let stiffness = mean * own.stiffness.min(other.stiffness);
        let edge = own.edge.max(other.edge);
        let length = own.half_length + other.half_length;
        Pair {
            neighbour: self.neighbour[place],
            offset,
            gradient: cubed * square,
            viscous: edge.max(self.viscosity) * length * cubed * impedance,
            separating: edge * length * cubed * impedance,
            hourglass: f64::from(self.value[place][lane]) * other.area * stiffness,
        }
    }

    /// Number of pairs of all particles.
    pub(super) fn count(&self) -> usize {
        (0..self.slot.len())
            .map(|a| self.places_of(a).count())
            .sum()
    }

    /// Takes the particles marked, and their images, out of all sums.
    pub(super) fn silence(&mut self, forgotten: &[bool], images: &[Image]) {
        let (particles, beyond) = self.fixed.split_at_mut(forgotten.len());
        for (fixed, gone) in particles.iter_mut().zip(forgotten) {
            if *gone {
                fixed.area = 0.0;
            }
        }
        for (fixed, image) in beyond.iter_mut().zip(images) {
            if forgotten[image.source as usize] {
                fixed.area = 0.0;
            }
        }
    }
}

impl Cloud {
    /// Smallest smoothing length, m: unit of the stored kernel values.
    pub(super) fn unit(&self) -> f64 {
        let h = self.smoothing_length.iter();
        h.fold(f64::INFINITY, |m: f64, &x| m.min(x))
    }

    /// Square of the distance (m2) and smoothing length (m) of a pair.
    fn distance(&self, a: usize, j: usize) -> (f64, f64) {
        let offset = [0, 1].map(|k| self.points[a][k] - self.points[j][k]);
        let square = offset[0] * offset[0] + offset[1] * offset[1];
        let h = 0.5 * (self.smoothing_length[a] + self.smoothing_length[j]);
        (square, h)
    }

    /// (dW/dX)/X of a pair as precise as the stored ones: images on one side of a particle balance neighbours on the other.
    pub(super) fn gradient_factor(&self, a: usize, j: usize, unit: f64) -> f64 {
        let (square, h) = self.distance(a, j);
        let stored = (kernel::gradient_factor(square.sqrt(), h) / square * unit.powi(6)) as f32;
        f64::from(stored) * unit.powi(-6) * square
    }
}

/// The list of one cluster.
struct List {
    neighbour: Vec<u32>,
    gradient: Vec<[f32; LANES]>,
    value: Vec<[f32; LANES]>,
}

impl List {
    fn new(
        cloud: &Cloud,
        lists: &[Vec<u32>],
        members: &[u32; LANES],
        real: usize,
        unit: f64,
    ) -> Self {
        let all = members.iter().flat_map(|&a| &lists[a as usize]).copied();
        let mut neighbour: Vec<u32> = all.filter(|&j| (j as usize) < real).collect();
        neighbour.sort_unstable();
        neighbour.dedup();
        let each = |of: fn(f64, f64) -> f64, power: i32| -> Vec<[f32; LANES]> {
            let lane = |a: u32, j: u32| {
                if a == j {
                    0.0
                } else {
                    let (square, h) = cloud.distance(a as usize, j as usize);
                    (of(square.sqrt(), h) / square * unit.powi(power)) as f32
                }
            };
            let of_neighbour = |&j: &u32| members.map(|a| lane(a, j));
            neighbour.iter().map(of_neighbour).collect()
        };
        Self {
            gradient: each(kernel::gradient_factor, 6),
            value: each(kernel::value, 4),
            neighbour,
        }
    }
}

/// Particles in compact patches of [`LANES`]; the last one is filled up with its last particle.
fn patches(position: &[Vec2]) -> Vec<[u32; LANES]> {
    let patch = |c: &[u32]| std::array::from_fn(|k| c[k.min(c.len() - 1)]);
    patches::order(position).chunks(LANES).map(patch).collect()
}
