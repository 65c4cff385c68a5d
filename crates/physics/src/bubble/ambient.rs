//! What a bubble sees of the liquid around it, as values and as functions of time.

use std::f64::consts::TAU;

/// Values of the liquid at the bubble at one instant, as if the bubble were not there.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Ambient {
    /// Pressure, Pa.
    pub pressure: f64,
    /// Its rate along the path of the bubble, Pa/s.
    pub pressure_rate: f64,
    /// Square of the velocity of the liquid relative to the bubble, m2/s2. The mean pressure on the bubble's surface is
    /// lower than [`Self::pressure`] by density * slip / 4 (Peters and el Moctar 2020, eq. 3.36).
    pub slip_squared: f64,
    /// Its rate, m2/s3.
    pub slip_squared_rate: f64,
}

impl Ambient {
    /// Mean pressure on a sphere that slips through liquid of a density (kg/m3), Pa.
    #[must_use]
    #[inline]
    pub fn mean_pressure(&self, density: f64) -> f64 {
        self.pressure - 0.25 * density * self.slip_squared
    }

    /// Rate of [`Self::mean_pressure`], Pa/s.
    #[must_use]
    #[inline]
    pub fn mean_pressure_rate(&self, density: f64) -> f64 {
        self.pressure_rate - 0.25 * density * self.slip_squared_rate
    }
}

/// The surroundings of a bubble as a function of time; smooth within an interval handed to the integrator.
pub trait Driving {
    /// Values at a time, s.
    fn at(&self, time: f64) -> Ambient;
}

impl<F: Fn(f64) -> Ambient> Driving for F {
    fn at(&self, time: f64) -> Ambient {
        self(time)
    }
}

/// Nothing changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constant {
    /// Pressure, Pa.
    pub pressure: f64,
}

impl Driving for Constant {
    fn at(&self, _time: f64) -> Ambient {
        Ambient {
            pressure: self.pressure,
            ..Ambient::default()
        }
    }
}

/// p = mean - amplitude sin(2 pi frequency t), Pa (Peters and el Moctar 2020, section 4.1: growth comes first).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sine {
    /// Mean pressure, Pa.
    pub mean: f64,
    /// Amplitude, Pa.
    pub amplitude: f64,
    /// Frequency, Hz.
    pub frequency: f64,
}

impl Driving for Sine {
    fn at(&self, time: f64) -> Ambient {
        let omega = TAU * self.frequency;
        let (sin, cos) = (omega * time).sin_cos();
        Ambient {
            pressure: self.mean - self.amplitude * sin,
            pressure_rate: -self.amplitude * omega * cos,
            ..Ambient::default()
        }
    }
}

/// Straight lines between the values at the two ends of a step of a carrier. Rates are those of the lines, so that
/// pressure and rate fit each other; the rates in `start` and `end` are not used.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Linear {
    /// Start of the step, s.
    pub start_time: f64,
    /// End of the step, s; after the start.
    pub end_time: f64,
    /// Values at the start.
    pub start: Ambient,
    /// Values at the end.
    pub end: Ambient,
}

impl Driving for Linear {
    fn at(&self, time: f64) -> Ambient {
        let length = self.end_time - self.start_time;
        let x = (time - self.start_time) / length;
        let pressure = self.end.pressure - self.start.pressure;
        let slip = self.end.slip_squared - self.start.slip_squared;
        Ambient {
            pressure: self.start.pressure + x * pressure,
            pressure_rate: pressure / length,
            slip_squared: self.start.slip_squared + x * slip,
            slip_squared_rate: slip / length,
        }
    }
}
