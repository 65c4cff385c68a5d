//! Where particles and ghosts stand in the clusters of eight.
//!
//! Places: particles as they follow each other in the arrays of the liquid, ghosts of axis and rigid sides, ghosts of surfaces of
//! solids; each of the three is filled up to a multiple of eight with places that nobody has for a neighbour. Particles that follow
//! each other lie close together: where they no longer do, all arrays are put in a new order.

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

/// How well eight particles that follow each other lie together. When they are put in a new order depends on it: part of a
/// checkpoint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Clustering {
    /// Length of all lists when the order was new; 0 when there are none yet.
    pub fresh: usize,
    /// Whether the next step makes a new order.
    pub stale: bool,
}

impl Default for Clustering {
    /// The first step makes an order.
    fn default() -> Self {
        Self {
            fresh: 0,
            stale: true,
        }
    }
}

impl Clustering {
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

    /// A new order of the particles if those of a cluster no longer lie together.
    pub(crate) fn renew_clusters(&mut self) {
        if self.clustering.stale {
            self.arrange(&compact_order(&self.position));
            self.clustering.fresh = 0;
        }
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
    particles: usize,
    /// Place of each ghost.
    of_ghost: Vec<u32>,
    lists: ClusterLists<D>,
    total: usize,
    groups: Vec<Points<D>>,
}

impl<const D: usize> Default for Places<D> {
    fn default() -> Self {
        Self {
            particles: 0,
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
        self.number(fluid.len(), &ghosts.surface);
        self.place(fluid, ghosts, dt);
        let clusters = fluid.len().div_ceil(LANES);
        let ordinary = ghosts.surface.iter().filter(|s| !**s).count();
        let divide = (clusters + ordinary.div_ceil(LANES)) * LANES;
        self.lists.rebuild(&self.groups, clusters, divide);
        fluid.clustering.judge(self.lists.len());
    }

    /// Points of all places, in their groups.
    fn place(&mut self, fluid: &Fluid<D>, ghosts: &Ghosts<D>, dt: f64) {
        let own = (fluid.position.par_chunks(LANES))
            .enumerate()
            .with_min_len(PARTICLES_PER_TASK / LANES)
            .map(|(cluster, position)| {
                let mut points = Points::NONE;
                for (lane, x) in position.iter().enumerate() {
                    points.set(lane, *x, fluid.reach(cluster * LANES + lane, dt));
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

    fn number(&mut self, particles: usize, surface: &[bool]) {
        self.particles = particles;
        let ordinary = surface.iter().filter(|s| !**s).count();
        let mut next = [particles.next_multiple_of(LANES), 0];
        next[1] = next[0] + ordinary.next_multiple_of(LANES);
        self.of_ghost.clear();
        self.of_ghost.extend(surface.iter().map(|s| {
            let next = &mut next[usize::from(*s)];
            *next += 1;
            (*next - 1) as u32
        }));
        self.total = next[1].next_multiple_of(LANES);
    }

    /// The records of all particles, to be filled before [`Self::sum`].
    pub(crate) fn records<'a, P: Record, R>(&self, sums: &'a mut Sums<P, R>) -> &'a mut [P] {
        sums.records.resize(self.total + LANES, P::default());
        &mut sums.records[..self.particles]
    }

    /// Sums over the neighbours, with the records of the particles and the `image` of a record in a plane. Where nobody stands there
    /// is a record of zeros.
    pub(crate) fn sum<L: PairSum>(
        &self,
        law: &L,
        ghosts: &Ghosts<D>,
        image: impl Fn(&Plane<D>, L::Particle) -> L::Particle,
        sums: &mut Sums<L::Particle, L::Result>,
    ) {
        let records = &mut sums.records;
        records[self.particles..].fill(L::Particle::default());
        for (k, place) in self.of_ghost.iter().enumerate() {
            records[*place as usize] =
                image(&ghosts.plane[k], records[self.source_place(ghosts, k)]);
        }
        self.lists.sum(law, records, &mut sums.results);
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
        let mut marked = vec![false; self.total + LANES];
        (marked[..self.particles].par_iter_mut())
            .zip(&mut sums.records)
            .enumerate()
            .with_min_len(PARTICLES_PER_TASK)
            .for_each(|(a, (marked, record))| *marked = change(a, record));
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
        match source.checked_sub(self.particles) {
            None => source,
            Some(ghost) => self.of_ghost[ghost] as usize,
        }
    }

    /// Number of particles that have a place.
    pub(crate) fn len(&self) -> usize {
        self.particles
    }
}
