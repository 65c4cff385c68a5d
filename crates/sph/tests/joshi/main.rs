//! The published formulation.

mod rayleigh;
