//! What a run tells about the damage: pure functions of tables and fields, for any run.
//!
//! Shock front along the wall, characteristic times, effective pressure, energies and volumes, jet and toroid. Each has a
//! file of its own with formula, source, units.

mod effective_pressure;
mod energy;
mod jet;
mod line;
mod order;
mod plastic_zone;
pub mod published;
mod shock_front;
mod times;
mod toroid;
mod wall_load;
mod wall_pressure;

pub use effective_pressure::effective_pressure;
pub use energy::{
    absorbed_energy, bubble_energy, energy_density, plastic_potential, plastic_volume,
};
pub use jet::half_width;
pub use line::crossing;
pub use order::{Extrapolated, error_bar, extrapolate, power_law};
pub use plastic_zone::{YIELDED, along_level, largest_in_column, zone_depth};
pub use shock_front::{Front, followed_above, front, front_position, front_speed};
pub use times::{FALL, RISE, above_step, loading_time, material_time};
pub use toroid::{Toroid, last_toroid};
pub use wall_load::WallLoad;
pub use wall_pressure::WallPressure;
