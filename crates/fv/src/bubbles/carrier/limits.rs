//! A flow with bounds: a box outside which it is not known, a plane wall.

use super::{Carrier, CarrierError, CarrierPoint, WallPoint};
use crate::vector::{Vector, dot, sub};

/// A flow known in a box only.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounded<C> {
    /// The flow.
    pub flow: C,
    /// Lower corner, m.
    pub lower: Vector,
    /// Upper corner, m.
    pub upper: Vector,
}

impl<C: Carrier> Carrier for Bounded<C> {
    fn at(&self, position: Vector, time: f64) -> Result<CarrierPoint, CarrierError> {
        let inside = (0..3).all(|k| position[k] >= self.lower[k] && position[k] <= self.upper[k]);
        if inside {
            self.flow.at(position, time)
        } else {
            Err(CarrierError::Outside { position })
        }
    }

    fn wall(&self, position: Vector) -> Option<WallPoint> {
        self.flow.wall(position)
    }

    fn length_scale(&self, position: Vector) -> f64 {
        self.flow.length_scale(position)
    }

    fn time_scale(&self) -> f64 {
        self.flow.time_scale()
    }
}

/// A flow on one side of a plane wall. The flow itself is as given: a flow that crosses the wall is the user's choice.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NearPlane<C> {
    /// The flow.
    pub flow: C,
    /// A point of the wall, m.
    pub point: Vector,
    /// Unit normal into the liquid.
    pub normal: Vector,
}

impl<C: Carrier> NearPlane<C> {
    fn distance(&self, position: Vector) -> f64 {
        dot(sub(position, self.point), self.normal)
    }
}

impl<C: Carrier> Carrier for NearPlane<C> {
    fn at(&self, position: Vector, time: f64) -> Result<CarrierPoint, CarrierError> {
        if self.distance(position) < 0.0 {
            return Err(CarrierError::Outside { position });
        }
        self.flow.at(position, time)
    }

    fn wall(&self, position: Vector) -> Option<WallPoint> {
        let own = WallPoint {
            distance: self.distance(position),
            normal: self.normal,
        };
        match self.flow.wall(position) {
            Some(other) if other.distance < own.distance => Some(other),
            _ => Some(own),
        }
    }

    fn length_scale(&self, position: Vector) -> f64 {
        self.flow.length_scale(position)
    }

    fn time_scale(&self) -> f64 {
        self.flow.time_scale()
    }
}
