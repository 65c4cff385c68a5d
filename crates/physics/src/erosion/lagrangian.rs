//! Lagrangian erosion model: the impact of one collapsing bubble (Peters and el Moctar 2020, eqs 3.50 to 3.61).
//!
//! gamma  = H/R_max                                                      stand-off                          (3.52)
//! H_corr = H - 2.5 (0.195 gamma^-2)^0.6 R_max                           distance after displacement        (3.53 to 3.56)
//! p_imp  = p_asym                      in contact: gamma <= 1 or H_corr <= R_min                           (3.60)
//! p_imp  = p_asym (R_min/H_corr)^n     liquid between bubble and wall, n = 2                               (3.61)
//!
//! p_asym from (3.57) to (3.59) with the pressure in the bubble at its smallest radius; H at the largest radius. Units Pa, m.
//! Range 0.2 <= gamma <= 3, enforced: outside it the answer is that it is outside. The impact pressure jumps at gamma = 1, where
//! contact is presumed although H_corr is still 0.06 R_max.
//! Misprint: (3.55) takes the power of a negative number; the displacement is towards the wall.

use super::asymmetric_pressure::{STANDOFF_RANGE, pressure_ratio};
use super::shock_decay::ShockDecay;
use crate::near_wall::{anisotropy_of_wall, displacement};
use serde::{Deserialize, Serialize};

/// A collapse of a spherical bubble near a wall.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct NearWallCollapse {
    /// Largest radius, at the beginning, m.
    pub max_radius: f64,
    /// Smallest radius, at the end, m.
    pub min_radius: f64,
    /// Pressure in the bubble at the smallest radius, Pa.
    pub pressure: f64,
    /// Distance of the centre from the wall at the largest radius, m.
    pub wall_distance: f64,
}

/// Whether liquid separates bubble and wall at the collapse.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Contact {
    /// The bubble collapses on the wall.
    Touching,
    /// A shock travels through liquid.
    Apart,
}

/// What a collapse does to the wall.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Impact {
    /// H/R_max.
    pub standoff: f64,
    /// Pressure radiated at the bubble, Pa.
    pub asymmetric_pressure: f64,
    /// Distance of the centre from the wall after its displacement, m; negative where the law carries it past the wall.
    pub corrected_distance: f64,
    /// Whether the bubble touches the wall.
    pub contact: Contact,
    /// Pressure on the wall, Pa.
    pub impact_pressure: f64,
}

/// Answer of the model.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Assessment {
    /// An impact.
    Impact(Impact),
    /// Nearer than the range of the model; the stand-off.
    TooNear(f64),
    /// Farther than the range of the model; the stand-off.
    TooFar(f64),
    /// Radii, distance or pressure are not positive and finite, or the smallest radius exceeds the largest.
    Impossible,
}

/// The model with the decay of the shock as its one choice.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct LagrangianModel {
    /// How the pressure falls between bubble and wall.
    pub decay: ShockDecay,
}

impl Default for LagrangianModel {
    /// n = 2, as in (3.61).
    fn default() -> Self {
        Self {
            decay: ShockDecay::Exponent(2.0),
        }
    }
}

impl NearWallCollapse {
    fn possible(&self) -> bool {
        let all = [
            self.max_radius,
            self.min_radius,
            self.pressure,
            self.wall_distance,
        ];
        all.iter().all(|x| x.is_finite() && *x > 0.0) && self.min_radius <= self.max_radius
    }
}

impl LagrangianModel {
    /// What a collapse does to the wall.
    #[must_use]
    pub fn assess(&self, collapse: &NearWallCollapse) -> Assessment {
        if !collapse.possible() {
            return Assessment::Impossible;
        }
        let standoff = collapse.wall_distance / collapse.max_radius;
        let Some(ratio) = pressure_ratio(standoff) else {
            return if standoff < *STANDOFF_RANGE.start() {
                Assessment::TooNear(standoff)
            } else {
                Assessment::TooFar(standoff)
            };
        };
        let asymmetric_pressure = collapse.pressure * ratio.total();
        let moved = displacement(anisotropy_of_wall(standoff)).over_max_radius;
        let corrected_distance = collapse.wall_distance - moved * collapse.max_radius;
        let touching = standoff <= 1.0 || corrected_distance <= collapse.min_radius;
        let (contact, impact_pressure) = if touching {
            (Contact::Touching, asymmetric_pressure)
        } else {
            let (from, to) = (collapse.min_radius, corrected_distance);
            let there = self.decay.pressure(asymmetric_pressure, from, to);
            (Contact::Apart, there)
        };
        Assessment::Impact(Impact {
            standoff,
            asymmetric_pressure,
            corrected_distance,
            contact,
            impact_pressure,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn collapse(standoff: f64) -> NearWallCollapse {
        NearWallCollapse {
            max_radius: 1e-3,
            min_radius: 1e-4,
            pressure: 1e8,
            wall_distance: standoff * 1e-3,
        }
    }

    fn impact(standoff: f64) -> Impact {
        match LagrangianModel::default().assess(&collapse(standoff)) {
            Assessment::Impact(impact) => impact,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn far_bubbles_act_through_liquid_by_hand() {
        let i = impact(2.0);
        let moved = 2.5 * (0.195f64 / 4.0).powf(0.6);
        assert!((i.corrected_distance - (2.0 - moved) * 1e-3).abs() < 1e-15);
        let expected = i.asymmetric_pressure * (1e-4 / i.corrected_distance).powi(2);
        assert!((i.impact_pressure / expected - 1.0).abs() < 1e-12);
        assert_eq!(i.contact, Contact::Apart);
    }

    #[test]
    fn near_bubbles_touch() {
        for standoff in [0.3, 0.99, 1.0, 1.001] {
            let i = impact(standoff);
            assert_eq!(i.contact, Contact::Touching, "{standoff}");
            assert_eq!(i.impact_pressure, i.asymmetric_pressure);
        }
    }

    #[test]
    fn outside_the_range_it_says_so() {
        let model = LagrangianModel::default();
        assert!(matches!(
            model.assess(&collapse(0.19)),
            Assessment::TooNear(_)
        ));
        assert!(matches!(
            model.assess(&collapse(3.01)),
            Assessment::TooFar(_)
        ));
        let upside_down = NearWallCollapse {
            min_radius: 2e-3,
            ..collapse(1.0)
        };
        assert_eq!(model.assess(&upside_down), Assessment::Impossible);
        let behind = NearWallCollapse {
            wall_distance: -1e-3,
            ..collapse(1.0)
        };
        assert_eq!(model.assess(&behind), Assessment::Impossible);
    }
}
