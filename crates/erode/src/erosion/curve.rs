//! Incubation and rate of a curve of lost mass against time.
//!
//! Nominal incubation time: where the straight line of the largest erosion rate meets the time axis (A and B of the
//! typical curve, Joshi 2018, figure 5.7, after ASTM G32). Onset: the instant of the first loss, which is what the same
//! source calls incubation in its text. Rates are least-squares slopes over a window of time, since mass is lost in whole
//! particles: the window must hold many of them.
//!
//! Units: s and kg (or any unit of loss).

use serde::Serialize;
use thiserror::Error;

/// What a curve says.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ErosionCurve {
    /// Time of the first loss, s.
    pub onset: f64,
    /// Where the line of the largest rate meets the time axis, s.
    pub nominal_incubation: f64,
    /// Largest rate over a window, kg/s.
    pub max_rate: f64,
    /// Middle of the window with the largest rate, s.
    pub max_rate_time: f64,
    /// Mean rate from the onset to the end, kg/s.
    pub mean_rate: f64,
    /// Loss at the end, kg.
    pub final_loss: f64,
}

/// Why a curve has no incubation time.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum CurveError {
    /// Nothing was lost.
    #[error(
        "nothing is lost until the end of the curve at {0} s: the incubation is longer than that"
    )]
    NoLoss(f64),
    /// Not a curve of loss.
    #[error("time must grow and the loss must not fall; point {0} of the curve breaks this")]
    NotMonotonic(usize),
    /// Too short for the window.
    #[error(
        "the window of {window} s must be positive and hold at least three points of the curve, of {points}"
    )]
    BadWindow {
        /// Length of the window, s.
        window: f64,
        /// Number of points of the curve.
        points: usize,
    },
}

impl ErosionCurve {
    /// Reads a curve of (time, loss), with rates over windows of length `window` (s).
    ///
    /// # Errors
    /// If the curve is not one of loss, nothing is lost, or no window holds three points.
    pub fn of(curve: &[[f64; 2]], window: f64) -> Result<Self, CurveError> {
        for (i, pair) in curve.windows(2).enumerate() {
            let grows = pair[1][0] > pair[0][0] && pair[1][1] >= pair[0][1];
            if !grows {
                return Err(CurveError::NotMonotonic(i + 1));
            }
        }
        let bad = CurveError::BadWindow {
            window,
            points: curve.len(),
        };
        let last = *curve.last().ok_or(bad)?;
        let onset = curve.iter().find(|p| p[1] > 0.0);
        let onset = onset.ok_or(CurveError::NoLoss(last[0]))?[0];
        let (mut best, mut from) = (None::<Line>, 0);
        for to in 0..curve.len() {
            while curve[to][0] - curve[from][0] > window {
                from += 1;
            }
            // Only whole windows: the first ones would hold a few points.
            let whole = curve[to][0] - curve[0][0] >= window;
            if whole && to - from >= 2 {
                let line = Line::through(&curve[from..=to]);
                if best.is_none_or(|b| line.slope > b.slope) {
                    best = Some(line);
                }
            }
        }
        let line = best.ok_or(bad)?;
        let after = last[0] - onset;
        Ok(Self {
            onset,
            nominal_incubation: line.time - line.loss / line.slope,
            max_rate: line.slope,
            max_rate_time: line.time,
            mean_rate: if after > 0.0 {
                last[1] / after
            } else {
                f64::NAN
            },
            final_loss: last[1],
        })
    }
}

/// A straight line through its mean point.
#[derive(Debug, Clone, Copy)]
struct Line {
    time: f64,
    loss: f64,
    slope: f64,
}

impl Line {
    fn through(points: &[[f64; 2]]) -> Self {
        let n = points.len() as f64;
        let mean = [0, 1].map(|k| points.iter().map(|p| p[k]).sum::<f64>() / n);
        let (mut covariance, mut variance) = (0.0, 0.0);
        for p in points {
            let d = [p[0] - mean[0], p[1] - mean[1]];
            covariance += d[0] * d[1];
            variance += d[0] * d[0];
        }
        Self {
            time: mean[0],
            loss: mean[1],
            slope: covariance / variance,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(loss: impl Fn(f64) -> f64) -> Vec<[f64; 2]> {
        (0..=1000)
            .map(|i| 0.01 * f64::from(i))
            .map(|t| [t, loss(t)])
            .collect()
    }

    #[test]
    fn a_bent_line_has_its_bend_as_incubation() {
        let found = ErosionCurve::of(&curve(|t| 3.0 * (t - 4.0).max(0.0)), 1.0).unwrap();
        assert!((found.onset - 4.01).abs() < 1e-9);
        assert!((found.nominal_incubation - 4.0).abs() < 1e-9);
        assert!((found.max_rate - 3.0).abs() < 1e-9);
        assert!((found.final_loss - 18.0).abs() < 1e-9);
        assert!((found.mean_rate / 3.0 - 1.0).abs() < 0.01);
    }

    #[test]
    fn acceleration_and_slowing_leave_the_steepest_line() {
        // Quadratic from 2 to 4, then a slower line: steepest at 4 with slope 4, through (4, 4).
        let loss = |t: f64| {
            if t < 4.0 {
                (t - 2.0).max(0.0).powi(2)
            } else {
                4.0 + (t - 4.0)
            }
        };
        let found = ErosionCurve::of(&curve(loss), 0.05).unwrap();
        assert!((found.onset - 2.0).abs() < 0.02);
        assert!((found.max_rate - 4.0).abs() < 0.06);
        assert!((found.nominal_incubation - 3.0).abs() < 0.03);
        assert!((found.max_rate_time - 4.0).abs() < 0.05);
    }

    #[test]
    fn loss_in_whole_particles_is_smoothed_by_the_window() {
        let found = ErosionCurve::of(&curve(|t| (5.0 * (t - 3.0).max(0.0)).floor() / 5.0), 2.0);
        let found = found.unwrap();
        assert!((found.max_rate - 1.0).abs() < 0.05);
        assert!((found.nominal_incubation - 3.1).abs() < 0.2);
    }

    #[test]
    fn what_is_no_curve_of_loss_is_refused() {
        let none = ErosionCurve::of(&curve(|_| 0.0), 1.0).unwrap_err();
        assert_eq!(none, CurveError::NoLoss(10.0));
        let falls = ErosionCurve::of(&[[0.0, 0.0], [1.0, 2.0], [2.0, 1.0]], 1.0).unwrap_err();
        assert_eq!(falls, CurveError::NotMonotonic(2));
        let short = ErosionCurve::of(&curve(|t| t), 0.001).unwrap_err();
        assert!(short.to_string().contains("three points"), "{short}");
        assert!(ErosionCurve::of(&[], 1.0).is_err());
    }
}
