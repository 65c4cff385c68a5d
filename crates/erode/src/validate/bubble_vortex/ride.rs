//! One bubble in the vortex.

use crate::validate::Failure;
use erode_fv::bubbles::carrier::{Carrier, LambOseen, VortexForm, surface_average};
use erode_fv::bubbles::forces::{Forces, volume};
use erode_fv::bubbles::{Averaging, Cloud, NewBubble, Settings};
use erode_physics::bubble::{Liquid, Model, RayleighPlesset, equilibrium_gas};
use std::f64::consts::TAU;

/// Circulation, m2/s.
pub(crate) const CIRCULATION: f64 = 0.29;
/// Core radius, m.
pub(crate) const CORE: f64 = 0.1;
/// Distance of the place of release from the axis, m.
pub(crate) const START: f64 = 0.25;
/// Kinematic viscosity of water, m2/s.
pub(crate) const VISCOSITY: f64 = 1e-6;

/// Rows per second.
const ROWS: f64 = 400.0;
/// Density of the gas, kg/m3: without weight in the result.
const GAS_DENSITY: f64 = 1.0;

/// What is run.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Setup {
    pub(crate) form: VortexForm,
    pub(crate) radius: f64,
    pub(crate) cavitation_number: f64,
    pub(crate) forces: Forces,
    /// Share of the bubble's own time in a substep.
    pub(crate) radius_share: f64,
    /// Time, s.
    pub(crate) duration: f64,
}

/// Rows over time: time s, x, y m, radius m.
#[derive(Debug, Clone)]
pub(crate) struct Ride {
    rows: Vec<[f64; 4]>,
}

impl Setup {
    fn liquid() -> Liquid {
        Liquid {
            density: 1000.0,
            viscosity: 1000.0 * VISCOSITY,
            ..Liquid::WATER
        }
    }

    fn vortex(&self, liquid: &Liquid) -> LambOseen {
        let vortex = LambOseen {
            form: self.form,
            circulation: CIRCULATION,
            core_radius: CORE,
            far_pressure: 0.0,
            density: liquid.density,
            viscosity: liquid.viscosity,
        };
        LambOseen {
            far_pressure: vortex.far_pressure_of(self.cavitation_number, liquid.vapour_pressure),
            ..vortex
        }
    }

    /// Releases the bubble and follows it.
    pub(crate) fn ride(&self) -> Result<Ride, Failure> {
        let liquid = Self::liquid();
        let vortex = self.vortex(&liquid);
        let position = [-START, 0.0, 0.0];
        let flow = surface_average(&vortex, position, self.radius, 0.0)?.point;
        let gas = equilibrium_gas(&liquid, self.radius, flow.pressure, 4.0 / 3.0)
            .map_err(|e| Failure::Run(e.to_string()))?;
        let settings = Settings {
            forces: self.forces,
            averaging: Averaging::Surface,
            slip: true,
            radius_share: self.radius_share,
            ..Settings::new(liquid, Some(Model::RayleighPlesset(RayleighPlesset)))
        };
        let mut cloud = Cloud::new(0.0);
        cloud.inject(&NewBubble {
            position,
            velocity: vortex.at(position, 0.0)?.velocity,
            radius: self.radius,
            wall_velocity: 0.0,
            gas,
            mass: GAS_DENSITY * volume(self.radius),
        })?;
        let mut rows = Vec::new();
        let count = (self.duration * ROWS) as u32;
        for k in 0..=count {
            cloud.advance(&vortex, &settings, f64::from(k) / ROWS)?;
            let Some(x) = cloud.position.first() else {
                let fate = cloud.lost.first().map(|l| format!("{:?}", l.fate));
                return Err(Failure::Run(format!(
                    "the bubble is gone: {}",
                    fate.unwrap_or_default()
                )));
            };
            rows.push([cloud.time, x[0], x[1], cloud.state[0].radius]);
        }
        Ok(Ride { rows })
    }
}

fn distance(row: &[f64; 4]) -> f64 {
    row[1].hypot(row[2])
}

impl Ride {
    fn at_core(&self) -> Option<usize> {
        self.rows.iter().position(|r| distance(r) < CORE)
    }

    /// Time at which the core radius is first passed, s, on the straight line between rows; not a number if it is not.
    pub(crate) fn time_to_core(&self) -> f64 {
        let Some(k) = self.at_core().filter(|&k| k > 0) else {
            return f64::NAN;
        };
        let (a, b) = (&self.rows[k - 1], &self.rows[k]);
        let x = (distance(a) - CORE) / (distance(a) - distance(b));
        a[0] + x * (b[0] - a[0])
    }

    /// Turns about the axis until a row.
    fn turns(&self, until: usize) -> f64 {
        let steps = self.rows[..=until].windows(2);
        let turned = steps.map(|w| {
            let (a, b) = (w[0], w[1]);
            (a[1] * b[2] - a[2] * b[1]).atan2(a[1] * b[1] + a[2] * b[2])
        });
        turned.sum::<f64>() / TAU
    }

    /// Turns until the core radius is first passed.
    pub(crate) fn turns_to_core(&self) -> f64 {
        self.at_core().map_or(f64::NAN, |k| self.turns(k))
    }

    /// Distance from the axis when the first turn is done, m.
    pub(crate) fn distance_after_turn(&self) -> f64 {
        let done = (1..self.rows.len()).find(|&k| self.turns(k) >= 1.0);
        done.map_or(f64::NAN, |k| distance(&self.rows[k]))
    }

    /// Least distance from the axis, m.
    pub(crate) fn last_distance(&self) -> f64 {
        self.rows.iter().map(distance).fold(f64::INFINITY, f64::min)
    }

    /// How often the radial motion turns round.
    pub(crate) fn radial_turns(&self) -> f64 {
        let moves: Vec<f64> = self
            .rows
            .windows(2)
            .map(|w| distance(&w[1]) - distance(&w[0]))
            .collect();
        moves.windows(2).filter(|m| m[0] * m[1] < 0.0).count() as f64
    }

    /// Radii over the first one, in the last quarter.
    fn late(&self) -> impl Iterator<Item = f64> {
        let first = self.rows[0][3];
        self.rows[3 * self.rows.len() / 4..]
            .iter()
            .map(move |r| r[3] / first)
    }

    /// Mean radius of the last quarter over the first radius.
    pub(crate) fn mean_radius(&self) -> f64 {
        let (sum, count) = self.late().fold((0.0, 0u32), |(s, n), r| (s + r, n + 1));
        sum / f64::from(count)
    }

    /// Largest radius over the first.
    pub(crate) fn max_radius(&self) -> f64 {
        let first = self.rows[0][3];
        self.rows.iter().map(|r| r[3] / first).fold(0.0, f64::max)
    }

    /// Largest fall of the radius from a largest to the next smallest one, over the first radius.
    pub(crate) fn swing(&self) -> f64 {
        let (mut top, mut largest) = (0.0f64, 0.0f64);
        for pair in self.rows.windows(2) {
            if pair[1][3] > pair[0][3] {
                top = pair[1][3];
            } else {
                largest = largest.max(top - pair[1][3]);
            }
        }
        largest / self.rows[0][3]
    }

    /// Rows of a figure.
    fn shown(&self) -> impl Iterator<Item = &[f64; 4]> {
        self.rows.iter().step_by(8)
    }

    pub(crate) fn path(&self) -> Vec<[f64; 2]> {
        self.shown().map(|r| [r[1], r[2]]).collect()
    }

    pub(crate) fn distances(&self) -> Vec<[f64; 2]> {
        self.rows
            .iter()
            .map(|r| [r[0], distance(r) / CORE])
            .collect()
    }

    pub(crate) fn radii(&self) -> Vec<[f64; 2]> {
        self.shown().map(|r| [r[0], r[3]]).collect()
    }
}
