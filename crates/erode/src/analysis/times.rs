//! Characteristic times of load and material (Joshi 2018, section 6.4.6).
//!
//! Loading time at a point of the wall: from the first rise of the pressure above 100 MPa until it last falls below the
//! initial yield stress, 508 MPa (figure 6.17). Material time: depth of the plastic zone / sound speed of the solid. Where
//! the material time is the longer one, inertia keeps the metal from yielding. SI units.

/// Pressure at which the load begins, Pa.
pub const RISE: f64 = 100e6;
/// Pressure at which it ends, Pa: initial yield stress of A-2205.
pub const FALL: f64 = 508e6;

/// Loading time, s; none where the pressure never exceeds `fall`. The end of the record ends a load that still lasts.
#[must_use]
pub fn loading_time(time: &[f64], pressure: &[f64], rise: f64, fall: f64) -> Option<f64> {
    let last = (0..pressure.len()).rev().find(|k| pressure[*k] >= fall)?;
    let first = (0..pressure.len()).find(|k| pressure[*k] >= rise)?;
    let begin = match first {
        0 => time[0],
        k => crossing(time, pressure, k - 1, rise),
    };
    let end = if last + 1 < pressure.len() {
        crossing(time, pressure, last, fall)
    } else {
        time[last]
    };
    Some(end - begin)
}

/// When the straight line from row k to the next one passes `level`.
fn crossing(time: &[f64], pressure: &[f64], k: usize, level: f64) -> f64 {
    let part = (level - pressure[k]) / (pressure[k + 1] - pressure[k]);
    time[k] + part * (time[k + 1] - time[k])
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
