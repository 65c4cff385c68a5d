//! Erosion: what curves of lost mass say.

mod curve;

pub use curve::{CurveError, ErosionCurve};
