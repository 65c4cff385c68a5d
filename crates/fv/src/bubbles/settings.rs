//! How a cloud is computed.

use super::forces::Forces;
use erode_physics::bubble::{BubbleError, Controls, Liquid, Model};
use erode_physics::erosion::LagrangianModel;
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// Where the flow around a bubble is taken.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Averaging {
    /// At the centre.
    Centre,
    /// Mean over the surface.
    Surface,
    /// Mean over the surface for radii above this one (m), of the size of a cell; at the centre below.
    SurfaceAbove(f64),
}

impl Averaging {
    pub(super) fn over_surface(self, radius: f64) -> bool {
        match self {
            Self::Centre => false,
            Self::Surface => true,
            Self::SurfaceAbove(least) => radius > least,
        }
    }
}

/// Laws and steps of a cloud.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Liquid of the radius dynamics.
    pub liquid: Liquid,
    /// Law of the radius; `None`: radii stay.
    pub dynamics: Option<Model>,
    /// Integrator of the radius.
    pub controls: Controls,
    /// Forces of the motion.
    pub forces: Forces,
    /// Where the flow is taken.
    pub averaging: Averaging,
    /// Whether the slip lowers the pressure on the bubble (last term of 3.36). The source leaves it out for bubbles smaller
    /// than a cell; the energy of a slip that a collapse concentrates then comes from nowhere (see `SlipLedger`). It costs:
    /// substeps then follow the radius.
    pub slip: bool,
    /// Erosion model.
    pub erosion: LagrangianModel,
    /// Largest way in a substep over the length in which the flow changes.
    pub courant: f64,
    /// Largest substep over the time in which the flow changes.
    pub time_share: f64,
    /// With `slip`: largest substep over R sqrt(rho/|p_b - p|) and R/|R'|.
    pub radius_share: f64,
    /// Substeps allowed for a bubble in one call.
    pub max_substeps: u64,
}

/// A setting that no cloud can be computed with.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SettingsError {
    /// A number that is not positive.
    #[error("{name} is {value}, but it must be positive")]
    NotPositive {
        /// Which.
        name: &'static str,
        /// What was given.
        value: f64,
    },
    /// Of the liquid.
    #[error(transparent)]
    Liquid(#[from] BubbleError),
}

impl Settings {
    /// Checks the ranges.
    ///
    /// # Errors
    /// Names the first number that is out of range.
    pub fn check(&self) -> Result<(), SettingsError> {
        self.liquid.check()?;
        let numbers = [
            ("courant", self.courant),
            ("time_share", self.time_share),
            ("radius_share", self.radius_share),
            ("tolerance", self.controls.tolerance),
        ];
        match numbers.into_iter().find(|(_, x)| x.is_nan() || *x <= 0.0) {
            Some((name, value)) => Err(SettingsError::NotPositive { name, value }),
            None => Ok(()),
        }
    }

    /// Usual settings: radii by `dynamics`, all forces of a flow without gravity, values at the centre, no slip term.
    #[must_use]
    pub fn new(liquid: Liquid, dynamics: Option<Model>) -> Self {
        Self {
            liquid,
            dynamics,
            controls: Controls {
                tolerance: 1e-8,
                ..Controls::default()
            },
            forces: Forces::IN_FLOW,
            averaging: Averaging::Centre,
            slip: false,
            erosion: LagrangianModel::default(),
            courant: 0.05,
            time_share: 0.1,
            radius_share: 0.1,
            max_substeps: 10_000_000,
        }
    }
}
