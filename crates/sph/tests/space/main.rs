//! Tests of the solid in three dimensions against known answers.

mod bodies;
mod kinematics;
