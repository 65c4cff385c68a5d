//! Weight of a pair of particles in a solid in three dimensions: a function of the square of their distance, which costs
//! neither root nor quotient.
//!
//! W = 3465/(512 pi R^3) s^4, (dW/dX)/X = -3465/(64 pi R^5) s^3, s = max(0, 1 - X^2/R^2), with the mean R of both: the support
//! radius 2 h. Corrected gradients of the reference are exact for linear fields with any kernel, and neighbours that never
//! change cannot form pairs, so the choice is free; with R = 2.4 dx the weights of the first neighbours are those of the cubic
//! spline with h = 1.3 dx.
//!
//! Each side gives its share: A_b = V_b sqrt(3465/(64 pi)) R_b^-11/2, so that A_b s^3 R^6 with k_a = A_a/V_a outside of the sum is
//! V_b |dW/dX|/X, exact where R is uniform and the same from both sides of a pair everywhere.
//!
//! Viscosity and hourglass forces (`sums.rs`) use w ~ A_b^2 s^5 R^10 with m_a = A_a^2/V_a outside, of dimension R^-6: in place of
//! h (dW/dX)/X^3 with the same fourth moment 3 h, and times R in place of W/X^2 with the same second moment 1.

use std::f64::consts::PI;

/// (dW/dX)/X = -SLOPE s^3/R^5.
const SLOPE: f64 = 3465.0 / (64.0 * PI);

/// Integrals of u^2 (1 - u^2)^5 and u^4 (1 - u^2)^5 over the unit ball: 2 pi B(5/2, 6) and 2 pi B(7/2, 6).
const MOMENTS: [f64; 2] = [
    2.0 * PI * 120.0 / (7.5 * 6.5 * 5.5 * 4.5 * 3.5 * 2.5),
    2.0 * PI * 120.0 / (8.5 * 7.5 * 6.5 * 5.5 * 4.5 * 3.5),
];

/// Share A of a particle in the weights of its pairs, from its volume (m3) and smoothing length (m).
pub(super) fn share(volume: f64, smoothing_length: f64) -> f64 {
    let radius = 2.0 * smoothing_length;
    volume * SLOPE.sqrt() * radius.powi(-5) / radius.sqrt()
}

/// Factors of w R (hourglass) and w (viscosity) for bodies with this ratio of smoothing length and spacing.
pub(super) fn stabiliser_factors(smoothing_ratio: f64) -> [f64; 2] {
    // Volume over R^3; w = (SLOPE n)^2 s^5/R^6 without factors.
    let n = (2.0 * smoothing_ratio).powi(-3);
    let unit = (SLOPE * n).powi(2);
    [1.0 / (MOMENTS[0] * unit), 1.5 / (MOMENTS[1] * unit)]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Integral of f(X) over space with the support 2 h, h = 0.6.
    fn integral(f: impl Fn(f64) -> f64) -> f64 {
        let n = 20_000;
        let d = 1.2 / f64::from(n);
        let at = |i: i32| (f64::from(i) + 0.5) * d;
        (0..n)
            .map(|i| f(at(i)) * 4.0 * PI * at(i).powi(2) * d)
            .sum()
    }

    #[test]
    fn moments_are_those_of_a_kernel_and_of_the_laws_in_the_plane() {
        let (ratio, h) = (1.2, 0.6_f64);
        let volume = (h / ratio).powi(3);
        let k = share(volume, h) / volume;
        let gap = |x: f64| (4.0 * h * h - x * x).max(0.0);
        // -X . grad W integrates to 3.
        let slope = |x: f64| k * k * gap(x).powi(3);
        assert!((integral(|x| slope(x) * x * x) - 3.0).abs() < 1e-7);
        let [hourglass, viscous] = stabiliser_factors(ratio);
        let w = |x: f64| (share(volume, h).powi(2) / volume).powi(2) * gap(x).powi(5);
        assert!((integral(|x| hourglass * w(x) * 2.0 * h * x * x) - 1.0).abs() < 1e-7);
        assert!((integral(|x| viscous * w(x) * x.powi(4)) - 3.0 * h).abs() < 1e-7);
    }
}
