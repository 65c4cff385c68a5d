//! The bubble of a run at one instant: its volume, its place, its jet.

use super::monitor::{liquid, solid};
use crate::analysis::half_width;
use crate::case::{Bubble, BubbleGas};
use erode_sph::cavity::{Cavity, Colour, Window};
use erode_sph::fluid::Fluid;
use erode_sph::fluid::ghosts::{Ghosts, Wall};
use erode_sph::geometry::Vec2;
use erode_sph::interface::SurfaceLine;
use erode_sph::solid::Side;
use erode_sph::world::World;
use std::f64::consts::PI;

/// A void of fewer cells than this is a gap between particles, not a bubble (a cell is half a spacing wide).
const SMALLEST_VOID: usize = 8;

/// The bubble at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BubbleState {
    /// Void volume, m3 (per metre in plane).
    pub volume: f64,
    /// Height of the centroid, m.
    pub centre: f64,
    /// Distance of the centroid from the axis, m: zero for a void on the axis.
    pub centre_r: f64,
    /// Voids.
    pub parts: usize,
    /// Distance of the largest void from the axis, m: positive for a toroid.
    pub inner_radius: f64,
    /// Gap on the axis between the upper and lower side of the void, m.
    pub gap: f64,
    /// Mean velocity of the liquid at the upper side on the axis towards the wall, m/s; NaN without a void on the axis.
    pub jet_speed: f64,
    /// Distance from the axis at which that velocity has fallen to half, m; NaN without a void on the axis.
    pub jet_half_width: f64,
}

/// Surfaces of solids that the liquid meets.
pub(super) fn wetted(world: &World) -> Vec<SurfaceLine> {
    let surface = solid(world).and_then(|s| s.surface(Side::Top));
    surface.map(SurfaceLine::of).into_iter().collect()
}

/// Where the bubble is looked for, in cells of the size `cell` (m).
pub(super) fn window(bubble: &Bubble, cell: f64) -> Window {
    // An empty bubble only shrinks; gas is looked for as far as it may grow.
    let reach = bubble.gas.map_or(1.4, |_| BubbleGas::REACH) * bubble.radius;
    let floor = if bubble.wall_distance.is_some() {
        0.0
    } else {
        f64::NEG_INFINITY
    };
    Window {
        lower: [0.0, (bubble.centre[1] - reach).max(floor)],
        upper: [bubble.centre[0] + reach, bubble.centre[1] + reach],
        cell,
    }
}

/// Measures the bubble.
#[must_use]
pub fn bubble(world: &World, bubble: &Bubble, cell: f64) -> BubbleState {
    let nothing = BubbleState {
        volume: 0.0,
        centre: f64::NAN,
        centre_r: f64::NAN,
        parts: 0,
        inner_radius: f64::NAN,
        gap: 0.0,
        jet_speed: f64::NAN,
        jet_half_width: f64::NAN,
    };
    let Some(fluid) = liquid(world) else {
        return nothing;
    };
    let lines = wetted(world);
    let walls: Vec<&dyn Wall> = lines.iter().map(|l| l as &dyn Wall).collect();
    let window = window(bubble, cell);
    let colour = Colour::new(fluid, &Ghosts::find(fluid, &walls), window);
    let cavities = colour.cavities(SMALLEST_VOID);
    let Some(largest) = cavities.first() else {
        return nothing;
    };
    let volume: f64 = cavities.iter().map(|c| c.volume).sum();
    let on_axis = cavities.iter().find(|c| c.inner_radius == 0.0);
    let mean = |k: usize| cavities.iter().map(|c| c.volume * c.centre[k]).sum::<f64>() / volume;
    BubbleState {
        volume,
        centre: mean(1),
        centre_r: mean(0),
        parts: cavities.len(),
        inner_radius: largest.inner_radius,
        gap: on_axis.map_or(0.0, Cavity::gap),
        jet_speed: on_axis.map_or(f64::NAN, |c| tip_speed(fluid, [0.0, c.axis_extent[1]])),
        jet_half_width: on_axis.map_or(f64::NAN, |c| jet_width(fluid, c.axis_extent[1])),
    }
}

/// Half-width of the jet one smoothing length above its tip, NaN where it has none.
fn jet_width(fluid: &Fluid, tip: f64) -> f64 {
    let finest = fluid
        .smoothing_length
        .iter()
        .copied()
        .fold(f64::INFINITY, f64::min);
    let speed: Vec<f64> = fluid.velocity.iter().map(|v| -v[1]).collect();
    half_width(&fluid.position, &speed, tip + finest, 0.5 * finest).unwrap_or(f64::NAN)
}

/// Kernel mean of the velocity towards smaller z just above `tip`.
fn tip_speed(fluid: &Fluid, tip: Vec2) -> f64 {
    let square = |x: Vec2| (x[0] - tip[0]).powi(2) + (x[1] - tip[1]).powi(2);
    let above = |a: usize| fluid.position[a][1] > tip[1] - fluid.smoothing_length[a];
    let distances = (0..fluid.len())
        .filter(|a| above(*a))
        .map(|a| (square(fluid.position[a]), a));
    let nearest = distances.min_by(|p, q| p.0.total_cmp(&q.0));
    let Some((_, nearest)) = nearest else {
        return f64::NAN;
    };
    let reach = (2.0 * fluid.smoothing_length[nearest]).powi(2);
    let (mut sum, mut weight) = (0.0, 0.0);
    for a in 0..fluid.len() {
        if square(fluid.position[a]) < reach && above(a) {
            let w = fluid.mass[a] / fluid.geometry.ring(fluid.position[a][0]);
            sum -= w * fluid.velocity[a][1];
            weight += w;
        }
    }
    sum / weight
}

/// Radius of the ball (disc in plane) with a volume.
#[must_use]
pub(crate) fn equivalent_radius(volume: f64, geometry: erode_sph::Geometry) -> f64 {
    match geometry {
        erode_sph::Geometry::Axisymmetric => (3.0 * volume.max(0.0) / (4.0 * PI)).cbrt(),
        // Half a disc lies at x > 0.
        erode_sph::Geometry::Plane => (2.0 * volume.max(0.0) / PI).sqrt(),
    }
}

#[cfg(test)]
#[path = "bubble_state_tests.rs"]
mod tests;
