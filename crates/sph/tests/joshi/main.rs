//! The published formulation against exact solutions.
#![allow(clippy::unwrap_used)] // a failed test may panic

mod interface;
mod rayleigh;
