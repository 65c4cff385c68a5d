//! Random numbers by place: the k-th number of a seed without those before it.
//!
//! SplitMix64 (Steele, Lea, Flood 2014): state s + (k + 1) g, g = 0x9e3779b97f4a7c15, then the finaliser
//! z ^= z >> 30; z *= 0xbf58476d1ce4e5b9; z ^= z >> 27; z *= 0x94d049bb133111eb; z ^= z >> 31.
//! 64-bit integers only, so the stream is the same everywhere. Not for secrets.

use serde::{Deserialize, Serialize};

/// A stream of random numbers with a seed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct Stream {
    /// Seed: any number.
    pub seed: u64,
}

impl Stream {
    /// The number at a place, 64 random bits.
    #[must_use]
    pub fn bits(self, place: u64) -> u64 {
        const STEP: u64 = 0x9e37_79b9_7f4a_7c15;
        let mut z = self
            .seed
            .wrapping_add(STEP.wrapping_mul(place.wrapping_add(1)));
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// The number at a place, uniform between 0 and 1, never 0 nor 1: (k + 1/2)/2^52.
    #[must_use]
    pub fn uniform(self, place: u64) -> f64 {
        ((self.bits(place) >> 12) as f64 + 0.5) / (1u64 << 52) as f64
    }

    /// An independent stream: its seed is the number at a place of this one.
    #[must_use]
    pub fn branch(self, place: u64) -> Self {
        Self {
            seed: self.bits(place),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// First numbers of the published generator for the seed 1234567.
    #[test]
    fn known_answers() {
        let stream = Stream { seed: 1_234_567 };
        let known = [
            6_457_827_717_110_365_317,
            3_203_168_211_198_807_973,
            9_817_491_932_198_370_423,
            4_593_380_528_125_082_431,
            16_408_922_859_458_223_821,
        ];
        for (k, &expected) in known.iter().enumerate() {
            assert_eq!(stream.bits(k as u64), expected);
        }
    }

    /// Mean and variance of a uniform number, within five standard errors.
    #[test]
    fn uniform_is_uniform() {
        let (stream, n) = (Stream { seed: 7 }, 100_000);
        let values = || (0..n).map(|k| stream.uniform(k));
        let mean = values().sum::<f64>() / n as f64;
        let variance = values().map(|u| (u - mean).powi(2)).sum::<f64>() / n as f64;
        let error = (1.0 / 12.0 / n as f64).sqrt();
        assert!((mean - 0.5).abs() < 5.0 * error);
        // Variance of (u - 1/2)^2 is 1/180.
        assert!((variance - 1.0 / 12.0).abs() < 5.0 * (1.0 / 180.0 / n as f64).sqrt());
        assert!(values().all(|u| u > 0.0 && u < 1.0));
    }
}
