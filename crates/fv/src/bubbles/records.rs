//! What the cloud reports: collapses, what they announce for the wall, and bubbles that are gone.

use super::motion::SlipLedger;
use crate::vector::Vector;
use erode_physics::erosion::{Assessment, PotentialMap, SurfaceError};
use serde::{Deserialize, Serialize};

/// Where a collapse began.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Begin {
    /// Time of the largest radius, s.
    pub time: f64,
    /// Largest radius, m.
    pub max_radius: f64,
    /// Centre, m.
    pub position: Vector,
    /// Distance of the centre from the nearest wall, m.
    pub wall_distance: Option<f64>,
    /// Nearest point of the wall, m.
    pub wall_point: Option<Vector>,
}

/// One collapse.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct CollapseRecord {
    /// Number of the bubble.
    pub bubble: u64,
    /// Where it began.
    pub begin: Begin,
    /// Time of the smallest radius, s.
    pub time: f64,
    /// Centre at the smallest radius, m.
    pub position: Vector,
    /// Smallest radius, m.
    pub min_radius: f64,
    /// Pressure in the bubble at the smallest radius, Pa.
    pub peak_pressure: f64,
    /// What the erosion model says; `None` where there is no wall.
    pub assessment: Option<Assessment>,
}

/// Why a bubble is no longer in the cloud.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Fate {
    /// It left the domain of the flow.
    LeftDomain,
    /// It had no gas and closed.
    Closed,
    /// Its radius could not be integrated; the message says why.
    Failed(String),
    /// It needed more substeps than allowed.
    TooManySubsteps,
}

/// A bubble that is gone.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Lost {
    /// Number of the bubble.
    pub bubble: u64,
    /// Time, s.
    pub time: f64,
    /// Last known centre, m.
    pub position: Vector,
    /// Radius, m.
    pub radius: f64,
    /// Mass, kg.
    pub mass: f64,
    /// What its slip had gained and lost.
    pub slip_ledger: SlipLedger,
    /// Why.
    pub fate: Fate,
}

/// Counts since the start; with the bubbles present they account for every bubble and every collapse.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct CloudLedger {
    /// Bubbles put in.
    pub injected: u64,
    /// Of these gone out of the domain.
    pub left_domain: u64,
    /// Of these closed.
    pub closed: u64,
    /// Of these given up: radius not integrable or too many substeps.
    pub failed: u64,
    /// Smallest radii passed.
    pub collapses: u64,
    /// Of these within the range of the erosion model.
    pub impacts: u64,
    /// Of these nearer than its range.
    pub too_near: u64,
    /// Of these farther than its range.
    pub too_far: u64,
    /// Of these without a wall.
    pub no_wall: u64,
    /// Of these whose data the model cannot use: not finite, or a collapse without a beginning that was seen.
    pub not_assessed: u64,
    /// Steps of motion that ended with a bubble held at a wall.
    pub wall_contacts: u64,
    /// Points of surface averages outside the flow.
    pub average_points_left_out: u64,
    /// Substeps.
    pub substeps: u64,
}

impl CloudLedger {
    /// Counts a collapse.
    pub(super) fn count(&mut self, assessment: Option<&Assessment>) {
        self.collapses += 1;
        let counter = match assessment {
            Some(Assessment::Impact(_)) => &mut self.impacts,
            Some(Assessment::TooNear(_)) => &mut self.too_near,
            Some(Assessment::TooFar(_)) => &mut self.too_far,
            Some(Assessment::Impossible) => &mut self.not_assessed,
            None => &mut self.no_wall,
        };
        *counter += 1;
    }

    /// Adds the counts of a part.
    pub(super) fn add(&mut self, part: &Self) {
        let pairs = [
            (&mut self.injected, part.injected),
            (&mut self.left_domain, part.left_domain),
            (&mut self.closed, part.closed),
            (&mut self.failed, part.failed),
            (&mut self.collapses, part.collapses),
            (&mut self.impacts, part.impacts),
            (&mut self.too_near, part.too_near),
            (&mut self.too_far, part.too_far),
            (&mut self.no_wall, part.no_wall),
            (&mut self.not_assessed, part.not_assessed),
            (&mut self.wall_contacts, part.wall_contacts),
            (
                &mut self.average_points_left_out,
                part.average_points_left_out,
            ),
            (&mut self.substeps, part.substeps),
        ];
        for (sum, more) in pairs {
            *sum += more;
        }
    }
}

/// Adds the impacts of records to a map of the wall, each on the element nearest to the wall point under the bubble.
///
/// # Errors
/// If an impact pressure is not finite.
pub fn deposit(map: &mut PotentialMap, records: &[CollapseRecord]) -> Result<(), SurfaceError> {
    for record in records {
        if let (Some(Assessment::Impact(impact)), Some(foot)) =
            (record.assessment, record.begin.wall_point)
        {
            map.add(map.nearest(foot), impact.impact_pressure)?;
        }
    }
    Ok(())
}
