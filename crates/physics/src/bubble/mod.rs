//! Spherical bubbles: how the radius follows the pressure of the liquid around it.
//!
//! A law is a [`BubbleModel`]: it gives the wall acceleration from the state of the wall and the [`Ambient`] values of
//! the liquid. [`advance`] integrates it in time with error control and finds the largest and smallest radii exactly.
//!
//! ```text
//! let gas = equilibrium_gas(&liquid, 8e-6, 1e5, 4.0 / 3.0)?;
//! let mut state = BubbleState::at_rest(8e-6, 0.0)?;
//! let mut events: Vec<Event> = Vec::new();
//! advance(&model, &liquid, &gas, &driving, &Controls::default(), &mut state, 4e-5, &mut events)?;
//! ```
//!
//! Units: SI. Pressure positive in compression; `wall_velocity` = dR/dt, positive while the bubble grows.

mod advance;
mod ambient;
mod batch;
mod energy;
mod equilibrium;
mod error;
mod gas;
mod liquid;
mod model;
mod models;
mod ode;
mod state;
#[cfg(test)]
mod tests;

pub use advance::{Controls, Progress, Watch, advance};
pub use ambient::{Ambient, Constant, Driving, Linear, Sine};
pub use batch::{Member, advance_all};
pub use energy::Energy;
pub use equilibrium::{blake_pressure, critical_radius, equilibrium_gas, equilibrium_radius};
pub use error::BubbleError;
pub use gas::Gas;
pub use liquid::Liquid;
pub use model::{BubbleModel, Phase, Wall, bubble_pressure};
pub use models::{Gilmore, KellerMiksis, Model, RayleighPlesset, Switching, TomitaShima};
pub use ode::DenseStep;
pub use state::{BubbleState, Collapse, Counters, Event, EventKind, Largest, Ledger};
