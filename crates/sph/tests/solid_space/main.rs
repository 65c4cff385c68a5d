//! Tests of the solid in three dimensions against known answers.

#![allow(clippy::unwrap_used)] // tests may

mod bits;
mod bodies;
mod dynamics;
mod kinematics;
mod material;
mod plane;
