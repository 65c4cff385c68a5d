//! Uniaxial loading of a Johnson-Cook material at a constant rate, with the plastic strain as independent variable.
//!
//! q = k strain - m e, k = 2G, m = 3G in uniaxial strain; k = m = E in uniaxial stress.
//! At first Y is so steep that the plastic rate stays below the reference rate r0: q = Y(e) theta(T), Y = A + B e^n,
//! theta = 1 - T*^m, d strain/de = (m + dq/de)/k. From where that rate reaches r0
//!
//! d strain/de = rate/(r0 exp((q/(Y theta) - 1)/C)),  dT/de = chi q/(rho c),
//!
//! integrated over s = ln e with the classical Runge-Kutta method: nothing of the return mapping (steps of time, a
//! scalar equation per step) is used. e stays the variable as it grows from 0 in an infinitely steep Y. Units: SI.

use erode_physics::material_point::Material;
use erode_physics::strength::JohnsonCook;

/// State at one axial strain; stresses as sizes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scalar {
    pub(super) stress: f64,
    pub(super) von_mises: f64,
    pub(super) plastic_strain: f64,
    pub(super) temperature: f64,
}

/// Axial strain and temperature as functions of e.
type Pair = [f64; 2];

/// A path of loading.
pub(super) struct Loading {
    law: JohnsonCook,
    rate: f64,
    k: f64,
    m: f64,
    /// Axial stress per strain beside the part of q: the bulk modulus in uniaxial strain, none in uniaxial stress.
    bulk: f64,
    heat_per_volume: f64,
    start_temperature: f64,
}

/// Step in ln e, a twentieth of the length C Y/(k e) over which the rate adapts at the end of the paths.
const STEP: f64 = 1e-4;

/// The integration starts here, on the quasi-static curve: r0 is reached later at all rates below 1e6 1/s.
const SMALLEST: f64 = 1e-16;

impl Loading {
    pub(super) fn new(material: &Material, law: JohnsonCook, stress: bool, rate: f64) -> Self {
        let (e, g) = (
            material.elastic.young_modulus,
            material.elastic.shear_modulus(),
        );
        let (k, m, bulk) = if stress {
            (e, e, 0.0)
        } else {
            (2.0 * g, 3.0 * g, material.elastic.bulk_modulus())
        };
        Self {
            law,
            rate,
            k,
            m,
            bulk,
            heat_per_volume: law.thermal.map_or(0.0, |t| {
                t.taylor_quinney / (material.density * t.heat_capacity)
            }),
            start_temperature: material.temperature,
        }
    }

    /// States at axial strains, which ascend from beyond first yield.
    pub(super) fn at(&self, strains: &[f64]) -> Vec<Scalar> {
        let mut s = SMALLEST.ln();
        let (hard, ..) = self.strength(SMALLEST, self.start_temperature);
        let mut y = [(hard + self.m * SMALLEST) / self.k, self.start_temperature];
        let mut found = Vec::new();
        while found.len() < strains.len() {
            let target = strains[found.len()];
            let next = self.step(s, y, STEP);
            if next[0] < target {
                (s, y) = (s + STEP, next);
                continue;
            }
            let (mut low, mut high) = (0.0, STEP);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if self.step(s, y, middle)[0] < target {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            let temperature = self.step(s, y, low)[1];
            found.push(self.state((s + low).exp(), target, temperature));
        }
        found
    }

    fn state(&self, e: f64, strain: f64, temperature: f64) -> Scalar {
        let q = self.k * strain - self.m * e;
        Scalar {
            stress: self.bulk * strain + q * if self.bulk > 0.0 { 2.0 / 3.0 } else { 1.0 },
            von_mises: q,
            plastic_strain: e,
            temperature,
        }
    }

    /// Runge-Kutta step of length `d` in ln e.
    fn step(&self, s: f64, y: Pair, d: f64) -> Pair {
        let along = |y: Pair, k: Pair, d: f64| [y[0] + d * k[0], y[1] + d * k[1]];
        let k1 = self.slope(s, y);
        let k2 = self.slope(s + 0.5 * d, along(y, k1, 0.5 * d));
        let k3 = self.slope(s + 0.5 * d, along(y, k2, 0.5 * d));
        let k4 = self.slope(s + d, along(y, k3, d));
        [0, 1].map(|i| y[i] + d / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]))
    }

    /// d(strain, T)/d ln e.
    fn slope(&self, s: f64, [strain, temperature]: Pair) -> Pair {
        let e = s.exp();
        let (hard, theta, cooling) = self.strength(e, temperature);
        let q = self.k * strain - self.m * e;
        let heating = self.heat_per_volume * q;
        // On the quasi-static curve q = Y theta: dq/de = theta dY/de + Y dtheta/dT dT/de.
        let hardening = self.law.b * self.law.n * e.powf(self.law.n - 1.0);
        let static_slope = (self.m + theta * hardening + hard * cooling * heating) / self.k;
        if self.law.c == 0.0 || static_slope * self.law.reference_rate >= self.rate {
            return [e * static_slope, e * heating];
        }
        let overstress = (q / (hard * theta) - 1.0) / self.law.c;
        let plastic_rate = self.law.reference_rate * overstress.exp();
        [e * self.rate / plastic_rate, e * heating]
    }

    /// Y, theta and dtheta/dT.
    fn strength(&self, e: f64, temperature: f64) -> (f64, f64, f64) {
        let hard = self.law.a + self.law.b * e.powf(self.law.n);
        let Some(t) = self.law.thermal else {
            return (hard, 1.0, 0.0);
        };
        let range = t.melting_temperature - t.reference_temperature;
        let x = ((temperature - t.reference_temperature) / range).max(0.0);
        (hard, 1.0 - x.powf(t.m), -t.m * x.powf(t.m - 1.0) / range)
    }
}
