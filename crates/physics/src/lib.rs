//! Laws at a point: tensors, equations of state, elasticity, strength, damage, loads, spherical bubbles, nuclei, collapses near
//! walls and what they announce.
//!
//! Pure functions and small structs; no particles, no grid, no files. SI units throughout;
//! pressure is positive in compression, stress positive in tension.

pub mod bubble;
pub mod damage;
pub mod eos;
pub mod erosion;
pub mod load;
pub mod material_point;
pub mod near_wall;
pub mod nuclei;
pub mod return_mapping;
pub mod strength;
pub mod tensor;

mod elastic;
pub use elastic::Elastic;
pub use tensor::Sym3;
