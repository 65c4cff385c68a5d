//! Decay of the shock of a collapse with distance (Peters and el Moctar 2020, eqs 3.50 and 3.51, and the text after them).
//!
//! p1/p0 = (r0/r1)^n, r the distance from the centre, r1 >= r0
//!
//! Units: Pa, m. Where the exponent changes on the way, the pieces join continuously.

use serde::{Deserialize, Serialize};

/// How the pressure falls on its way.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ShockDecay {
    /// One exponent all the way; 2 in the erosion model (3.61), 1.249 after Supponen et al. 2017.
    Exponent(f64),
    /// Linear acoustics, n = 1 (3.50); Johnsen and Colonius 2008.
    Acoustic,
    /// n = 2 above 100 MPa, 1.06 below (Vogel, Busch and Parlitz 1996).
    Vogel,
    /// n = 1.3 up to two initial radii, 2.2 beyond (Noack and Vogel 1998).
    Noack,
}

/// Pressure below which Vogel's shock decays as a sound wave does, Pa.
const WEAK: f64 = 100e6;

impl ShockDecay {
    /// Pressure (Pa) at the distance `r1` of a wave with pressure `p0` at `r0` (both m, positive). At r1 <= r0 it is `p0`.
    #[must_use]
    pub fn pressure(self, p0: f64, r0: f64, r1: f64) -> f64 {
        let ratio = r0 / r1;
        if ratio >= 1.0 {
            return p0;
        }
        match self {
            Self::Exponent(n) => p0 * ratio.powf(n),
            Self::Acoustic => p0 * ratio,
            Self::Vogel if p0 <= WEAK => p0 * ratio.powf(1.06),
            Self::Vogel => {
                // Reaches 100 MPa at r0 sqrt(p0/100 MPa).
                let strong = p0 * ratio * ratio;
                let beyond = r0 * (p0 / WEAK).sqrt() / r1;
                if strong >= WEAK {
                    strong
                } else {
                    WEAK * beyond.powf(1.06)
                }
            }
            Self::Noack if ratio >= 0.5 => p0 * ratio.powf(1.3),
            Self::Noack => p0 * 0.5f64.powf(1.3) * (2.0 * ratio).powf(2.2),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_join_and_have_their_slopes() {
        let slope = |law: ShockDecay, p0: f64, r: f64| {
            (law.pressure(p0, 1.0, r * 1.001) / law.pressure(p0, 1.0, r)).ln() / 1.001f64.ln()
        };
        for (law, p0, r, n) in [
            (ShockDecay::Acoustic, 1e9, 3.0, 1.0),
            (ShockDecay::Exponent(2.0), 1e9, 3.0, 2.0),
            (ShockDecay::Vogel, 1e9, 2.0, 2.0),
            (ShockDecay::Vogel, 1e9, 5.0, 1.06),
            (ShockDecay::Vogel, 5e7, 5.0, 1.06),
            (ShockDecay::Noack, 1e9, 1.5, 1.3),
            (ShockDecay::Noack, 1e9, 3.0, 2.2),
        ] {
            assert!((slope(law, p0, r) + n).abs() < 1e-9, "{law:?} {r}");
        }
        for (law, joint) in [
            (ShockDecay::Vogel, 10.0f64.sqrt()),
            (ShockDecay::Noack, 2.0),
        ] {
            let (a, b) = (
                law.pressure(1e9, 1.0, joint * (1.0 - 1e-9)),
                law.pressure(1e9, 1.0, joint * (1.0 + 1e-9)),
            );
            assert!((a / b - 1.0).abs() < 1e-8, "{law:?}");
        }
        assert_eq!(ShockDecay::Vogel.pressure(1e9, 1.0, 0.5), 1e9);
    }
}
