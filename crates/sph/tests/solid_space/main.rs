//! Tests of the solid in three dimensions against known answers.

mod bits;
mod bodies;
mod dynamics;
mod kinematics;
mod material;
mod plane;
