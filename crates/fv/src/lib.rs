//! The flow and what it carries. For now: a cloud of bubbles in a flow that is given (one way: the flow does not feel them).
//!
//! Vectors are `[f64; 3]` in Cartesian coordinates; SI units; pressure positive in compression.

pub mod bubbles;
mod vector;
