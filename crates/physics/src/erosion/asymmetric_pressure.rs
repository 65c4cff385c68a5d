//! Pressure radiated by a collapse near a wall over that of the same collapse far away
//! (Peters and el Moctar 2020, eqs 3.57 to 3.59; fit to Vogel and Lauterborn 1988).
//!
//! p1/p = b1 g^4 + b2 g^3 + b3 g^2 + b4 g + b5, g = gamma - 0.2                     first collapse    (3.57)
//! p2/p = c1 gamma^5 + ... + c6 for gamma <= 2, d1 + d2 exp(d3 gamma) beyond        second collapse   (3.58)
//! p_asym/p = p1/p + p2/p                                                                             (3.59)
//!
//! gamma = H/R_max. Range: 0.2 to 3. Below, the fit is not anchored; above 3.16 the quartic turns over and is negative beyond
//! 4.78. The second part jumps by 2 % at gamma = 2 (0.061480 to 0.060229), as in the source.

use std::ops::RangeInclusive;

/// Stand-offs in which the fit holds.
pub const STANDOFF_RANGE: RangeInclusive<f64> = 0.2..=3.0;

const B: [f64; 5] = [0.02788, -0.35725, 1.33158, -1.38117, 0.44444];
const C: [f64; 6] = [0.07680, -0.46386, 0.88197, -0.60657, 0.19778, 0.0006];
const D: [f64; 3] = [0.03802, 11.64971, -3.13128];

/// Pressures over that of the spherical collapse.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PressureRatio {
    /// Of the first collapse.
    pub first: f64,
    /// Of the second collapse.
    pub second: f64,
}

impl PressureRatio {
    /// Of both (3.59).
    #[must_use]
    pub fn total(&self) -> f64 {
        self.first + self.second
    }
}

fn polynomial(coefficients: &[f64], x: f64) -> f64 {
    coefficients.iter().fold(0.0, |sum, a| sum * x + a)
}

/// Ratios at a stand-off; `None` outside [`STANDOFF_RANGE`].
#[must_use]
pub fn pressure_ratio(standoff: f64) -> Option<PressureRatio> {
    let second = if standoff <= 2.0 {
        polynomial(&C, standoff)
    } else {
        D[0] + D[1] * (D[2] * standoff).exp()
    };
    STANDOFF_RANGE.contains(&standoff).then(|| PressureRatio {
        first: polynomial(&B, standoff - 0.2),
        second,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values by independent evaluation: least 0.07883 at 0.810.
    #[test]
    fn known_points_and_refusals() {
        let total = |g: f64| pressure_ratio(g).unwrap().total();
        for (gamma, value) in [
            (0.2, 0.46667),
            (0.81, 0.07883),
            (1.0, 0.10694),
            (3.0, 0.92705),
        ] {
            assert!((total(gamma) - value).abs() < 6e-6, "{gamma}");
        }
        assert!(total(0.80) > total(0.81) && total(0.82) > total(0.81));
        for outside in [0.0, 0.199, 3.001, 4.0, f64::NAN, f64::INFINITY, -1.0] {
            assert!(pressure_ratio(outside).is_none());
        }
    }
}
