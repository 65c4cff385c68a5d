//! Numbers for people.

/// Value with unit and prefix: 1.5e-4 m as "0.15 mm" or "150 um".
pub(crate) fn si(value: f64, unit: &str) -> String {
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
pub(crate) fn significant(x: f64) -> String {
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

/// A count with thin groups of three: 12 345.
pub(crate) fn count(x: f64) -> String {
    if x >= 1e12 {
        return format!("{x:.2e}");
    }
    let digits = format!("{x:.0}");
    let mut out = String::new();
    for (i, c) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            out.push(' ');
        }
        out.push(c);
    }
    out
}

/// A duration: about 35 s, 4.2 min, 3.1 h, 2.0 days.
pub(crate) fn duration(seconds: f64) -> String {
    match seconds {
        s if s < 1.0 => "less than 1 s".to_owned(),
        s if s < 100.0 => format!("about {s:.0} s"),
        s if s < 6000.0 => format!("about {:.1} min", s / 60.0),
        s if s < 172_800.0 => format!("about {:.1} h", s / 3600.0),
        s => format!("about {:.1} days", s / 86_400.0),
    }
}

/// Lines of columns, each as wide as its widest cell.
pub(crate) fn columns(rows: &[Vec<String>]) -> Vec<String> {
    let number = rows.iter().map(Vec::len).max().unwrap_or(0);
    let width = |k: usize| {
        rows.iter()
            .filter_map(|r| r.get(k))
            .map(|c| c.chars().count())
            .max()
            .unwrap_or(0)
    };
    let widths: Vec<usize> = (0..number).map(width).collect();
    let line = |row: &Vec<String>| {
        let cells = row
            .iter()
            .zip(&widths)
            .map(|(cell, w)| format!("{cell:<w$}"));
        cells.collect::<Vec<_>>().join("  ").trim_end().to_owned()
    };
    rows.iter().map(line).collect()
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
        assert_eq!(count(1_234_567.0), "1 234 567");
        assert_eq!(duration(252.0), "about 4.2 min");
    }
}
