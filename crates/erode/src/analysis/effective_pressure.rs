//! Effective pressure (Joshi 2018, eq. 6.21): P_eff = (P - sigma_Y0) / (rho (v - c)^2), dimensionless.
//!
//! What exceeds the yield stress, over the inertia of metal that a front faster than sound leaves no time to yield. It has
//! no bound where the front has slowed down to the speed of sound; only its shape along the wall is meant.

/// `pressure` at the front and `yield_stress`, Pa; `density` of the solid, kg/m3; `front_speed` and `sound_speed` of the
/// liquid, m/s. Negative where the pressure is below the yield stress; NaN where the front is not faster than sound.
#[must_use]
pub fn effective_pressure(
    pressure: f64,
    yield_stress: f64,
    density: f64,
    front_speed: f64,
    sound_speed: f64,
) -> f64 {
    if front_speed <= sound_speed {
        return f64::NAN;
    }
    (pressure - yield_stress) / (density * (front_speed - sound_speed).powi(2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_known_point() {
        // (1508 - 508) MPa over 7800 (2500 - 1500)^2 = 7.8 GPa.
        let found = effective_pressure(1508e6, 508e6, 7800.0, 2500.0, 1500.0);
        assert!((found - 1.0 / 7.8).abs() < 1e-12);
        assert!(effective_pressure(4e8, 508e6, 7800.0, 2500.0, 1500.0) < 0.0);
        assert!(effective_pressure(1e9, 508e6, 7800.0, 1500.0, 1500.0).is_nan());
    }

    /// With the front of 6.20 and a pressure that falls as 1/d, the largest value lies off the axis: the finding of 6.4.5.
    #[test]
    fn a_spherical_wave_has_its_largest_effective_pressure_off_the_axis() {
        use crate::analysis::front_speed;
        let (c, height) = (1500.0, 0.09e-3);
        let at = |r: f64| {
            let p = 2e9 * height / r.hypot(height);
            effective_pressure(p, 508e6, 7800.0, front_speed(c, height, r), c)
        };
        let radii: Vec<f64> = (1..80).map(|i| f64::from(i) * 5e-6).collect();
        let best = radii
            .iter()
            .max_by(|a, b| at(**a).total_cmp(&at(**b)))
            .unwrap();
        assert!(*best > 0.1e-3 && at(5e-6) < 0.01 * at(*best), "{best}");
    }
}
