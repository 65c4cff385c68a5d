//! Prescribed loads on a surface.
//!
//! p(r) = sigma_H exp(-(2 r/d_H)^2)                                                    (Joshi 2018, eq. 3.9)
//! p(r, t) = p(r) exp(-((t - t_max)/t_H)^2)                                            (Joshi 2018, eq. 3.10)
//! g(r) = exp(-ln(100) (r/R)^2), 1 % at r = R                            (Joshi 2018, figure 5.4: shape of the pit)
//!
//! Checked: the force of (3.9) on a plane is pi/4 sigma_H d_H^2, the impulse of (3.10) sqrt(pi) t_H times that.
//! Units: SI. Range: any r and t.

use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// Gaussian pressure of a cavitation impact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct GaussianPressure {
    /// Largest pressure sigma_H, Pa.
    pub amplitude: f64,
    /// Extent d_H, m: at d_H/2 from the centre the pressure is 1/e of the largest.
    pub diameter: f64,
    /// Course in time; none: constant.
    pub pulse: Option<GaussianPulse>,
}

/// Gaussian course in time.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct GaussianPulse {
    /// Time t_max of the largest pressure, s.
    pub peak_time: f64,
    /// Characteristic rise time t_H, s.
    pub rise_time: f64,
}

impl GaussianPressure {
    /// Pressure at distance `r` (m) from the centre and time `t` (s), Pa.
    #[must_use]
    pub fn at(&self, r: f64, t: f64) -> f64 {
        let x = 2.0 * r / self.diameter;
        let share = self.pulse.map_or(1.0, |p| {
            let y = (t - p.peak_time) / p.rise_time;
            (-y * y).exp()
        });
        self.amplitude * (-x * x).exp() * share
    }

    /// Force on an endless plane at the time of the largest pressure, N.
    #[must_use]
    pub fn force(&self) -> f64 {
        0.25 * PI * self.amplitude * self.diameter * self.diameter
    }
}

/// exp(-ln(100) (r/R)^2): 1 at the centre, 0.01 at r = R.
#[must_use]
pub fn gaussian_one_percent(r: f64, radius: f64) -> f64 {
    let x = r / radius;
    (-(100_f64.ln()) * x * x).exp()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn force_and_impulse_are_the_integrals() {
        let load = GaussianPressure {
            amplitude: 2.5e9,
            diameter: 1e-4,
            pulse: Some(GaussianPulse {
                peak_time: 5e-8,
                rise_time: 1e-8,
            }),
        };
        let (n, reach) = (2000, 5e-4);
        let dr = reach / f64::from(n);
        let force: f64 = (0..n)
            .map(|i| (f64::from(i) + 0.5) * dr)
            .map(|r| load.at(r, 5e-8) * 2.0 * PI * r * dr)
            .sum();
        assert!((force / load.force() - 1.0).abs() < 1e-4);
        assert!((load.force() - 19.635).abs() < 1e-3);
        let dt = 1e-7 / f64::from(n);
        let time: f64 = (0..n)
            .map(|i| load.at(0.0, (f64::from(i) + 0.5) * dt) * dt)
            .sum();
        assert!((time / (load.amplitude * PI.sqrt() * 1e-8) - 1.0).abs() < 1e-6);
    }

    #[test]
    fn the_pit_is_one_percent_at_its_radius() {
        assert!((gaussian_one_percent(0.4e-3, 0.4e-3) - 0.01).abs() < 1e-15);
        assert_eq!(gaussian_one_percent(0.0, 0.4e-3), 1.0);
    }
}
