//! Characteristic times of load and material (Joshi 2018, section 6.4.6).
//!
//! Loading time at a point of the wall: from the rise of the pressure above 100 MPa until it last falls below the initial
//! yield stress, 508 MPa (figure 6.17). The rise that counts is the last one before the yield stress is first reached: what
//! came and went before never loaded the metal. The step that drives the collapse is reflected with nearly twice its
//! pressure, 100 MPa in the thesis: for the rise to be that of the collapse, its level must lie above it. Material time: depth of the plastic zone / sound speed of the solid. Where
//! the material time is the longer one, inertia keeps the metal from yielding. SI units.

use super::crossing;

/// Pressure at which the load begins, Pa.
pub const RISE: f64 = 100e6;
/// Pressure at which it ends, Pa: initial yield stress of A-2205.
pub const FALL: f64 = 508e6;

/// What the wall feels of a step of pressure, in units of the step: twice it at a rigid wall, and a fifth more.
const REFLECTED: f64 = 2.4;

/// `level`, Pa, or what lies above the pressure that the driving step makes at the wall, if that is more.
#[must_use]
pub fn above_step(level: f64, driving_pressure: f64) -> f64 {
    level.max(REFLECTED * driving_pressure)
}

/// Loading time, s, from `rise` to `fall` (Pa; a rise above the fall counts as the fall); none where the pressure never
/// exceeds `fall`. The end of the record ends a load that still lasts.
#[must_use]
pub fn loading_time(time: &[f64], pressure: &[f64], rise: f64, fall: f64) -> Option<f64> {
    let rise = rise.min(fall);
    let loaded = |k: &usize| pressure[*k] >= fall;
    let first = (0..pressure.len()).find(loaded)?;
    let last = (0..pressure.len()).rev().find(loaded)?;
    let passed = |k: usize, level: f64| {
        crossing(
            [time[k], pressure[k]],
            [time[k + 1], pressure[k + 1]],
            level,
        )
    };
    let below = (0..first).rev().find(|k| pressure[*k] < rise);
    let begin = below.map_or(time[0], |k| passed(k, rise));
    let end = if last + 1 < pressure.len() {
        passed(last, fall)
    } else {
        time[last]
    };
    Some(end - begin)
}

/// Material time, s: `depth` of the plastic zone in m, `sound_speed` in m/s.
#[must_use]
pub fn material_time(depth: f64, sound_speed: f64) -> f64 {
    depth / sound_speed
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_triangle_of_load_has_the_time_between_its_crossings() {
        // Up to 1 GPa in 10 ns, down in 20 ns: 100 MPa at 1 ns, 508 MPa on the way down at 19.84 ns.
        let time = [0.0, 10e-9, 30e-9, 40e-9];
        let pressure = [0.0, 1e9, 0.0, 0.0];
        let found = loading_time(&time, &pressure, RISE, FALL).unwrap();
        assert!((found - (19.84e-9 - 1e-9)).abs() < 1e-15, "{found}");
    }

    #[test]
    fn two_peaks_count_from_the_first_rise_to_the_last_fall() {
        let time: Vec<f64> = (0..7).map(f64::from).collect();
        let pressure = [0.0, 1e9, 0.0, 1e9, 0.0, 4e8, 0.0];
        let found = loading_time(&time, &pressure, RISE, FALL).unwrap();
        assert!((found - (3.0 + 0.492 - 0.1)).abs() < 1e-12, "{found}");
    }

    /// A driving step of 75 MPa presses with 150 MPa on the wall for long before the shock of the collapse arrives.
    #[test]
    fn the_driving_step_is_no_load() {
        let time: Vec<f64> = (0..9).map(f64::from).collect();
        let pressure = [0.0, 1.5e8, 1.5e8, 1.5e8, 1.5e8, 1e9, 0.0, 0.0, 0.0];
        let rise = above_step(RISE, 75e6);
        let found = loading_time(&time, &pressure, rise, FALL).unwrap();
        // From 180 MPa between rows 4 and 5 to 508 MPa between rows 5 and 6.
        let exact = 5.492 - (4.0 + 0.3e8 / 8.5e8);
        assert!((found - exact).abs() < 1e-12, "{found}");
        assert_eq!(above_step(RISE, 25e6), RISE);
    }

    #[test]
    fn an_earlier_pulse_that_never_reached_the_yield_stress_is_no_load() {
        let time: Vec<f64> = (0..6).map(f64::from).collect();
        let pressure = [0.0, 3e8, 0.0, 0.0, 1e9, 0.0];
        let found = loading_time(&time, &pressure, RISE, FALL).unwrap();
        assert!((found - (4.492 - 3.1)).abs() < 1e-12, "{found}");
    }

    #[test]
    fn a_load_below_the_yield_stress_is_none() {
        assert_eq!(
            loading_time(&[0.0, 1.0, 2.0], &[0.0, 5e8, 0.0], RISE, FALL),
            None
        );
        assert_eq!(loading_time(&[], &[], RISE, FALL), None);
    }

    #[test]
    fn a_load_at_the_end_of_the_record_lasts_until_there() {
        let found = loading_time(&[0.0, 1.0, 2.0], &[0.0, 1e9, 9e8], RISE, FALL).unwrap();
        assert!((found - 1.9).abs() < 1e-12);
    }

    #[test]
    fn fifty_micrometres_of_steel_answer_in_ten_nanoseconds() {
        assert!((material_time(50e-6, 5000.0) - 10e-9).abs() < 1e-20);
    }
}
