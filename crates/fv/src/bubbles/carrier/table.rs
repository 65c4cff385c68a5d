//! A flow from a table: velocity and pressure on a regular grid at one or more times.
//!
//! Linear between grid points and between snapshots; gradients and Du/Dt are those of the interpolant. A direction with one
//! point is one in which nothing changes. Outside grid or times the table has no answer. The pressure holds its hydrostatic
//! part; `gravity` takes it out of the gradient.

use super::{Carrier, CarrierError, CarrierPoint};
use crate::vector::{Vector, along, dot, finite, mix, scale, sub};
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// A regular grid; x runs fastest.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Grid {
    /// First point, m.
    pub lower: Vector,
    /// Distance of points, m.
    pub spacing: Vector,
    /// Points in each direction, at least one.
    pub counts: [usize; 3],
}

/// The flow at one time.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Snapshot {
    /// Time, s.
    pub time: f64,
    /// Velocity at each point, m/s.
    pub velocity: Vec<Vector>,
    /// Pressure at each point, Pa.
    pub pressure: Vec<f64>,
}

/// What is wrong with a table.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum TableError {
    /// Grid without points or with a spacing that is not positive.
    #[error(
        "the grid of the flow needs at least one point and a positive spacing in each direction, not {counts:?} and {spacing:?} m"
    )]
    Grid {
        /// Points in each direction.
        counts: [usize; 3],
        /// Spacing, m.
        spacing: Vector,
    },
    /// No snapshots, or times that do not increase.
    #[error("the flow needs at least one snapshot, and their times must increase")]
    Times,
    /// Wrong number of values.
    #[error(
        "snapshot {snapshot} of the flow has {found} values, but the grid has {expected} points"
    )]
    Size {
        /// Number of the snapshot, from 0.
        snapshot: usize,
        /// Values found.
        found: usize,
        /// Points of the grid.
        expected: usize,
    },
    /// A value that is not finite.
    #[error("snapshot {snapshot} of the flow has a value that is not finite at point {point}")]
    NotFinite {
        /// Number of the snapshot, from 0.
        snapshot: usize,
        /// Number of the point, from 0.
        point: usize,
    },
}

/// A flow from a table.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    grid: Grid,
    snapshots: Vec<Snapshot>,
    density: f64,
    viscosity: f64,
    gravity: Vector,
}

/// Velocity, pressure and their gradients from one snapshot.
#[derive(Clone, Copy)]
struct Local {
    velocity: Vector,
    pressure: f64,
    velocity_gradient: [Vector; 3],
    pressure_gradient: Vector,
}

impl Table {
    /// A checked table. One snapshot is a steady flow.
    ///
    /// # Errors
    /// If grid, times or values do not fit.
    pub fn new(
        grid: Grid,
        snapshots: Vec<Snapshot>,
        (density, viscosity): (f64, f64),
        gravity: Vector,
    ) -> Result<Self, TableError> {
        let good = (0..3).all(|k| grid.counts[k] >= 1 && grid.spacing[k] > 0.0);
        if !good {
            return Err(TableError::Grid {
                counts: grid.counts,
                spacing: grid.spacing,
            });
        }
        let rising = snapshots.windows(2).all(|w| w[0].time < w[1].time);
        if snapshots.is_empty() || !rising {
            return Err(TableError::Times);
        }
        let expected = grid.counts.iter().product();
        for (number, snapshot) in snapshots.iter().enumerate() {
            check(number, snapshot, expected)?;
        }
        Ok(Self {
            grid,
            snapshots,
            density,
            viscosity,
            gravity,
        })
    }

    /// Cell and place in it for one direction: index of the lower point, fraction, 1/spacing (zero where nothing changes).
    fn cell(&self, axis: usize, x: f64) -> Option<(usize, f64, f64)> {
        let n = self.grid.counts[axis];
        if n == 1 {
            return Some((0, 0.0, 0.0));
        }
        let inverse = 1.0 / self.grid.spacing[axis];
        let s = (x - self.grid.lower[axis]) * inverse;
        let last = (n - 1) as f64;
        if !(0.0..=last).contains(&s) {
            return None;
        }
        let index = (s as usize).min(n - 2);
        Some((index, s - index as f64, inverse))
    }

    fn local(&self, snapshot: &Snapshot, position: Vector) -> Option<Local> {
        let mut cells = [(0, 0.0, 0.0); 3];
        for (axis, cell) in cells.iter_mut().enumerate() {
            *cell = self.cell(axis, position[axis])?;
        }
        let mut local = Local {
            velocity: [0.0; 3],
            pressure: 0.0,
            velocity_gradient: [[0.0; 3]; 3],
            pressure_gradient: [0.0; 3],
        };
        let [nx, ny, _] = self.grid.counts;
        for corner in 0..8usize {
            let up = [corner & 1, corner >> 1 & 1, corner >> 2];
            if (0..3).any(|k| up[k] == 1 && self.grid.counts[k] == 1) {
                continue;
            }
            let at = [0, 1, 2].map(|k| cells[k].0 + up[k]);
            let point = at[0] + nx * (at[1] + ny * at[2]);
            let (u, p) = (snapshot.velocity[point], snapshot.pressure[point]);
            let share = [0, 1, 2].map(|k| {
                if up[k] == 1 {
                    cells[k].1
                } else {
                    1.0 - cells[k].1
                }
            });
            let weight = share[0] * share[1] * share[2];
            local.velocity = along(local.velocity, weight, u);
            local.pressure += weight * p;
            for j in 0..3 {
                let sign = if up[j] == 1 { 1.0 } else { -1.0 };
                let slope = sign * cells[j].2 * share[(j + 1) % 3] * share[(j + 2) % 3];
                for (row, component) in local.velocity_gradient.iter_mut().zip(u) {
                    row[j] += slope * component;
                }
                local.pressure_gradient[j] += slope * p;
            }
        }
        Some(local)
    }

    /// The snapshots around a time, the fraction between them, and their distance in time (zero in steady flow).
    fn around(&self, time: f64) -> Result<(&Snapshot, &Snapshot, f64, f64), CarrierError> {
        let (first, last) = (
            &self.snapshots[0],
            &self.snapshots[self.snapshots.len() - 1],
        );
        if self.snapshots.len() == 1 {
            return Ok((first, first, 0.0, 0.0));
        }
        if !(first.time..=last.time).contains(&time) {
            return Err(CarrierError::OutsideTime {
                time,
                start: first.time,
                end: last.time,
            });
        }
        let after = self.snapshots.partition_point(|s| s.time <= time);
        let after = after.clamp(1, self.snapshots.len() - 1);
        let (a, b) = (&self.snapshots[after - 1], &self.snapshots[after]);
        let length = b.time - a.time;
        Ok((a, b, (time - a.time) / length, length))
    }
}

fn check(number: usize, snapshot: &Snapshot, expected: usize) -> Result<(), TableError> {
    for found in [snapshot.velocity.len(), snapshot.pressure.len()] {
        if found != expected {
            return Err(TableError::Size {
                snapshot: number,
                found,
                expected,
            });
        }
    }
    let good = |k: usize| finite(snapshot.velocity[k]) && snapshot.pressure[k].is_finite();
    match (0..expected).find(|&k| !good(k)) {
        Some(point) => Err(TableError::NotFinite {
            snapshot: number,
            point,
        }),
        None => Ok(()),
    }
}

impl Carrier for Table {
    fn at(&self, position: Vector, time: f64) -> Result<CarrierPoint, CarrierError> {
        let (before, after, x, length) = self.around(time)?;
        let outside = CarrierError::Outside { position };
        let a = self.local(before, position).ok_or(outside)?;
        let b = if length > 0.0 {
            self.local(after, position).ok_or(outside)?
        } else {
            a
        };
        let velocity = mix(a.velocity, b.velocity, x);
        let rows = [0, 1, 2].map(|i| mix(a.velocity_gradient[i], b.velocity_gradient[i], x));
        let rate = if length > 0.0 {
            scale(1.0 / length, sub(b.velocity, a.velocity))
        } else {
            [0.0; 3]
        };
        let convective = rows.map(|row| dot(row, velocity));
        let gradient = mix(a.pressure_gradient, b.pressure_gradient, x);
        let pressure = (1.0 - x) * a.pressure + x * b.pressure;
        Ok(CarrierPoint {
            velocity,
            pressure_gradient: along(gradient, -self.density, self.gravity),
            velocity_gradient: rows,
            acceleration: along(rate, 1.0, convective),
            ..CarrierPoint::at_rest(pressure, self.density, self.viscosity)
        })
    }

    fn length_scale(&self, _position: Vector) -> f64 {
        let used = (0..3).filter(|&k| self.grid.counts[k] > 1);
        used.map(|k| self.grid.spacing[k])
            .fold(f64::INFINITY, f64::min)
    }

    fn time_scale(&self) -> f64 {
        let gaps = self.snapshots.windows(2).map(|w| w[1].time - w[0].time);
        gaps.fold(f64::INFINITY, f64::min)
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::misses;
    use super::*;

    /// u = (1 + 2 x + 3 t) (1, -1, 0) + y (0, 0, 4), p = 5 + 6 x - 7 y + 8 t on a grid that is uniform in z.
    fn linear() -> Table {
        let grid = Grid {
            lower: [-1.0, 0.0, 0.0],
            spacing: [0.5, 0.25, 1.0],
            counts: [5, 4, 1],
        };
        let snapshot = |time: f64| {
            let mut s = Snapshot {
                time,
                velocity: vec![],
                pressure: vec![],
            };
            for j in 0..4 {
                for i in 0..5 {
                    let (x, y) = (-1.0 + 0.5 * f64::from(i), 0.25 * f64::from(j));
                    let a = 1.0 + 2.0 * x + 3.0 * time;
                    s.velocity.push([a, -a, 4.0 * y]);
                    s.pressure.push(5.0 + 6.0 * x - 7.0 * y + 8.0 * time);
                }
            }
            s
        };
        let snapshots = [0.0, 0.5, 2.0].map(snapshot).to_vec();
        Table::new(grid, snapshots, (1.0, 1e-3), [0.0; 3]).unwrap()
    }

    #[test]
    fn linear_flows_are_met_exactly() {
        let flow = linear();
        for (x, t) in [
            ([0.3, 0.4, 9.0], 0.3),
            ([-0.9, 0.1, -5.0], 1.2),
            ([1.0, 0.75, 0.0], 2.0),
        ] {
            let p = flow.at(x, t).unwrap();
            let a = 1.0 + 2.0 * x[0] + 3.0 * t;
            assert!(
                (p.velocity[0] - a).abs() < 1e-12 && (p.velocity[2] - 4.0 * x[1]).abs() < 1e-12
            );
            assert!((p.pressure - (5.0 + 6.0 * x[0] - 7.0 * x[1] + 8.0 * t)).abs() < 1e-12);
            // du/dt + (u . grad) u = 3 + 2 a.
            assert!((p.acceleration[0] - (3.0 + 2.0 * a)).abs() < 1e-11);
        }
        let missed = misses(&flow, [0.3, 0.4, 0.0], 0.3, 1e-3, 1e-3);
        assert!(missed.iter().all(|m| *m < 1e-9), "{missed:?}");
    }

    #[test]
    fn outside_is_an_error() {
        let flow = linear();
        assert!(matches!(
            flow.at([1.001, 0.1, 0.0], 0.1),
            Err(CarrierError::Outside { .. })
        ));
        assert!(matches!(
            flow.at([0.0, -0.001, 0.0], 0.1),
            Err(CarrierError::Outside { .. })
        ));
        assert!(matches!(
            flow.at([0.0, 0.1, 0.0], 2.1),
            Err(CarrierError::OutsideTime { .. })
        ));
        assert!(flow.at([f64::NAN, 0.1, 0.0], 0.1).is_err());
    }

    #[test]
    fn bad_tables_are_refused() {
        let good = linear();
        let mut short = good.snapshots.clone();
        short[1].pressure.pop();
        let message = Table::new(good.grid, short, (1.0, 0.0), [0.0; 3])
            .unwrap_err()
            .to_string();
        assert!(message.contains("snapshot 1"), "{message}");
        let mut twice = good.snapshots.clone();
        twice[1].time = 0.0;
        assert_eq!(
            Table::new(good.grid, twice, (1.0, 0.0), [0.0; 3]),
            Err(TableError::Times)
        );
    }
}
