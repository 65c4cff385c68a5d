//! The most that this machine computes: chains of fused multiply-adds in registers, in the widest lanes it has.

use super::BenchError;
use super::measure::pool;
use std::hint::black_box;
use std::time::Instant;

/// Numbers that are advanced side by side: enough to hide the latency of an operation.
const CHAINS: usize = 96;
/// Operations per chain in one measurement.
const ROUNDS: usize = 400_000;
/// Measurements; the fastest counts.
const REPEATS: usize = 12;

#[inline(always)]
fn chains(rounds: usize) -> f64 {
    let (scale, shift) = (black_box(0.999_999), black_box(1e-6));
    let mut x: [f64; CHAINS] = std::array::from_fn(|i| 1.0 + i as f64);
    for _ in 0..rounds {
        for x in &mut x {
            *x = x.mul_add(scale, shift);
        }
    }
    x.iter().sum()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,fma")]
fn chains_of_eight(rounds: usize) -> f64 {
    chains(rounds)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn chains_of_four(rounds: usize) -> f64 {
    chains(rounds)
}

#[cfg(target_arch = "x86_64")]
#[allow(unsafe_code)]
fn widest(rounds: usize) -> f64 {
    if is_x86_feature_detected!("avx512f") {
        // SAFETY: the processor has just said that it knows these instructions.
        unsafe { chains_of_eight(rounds) }
    } else if is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma") {
        // SAFETY: the processor has just said that it knows these instructions.
        unsafe { chains_of_four(rounds) }
    } else {
        chains(rounds)
    }
}

#[cfg(not(target_arch = "x86_64"))]
fn widest(rounds: usize) -> f64 {
    chains(rounds)
}

/// Multiplications and additions per second of `threads` threads together.
///
/// # Errors
/// If the threads cannot be started.
pub(super) fn measured(threads: usize) -> Result<f64, BenchError> {
    let pool = pool(threads)?;
    let once = || {
        let begun = Instant::now();
        pool.broadcast(|_| black_box(widest(black_box(ROUNDS))));
        2.0 * (CHAINS * ROUNDS * threads) as f64 / begun.elapsed().as_secs_f64()
    };
    Ok((0..REPEATS).map(|_| once()).fold(0.0, f64::max))
}
