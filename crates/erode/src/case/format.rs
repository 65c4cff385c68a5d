//! Numbers for people.

/// Value with unit and prefix: 1.5e-4 m as "0.15 mm" or "150 um".
#[must_use]
pub fn si(value: f64, unit: &str) -> String {
    const PREFIXES: [(f64, &str); 8] = [
        (1e9, "G"),
        (1e6, "M"),
        (1e3, "k"),
        (1.0, ""),
        (1e-3, "m"),
        (1e-6, "u"),
        (1e-9, "n"),
        (1e-12, "p"),
    ];
    let size = value.abs();
    let (scale, prefix) = PREFIXES
        .into_iter()
        .find(|(s, _)| size >= *s * 0.999_999)
        .unwrap_or((1.0, ""));
    format!("{} {prefix}{unit}", significant(value / scale))
}

/// At most four significant digits, without trailing zeros.
#[must_use]
pub fn significant(x: f64) -> String {
    if x == 0.0 || !x.is_finite() {
        return format!("{x}");
    }
    if !(1e-4..1e7).contains(&x.abs()) {
        return format!("{x:.3e}");
    }
    let digits = [1.0, 10.0, 100.0, 1000.0]
        .iter()
        .filter(|s| x.abs() >= **s)
        .count();
    let decimals = if x.abs() < 1.0 { 5 } else { 4 - digits };
    let text = format!("{x:.decimals$}");
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_right() {
        assert_eq!(si(1.5e-4, "m"), "150 um");
        assert_eq!(si(50e6, "Pa"), "50 MPa");
        assert_eq!(si(0.0, "Pa"), "0 Pa");
        assert_eq!(si(-1e-3, "m"), "-1 mm");
        assert_eq!(significant(1.33), "1.33");
        assert_eq!(significant(0.05), "0.05");
        assert_eq!(significant(1234.5), "1234");
        assert_eq!(si(3.000_000_000_000_000_3e-4, "m"), "300 um");
    }
}
