use super::*;

/// Every operation on eight pairs and triples of numbers, as bits.
struct Everything([[f64; LANES]; 3]);

impl Task for Everything {
    type Output = Vec<[u64; LANES]>;

    #[inline(always)]
    fn run<S: Simd>(self) -> Self::Output {
        let [a, b, c] = self.0.each_ref().map(S::load);
        let less = a.lt(b);
        let results = [
            a + b,
            a - b,
            a * b,
            a / b,
            -a,
            a.mul_add(b, c),
            a.abs().sqrt(),
            a.abs(),
            a.min(b),
            a.max(b),
            S::select(less, b, c),
            S::splat(self.0[2][3]),
            S::splat(f64::from(S::bits(less))),
            S::splat_halves(self.0[1][2], self.0[2][5]),
            a.halves()[0],
            a.halves()[1],
            a.sum_halves(c),
            S::load_single(&self.0[0].map(|x| x as f32)),
            S::load(&self.0[0].map(|x| within(x.abs() * 7.0, 1e-300, 1e300)))
                .split()
                .0,
            S::load(&self.0[0].map(|x| within(x.abs() * 7.0, 1e-300, 1e300)))
                .split()
                .1,
            b.scale(S::load(
                &self.0[0].map(|x| within(x, -500.0, 500.0).round()),
            )),
            functions::ln(S::load(
                &self.0[0].map(|x| within(x.abs() * 7.0, 1e-300, 1e300)),
            )),
            functions::exp(c),
        ];
        // The sign and payload of a result that is not a number are nobody's business.
        let bits = |x: f64| if x.is_nan() { u64::MAX } else { x.to_bits() };
        results.map(|r| r.store().map(bits)).to_vec()
    }
}

/// Clamped; `least` for what is not a number.
fn within(x: f64, least: f64, most: f64) -> f64 {
    if x.is_nan() {
        least
    } else {
        x.clamp(least, most)
    }
}

fn with(width: Width, task: Everything) -> Vec<[u64; LANES]> {
    match width {
        #[cfg(target_arch = "x86_64")]
        Width::Avx512 => avx512::run(task),
        #[cfg(target_arch = "x86_64")]
        Width::Avx2 => avx2::run(task),
        _ => task.run::<scalar::Lanes>(),
    }
}

#[test]
fn all_widths_give_the_same_bits() {
    let special = [0.0, -0.0, 1.0, -3.5, 1e-310, 1e300, f64::INFINITY, f64::NAN];
    let mut state = 1_u64;
    let mut next = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        let unit = (state >> 11) as f64 / (1_u64 << 53) as f64;
        (unit - 0.5) * 2.0_f64.powi((state % 60) as i32 - 30)
    };
    for k in 0..2000 {
        let mut lanes = [[0.0; LANES]; 3];
        lanes.iter_mut().flatten().for_each(|x| *x = next());
        if k < 8 {
            lanes[0] = special;
            lanes[1].rotate_left(k);
            lanes[1] = special;
            lanes[1].rotate_left(k);
        }
        let reference = with(Width::Scalar, Everything(lanes));
        for width in Width::ALL.into_iter().filter(|w| w.is_available()) {
            assert_eq!(
                with(width, Everything(lanes)),
                reference,
                "{}: {lanes:?}",
                width.name()
            );
        }
    }
}

#[test]
fn the_reference_does_what_it_says() {
    let [a, b, c] = [
        [1.0, -2.0, 3.0, 4.0, 0.1, 6.0, 7.0, -8.0],
        [2.0; 8],
        [0.5; 8],
    ];
    let found = with(Width::Scalar, Everything([a, b, c]));
    for i in 0..LANES {
        let less = a[i] < b[i];
        let mask = f64::from((0..LANES).map(|k| u8::from(a[k] < b[k]) << k).sum::<u8>());
        let expected = [
            a[i] + b[i],
            a[i] - b[i],
            a[i] * b[i],
            a[i] / b[i],
            -a[i],
            a[i].mul_add(b[i], c[i]),
            a[i].abs().sqrt(),
            a[i].abs(),
            a[i].min(b[i]),
            a[i].max(b[i]),
            if less { b[i] } else { c[i] },
            c[3],
            mask,
            if i < 4 { b[2] } else { c[5] },
            a[i % 4],
            a[4 + i % 4],
            if i < 4 { a[i] + a[i + 4] } else { 1.0 },
            f64::from(a[i] as f32),
            (a[i].abs() * 7.0) / (a[i].abs() * 7.0).log2().floor().exp2(),
            (a[i].abs() * 7.0).log2().floor(),
            b[i] * a[i].round().exp2(),
        ];
        let found: Vec<f64> = found.iter().map(|f| f64::from_bits(f[i])).collect();
        assert_eq!(found[..expected.len()], expected);
    }
}

#[test]
fn a_width_can_be_chosen_and_the_scalar_one_is_always_there() {
    assert_eq!(set_width(Some(Width::Scalar)), Width::Scalar);
    assert_eq!(width(), Width::Scalar);
    assert!(set_width(None).is_available());
}
