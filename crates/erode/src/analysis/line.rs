//! Between two points of a curve.

/// Where the straight line from `a` to `b`, each (x, y), passes y = `level`; not a number where one of them is none.
#[must_use]
pub fn crossing(a: [f64; 2], b: [f64; 2], level: f64) -> f64 {
    a[0] + (level - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_crossed_where_it_should_be() {
        assert_eq!(crossing([1.0, 10.0], [3.0, 30.0], 15.0), 1.5);
        assert_eq!(crossing([3.0, 30.0], [1.0, 10.0], 15.0), 1.5);
        assert!(crossing([1.0, f64::NAN], [3.0, 30.0], 15.0).is_nan());
    }
}
