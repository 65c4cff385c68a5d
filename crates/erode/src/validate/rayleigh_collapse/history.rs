//! Radius, speed and shape of a simulated cavity at given radii.

/// One instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Sample {
    /// s.
    pub(super) time: f64,
    /// Mean radius by volume, R/R0.
    pub(super) radius: f64,
    /// (largest - smallest radius)/mean.
    pub(super) roundness: f64,
    /// Kinetic and compression energy, J.
    pub(super) energy: f64,
    /// Dissipated less the work of the far field, J.
    pub(super) balance: f64,
}

/// Half of the range of radii from which a speed is read, relative to the radius.
const HALF_RANGE: f64 = 0.06;

/// d(R^(5/2))/dt (1/s) by least squares within [`HALF_RANGE`] of a radius; late in a collapse R^(5/2) is linear in time.
fn slope(samples: &[Sample], radius: f64) -> Option<f64> {
    let near = |s: &&Sample| (s.radius / radius - 1.0).abs() <= HALF_RANGE;
    let powers = samples
        .iter()
        .filter(near)
        .map(|s| (s.time, s.radius.powf(2.5)));
    let points: Vec<(f64, f64)> = powers.collect();
    if points.len() < 3 {
        return None;
    }
    let n = points.len() as f64;
    let time = points.iter().map(|p| p.0).sum::<f64>() / n;
    let power = points.iter().map(|p| p.1).sum::<f64>() / n;
    let (mut xx, mut xy) = (0.0, 0.0);
    for (t, y) in &points {
        xx += (t - time).powi(2);
        xy += (t - time) * (y - power);
    }
    Some(xy / xx)
}

/// Time at which the radius is first reached, s: linear between samples.
pub(super) fn time_at(samples: &[Sample], radius: f64) -> Option<f64> {
    let k = samples
        .windows(2)
        .position(|w| w[0].radius > radius && w[1].radius <= radius)?;
    let (a, b) = (samples[k], samples[k + 1]);
    Some(a.time + (b.time - a.time) * (a.radius - radius) / (a.radius - b.radius))
}

/// Speed of the wall inwards at a radius in units of R0, R0/s.
pub(super) fn speed_at(samples: &[Sample], radius: f64) -> Option<f64> {
    Some(-slope(samples, radius)? / (2.5 * radius.powf(1.5)))
}

/// The first sample at or below a radius.
pub(super) fn sample_at(samples: &[Sample], radius: f64) -> Option<&Sample> {
    samples.iter().find(|s| s.radius <= radius)
}
