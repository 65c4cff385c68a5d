//! Solid against exact solutions and invariants.
#![allow(clippy::unwrap_used)] // a failed test may panic

mod bodies;
mod contact;
mod damage;
mod dynamics;
mod equilibrium;
mod faces;
mod kinematics;
mod large_strain;
mod layers;
mod ledger;
mod updated;
