//! Area of a domain without some shapes.

use super::domain::Domain;
use crate::shapes::Shape;
use std::f64::consts::PI;

/// Slices between two corners; the error falls with their square.
const SLICES: u32 = 2000;

/// Area of the domain outside of some shapes, which may overlap, m2.
///
/// Integrates the exact length of horizontal slices, with places that crowd at the corners, where slices of discs
/// change like a square root.
pub(super) fn area_without(domain: &Domain, cut: &[&Shape]) -> f64 {
    let (lower, upper) = domain.bounding_box();
    let mut corners = vec![lower[1], upper[1]];
    for shape in cut {
        let (l, u) = shape.bounding_box();
        corners.extend([l[1], u[1]].map(|y| y.clamp(lower[1], upper[1])));
    }
    corners.sort_by(f64::total_cmp);
    let slice = |y: f64| {
        let whole = interval(&domain.region.shape, y)
            .map(|(from, to)| (from.max(lower[0]), to.min(upper[0])));
        let holes = cut.iter().filter_map(|shape| interval(shape, y)).collect();
        whole.map_or(0.0, |whole| uncovered(whole, holes))
    };
    corners
        .windows(2)
        .map(|pair| integrate(pair[0], pair[1], &slice))
        .sum()
}

fn integrate(from: f64, to: f64, slice: &impl Fn(f64) -> f64) -> f64 {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    let step = PI / f64::from(SLICES);
    (0..SLICES)
        .map(|i| (f64::from(i) + 0.5) * step)
        .map(|t| slice(middle - half * t.cos()) * half * t.sin() * step)
        .sum()
}

/// The part of a horizontal line inside a shape.
fn interval(shape: &Shape, y: f64) -> Option<(f64, f64)> {
    match *shape {
        Shape::Rectangle { lower, upper } => {
            (lower[1] <= y && y <= upper[1]).then_some((lower[0], upper[0]))
        }
        Shape::Disc { centre, radius } => {
            let square = radius * radius - (y - centre[1]).powi(2);
            (square > 0.0).then(|| (centre[0] - square.sqrt(), centre[0] + square.sqrt()))
        }
    }
}

/// Length of an interval that no other interval covers.
fn uncovered(whole: (f64, f64), mut others: Vec<(f64, f64)>) -> f64 {
    others.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (mut at, mut length) = (whole.0, 0.0);
    for (from, to) in others {
        length += (from.min(whole.1) - at).max(0.0);
        at = at.max(to);
    }
    length + (whole.1 - at).max(0.0)
}
