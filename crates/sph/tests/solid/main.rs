//! Solid against exact solutions and invariants.
#![allow(clippy::unwrap_used)] // a failed test may panic

mod bodies;
mod contact;
mod dynamics;
mod equilibrium;
mod faces;
mod kinematics;
mod ledger;
mod updated;
