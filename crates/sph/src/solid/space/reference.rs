//! The body as it was at the start: places, lists, moment matrices.

use super::blocks::{Block, Blocks};
use super::list::List;
use super::{Setup, SpaceError, TASK, lanes, sums, weight};
use crate::simd::{self, Simd, Task};
use rayon::prelude::*;

/// Smallest determinant of a moment matrix of mean 1 that spans a gradient; 0.3 in a corner of a cube.
const LEAST_MOMENT: f64 = 0.01;

/// The body as it was at the start.
#[derive(Debug, Clone)]
pub(super) struct Reference {
    /// Position, smoothing length (m) and share in the weights of pairs.
    pub(super) place: Blocks<5>,
    /// Moment matrix M, see `sums.rs`.
    pub(super) moment: Blocks<6>,
    pub(super) list: List,
    smoothing_ratio: f64,
}

impl Reference {
    /// Finds neighbours of the particles of a setup in this order.
    pub(super) fn new(setup: &Setup, order: &[u32]) -> Result<Self, SpaceError> {
        let smoothing_ratio = setup.numerics.smoothing_ratio;
        let place = Blocks::collect(order.len(), |a| {
            let a = order[a] as usize;
            let ([x, y, z], volume) = (setup.position[a], setup.volume[a]);
            let h = smoothing_ratio * volume.cbrt();
            [x, y, z, h, weight::share(volume, h)]
        });
        let mut moment = Blocks::splat(place.len(), [0.0; 6]);
        let mut reference = Self {
            moment: Blocks::default(),
            list: List::new(&place),
            place,
            smoothing_ratio,
        };
        (moment.blocks.par_chunks_mut(TASK).enumerate()).for_each(|(task, moment)| {
            simd::run(Moments(&reference, task, moment));
        });
        reference.moment = moment;
        reference.check()?;
        Ok(reference)
    }

    fn check(&self) -> Result<(), SpaceError> {
        for (particle, m) in self.moment.iter().enumerate() {
            let [xx, yy, zz, xy, xz, yz] = m;
            let mean = (xx + yy + zz) / 3.0;
            let determinant =
                xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
            let spans = determinant > LEAST_MOMENT * mean.powi(3);
            if !spans {
                let [x, y, z, _, _] = self.place.get(particle);
                return Err(SpaceError::TooFewNeighbours {
                    particle,
                    position: [x, y, z],
                });
            }
        }
        Ok(())
    }

    /// k = A/V of a cluster.
    #[inline(always)]
    pub(super) fn pair_factor<S: Simd>(&self, cluster: usize) -> S {
        let [_, _, _, h, share] = self.place.blocks[cluster].load::<S>();
        let spacing = h * S::splat(1.0 / self.smoothing_ratio);
        share / (spacing * spacing * spacing)
    }

    /// m = A^2/V of a cluster.
    #[inline(always)]
    pub(super) fn damper_factor<S: Simd>(&self, cluster: usize) -> S {
        let [_, _, _, _, share] = self.place.blocks[cluster].load::<S>();
        self.pair_factor::<S>(cluster) * share
    }
}

/// Moment matrices of the clusters of a task.
struct Moments<'a>(&'a Reference, usize, &'a mut [Block<6>]);

impl Task for Moments<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self(reference, task, moments) = self;
        for (k, moment) in moments.iter_mut().enumerate() {
            let cluster = task * TASK + k;
            let sum = sums::moment::<S>(&reference.list, &reference.place, cluster);
            moment.store(lanes::times(sum, reference.pair_factor(cluster)));
        }
    }
}
