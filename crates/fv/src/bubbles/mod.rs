//! A cloud of spherical bubbles that a flow carries (Peters and el Moctar 2020, sections 3.2, 3.3 and 3.7).
//!
//! [`carrier`] says what the flow is, [`forces`] what it does to a bubble; a [`Cloud`] advances radius and motion of all bubbles
//! and yields a [`CollapseRecord`] for every collapse, with what the erosion model says about the wall.

pub mod carrier;
pub mod forces;

mod cloud;
mod motion;
mod records;
mod seeding;
mod settings;
mod totals;
mod traveller;

pub use cloud::{Cloud, CloudError, NewBubble};
pub use motion::SlipLedger;
pub use records::{Begin, CloudLedger, CollapseRecord, Fate, Lost, deposit};
pub use seeding::{Seeded, Seeding, SeedingError};
pub use settings::{Averaging, Settings, SettingsError};
pub use totals::Totals;
