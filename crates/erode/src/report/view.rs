//! What part of the bodies a picture shows.

use super::colour::robust_range;
use super::raster::View;
use super::snapshot::Body;

/// Particles up to this many times the finest spacing belong to the finely resolved region.
const FINE: f64 = 1.6;

/// The finely resolved region of all bodies with its mirror image, or everything where the resolution is uniform.
pub(crate) fn fine_view(bodies: &[Body]) -> Option<View> {
    let sizes: Vec<f64> = bodies
        .iter()
        .flat_map(|b| &b.size)
        .copied()
        .filter(|s| *s > 0.0)
        .collect();
    // Packed particles scatter around the spacing asked for: the smallest one would be misleading.
    let finest = robust_range(&sizes, 0.05)?[0];
    let fine = bodies
        .iter()
        .flat_map(|b| b.position.iter().zip(&b.size))
        .filter(|(_, s)| **s <= FINE * finest);
    let view = bounding(fine.map(|(p, _)| *p), 0.5 * finest)?;
    Some(without_depth(view, bodies))
}

/// The view with at most half as much solid below the surface as liquid above it: what happens deeper is seen in the
/// picture of the plastic strain. Unchanged without a liquid.
fn without_depth(view: View, bodies: &[Body]) -> View {
    let tops = bodies
        .iter()
        .filter(|b| b.is_solid())
        .flat_map(|b| &b.position)
        .map(|p| p[1]);
    let surface = tops.fold(f64::NEG_INFINITY, f64::max);
    let dry = bodies.iter().all(Body::is_solid);
    if dry || !(view.z[0] < surface && surface < view.z[1]) {
        return view;
    }
    View {
        z: [
            view.z[0].max(surface - 0.5 * (view.z[1] - surface)),
            view.z[1],
        ],
        ..view
    }
}

/// The region of the solids where the plastic strain is above a twentieth of its largest value, widened by a half.
pub(crate) fn strained_view(bodies: &[Body], largest: f64) -> Option<View> {
    if largest <= 0.0 {
        return None;
    }
    let solids = || bodies.iter().filter(|b| b.is_solid());
    let strained = solids().flat_map(|b| {
        let strain = b.field("plastic_strain").unwrap_or(&[]);
        b.position
            .iter()
            .zip(strain)
            .filter(|(_, e)| **e > 0.05 * largest)
            .map(|(p, _)| *p)
    });
    let finest = solids()
        .flat_map(|b| &b.size)
        .copied()
        .fold(f64::INFINITY, f64::min);
    let all = bounding(
        solids().flat_map(|b| b.position.iter().copied()),
        0.5 * finest,
    )?;
    let core = bounding(strained, 3.0 * finest)?;
    let reach = (1.5 * core.r[1]).min(all.r[1]);
    // At least half as high as wide, so that a thin skin does not become a stripe.
    let depth = (1.5 * (all.z[1] - core.z[0]))
        .max(reach)
        .min(all.z[1] - all.z[0]);
    Some(View {
        r: [-reach, reach],
        // Enough above the surface to be seen as empty and not as a gap.
        z: [
            all.z[1] - depth,
            all.z[1] + (0.04 * depth).max(2.0 * finest),
        ],
    })
}

/// The box around points and their mirror images, with a margin.
fn bounding(points: impl Iterator<Item = [f64; 2]>, margin: f64) -> Option<View> {
    let mut reach = 0.0_f64;
    let mut z = [f64::INFINITY, f64::NEG_INFINITY];
    for point in points.filter(|p| p[0].is_finite() && p[1].is_finite()) {
        reach = reach.max(point[0].abs());
        z = [z[0].min(point[1]), z[1].max(point[1])];
    }
    (z[0] <= z[1]).then(|| View {
        r: [-reach - margin, reach + margin],
        z: [z[0] - margin, z[1] + margin],
    })
}
