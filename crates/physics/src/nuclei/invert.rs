//! Inverse of a distribution function.

/// The x in [low, high] at which the increasing `f` is `target`: Newton's method with the slope `df`, kept in the bracket by
/// bisection. Ends when the bracket or the step is at rounding.
pub(super) fn invert(
    f: impl Fn(f64) -> f64,
    df: impl Fn(f64) -> f64,
    (mut low, mut high): (f64, f64),
    target: f64,
) -> f64 {
    let mut x = 0.5 * (low + high);
    for _ in 0..200 {
        let miss = f(x) - target;
        if miss > 0.0 {
            high = x;
        } else {
            low = x;
        }
        let newton = x - miss / df(x);
        let next = if newton > low && newton < high {
            newton
        } else {
            0.5 * (low + high)
        };
        if (next - x).abs() <= 2.0 * f64::EPSILON * x.abs() {
            return next;
        }
        x = next;
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_a_square_root_from_a_bad_start() {
        let x = invert(|x| x * x, |x| 2.0 * x, (0.0, 1e6), 2.0);
        assert!((x - 2.0f64.sqrt()).abs() < 1e-15);
    }
}
