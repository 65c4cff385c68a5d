//! Equations of state of liquids.

mod tait;
pub use tait::Tait;
