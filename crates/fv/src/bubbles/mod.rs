//! A cloud of spherical bubbles that a flow carries (Peters and el Moctar 2020, sections 3.2, 3.3 and 3.7).
//!
//! [`carrier`] what the flow is, [`forces`] what it does to a bubble.

pub mod carrier;
pub mod forces;
