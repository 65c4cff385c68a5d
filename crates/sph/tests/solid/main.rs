//! Total Lagrangian solid against exact solutions and invariants.

mod bodies;
mod dynamics;
mod equilibrium;
mod kinematics;
mod ledger;
