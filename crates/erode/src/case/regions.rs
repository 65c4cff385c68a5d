//! Shapes against each other: do they overlap, does one lie in another.

use erode_sph::{geometry::Vec2, shapes::Shape};

/// Corners of the smallest rectangle around a shape.
pub(crate) fn bounds(shape: &Shape) -> (Vec2, Vec2) {
    match *shape {
        Shape::Rectangle { lower, upper } => (lower, upper),
        Shape::Disc { centre: [x, y], radius: r } => ([x - r, y - r], [x + r, y + r]),
    }
}

/// Whether a point lies in a shape or on its edge.
pub(crate) fn contains(shape: &Shape, p: Vec2) -> bool {
    distance(shape, p) <= 0.0
}

/// Distance of a point from a shape, m; zero inside.
pub(crate) fn distance(shape: &Shape, p: Vec2) -> f64 {
    match *shape {
        Shape::Rectangle { lower, upper } => {
            let outside = |k: usize| (lower[k] - p[k]).max(p[k] - upper[k]).max(0.0);
            outside(0).hypot(outside(1))
        }
        Shape::Disc { centre, radius } => ((p[0] - centre[0]).hypot(p[1] - centre[1]) - radius).max(0.0),
    }
}

/// Whether two shapes share an area, not only an edge.
pub(crate) fn overlap(a: &Shape, b: &Shape) -> bool {
    // Edges that are meant to coincide may differ by rounding.
    let slack = 1e-9 * size(a).min(size(b));
    match (a, b) {
        (Shape::Disc { centre, radius }, other) | (other, Shape::Disc { centre, radius }) => {
            distance(other, *centre) < radius - slack
        }
        (Shape::Rectangle { lower: al, upper: au }, Shape::Rectangle { lower: bl, upper: bu }) => {
            (0..2).all(|k| al[k].max(bl[k]) < au[k].min(bu[k]) - slack)
        }
    }
}

/// Whether `inner` lies in `outer` as a whole.
pub(crate) fn encloses(outer: &Shape, inner: &Shape) -> bool {
    match (outer, inner) {
        (Shape::Disc { centre: c, radius: r }, Shape::Disc { centre, radius }) => {
            (c[0] - centre[0]).hypot(c[1] - centre[1]) + radius <= *r
        }
        _ => {
            let (l, u) = bounds(inner);
            [l, u, [l[0], u[1]], [u[0], l[1]]].iter().all(|p| contains(outer, *p))
        }
    }
}

/// Smallest extent, m.
pub(crate) fn size(shape: &Shape) -> f64 {
    let (l, u) = bounds(shape);
    (u[0] - l[0]).min(u[1] - l[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn touching_is_no_overlap() {
        let a = Shape::Rectangle { lower: [0.0, 0.0], upper: [2.0, 1.0] };
        let above = Shape::Rectangle { lower: [0.0, 1.0], upper: [2.0, 3.0] };
        let inside = Shape::Rectangle { lower: [0.5, 0.9], upper: [0.7, 3.0] };
        let disc = Shape::Disc { centre: [1.0, 2.0], radius: 1.0 };
        let larger = Shape::Disc { centre: [1.0, 2.0], radius: 1.1 };
        assert!(!overlap(&a, &above));
        assert!(overlap(&a, &inside));
        assert!(!overlap(&a, &disc));
        assert!(overlap(&a, &larger));
        assert!(overlap(&disc, &larger));
        assert!(encloses(&larger, &disc) && !encloses(&disc, &larger));
        assert!(!encloses(&disc, &Shape::Rectangle { lower: [0.1, 1.1], upper: [1.9, 2.9] }));
    }
}
