//! Other kinds of packings, refusals, speed.

use super::*;
use std::f64::consts::PI;

#[test]
fn uniform_spacing_is_a_perfect_lattice() {
    let region = Region::new(rectangle([0.2, 0.0], [1.2, 0.53]));
    let packing = pack(&region, &Spacing::uniform(0.05), &Options::default()).unwrap();
    assert_eq!(packing.position.len(), 20 * 11);
    assert_eq!(packing.undisturbed, 220);
    assert!(packing.residual.max < 1e-12);
    assert!((packing.area.iter().sum::<f64>() - 0.53).abs() < 1e-12);
}

#[test]
fn a_strip_of_two_rows_is_at_rest() {
    let region = Region::new(rectangle([-0.5, 0.0], [0.5, 0.1]));
    let options = Options {
        axis: false,
        ..Options::default()
    };
    let packing = pack(&region, &Spacing::uniform(0.05), &options).unwrap();
    assert_eq!(packing.position.len(), 40);
    assert!(packing.residual.max < 1e-12, "{:?}", packing.residual);
}

#[test]
fn shells_are_concentric_and_symmetric() {
    let (r0, dx) = (95e-6, 95e-6 / 30.0);
    let bubble = Shape::Disc {
        centre: [0.0, 0.0],
        radius: r0,
    };
    let region = Region::new(rectangle([0.0, -4.5e-4], [4.5e-4, 4.5e-4])).with_hole(bubble);
    let spacing = Spacing {
        finest: dx,
        coarsest: 6.0 * dx,
        growth: 0.06,
        core: Some(Shape::Disc {
            centre: [0.0, 0.0],
            radius: 1.35 * r0,
        }),
    };
    let options = Options {
        arrangement: Arrangement::Shells,
        ..Options::default()
    };
    let packing = pack(&region, &spacing, &options).unwrap();
    let core = &packing.position[..packing.undisturbed];
    for shell in 0..10 {
        let rho = r0 + (f64::from(shell) + 0.5) * dx;
        let on: Vec<Vec2> = core
            .iter()
            .copied()
            .filter(|x| (x[0].hypot(x[1]) - rho).abs() < 1e-9 * rho)
            .collect();
        let n = (PI * rho / dx).round();
        assert_eq!(on.len() as f64, n);
        let lowest = on.iter().map(|x| x[0]).fold(1.0, f64::min);
        assert!((lowest - rho * (0.5 * PI / n).sin()).abs() < 1e-9 * rho);
        for x in &on {
            assert!(on.iter().any(|y| distance([x[0], -x[1]], *y) < 1e-9 * rho));
        }
    }
    let total: f64 = packing.area.iter().sum();
    assert!((total / region.area() - 1.0).abs() < 1e-6);
    assert!(packing.residual.max < 0.015, "{:?}", packing.residual);
}

#[test]
fn a_ball_and_a_hole_outside_the_core_are_filled_to_their_rims() {
    let ball = Region::new(Shape::Disc {
        centre: [0.0, 1.0],
        radius: 1.0,
    });
    let packing = pack(&ball, &Spacing::uniform(0.05), &Options::default()).unwrap();
    let half: f64 = packing.area.iter().sum();
    assert!((half - 0.5 * PI).abs() < 1e-5, "{half}");
    assert!(
        packing
            .position
            .iter()
            .all(|&x| x[0] > 0.0 && ball.contains(x))
    );
    assert!(packing.residual.max < 0.05, "{:?}", packing.residual);

    let (mut region, spacing) = steel();
    region = region.with_hole(Shape::Disc {
        centre: [6e-4, -4e-4],
        radius: 1e-4,
    });
    let packing = packed(&(region.clone(), spacing));
    assert!(packing.position.iter().all(|&x| region.contains(x)));
    let total: f64 = packing.area.iter().sum();
    assert!((total / region.area() - 1.0).abs() < 1e-6);
}

#[test]
fn wrong_requests_are_refused() {
    let (region, spacing) = steel();
    let refuse = |region: &Region, spacing: &Spacing, arrangement| {
        let options = Options {
            arrangement,
            ..Options::default()
        };
        pack(region, spacing, &options).unwrap_err()
    };
    let lattice = Arrangement::Lattice;
    for finest in [0.0, -1.0, f64::NAN, 1.0] {
        let bad = Spacing {
            finest,
            ..spacing.clone()
        };
        assert!(matches!(
            refuse(&region, &bad, lattice),
            PackingError::Spacing { .. }
        ));
    }
    let thin = Region::new(rectangle([0.0, 0.0], [1.0, 1e-6]));
    let error = refuse(&thin, &Spacing::uniform(1e-5), lattice);
    assert!(matches!(error, PackingError::TooSmall { .. }));
    let narrow = Region::new(rectangle([0.0, 0.0], [1e-3, 3.0 * DX]));
    let error = refuse(
        &narrow,
        &graded(rectangle([0.0, 0.0], [1e-4, 3.0 * DX])),
        lattice,
    );
    assert!(matches!(error, PackingError::TooSmall { .. }));
    let left = Region::new(rectangle([-1.0, 0.0], [1.0, 1.0]));
    let error = refuse(&left, &Spacing::uniform(0.1), lattice);
    assert!(matches!(error, PackingError::NegativeRadius { .. }));
    let away = graded(rectangle([2.0, 2.0], [3.0, 3.0]));
    assert_eq!(refuse(&region, &away, lattice), PackingError::CoreOutside);
    assert_eq!(
        refuse(&region, &spacing, Arrangement::Shells),
        PackingError::NoDisc
    );
    let right = Region::new(rectangle([0.0, 0.0], [1.0, 1.0]));
    let error = refuse(&right, &Spacing::uniform(1e-6), lattice);
    assert!(matches!(error, PackingError::TooMany { .. }));
}

/// Prints time and residual: `cargo test --release -p erode-sph packing -- --ignored --nocapture`.
#[test]
#[ignore = "a measurement"]
fn speed() {
    let bubble = Shape::Disc {
        centre: [0.0, 0.2e-3],
        radius: 0.15e-3,
    };
    let region = Region::new(rectangle([0.0, 0.0], [1.2e-3, 1.1e-3])).with_hole(bubble);
    let spacing = Spacing {
        finest: 2e-6,
        coarsest: 1.6e-5,
        ..graded(rectangle([0.0, 0.0], [2.25e-4, 4.1e-4]))
    };
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build()
        .unwrap();
    let clock = std::time::Instant::now();
    let packing = pool.install(|| packed(&(region, spacing)));
    println!(
        "{} particles, {} relaxed, {:.2} s, {:?}",
        packing.position.len(),
        packing.position.len() - packing.undisturbed,
        clock.elapsed().as_secs_f64(),
        packing.residual
    );
}
