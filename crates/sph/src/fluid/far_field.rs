//! Far field: a side of the liquid through which waves leave and a pressure step may enter.
//!
//! Along the characteristic that enters the liquid the Riemann invariant u - F(p) keeps the value of the far field,
//! F(p) = integral of dp/(rho c) (u outward normal velocity), so at the side F(p) = u + 2 F(p_s) - F(p_inf), with p_inf the
//! pressure at rest and p_s behind the entering step. A wave that leaves meets no resistance but its own impedance.
//! Exact for simple waves of one space dimension.

use crate::fluid::Fluid;
use crate::fluid::ghosts::Plane;
use crate::geometry::dot;
use erode_physics::eos::Tait;

/// What lies outside a particle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FarField<const D: usize = 2> {
    /// Outward unit normal; zero for particles without a far field.
    pub normal: [f64; D],
    /// Pressure of the undisturbed far field, Pa.
    pub pressure: f64,
    /// Pressure behind the entering step, Pa; equal to `pressure` when there is none.
    pub step_pressure: f64,
    /// Time at which the step begins to enter, s.
    pub start: f64,
    /// Time in which it rises, s: what the spacing at the side can carry.
    pub rise: f64,
    /// Area of the side that the particle stands for, m2; zero behind the outermost row.
    pub face_area: f64,
}

impl<const D: usize> FarField<D> {
    /// No far field.
    pub const NONE: Self = Self {
        normal: [0.0; D],
        pressure: 0.0,
        step_pressure: 0.0,
        start: 0.0,
        rise: 0.0,
        face_area: 0.0,
    };

    /// Whether there is one.
    #[must_use]
    pub fn is_some(&self) -> bool {
        self.normal != [0.0; D]
    }

    /// Part of the step that has entered at `time`: a smooth rise.
    fn risen(&self, time: f64) -> f64 {
        let s = (time - self.start) / self.rise;
        if time < self.start {
            0.0
        } else if s < 1.0 {
            s * s * (3.0 - 2.0 * s)
        } else {
            1.0
        }
    }

    /// Pressure (Pa) on the outside of a particle (zero without a far field) that moves with `velocity` at `time`.
    #[must_use]
    pub fn pressure_outside(&self, eos: &Tait, velocity: [f64; D], time: f64) -> f64 {
        if !self.is_some() {
            return 0.0;
        }
        let integral = |p: f64| eos.riemann_integral(eos.density(p));
        let step = self.pressure + self.risen(time) * (self.step_pressure - self.pressure);
        let u = dot(velocity, self.normal);
        let f = u + 2.0 * integral(step) - integral(self.pressure);
        eos.pressure_of_riemann_integral(f).max(0.0)
    }
}

/// Particles within this many smoothing lengths of a far side feel the pressure outside.
const REACH: f64 = 2.5;

/// A step rises while sound runs this many smoothing lengths of the side: sharper ones only ring.
const RISE: f64 = 2.5;

/// The outermost row: particles within this many spacings of the side.
const OUTERMOST: f64 = 0.75;

impl Fluid {
    /// Opens a straight side: `side` is its plane with the normal into the liquid, `far` its state (normal and area are
    /// filled in here, and the rise time of a step from the spacing). In a corner the nearer side wins.
    pub fn open_side(&mut self, side: &Plane, far: FarField) {
        let outward = side.normal.map(|n| -n);
        let tangent = [-outward[1], outward[0]];
        let mut row = Vec::new();
        let at_side = |a: &usize| side.distance(self.position[*a]) < self.smoothing_length[*a];
        let coarsest = (0..self.len())
            .filter(at_side)
            .map(|a| self.smoothing_length[a])
            .fold(0.0, f64::max);
        let rise = RISE * coarsest / self.eos.sound_speed;
        for a in 0..self.len() {
            let depth = side.distance(self.position[a]);
            let nearest = self.far_field[a].is_some() && self.side_depth[a] <= depth;
            if depth < REACH * self.smoothing_length[a] && !nearest {
                self.far_field[a] = FarField {
                    normal: outward,
                    face_area: 0.0,
                    rise,
                    ..far
                };
                self.side_depth[a] = depth;
            }
            if depth < OUTERMOST * self.area(a).sqrt() {
                row.push((
                    tangent[0] * self.position[a][0] + tangent[1] * self.position[a][1],
                    a,
                ));
            }
        }
        row.sort_by(|p, q| p.0.total_cmp(&q.0));
        for (k, (place, a)) in row.iter().enumerate() {
            let width = self.area(*a).sqrt();
            let from = if k > 0 {
                0.5 * (row[k - 1].0 + place)
            } else {
                place - 0.5 * width
            };
            let to = if k + 1 < row.len() {
                0.5 * (row[k + 1].0 + place)
            } else {
                place + 0.5 * width
            };
            self.far_field[*a].face_area = (to - from) * self.geometry.ring(self.position[*a][0]);
        }
    }
}
