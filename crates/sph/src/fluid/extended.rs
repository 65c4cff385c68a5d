//! Liquid and ghosts side by side, so that sums over neighbours know no boundaries: for the published formulation.

use crate::fluid::Fluid;
use crate::fluid::ghosts::Ghosts;
use crate::geometry::Vec2;

/// Liquid and ghosts at one instant, in arrays of equal length: particles first, then ghosts.
pub(crate) struct Extended {
    pub(crate) position: Vec<Vec2>,
    pub(crate) velocity: Vec<Vec2>,
    pub(crate) area: Vec<f64>,
    pub(crate) pressure: Vec<f64>,
    pub(crate) density: Vec<f64>,
    pub(crate) sound_speed: Vec<f64>,
    pub(crate) smoothing_length: Vec<f64>,
}

impl Extended {
    /// Snapshot with the given velocities (those of the particles or a prediction of them).
    pub(crate) fn new(fluid: &Fluid, ghosts: &Ghosts, velocity: &[Vec2]) -> Self {
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
    pub(crate) fn pair(&self, a: usize, b: usize) -> Option<Pair> {
        let (xa, xb) = (self.position[a], self.position[b]);
        let d = [xa[0] - xb[0], xa[1] - xb[1]];
        let distance = (d[0] * d[0] + d[1] * d[1]).sqrt();
        let h = 0.5 * (self.smoothing_length[a] + self.smoothing_length[b]);
        (distance < crate::kernel::SUPPORT * h && distance > 0.0).then(|| Pair {
            separation: d,
            distance,
            h,
            factor: crate::kernel::gradient_factor(distance, h),
        })
    }
}

/// Geometry of a pair.
pub(crate) struct Pair {
    pub(crate) separation: Vec2,
    pub(crate) distance: f64,
    pub(crate) h: f64,
    /// (dW/ddistance)/distance, 1/m4.
    pub(crate) factor: f64,
}
