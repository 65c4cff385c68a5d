use super::*;
use crate::geometry::Vec2;

fn random(n: usize, seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ n as u64;
    move || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    }
}

fn brute_force(x: &[Vec2], h: &[f64], a: usize, skin: f64) -> Vec<u32> {
    let near = |b: &usize| {
        let radius = 0.5 * SUPPORT * (1.0 + skin) * (h[a] + h[*b]);
        *b != a && (x[a][0] - x[*b][0]).hypot(x[a][1] - x[*b][1]) < radius
    };
    (0..x.len()).filter(near).map(|b| b as u32).collect()
}

/// Random places, smoothing lengths in a ratio of 1:8 (graded or not).
fn cloud(n: usize, seed: u64, graded: bool) -> (Vec<Vec2>, Vec<f64>) {
    let mut next = random(n, seed);
    let x: Vec<Vec2> = (0..n).map(|_| [next() - 0.3, 2.0 * next()]).collect();
    let h = x
        .iter()
        .map(|x| 0.01 * (1.0 + 7.0 * if graded { x[0] + 0.3 } else { next() }))
        .collect();
    (x, h)
}

#[test]
fn equals_brute_force() {
    for (seed, n) in [0, 1, 2, 3, 17, 300, 1500].into_iter().enumerate() {
        for graded in [true, false] {
            let (mut x, h) = cloud(n, seed as u64, graded);
            if n > 10 {
                x[7] = x[3]; // coincident
                x[5] = [1e3, -4e2]; // stray, far outside
            }
            for skin in [0.0, 0.15] {
                for n_real in [n, n / 2] {
                    let list = Neighbours::build(&x, &h, n_real, skin);
                    assert_eq!(list.len(), n_real);
                    for a in 0..n_real {
                        assert_eq!(list.of(a), brute_force(&x, &h, a, skin), "particle {a}");
                    }
                }
            }
        }
    }
}

#[test]
fn places_that_are_not_finite_have_no_neighbours() {
    let (mut x, h) = cloud(50, 1, true);
    x[4] = [f64::NAN, 0.5];
    x[9] = [f64::INFINITY, f64::NEG_INFINITY];
    let list = Neighbours::build(&x, &h, 50, 0.0);
    assert!(list.of(4).is_empty() && list.of(9).is_empty());
    assert_eq!(list.of(11), brute_force(&x, &h, 11, 0.0));
}

#[test]
fn does_not_depend_on_threads() {
    let (x, h) = cloud(3000, 5, true);
    let with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| Neighbours::build(&x, &h, 3000, 0.0))
    };
    assert_eq!(with(1), with(3));
}

/// Prints the speed: `cargo test --release -p erode-sph neighbours -- --ignored --nocapture`.
#[test]
#[ignore = "a measurement"]
fn speed() {
    for ratio in [1.0, 8.0_f64] {
        let (x, h) = sheet(ratio);
        let order = compact_order(&x);
        let x: Vec<Vec2> = order.iter().map(|&o| x[o as usize]).collect();
        let h: Vec<f64> = order.iter().map(|&o| h[o as usize]).collect();
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(1)
            .build()
            .unwrap();
        let mut best = f64::INFINITY;
        let mut pairs = 0;
        for _ in 0..20 {
            let clock = std::time::Instant::now();
            pairs = pool.install(|| Neighbours::build(&x, &h, x.len(), 0.05).pairs());
            best = best.min(clock.elapsed().as_secs_f64());
        }
        println!(
            "h 1:{ratio}: {} particles, {:.1} neighbours, {:.1} M pairs/s on one thread",
            x.len(),
            pairs as f64 / x.len() as f64,
            pairs as f64 / best * 1e-6
        );
    }
}

/// Jittered columns whose spacing grows from 1 to `ratio` along x, about 40 000 particles.
fn sheet(ratio: f64) -> (Vec<Vec2>, Vec<f64>) {
    let mut next = random(1, 3);
    let (mut x, mut h) = (Vec::new(), Vec::new());
    let mut at = 0.0;
    while x.len() < 40_000 {
        let s = 1.0 + (ratio - 1.0) * (x.len() as f64 / 40_000.0).powi(2);
        for j in 0..(800.0 / s) as usize {
            x.push([at + 0.2 * s * next(), (j as f64 + 0.2 * next()) * s]);
            h.push(1.3 * s);
        }
        at += s;
    }
    (x, h)
}
