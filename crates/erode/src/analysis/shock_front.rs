//! The shock front: where the spherical shock of the collapse meets the wall, how it runs outwards, how fast.
//!
//! Joshi 2018, section 6.4.4.2: the pressure along the wall is largest where the primary and the reflected wave cross.
//! A sphere that grows at c from the height a above the wall meets it at r^2 + a^2 = (c t)^2 (6.19, z = 0), so that
//! dr/dt = c sqrt(1 + (a/r)^2) (6.20). SI units; r > 0.

use super::{WallPressure, above_step};

/// The front is followed down to this part of the yield stress: below, other waves are as strong.
const FOLLOWED: f64 = 0.4;
/// Radii on each side that its speed is read from.
const REACH: usize = 3;

/// The front at one radius.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Front {
    /// Distance from the axis, m.
    pub radius: f64,
    /// When it passes, s: at the largest pressure there.
    pub time: f64,
    /// Largest pressure there, Pa.
    pub pressure: f64,
    /// Speed along the wall, m/s; NaN where the front does not run outwards.
    pub speed: f64,
}

/// Speed of the front along the wall (6.20), m/s: `c` speed of the sphere, `height` of its centre, `radius` from the axis.
#[must_use]
pub fn front_speed(c: f64, height: f64, radius: f64) -> f64 {
    c * 1.0_f64.hypot(height / radius)
}

/// Distance of the front from the axis (6.19), m, `time` after the sphere was a point; NaN before it reaches the wall.
#[must_use]
pub fn front_position(c: f64, height: f64, time: f64) -> f64 {
    ((c * time).powi(2) - height * height).sqrt()
}

/// Pressure above which the front is told from what else acts on the wall, Pa: a part of the yield stress of the metal, and
/// more than the step that drives the collapse makes by itself.
#[must_use]
pub fn followed_above(yield_stress: f64, driving_pressure: f64) -> f64 {
    above_step(FOLLOWED * yield_stress, driving_pressure)
}

/// The front at every radius where the pressure exceeds `least`, Pa: how far it is followed before it is lost in what
/// else acts on the wall. The speed is the inverse slope of a straight line through seven neighbouring radii.
#[must_use]
pub fn front(wall: &WallPressure, least: f64) -> Vec<Front> {
    let peaks = wall.peaks();
    let followed = peaks.iter().take_while(|[p, _]| *p > least).count();
    let times: Vec<f64> = (0..followed)
        .map(|k| peak_time(&wall.time, &wall.pressure[k]))
        .collect();
    (0..followed)
        .map(|k| {
            let (low, high) = (k.saturating_sub(REACH), (k + REACH + 1).min(followed));
            let slowness = slope(&wall.radius[low..high], &times[low..high]);
            Front {
                radius: wall.radius[k],
                time: times[k],
                pressure: peaks[k][0],
                speed: if slowness > 0.0 {
                    1.0 / slowness
                } else {
                    f64::NAN
                },
            }
        })
        .collect()
}

/// When the pressure is largest: the top of the parabola through the largest row and its neighbours. A shock that the
/// discrete form smears over some spacings has its top where the sharp one has its jump and top, and not its foot.
fn peak_time(time: &[f64], pressure: &[f64]) -> f64 {
    let known = (0..pressure.len()).filter(|k| pressure[*k].is_finite());
    let Some(peak) = known.max_by(|a, b| pressure[*a].total_cmp(&pressure[*b])) else {
        return f64::NAN;
    };
    if peak == 0 || peak + 1 >= pressure.len() {
        return time.get(peak).copied().unwrap_or(f64::NAN);
    }
    // Newton's form of the parabola; rows need not be evenly spaced.
    let slope = |k: usize| (pressure[k + 1] - pressure[k]) / (time[k + 1] - time[k]);
    let (before, after) = (slope(peak - 1), slope(peak));
    let middle = |k: usize| 0.5 * (time[k] + time[k + 1]);
    if before > after {
        middle(peak - 1) + before / (before - after) * (middle(peak) - middle(peak - 1))
    } else {
        time[peak]
    }
}

/// Slope of the straight line of least squares; NaN for fewer than two points.
fn slope(x: &[f64], y: &[f64]) -> f64 {
    let n = x.len() as f64;
    let (mx, my) = (x.iter().sum::<f64>() / n, y.iter().sum::<f64>() / n);
    let xy: f64 = x.iter().zip(y).map(|(x, y)| (x - mx) * (y - my)).sum();
    let xx: f64 = x.iter().map(|x| (x - mx) * (x - mx)).sum();
    xy / xx
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A spherical shock as a discrete form smears it, from a point at `height` at time 0; it decays as 1/d.
    fn sphere(c: f64, height: f64) -> WallPressure {
        let radius: Vec<f64> = (0..80).map(|i| (f64::from(i) + 0.5) * 5e-6).collect();
        let time: Vec<f64> = (0..400).map(|k| f64::from(k) * 1e-9).collect();
        let width = 8e-9;
        let pressure = radius.iter().map(|r| {
            let d = r.hypot(height);
            let at = |t: &f64| 1e9 * height / d * (-((t - d / c) / width).powi(2)).exp();
            time.iter().map(at).collect()
        });
        WallPressure {
            pressure: pressure.collect(),
            time,
            radius,
        }
    }

    #[test]
    fn a_spherical_wave_runs_along_the_wall_as_the_equation_says() {
        let (c, height) = (1500.0, 0.09e-3);
        let found = front(&sphere(c, height), 1e8);
        assert_eq!(found.len(), 80);
        // Straight lines over seven radii: the curvature of the path counts on the axis, where the speed has no bound.
        for f in found.iter().skip(8).take(68) {
            let exact = front_speed(c, height, f.radius);
            assert!((f.speed / exact - 1.0).abs() < 0.03, "{f:?}: {exact}");
        }
        let far = &found[60];
        let when = far.radius.hypot(height) / c;
        // A hundredth of a row: a bell is not quite a parabola.
        assert!((far.time - when).abs() < 1e-11, "{far:?}: {when}");
        assert!((front_position(c, height, when) / far.radius - 1.0).abs() < 1e-12);
    }

    #[test]
    fn the_front_is_followed_only_as_far_as_it_stands_out() {
        let wall = sphere(1500.0, 0.09e-3);
        let found = front(&wall, 5e8);
        let limit = found.last().unwrap().radius;
        // 1e9 a/d = 5e8 at d = 2 a; radii are 5 um apart.
        let exact = (3.0_f64).sqrt() * 0.09e-3;
        assert!((limit - exact).abs() < 6e-6, "{limit} {exact}");
        assert!(front(&wall, 2e9).is_empty());
    }

    #[test]
    fn an_earlier_weaker_wave_is_not_taken_for_the_front() {
        let mut wall = sphere(1500.0, 0.09e-3);
        for p in &mut wall.pressure {
            p[..20].fill(1.5e8);
            p[20..30].fill(0.0);
        }
        let found = front(&wall, 1e8);
        assert!(found[10].time > 50e-9, "{:?}", found[10]);
    }

    /// Rows without a value are no largest ones.
    #[test]
    fn rows_that_are_not_numbers_are_left_out() {
        let mut wall = sphere(1500.0, 0.09e-3);
        let whole = front(&wall, 1e8);
        for p in &mut wall.pressure {
            p[5] = f64::NAN;
            p[399] = f64::NAN;
        }
        assert_eq!(front(&wall, 1e8), whole);
    }

    #[test]
    fn the_front_stands_out_of_the_driving_step() {
        assert_eq!(followed_above(500e6, 50e6), 200e6);
        // The step of 100 MPa makes 200 MPa at a rigid wall.
        assert!(followed_above(500e6, 100e6) > 200e6);
    }

    #[test]
    fn far_out_the_front_has_the_speed_of_the_wave() {
        assert!((front_speed(1500.0, 1e-4, 1e-2) / 1500.0 - 1.0).abs() < 1e-4);
        assert!((front_speed(1500.0, 3.0, 4.0) - 1875.0).abs() < 1e-9);
        assert!(front_position(1500.0, 1.0, 1e-5).is_nan());
    }
}
