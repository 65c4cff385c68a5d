use super::*;

const BOX: Shape = Shape::Rectangle {
    lower: [0.0, -1.0],
    upper: [3.0, 2.0],
};
const DISC: Shape = Shape::Disc {
    centre: [0.0, 0.5],
    radius: 1.0,
};

/// Counts points of a lattice turned by 0.5 rad, so that no side runs along its rows.
fn counted_area(inside: impl Fn(Vec2) -> bool) -> f64 {
    let n = 1000;
    let d = 12.0 / f64::from(n);
    let at = |i: i32| -6.0 + (f64::from(i) + 0.5) * d;
    let (sin, cos) = 0.5_f64.sin_cos();
    let turned = |x: f64, y: f64| [cos * x - sin * y, sin * x + cos * y];
    let hits = (0..n * n)
        .filter(|i| inside(turned(at(i % n), at(i / n))))
        .count();
    hits as f64 * d * d
}

#[test]
fn distances_have_the_right_sign_and_size() {
    assert_eq!(BOX.signed_distance([1.0, 0.0]), -1.0);
    assert_eq!(BOX.signed_distance([-3.0, -5.0]), 5.0);
    assert_eq!(BOX.distance([1.0, 1.0]), 0.0);
    assert_eq!(DISC.signed_distance([0.0, 0.5]), -1.0);
    assert_eq!(DISC.signed_distance([4.0, 3.5]), 4.0);
    assert!(BOX.contains([3.0, 2.0]) && !BOX.contains([3.001, 2.0]));
}

#[test]
fn normal_is_the_gradient_of_the_distance() {
    let region = Region::new(BOX).with_hole(DISC);
    let e = 1e-6;
    for p in [
        [0.2, -0.7],
        [2.5, 0.1],
        [1.3, 0.6],
        [-1.0, 4.0],
        [4.0, 0.3],
        [0.4, 0.7],
    ] {
        for (query, normal) in [
            (&BOX as &dyn Query, BOX.normal(p)),
            (&DISC, DISC.normal(p)),
            (&region, region.normal(p)),
        ] {
            let slope = |k: usize| {
                let (mut a, mut b) = (p, p);
                a[k] += e;
                b[k] -= e;
                (query.at(a) - query.at(b)) / (2.0 * e)
            };
            assert!((slope(0) - normal[0]).abs() < 1e-8, "{p:?}");
            assert!((slope(1) - normal[1]).abs() < 1e-8, "{p:?}");
        }
    }
}

trait Query {
    fn at(&self, p: Vec2) -> f64;
}
impl Query for Shape {
    fn at(&self, p: Vec2) -> f64 {
        self.signed_distance(p)
    }
}
impl Query for Region {
    fn at(&self, p: Vec2) -> f64 {
        self.signed_distance(p)
    }
}

#[test]
fn mirror_is_its_own_inverse_near_the_boundary() {
    let region = Region::new(BOX).with_hole(DISC);
    for p in [[2.9, 0.5], [0.1, -0.9], [1.05, 0.6], [1.5, 1.95]] {
        let image = region.mirror(p);
        assert!((region.signed_distance(image) + region.signed_distance(p)).abs() < 1e-12);
        let back = region.mirror(image);
        assert!((back[0] - p[0]).hypot(back[1] - p[1]) < 1e-12);
    }
}

#[test]
fn areas_match_counting() {
    // Cells of side 0.012 cut at random along edges of length up to 18: standard error 0.3 x 0.012^2 x sqrt(18/0.012).
    let shapes = [
        BOX,
        DISC,
        Shape::Disc {
            centre: [2.5, 1.5],
            radius: 1.7,
        },
        Shape::Disc {
            centre: [-0.6, 0.5],
            radius: 0.5,
        },
        Shape::Disc {
            centre: [1.0, 0.5],
            radius: 2.6,
        },
        Shape::Rectangle {
            lower: [-0.5, 0.0],
            upper: [0.5, 3.0],
        },
    ];
    for a in &shapes {
        for b in &shapes {
            let counted = counted_area(|p| a.contains(p) && b.contains(p));
            assert!((a.overlap_area(b) - counted).abs() < 5e-3, "{a:?} {b:?}");
        }
    }
    let half = Region::new(BOX).with_hole(DISC).area();
    assert!((half - (9.0 - 0.5 * PI)).abs() < 1e-14);
}
