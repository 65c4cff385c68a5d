//! What the liquid does to the wall within a distance of the axis: impulse and acoustic work.
//!
//! Impulse: integral of p dA dt, N s. Acoustic work: integral of p^2/Z dA dt, J, the work of the same pressure on a wall of
//! impedance Z that answers with plane waves, p = Z v (plane acoustics; no equation of the sources).

use super::WallPressure;
use std::f64::consts::PI;

/// See the head of this file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WallLoad {
    /// N s.
    pub impulse: f64,
    /// J.
    pub work: f64,
}

impl WallPressure {
    /// Of the part nearer to the axis than `reach` (m), from time `span[0]` to `span[1]` (s), on a wall of `impedance`
    /// (kg/(m2 s)). Each column of the record stands for the ring between the middles to its neighbours; times are joined by
    /// the trapezoidal rule; pressures that are no number count as none.
    #[must_use]
    pub fn load(&self, reach: f64, impedance: f64, span: [f64; 2]) -> WallLoad {
        let rings: Vec<f64> = self.rings();
        let inside = self.radius.iter().take_while(|r| **r < reach).count();
        let at = |k: usize| {
            let (mut force, mut power) = (0.0, 0.0);
            for (ring, pressure) in rings.iter().zip(&self.pressure).take(inside) {
                let p = if pressure[k].is_finite() {
                    pressure[k]
                } else {
                    0.0
                };
                force += ring * p;
                power += ring * p * p / impedance;
            }
            [force, power]
        };
        let mut sum = [0.0; 2];
        for k in 1..self.time.len() {
            if self.time[k - 1] < span[0] || self.time[k] > span[1] {
                continue;
            }
            let (a, b) = (at(k - 1), at(k));
            for i in 0..2 {
                sum[i] += 0.5 * (a[i] + b[i]) * (self.time[k] - self.time[k - 1]);
            }
        }
        let [impulse, work] = sum;
        WallLoad { impulse, work }
    }

    /// Area of the ring that each column stands for, m2.
    fn rings(&self) -> Vec<f64> {
        let r = &self.radius;
        let middle = |i: usize| 0.5 * (r[i - 1] + r[i]);
        let inner = |i: usize| if i == 0 { 0.0 } else { middle(i) };
        let outer = |i: usize| {
            if i + 1 < r.len() { middle(i + 1) } else { r[i] }
        };
        (0..r.len())
            .map(|i| PI * (outer(i).powi(2) - inner(i).powi(2)))
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A pressure that is the same everywhere, on and off as a tent of 2 us.
    #[test]
    fn a_tent_of_pressure_on_a_disc() {
        let radius: Vec<f64> = (0..100).map(|i| (f64::from(i) + 0.5) * 2e-6).collect();
        let time: Vec<f64> = (0..=200).map(|k| f64::from(k) * 10e-9).collect();
        let tent: Vec<f64> = (time.iter())
            .map(|t| 1e9 * (1.0 - (t * 1e6 - 1.0).abs()))
            .collect();
        let wall = WallPressure {
            pressure: vec![tent; radius.len()],
            time,
            radius,
        };
        let load = wall.load(1e-4, 4e7, [0.0, 2e-6]);
        let disc = PI * 1e-8;
        assert!(
            (load.impulse / (1e9 * 1e-6 * disc) - 1.0).abs() < 1e-9,
            "{load:?}"
        );
        // The mean of the square of a tent is a third; the trapezoidal rule has half a step squared too much.
        let exact = 1e18 / 4e7 * 2e-6 / 3.0 * disc;
        assert!((load.work / exact - 1.0).abs() < 1e-4, "{load:?}");
        let nothing = WallPressure {
            time: Vec::new(),
            radius: Vec::new(),
            pressure: Vec::new(),
        };
        assert_eq!(nothing.load(1e-4, 4e7, [0.0, 2e-6]).impulse, 0.0);
        let half = wall.load(1e-4, 4e7, [0.0, 1e-6]);
        assert!((2.0 * half.impulse / load.impulse - 1.0).abs() < 1e-9);
    }
}
