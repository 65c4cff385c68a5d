//! Width of the liquid jet that crosses a collapsing bubble.

use super::crossing;

/// Distance from the axis at which the speed of the jet falls to half of that on the axis, m, at the height `level`:
/// `position` (r, z) in m, `speed` towards the wall in m/s, `band` half the height of the slice that is read, m. The
/// speed between particles is that of straight lines; on the axis it is that of the innermost particle. None without
/// particles in the slice, without a jet (no speed towards the wall on the axis), or when the speed does not fall to half.
#[must_use]
pub fn half_width(position: &[[f64; 2]], speed: &[f64], level: f64, band: f64) -> Option<f64> {
    let mut slice: Vec<[f64; 2]> = position
        .iter()
        .zip(speed)
        .filter(|(x, _)| (x[1] - level).abs() <= band)
        .map(|(x, v)| [x[0], *v])
        .collect();
    slice.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let half = Some(0.5 * slice.first()?[1]).filter(|half| *half > 0.0)?;
    let pair = slice.windows(2).find(|p| p[1][1] < half)?;
    Some(crossing(pair[0], pair[1], half))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// v = U exp(-(r/w)^2): half at r = w sqrt(ln 2).
    #[test]
    fn a_gaussian_jet_has_its_half_width() {
        let (u, w, dx) = (900.0, 20e-6, 1e-6);
        let mut position = Vec::new();
        for i in 0..60 {
            for j in -5..=5 {
                position.push([(f64::from(i) + 0.5) * dx, f64::from(j) * dx]);
            }
        }
        let speed: Vec<f64> = position
            .iter()
            .map(|x| u * (-(x[0] / w).powi(2)).exp())
            .collect();
        let found = half_width(&position, &speed, 0.0, 0.6 * dx).unwrap();
        let exact = w * std::f64::consts::LN_2.sqrt();
        // The innermost particle is half a spacing off the axis.
        assert!((found / exact - 1.0).abs() < 2e-3, "{found} {exact}");
    }

    /// Half of a speed away from the wall is larger than the speed itself: no place would be one.
    #[test]
    fn liquid_that_does_not_move_towards_the_wall_is_no_jet() {
        let position = [[1.0, 0.0], [2.0, 0.0], [3.0, 0.0]];
        for speed in [[-5.0, -6.0, -7.0], [0.0, -1.0, -2.0], [f64::NAN, 1.0, 0.0]] {
            assert_eq!(half_width(&position, &speed, 0.0, 0.1), None);
        }
    }

    #[test]
    fn a_uniform_stream_has_none() {
        let position = [[1.0, 0.0], [2.0, 0.0]];
        assert_eq!(half_width(&position, &[5.0, 5.0], 0.0, 0.1), None);
        assert_eq!(half_width(&[], &[], 0.0, 0.1), None);
    }
}
