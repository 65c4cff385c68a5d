//! Liquid and ghosts side by side, so that sums over neighbours know no boundaries: for the published formulation.

use crate::fluid::Fluid;
use crate::fluid::ghosts::Ghosts;
use crate::geometry::length;

/// Liquid and ghosts at one instant, in arrays of equal length: particles first, then ghosts.
pub(crate) struct Extended<const D: usize> {
    pub(crate) position: Vec<[f64; D]>,
    pub(crate) velocity: Vec<[f64; D]>,
    pub(crate) area: Vec<f64>,
    pub(crate) pressure: Vec<f64>,
    pub(crate) density: Vec<f64>,
    pub(crate) sound_speed: Vec<f64>,
    pub(crate) smoothing_length: Vec<f64>,
}

impl<const D: usize> Extended<D> {
    /// Snapshot with the given velocities (those of the particles or a prediction of them).
    pub(crate) fn new(fluid: &Fluid<D>, ghosts: &Ghosts<D>, velocity: &[[f64; D]]) -> Self {
        let n = fluid.len();
        let area: Vec<f64> = (0..n).map(|a| fluid.area(a)).collect();
        let density: Vec<f64> = (0..n).map(|a| fluid.density(a)).collect();
        let sound_speed: Vec<f64> = density
            .iter()
            .map(|d| fluid.eos.sound_speed_at(*d))
            .collect();
        Self {
            position: ghosts.extend(&fluid.position, |p, x| p.mirror(x)),
            velocity: ghosts.extend(velocity, |p, v| p.mirror_velocity(v)),
            area: ghosts.extend_even(&area),
            pressure: ghosts.extend_even(&fluid.pressure),
            density: ghosts.extend_even(&density),
            sound_speed: ghosts.extend_even(&sound_speed),
            smoothing_length: ghosts.extend_even(&fluid.smoothing_length),
        }
    }

    /// Separation x_a - x_b, distance, and area-weighted gradient factor A_b W'/distance of a pair; none out of support.
    #[inline]
    pub(crate) fn pair(&self, a: usize, b: usize) -> Option<Pair<D>> {
        let (xa, xb) = (self.position[a], self.position[b]);
        let d: [f64; D] = std::array::from_fn(|k| xa[k] - xb[k]);
        let distance = length(d);
        let h = 0.5 * (self.smoothing_length[a] + self.smoothing_length[b]);
        (distance < crate::kernel::SUPPORT * h && distance > 0.0).then(|| Pair {
            separation: d,
            distance,
            h,
            factor: crate::kernel::gradient_factor_in::<D>(distance, h),
        })
    }
}

/// Geometry of a pair.
pub(crate) struct Pair<const D: usize> {
    pub(crate) separation: [f64; D],
    pub(crate) distance: f64,
    pub(crate) h: f64,
    /// (dW/ddistance)/distance, 1/m^(D + 2).
    pub(crate) factor: f64,
}
