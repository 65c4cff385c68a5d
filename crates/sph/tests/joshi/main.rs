//! The published formulation.

mod interface;
mod rayleigh;
