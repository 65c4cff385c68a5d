//! Where particles and ghosts stand in the clusters of eight.
//!
//! Places: particles in the order of their clusters, ghosts of axis and rigid sides, ghosts of surfaces of solids; each of the
//! three is filled up to a multiple of eight with places that nobody has for a neighbour. The particles themselves stay where
//! they are in the arrays of the liquid; only the order is renewed.

use crate::fluid::ghosts::{Ghosts, Plane};
use crate::fluid::{Fluid, PARTICLES_PER_TASK};
use crate::geometry::length;
use crate::neighbours::boxes::Points;
use crate::neighbours::clusters::ClusterLists;
use crate::neighbours::order::compact_order;
use crate::neighbours::pair_sum::{PairSum, Record};
use crate::simd::LANES;
use rayon::prelude::*;

/// Lists that have grown to this multiple of their length when the clusters were new call for new ones.
const STALE: f64 = 1.1;

/// Room in the lists for the change of h and for shifting within a step of dt, in units of h: the first at rest, the second
/// times |grad v| dt of the last step. Shifting moves a particle by up to 2 h |grad v| dt (with `shifting_limit` 2), and h changes by
/// less than half of h |grad v| dt: 2.5, and more for a rate that grows from one step to the next. Motion comes on top.
const ROOM: (f64, f64) = (0.005, 4.0);

/// Which eight particles make a cluster. Results depend on it in the last bits: part of a checkpoint.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Clustering {
    /// Particles in the order of the clusters.
    pub order: Vec<u32>,
    /// Length of all lists when the clusters were new; 0 when they have none yet.
    pub fresh: usize,
    /// Whether the next step makes new clusters.
    pub stale: bool,
}

impl Clustering {
    /// Clusters that the first step will make.
    pub(crate) fn of(n: usize) -> Self {
        Self {
            order: (0..n as u32).collect(),
            fresh: 0,
            stale: true,
        }
    }

    /// Whether the order names each particle once.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        let mut seen = vec![false; self.order.len()];
        for &a in &self.order {
            if let Some(seen) = seen.get_mut(a as usize) {
                *seen = true;
            }
        }
        seen.iter().all(|s| *s)
    }

    /// New clusters where the old ones no longer lie together.
    fn renew<const D: usize>(&mut self, position: &[[f64; D]]) {
        if self.stale || self.order.len() != position.len() {
            self.order = compact_order(position);
            self.fresh = 0;
        }
    }

    /// Whether the clusters still lie together, from the length of all lists.
    fn judge(&mut self, entries: usize) {
        if self.fresh == 0 {
            self.fresh = entries;
        }
        self.stale = entries as f64 > STALE * self.fresh as f64;
    }
}

impl<const D: usize> Fluid<D> {
    /// Half of the support of particle `a` with room for what a step of `dt` may bring, m.
    fn reach(&self, a: usize, dt: f64) -> f64 {
        let room = ROOM.0 + ROOM.1 * self.strain_rate[a] * dt;
        (1.0 + room) * self.smoothing_length[a] + 0.5 * dt * length(self.velocity[a])
    }

    /// New clusters if those of the last step no longer lie together.
    pub(crate) fn renew_clusters(&mut self) {
        self.clustering.renew(&self.position);
    }
}

/// Records of all places, and what comes out for the particles, by place.
#[derive(Debug, Clone)]
pub(crate) struct Sums<P, R> {
    records: Vec<P>,
    /// Results of the last law.
    pub(crate) results: Vec<R>,
}

impl<P, R> Default for Sums<P, R> {
    fn default() -> Self {
        Self {
            records: Vec::new(),
            results: Vec::new(),
        }
    }
}

/// Places and lists of one step. Kept for the next step for the sake of its memory.
#[derive(Debug, Clone)]
pub(crate) struct Places<const D: usize> {
    order: Vec<u32>,
    /// Place of each particle.
    of_particle: Vec<u32>,
    /// Place of each ghost.
    of_ghost: Vec<u32>,
    lists: ClusterLists<D>,
    total: usize,
    groups: Vec<Points<D>>,
}

impl<const D: usize> Default for Places<D> {
    fn default() -> Self {
        Self {
            order: Vec::new(),
            of_particle: Vec::new(),
            of_ghost: Vec::new(),
            lists: ClusterLists::default(),
            total: 0,
            groups: Vec::new(),
        }
    }
}

impl<const D: usize> Places<D> {
    /// Places and neighbours for the rest of a step of `dt`: pairs that come into the support of the kernel until its end are in
    /// the lists too.
    pub(crate) fn find(&mut self, fluid: &mut Fluid<D>, ghosts: &Ghosts<D>, dt: f64) {
        self.number(&fluid.clustering.order, &ghosts.surface);
        self.place(fluid, ghosts, dt);
        let clusters = fluid.len().div_ceil(LANES);
        let ordinary = ghosts.surface.iter().filter(|s| !**s).count();
        let divide = (clusters + ordinary.div_ceil(LANES)) * LANES;
        self.lists.rebuild(&self.groups, clusters, divide);
        fluid.clustering.judge(self.lists.len());
    }

    /// Points of all places, in their groups.
    fn place(&mut self, fluid: &Fluid<D>, ghosts: &Ghosts<D>, dt: f64) {
        let own = (self.order.par_chunks(LANES))
            .with_min_len(PARTICLES_PER_TASK / LANES)
            .map(|members| {
                let mut points = Points::NONE;
                for (lane, &a) in members.iter().enumerate() {
                    let a = a as usize;
                    points.set(lane, fluid.position[a], fluid.reach(a, dt));
                }
                points
            });
        own.collect_into_vec(&mut self.groups);
        self.groups.resize(self.total / LANES, Points::NONE);
        for (k, &place) in self.of_ghost.iter().enumerate() {
            let source = self.source_place(ghosts, k);
            let (x, reach) = self.groups[source / LANES].get(source % LANES);
            let place = place as usize;
            self.groups[place / LANES].set(place % LANES, ghosts.plane[k].mirror(x), reach);
        }
    }

    fn number(&mut self, order: &[u32], surface: &[bool]) {
        if self.order != order {
            self.order.clear();
            self.order.extend_from_slice(order);
            self.of_particle.resize(order.len(), 0);
            for (place, &a) in order.iter().enumerate() {
                self.of_particle[a as usize] = place as u32;
            }
        }
        let ordinary = surface.iter().filter(|s| !**s).count();
        let mut next = [order.len().next_multiple_of(LANES), 0];
        next[1] = next[0] + ordinary.next_multiple_of(LANES);
        self.of_ghost.clear();
        self.of_ghost.extend(surface.iter().map(|s| {
            let next = &mut next[usize::from(*s)];
            *next += 1;
            (*next - 1) as u32
        }));
        self.total = next[1].next_multiple_of(LANES);
    }

    /// One record per place: `of` a particle, `image` of another record in a plane; anything where nobody stands.
    fn fill<R: Record>(
        &self,
        records: &mut Vec<R>,
        ghosts: &Ghosts<D>,
        of: impl Fn(usize) -> R + Sync,
        image: impl Fn(&Plane<D>, R) -> R,
    ) {
        let n = self.order.len();
        records.resize(self.total, R::default());
        (records[..n].par_iter_mut().zip(&self.order))
            .with_min_len(PARTICLES_PER_TASK)
            .for_each(|(record, a)| *record = of(*a as usize));
        records[n..].fill(R::default());
        for (k, place) in self.of_ghost.iter().enumerate() {
            records[*place as usize] =
                image(&ghosts.plane[k], records[self.source_place(ghosts, k)]);
        }
    }

    /// Sums over the neighbours, with a record `of` each particle and the `image` of a record in a plane; use [`Self::of`] to
    /// find those of a particle.
    pub(crate) fn sum<L: PairSum>(
        &self,
        law: &L,
        ghosts: &Ghosts<D>,
        of: impl Fn(usize) -> L::Particle + Sync,
        image: impl Fn(&Plane<D>, L::Particle) -> L::Particle,
        sums: &mut Sums<L::Particle, L::Result>,
    ) {
        self.fill(&mut sums.records, ghosts, of, image);
        self.lists.sum(law, &sums.records, &mut sums.results);
    }

    /// The sums once more after `change` has changed the records of some particles (and says of which): only where these are
    /// neighbours.
    pub(crate) fn sum_again<L: PairSum>(
        &self,
        law: &L,
        ghosts: &Ghosts<D>,
        change: impl Fn(usize, &mut L::Particle) -> bool + Sync,
        image: impl Fn(&Plane<D>, L::Particle) -> L::Particle,
        sums: &mut Sums<L::Particle, L::Result>,
    ) {
        let mut marked = vec![false; self.total];
        (marked.par_iter_mut().zip(&mut sums.records))
            .zip(&self.order)
            .with_min_len(PARTICLES_PER_TASK)
            .for_each(|((marked, record), &a)| *marked = change(a as usize, record));
        for (k, &place) in self.of_ghost.iter().enumerate() {
            let source = self.source_place(ghosts, k);
            if marked[source] {
                marked[place as usize] = true;
                sums.records[place as usize] = image(&ghosts.plane[k], sums.records[source]);
            }
        }
        self.lists
            .sum_near(law, &sums.records, &mut sums.results, &marked);
    }

    /// Place of what ghost `k` is an image of.
    fn source_place(&self, ghosts: &Ghosts<D>, k: usize) -> usize {
        let source = ghosts.source[k] as usize;
        let place = match source.checked_sub(self.order.len()) {
            None => self.of_particle[source],
            Some(ghost) => self.of_ghost[ghost],
        };
        place as usize
    }

    /// Number of particles that have a place.
    pub(crate) fn len(&self) -> usize {
        self.of_particle.len()
    }

    /// Place of particle `a`.
    #[inline]
    pub(crate) fn of(&self, a: usize) -> usize {
        self.of_particle[a] as usize
    }
}
