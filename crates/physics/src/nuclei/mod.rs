//! Sizes of nuclei: gas bubbles from which cavitation starts.
//!
//! Radii are equilibrium radii R0 in m; densities of probability in 1/m. Samples come from a [`Stream`]: the k-th nucleus of a
//! seed is the same on every machine, for any number of threads and after a restart.

mod distribution;
mod invert;
mod measured;
mod stream;

pub use distribution::{NucleiDistribution, NucleiError, measured_as_printed};
pub use measured::PRINTED_INTEGRAL;
pub use stream::Stream;
