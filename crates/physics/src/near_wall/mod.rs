//! Theory of one bubble collapsing near a rigid wall, for comparison with resolved (SPH) collapses.
//!
//! Distances are measured by the stand-off gamma = H/R_max (H: centre of the bubble at its largest radius to the wall) and
//! by the anisotropy zeta, the dimensionless Kelvin impulse.

mod anisotropy;
mod prolongation;

pub use anisotropy::{
    Displacement, JetRegime, PIERCING_ANISOTROPY, POWER_LAW_LIMIT, WALL_COEFFICIENT, WEAK_LIMIT,
    anisotropy_of_gradient, anisotropy_of_wall, displacement, jet_regime, jet_speed,
    kelvin_impulse,
};
pub use prolongation::{
    PROLONGATION_LEAST_STANDOFF, prolongation, prolongation_first_order, rayleigh_collapse_time,
};
