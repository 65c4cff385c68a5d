use super::*;
use crate::kernel::{self, SUPPORT};
use crate::neighbours::Neighbours;

mod kinds;

const DX: f64 = 5e-6;

fn rectangle(lower: Vec2, upper: Vec2) -> Shape {
    Shape::Rectangle { lower, upper }
}

fn graded(core: Shape) -> Spacing {
    Spacing {
        finest: DX,
        coarsest: 8.0 * DX,
        growth: 0.06,
        core: Some(core),
    }
}

/// Water with a bubble of 30 spacings radius above a wall at z = 0.
fn water() -> (Region, Spacing) {
    let bubble = Shape::Disc {
        centre: [0.0, 0.2e-3],
        radius: 0.15e-3,
    };
    (
        Region::new(rectangle([0.0, 0.0], [1.2e-3, 1.1e-3])).with_hole(bubble),
        graded(rectangle([0.0, 0.0], [2.25e-4, 4.1e-4])),
    )
}

/// Block of steel below z = 0.
fn steel() -> (Region, Spacing) {
    (
        Region::new(rectangle([0.0, -0.75e-3], [1.2e-3, 0.0])),
        graded(rectangle([0.0, -1.1e-4], [3e-4, 0.0])),
    )
}

fn packed(case: &(Region, Spacing)) -> Packing {
    pack(&case.0, &case.1, &Options::default()).unwrap()
}

fn lists(packing: &Packing) -> (Vec<f64>, Neighbours) {
    let s = packing.spacing.clone();
    let h: Vec<f64> = s.iter().map(|s| SMOOTHING * s).collect();
    let list = Neighbours::build(&packing.position, &h, h.len(), 0.0);
    (s, list)
}

fn distance(a: Vec2, b: Vec2) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

fn pairs(list: &Neighbours) -> impl Iterator<Item = (usize, usize)> {
    (0..list.len()).flat_map(|a| list.of(a).iter().map(move |&b| (a, b as usize)))
}

#[test]
fn uniform_pressure_is_nearly_at_rest() {
    for case in [water(), steel()] {
        let packing = packed(&case);
        assert!(packing.residual.max < 0.01, "{:?}", packing.residual);
        assert!(packing.residual.mean < 0.002, "{:?}", packing.residual);
    }
}

/// The same away from the walls, summed here without images, together with the interpolation of a constant and the
/// plain gradient of a linear field (the lattice alone errs by 5e-5 and 0.0105).
#[test]
fn kernel_sums_of_the_interior_are_consistent() {
    for (region, spacing) in [water(), steel()] {
        let packing = packed(&(region.clone(), spacing.clone()));
        let (s, list) = lists(&packing);
        let mut checked = 0;
        for a in 0..s.len() {
            let x = packing.position[a];
            if -region.signed_distance(x) < 1.1 * SUPPORT * SMOOTHING * s[a] {
                continue;
            }
            let mut one = packing.area[a] * kernel::value(0.0, SMOOTHING * s[a]);
            let (mut force, mut slope) = ([0.0; 2], [0.0; 2]);
            for b in list.of(a).iter().map(|&b| b as usize) {
                let y = packing.position[b];
                let (r, h) = (distance(x, y), 0.5 * SMOOTHING * (s[a] + s[b]));
                one += packing.area[b] * kernel::value(r, h);
                for k in 0..2 {
                    let g = packing.area[b] * kernel::gradient_factor(r, h) * (x[k] - y[k]);
                    force[k] += g * s[a];
                    slope[k] += g * (y[k] - x[k]);
                }
            }
            assert!((one - 1.0).abs() < 0.01, "constant {one} at {x:?}");
            assert!(force[0].hypot(force[1]) < 0.01, "force {force:?} at {x:?}");
            assert!(
                slope.iter().all(|g| (g - 1.0).abs() < 0.05),
                "slope {slope:?} at {x:?}"
            );
            checked += 1;
        }
        assert!(checked > 2000);
    }
}

#[test]
fn no_pairs_no_voids_and_smooth_areas() {
    for (region, spacing) in [water(), steel()] {
        let packing = packed(&(region.clone(), spacing.clone()));
        let (s, list) = lists(&packing);
        for (a, b) in pairs(&list) {
            let apart = distance(packing.position[a], packing.position[b]) / (0.5 * (s[a] + s[b]));
            assert!(apart > 0.6, "{apart} between {a} and {b}");
            let ratio = packing.area[a] / packing.area[b];
            assert!(ratio < 1.6, "area ratio {ratio} of {a} and {b}");
        }
        assert!(largest_void(&packing, &region, &spacing) < 0.95);
    }
}

/// Largest distance of any place in the region from the nearest particle, in spacings: 0.71 in a square lattice.
fn largest_void(packing: &Packing, region: &Region, spacing: &Spacing) -> f64 {
    let (lower, upper) = region.bounding_box();
    let n = 300;
    let probes: Vec<Vec2> = (0..n * n)
        .map(|i| {
            let t = [i % n, i / n].map(|i| (f64::from(i) + 0.37) / f64::from(n));
            [0, 1].map(|k| lower[k] + t[k] * (upper[k] - lower[k]))
        })
        // Along the hole the lattice is cut in steps.
        .filter(|&x| region.contains(x) && region.holes.iter().all(|h| h.distance(x) > DX))
        .collect();
    let all: Vec<Vec2> = probes.iter().chain(&packing.position).copied().collect();
    let h: Vec<f64> = all.iter().map(|&x| spacing.at(x)).collect();
    let list = Neighbours::build(&all, &h, probes.len(), 0.0);
    let nearest = |p: usize| {
        let near = list.of(p).iter().map(|&b| b as usize);
        near.filter(|&b| b >= probes.len())
            .map(|b| distance(all[p], all[b]) / h[p])
            .fold(f64::INFINITY, f64::min)
    };
    (0..probes.len()).map(nearest).fold(0.0, f64::max)
}

#[test]
fn core_is_a_lattice_from_the_axis_and_the_wall() {
    for (case, side) in [(water(), 1.0), (steel(), -1.0)] {
        let packing = packed(&case);
        assert!(packing.undisturbed > 1000);
        for (x, area) in packing
            .position
            .iter()
            .zip(&packing.area)
            .take(packing.undisturbed)
        {
            for place in [x[0], side * x[1]] {
                let cell = place / DX - 0.5;
                assert!((cell - cell.round()).abs() < 1e-9 && cell > -0.1);
            }
            assert_eq!(*area, DX * DX);
        }
        let core = &packing.position[..packing.undisturbed];
        let first = core.iter().map(|x| side * x[1]).fold(1.0, f64::min);
        assert!((first - 0.5 * DX).abs() < 1e-12 * DX);
    }
}

#[test]
fn areas_add_up_and_the_estimate_is_close() {
    for case in [water(), steel()] {
        let packing = packed(&case);
        // The bubble cuts the lattice in steps: up to sqrt(boundary cells) cells too many or too few.
        let steps = if case.0.holes.is_empty() {
            0.0
        } else {
            10.0 * DX * DX
        };
        let error = packing.area.iter().sum::<f64>() - case.0.area();
        assert!(error.abs() < steps + 1e-6 * case.0.area(), "{error:e}");
        let estimate = estimate_count(&case.0, &case.1, true);
        assert!((estimate / packing.position.len() as f64 - 1.0).abs() < 0.02);
    }
}

#[test]
fn does_not_depend_on_threads() {
    let with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| packed(&steel()))
    };
    assert_eq!(with(1), with(3));
}
