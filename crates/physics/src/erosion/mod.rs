//! What collapsing bubbles announce for a wall: the Eulerian micro-jet model and the Lagrangian model of Peters and el Moctar
//! (2020), section 3.7, and maps of their erosion potential.
//!
//! Both give potentials, shares of a whole, and impact pressures; neither gives a depth.

mod asymmetric_pressure;
mod lagrangian;
mod micro_jet;
mod potential;
mod shock_decay;

pub use asymmetric_pressure::{PressureRatio, STANDOFF_RANGE, pressure_ratio};
pub use lagrangian::{Assessment, Contact, Impact, LagrangianModel, NearWallCollapse};
pub use micro_jet::{JetImpact, MicroJetModel, critical_speed, micro_jet_speed, water_hammer};
pub use potential::{PotentialMap, SurfaceError, WallElement};
pub use shock_decay::ShockDecay;
