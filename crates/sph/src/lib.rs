//! Smoothed particle hydrodynamics of liquids and elastic-plastic solids, plane and axisymmetric.
//!
//! SI units; positions are (r, z) in axisymmetry with the axis at r = 0, (x, y) in plane strain.

pub mod cavity;
pub mod departed;
pub mod fluid;
pub mod geometry;
pub mod interact;
pub mod interface;
pub mod kernel;
pub mod neighbours;
pub mod packing;
pub mod phases;
pub mod shapes;
pub mod simd;
pub mod solid;

pub mod world;

pub use geometry::Geometry;
