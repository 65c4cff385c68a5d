//! Bubbles at rest, and the pressure below which they grow without bound.
//!
//! Equilibrium: p_g0 = p + 2 sigma/R0 - p_v      (text of section 4.1 of Peters and el Moctar 2020, not stated there)
//!
//! Blake threshold of a gas (p_g0, R0, k): the lowest pressure with an equilibrium,
//! p_B = p_v - (2 sigma/R_c) (1 - 1/(3 k)),  R_c^(3 k - 1) = 3 k p_g0 R0^(3 k)/(2 sigma)
//! (Blake 1949 for k = 1; Brennen 1995, section 2.5.) Smaller than R_c is stable, larger is not. Without surface
//! tension R_c is infinite and p_B = p_v; without gas there is no stable equilibrium. Units: Pa, m.

use super::error::{BubbleError, positive};
use super::{Gas, Liquid};

/// Content of gas with which a bubble of radius `radius` rests at a pressure, Pa.
///
/// # Errors
/// [`BubbleError::OutOfRange`] for a bad radius, exponent or liquid; [`BubbleError::NoEquilibriumOfRadius`] if the
/// pressure is not above the Blake threshold of the bubble for which `radius` is critical.
pub fn equilibrium_gas(
    liquid: &Liquid,
    radius: f64,
    pressure: f64,
    polytropic_exponent: f64,
) -> Result<Gas, BubbleError> {
    liquid.check()?;
    let probe = Gas {
        pressure: 0.0,
        radius,
        polytropic_exponent,
    };
    probe.check()?;
    positive("size of pressure", "Pa", pressure.abs(), true)?;
    let capillary = 2.0 * liquid.surface_tension / radius;
    let threshold = liquid.vapour_pressure - capillary * (1.0 - 1.0 / (3.0 * polytropic_exponent));
    if pressure <= threshold {
        return Err(BubbleError::NoEquilibriumOfRadius {
            radius,
            pressure,
            threshold,
        });
    }
    Ok(Gas {
        pressure: pressure + capillary - liquid.vapour_pressure,
        ..probe
    })
}

/// Radius above which a bubble with this gas is unstable, m; infinite without surface tension.
#[must_use]
pub fn critical_radius(liquid: &Liquid, gas: &Gas) -> f64 {
    let three_k = 3.0 * gas.polytropic_exponent;
    let ratio = three_k * gas.pressure * gas.radius / (2.0 * liquid.surface_tension);
    gas.radius * ratio.powf(1.0 / (three_k - 1.0))
}

/// Blake threshold of a bubble with this gas, Pa.
#[must_use]
pub fn blake_pressure(liquid: &Liquid, gas: &Gas) -> f64 {
    let capillary = 2.0 * liquid.surface_tension / critical_radius(liquid, gas);
    liquid.vapour_pressure - capillary * (1.0 - 1.0 / (3.0 * gas.polytropic_exponent))
}

/// Radius at which a bubble with this gas rests stably at a pressure, Pa.
///
/// # Errors
/// [`BubbleError::OutOfRange`] for bad data; [`BubbleError::NoEquilibriumOfGas`] with the Blake threshold.
pub fn equilibrium_radius(liquid: &Liquid, gas: &Gas, pressure: f64) -> Result<f64, BubbleError> {
    liquid.check()?;
    gas.check()?;
    positive(
        "gas_pressure of a bubble at rest",
        "Pa",
        gas.pressure,
        false,
    )?;
    let threshold = blake_pressure(liquid, gas);
    let critical = critical_radius(liquid, gas);
    if pressure <= threshold {
        return Err(BubbleError::NoEquilibriumOfGas {
            pressure,
            threshold,
            critical_radius: critical,
        });
    }
    let excess = |radius: f64| {
        liquid.vapour_pressure + gas.pressure_at(radius)
            - 2.0 * liquid.surface_tension / radius
            - pressure
    };
    // The excess falls from plus infinity to its minimum at the critical radius: bracket the only root below it.
    let mut high = critical.min(gas.radius);
    while excess(high) > 0.0 {
        high = (2.0 * high).min(critical);
    }
    let mut low = high;
    while excess(low) <= 0.0 {
        low *= 0.5;
    }
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return Ok(middle);
        }
        if excess(middle) > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_gas_of_the_acoustic_case() {
        let gas = equilibrium_gas(&Liquid::WATER, 8e-6, 1e5, 4.0 / 3.0).unwrap();
        // 1e5 + 2 * 0.0725/8e-6 - 2337; bubble pressure 118125 Pa in reference/bubble-acoustic.
        assert!((gas.pressure - (118_125.0 - 2337.0)).abs() < 1e-9);
        let radius = equilibrium_radius(&Liquid::WATER, &gas, 1e5).unwrap();
        assert!((radius / 8e-6 - 1.0).abs() < 1e-14);
    }

    #[test]
    fn the_threshold_separates_rest_from_growth() {
        for k in [1.0, 1.25, 1.4] {
            let gas = equilibrium_gas(&Liquid::WATER, 3e-6, 1e5, k).unwrap();
            let threshold = blake_pressure(&Liquid::WATER, &gas);
            assert!(threshold < Liquid::WATER.vapour_pressure);
            let just_above = threshold + 1e-6 * threshold.abs();
            let radius = equilibrium_radius(&Liquid::WATER, &gas, just_above).unwrap();
            let critical = critical_radius(&Liquid::WATER, &gas);
            assert!(radius < critical && radius > 0.99 * critical);
            let error = equilibrium_radius(&Liquid::WATER, &gas, threshold).unwrap_err();
            assert!(error.to_string().contains("Blake threshold"), "{error}");
            // A bubble made at its critical radius is refused with the same threshold.
            let made = equilibrium_gas(&Liquid::WATER, critical, threshold, k).unwrap_err();
            let BubbleError::NoEquilibriumOfRadius {
                threshold: told, ..
            } = made
            else {
                panic!("{made}");
            };
            assert!((told - threshold).abs() < 1e-9 * threshold.abs());
        }
    }

    #[test]
    fn blake_1949_for_an_isothermal_bubble() {
        let gas = equilibrium_gas(&Liquid::WATER, 1e-6, 1e5, 1.0).unwrap();
        let s = 0.0725;
        let critical = (3.0 * gas.pressure * 1e-18 / (2.0 * s)).sqrt();
        assert!((critical_radius(&Liquid::WATER, &gas) / critical - 1.0).abs() < 1e-12);
        let blake = 2337.0 - 4.0 * s / (3.0 * critical);
        assert!((blake_pressure(&Liquid::WATER, &gas) - blake).abs() < 1e-9 * blake.abs());
    }

    #[test]
    fn no_surface_tension_no_critical_radius() {
        let liquid = Liquid {
            surface_tension: 0.0,
            ..Liquid::WATER
        };
        let gas = equilibrium_gas(&liquid, 1e-5, 1e5, 1.4).unwrap();
        assert!(critical_radius(&liquid, &gas).is_infinite());
        assert!((blake_pressure(&liquid, &gas) - 2337.0).abs() < 1e-12);
        let radius = equilibrium_radius(&liquid, &gas, 5e3).unwrap();
        assert!(radius > 1e-5 && radius.is_finite());
    }

    #[test]
    fn negative_radius_is_named() {
        let error = equilibrium_gas(&Liquid::WATER, -1e-6, 1e5, 1.4).unwrap_err();
        assert!(
            error.to_string().starts_with("radius is -1e-6 m"),
            "{error}"
        );
    }
}
