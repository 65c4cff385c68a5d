//! Fewer points for long curves, without losing a peak.

/// A curve with at most four points per pixel column: first, lowest, highest and last, so that no peak is lost.
pub(crate) fn thinned(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut kept: Vec<[f64; 2]> = Vec::new();
    let column = |p: &[f64; 2]| {
        if p[0].is_finite() && p[1].is_finite() {
            p[0].floor()
        } else {
            f64::NAN
        }
    };
    for group in points.chunk_by(|a, b| column(a) == column(b)) {
        if group.len() <= 4 {
            kept.extend_from_slice(group);
            continue;
        }
        let by_height = |a: &usize, b: &usize| group[*a][1].total_cmp(&group[*b][1]);
        let lowest = (0..group.len()).min_by(by_height).unwrap_or(0);
        let highest = (0..group.len()).max_by(by_height).unwrap_or(0);
        let mut chosen = vec![0, lowest, highest, group.len() - 1];
        chosen.sort_unstable();
        chosen.dedup();
        kept.extend(chosen.into_iter().map(|k| group[k]));
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thinning_keeps_peaks_and_gaps() {
        let mut points: Vec<[f64; 2]> = (0..10_000).map(|k| [k as f64 * 0.01, 1.0]).collect();
        points[5003][1] = 99.0;
        points[7000][1] = f64::NAN;
        let thin = thinned(&points);
        assert!(thin.len() < 500, "{}", thin.len());
        assert!(thin.iter().any(|p| p[1] == 99.0));
        assert!(thin.iter().any(|p| p[1].is_nan()));
        assert_eq!(thin.first(), points.first());
        assert_eq!(thin.last(), points.last());
    }
}
