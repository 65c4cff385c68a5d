//! Nuclei put into a box of the flow: random places, sizes from a distribution, each in equilibrium where it is.
//!
//! A nucleus has the velocity of the flow and the gas that keeps it at rest at the pressure there. The k-th nucleus of a seed is
//! the same for any number of them.

use super::carrier::{Carrier, CarrierError};
use super::cloud::{Cloud, CloudError, NewBubble};
use super::forces::volume;
use crate::vector::Vector;
use erode_physics::bubble::{BubbleError, Liquid, equilibrium_gas};
use erode_physics::nuclei::{NucleiDistribution, NucleiError, Stream};
use thiserror::Error;

/// What is put in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Seeding {
    /// Sizes.
    pub distribution: NucleiDistribution,
    /// Random numbers of sizes and places.
    pub seed: u64,
    /// Lower corner of the box, m.
    pub lower: Vector,
    /// Upper corner of the box, m.
    pub upper: Vector,
    /// Number of nuclei.
    pub count: u64,
    /// Polytropic exponent of their gas.
    pub polytropic_exponent: f64,
    /// Density of a nucleus, kg/m3.
    pub density: f64,
}

/// What came of it; all nuclei are in one of the counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Seeded {
    /// Put in.
    pub injected: u64,
    /// Not put in: the place is not in the flow.
    pub outside: u64,
    /// Not put in: no stable equilibrium at the pressure there (below the Blake threshold).
    pub without_equilibrium: u64,
}

/// Why nothing, or not all, was put in.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SeedingError {
    /// The distribution.
    #[error(transparent)]
    Nuclei(#[from] NucleiError),
    /// The flow has no answer.
    #[error(transparent)]
    Flow(CarrierError),
    /// Data of a bubble.
    #[error(transparent)]
    Bubble(#[from] BubbleError),
    /// A bubble cannot be put in.
    #[error(transparent)]
    Cloud(#[from] CloudError),
}

impl Cloud {
    /// Puts nuclei in.
    ///
    /// # Errors
    /// If the distribution, the liquid or the flow cannot be used; bubbles put in before stay.
    pub fn seed<C: Carrier>(
        &mut self,
        carrier: &C,
        liquid: &Liquid,
        seeding: &Seeding,
    ) -> Result<Seeded, SeedingError> {
        let distribution = seeding.distribution.checked()?;
        liquid.check()?;
        let root = Stream { seed: seeding.seed };
        let (sizes, places) = (root.branch(0), root.branch(1));
        let mut seeded = Seeded::default();
        for k in 0..seeding.count {
            let position: Vector = std::array::from_fn(|j| {
                let x = places.uniform(3 * k + j as u64);
                seeding.lower[j] + x * (seeding.upper[j] - seeding.lower[j])
            });
            let flow = match carrier.at(position, self.time) {
                Ok(flow) => flow,
                Err(CarrierError::Outside { .. }) => {
                    seeded.outside += 1;
                    continue;
                }
                Err(other) => return Err(SeedingError::Flow(other)),
            };
            let radius = distribution.sample(sizes, k);
            let gas = equilibrium_gas(liquid, radius, flow.pressure, seeding.polytropic_exponent);
            let gas = match gas {
                Ok(gas) => gas,
                Err(BubbleError::NoEquilibriumOfRadius { .. }) => {
                    seeded.without_equilibrium += 1;
                    continue;
                }
                Err(other) => return Err(other.into()),
            };
            self.inject(&NewBubble {
                position,
                velocity: flow.velocity,
                radius,
                wall_velocity: 0.0,
                gas,
                mass: seeding.density * volume(radius),
            })?;
            seeded.injected += 1;
        }
        Ok(seeded)
    }
}

#[cfg(test)]
mod tests {
    use super::super::carrier::{NearPlane, Still};
    use super::*;

    const SEEDING: Seeding = Seeding {
        distribution: NucleiDistribution::Measured,
        seed: 5,
        lower: [-1e-3; 3],
        upper: [1e-3; 3],
        count: 200,
        polytropic_exponent: 1.4,
        density: 1.2,
    };

    fn flow(pressure: f64) -> NearPlane<Still> {
        NearPlane {
            flow: Still {
                pressure,
                density: 998.2,
                viscosity: 1e-3,
                gravity: [0.0; 3],
            },
            point: [0.0; 3],
            normal: [0.0, 0.0, 1.0],
        }
    }

    /// Half of the box is behind the wall; nuclei of a longer seeding begin with those of a shorter one.
    #[test]
    fn all_are_counted_and_the_order_is_kept() {
        let (mut few, mut many) = (Cloud::new(0.0), Cloud::new(0.0));
        let seeded = few.seed(&flow(1e5), &Liquid::WATER, &SEEDING).unwrap();
        assert_eq!(seeded.injected + seeded.outside, 200);
        assert!((70..130).contains(&seeded.outside) && few.len() as u64 == seeded.injected);
        let longer = Seeding {
            count: 400,
            ..SEEDING
        };
        many.seed(&flow(1e5), &Liquid::WATER, &longer).unwrap();
        assert_eq!(many.position[..few.len()], few.position[..]);
        assert_eq!(many.state[..few.len()], few.state[..]);
    }

    #[test]
    fn nuclei_that_cannot_rest_are_counted() {
        let mut cloud = Cloud::new(0.0);
        let seeded = cloud.seed(&flow(-1e5), &Liquid::WATER, &SEEDING).unwrap();
        assert!(seeded.without_equilibrium > 0);
        assert_eq!(
            seeded.injected + seeded.outside + seeded.without_equilibrium,
            200
        );
        let bad = Seeding {
            distribution: NucleiDistribution::Constant { radius: 0.0 },
            ..SEEDING
        };
        assert!(cloud.seed(&flow(1e5), &Liquid::WATER, &bad).is_err());
    }
}
