//! Rayleigh's collapse of an empty spherical cavity in an incompressible liquid under constant pressure.
//!
//! (dR/dt)^2 = (2 p / 3 rho) ((R0/R)^3 - 1); Lord Rayleigh, Phil. Mag. 34 (1917) 94, eq. 3; the whole collapse takes
//! 0.914 68 R0 sqrt(rho / p). With (R/R0)^3 = cos^2 a the time is R0 sqrt(3 rho / 2 p) (2/3) times the integral of
//! cos^(2/3) from 0 to a, which has no singularity. SI units.

use std::f64::consts::FRAC_PI_2;

/// Time and radius of the collapse, `[t, R]` in s and m, from rest at `radius` to zero in `count` intervals (even).
///
/// Shapes: `count / 2 + 1` points; `pressure` (Pa) and `density` (kg/m3) positive.
pub fn collapse_curve(radius: f64, pressure: f64, density: f64, count: usize) -> Vec<[f64; 2]> {
    let unit = radius * (1.5 * density / pressure).sqrt() * 2.0 / 3.0;
    let step = FRAC_PI_2 / count as f64;
    let weight = |k: usize| (k as f64 * step).cos().max(0.0).powf(2.0 / 3.0);
    let mut integral = 0.0;
    let mut curve = vec![[0.0, radius]];
    for k in (2..=count).step_by(2) {
        integral += step / 3.0 * (weight(k - 2) + 4.0 * weight(k - 1) + weight(k));
        curve.push([unit * integral, radius * weight(k)]);
    }
    curve
}

/// The whole collapse, 0.914 68 R0 sqrt(rho / p), s.
pub fn collapse_time(radius: f64, pressure: f64, density: f64) -> f64 {
    0.914_681_36 * radius * (density / pressure).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curve_ends_at_rayleighs_time() {
        let curve = collapse_curve(1.5e-4, 5.0e7, 1000.0, 400);
        let end = curve.last().unwrap();
        // The cusp of cos^(2/3) at the end limits Simpson's rule to order 5/3: (pi/800)^(5/3) is 1e-4.
        assert!(
            (end[0] / collapse_time(1.5e-4, 5.0e7, 1000.0) - 1.0).abs() < 1e-4,
            "{end:?}"
        );
        assert!(end[1] < 1e-8);
    }

    #[test]
    fn the_speed_follows_from_the_energy() {
        let (radius, pressure, density) = (1.0, 3.0, 2.0);
        let curve = collapse_curve(radius, pressure, density, 4000);
        for triple in curve
            .windows(3)
            .skip(20)
            .step_by(97)
            .take_while(|t| t[1][1] > 0.2)
        {
            let speed = (triple[2][1] - triple[0][1]) / (triple[2][0] - triple[0][0]);
            let expected = -(2.0 * pressure / (3.0 * density)
                * ((radius / triple[1][1]).powi(3) - 1.0))
                .sqrt();
            // Central differences of intervals of 1/2000 of the collapse.
            assert!((speed / expected - 1.0).abs() < 1e-3, "{speed} {expected}");
        }
    }
}
