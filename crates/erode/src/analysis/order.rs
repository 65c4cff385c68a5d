//! How a value depends on another: power laws, and the order of convergence with an error bar.

/// Exponent and factor of y = factor x^exponent through positive points by least squares in logarithms; none for fewer
/// than two points.
#[must_use]
pub fn power_law(points: &[[f64; 2]]) -> Option<[f64; 2]> {
    let logs: Vec<[f64; 2]> = points
        .iter()
        .filter(|p| p[0] > 0.0 && p[1] > 0.0)
        .map(|p| p.map(f64::ln))
        .collect();
    if logs.len() < 2 {
        return None;
    }
    let n = logs.len() as f64;
    let mean = |k: usize| logs.iter().map(|p| p[k]).sum::<f64>() / n;
    let (mx, my) = (mean(0), mean(1));
    let xy: f64 = logs.iter().map(|p| (p[0] - mx) * (p[1] - my)).sum();
    let xx: f64 = logs.iter().map(|p| (p[0] - mx) * (p[0] - mx)).sum();
    let exponent = xy / xx;
    exponent
        .is_finite()
        .then(|| [exponent, (my - exponent * mx).exp()])
}

/// A value at spacing zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extrapolated {
    /// Observed order of convergence.
    pub order: f64,
    /// Value at spacing zero (Richardson).
    pub value: f64,
    /// Error bar of the value at the finest spacing: 1.25 times its distance from that (grid convergence index, Roache
    /// 1994).
    pub error: f64,
}

/// From values at three spacings (spacing, value), finest first, in any ratio; none where they do not converge in one
/// direction.
#[must_use]
pub fn extrapolate([fine, middle, coarse]: [[f64; 2]; 3]) -> Option<Extrapolated> {
    let ratio = (coarse[1] - middle[1]) / (middle[1] - fine[1]);
    if !(ratio.is_finite() && ratio > 0.0) {
        return None;
    }
    // (h3^p - h2^p)/(h2^p - h1^p) grows with p.
    let of = |p: f64| {
        let h = [fine[0], middle[0], coarse[0]].map(|h| (h / fine[0]).powf(p));
        (h[2] - h[1]) / (h[1] - h[0])
    };
    let (mut low, mut high) = (1e-3, 12.0);
    if !(of(low)..=of(high)).contains(&ratio) {
        return None;
    }
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if of(middle) < ratio {
            low = middle;
        } else {
            high = middle;
        }
    }
    let order = 0.5 * (low + high);
    let rest = (fine[1] - middle[1]) / ((middle[0] / fine[0]).powf(order) - 1.0);
    Some(Extrapolated {
        order,
        value: fine[1] + rest,
        error: 1.25 * rest.abs(),
    })
}

/// Orders that an error bar may rest on: below, the extrapolation runs away; above the formal order of two, and some scatter, it
/// is an accident of three values.
const PLAUSIBLE: std::ops::RangeInclusive<f64> = 0.5..=3.0;

/// Error bar of the finest of at least three values (spacing, value), finest first: that of [`extrapolate`] with a plausible order,
/// otherwise three times the range of the values (the safety factor of Eca and Hoekstra 2014 for data without a plausible order).
/// None from fewer values.
#[must_use]
pub fn error_bar(known: &[[f64; 2]]) -> Option<f64> {
    let three = <[[f64; 2]; 3]>::try_from(known.get(..3)?).ok()?;
    if let Some(found) = extrapolate(three)
        && PLAUSIBLE.contains(&found.order)
    {
        return Some(found.error);
    }
    let range = (three.iter().map(|p| p[1]))
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], v| {
            [l.min(v), h.max(v)]
        });
    Some(3.0 * (range[1] - range[0]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_without_an_order_get_three_times_their_range() {
        let smooth = [1.0, 1.5, 2.0].map(|h: f64| [h, 3.0 + h * h]);
        let bar = error_bar(&smooth).unwrap();
        assert!((bar - 1.25).abs() < 1e-9, "{bar}");
        assert_eq!(error_bar(&[[1.0, 5.0], [2.0, 6.0], [3.0, 5.5]]), Some(3.0));
        // Differences that hardly shrink: the extrapolation would be far away.
        let slow = [[1.0, 5.0], [2.0, 6.0], [4.0, 7.1]];
        assert!(extrapolate(slow).unwrap().order < 0.5);
        assert!((error_bar(&slow).unwrap() - 6.3).abs() < 1e-12);
        assert_eq!(error_bar(&slow[..2]), None);
    }

    #[test]
    fn the_cube_of_the_radius() {
        let points = [1.0, 1.5, 2.0].map(|x: f64| [x, 7.0 * x.powi(3)]);
        let [exponent, factor] = power_law(&points).unwrap();
        assert!((exponent - 3.0).abs() < 1e-12 && (factor - 7.0).abs() < 1e-11);
        assert_eq!(power_law(&points[..1]), None);
    }

    #[test]
    fn order_and_limit_of_a_known_series() {
        let value = |h: f64| 5.0 + 3.0 * h.powf(1.7);
        let series = [1.0, 2.0, 3.0].map(|h: f64| [h, value(h)]);
        let found = extrapolate(series).unwrap();
        assert!(
            (found.order - 1.7).abs() < 1e-9 && (found.value - 5.0).abs() < 1e-9,
            "{found:?}"
        );
        assert!((found.error - 1.25 * 3.0).abs() < 1e-8);
        let wobbling = [[1.0, 1.0], [2.0, 2.0], [4.0, 1.5]];
        assert_eq!(extrapolate(wobbling), None);
    }
}
