//! Numbers of checks as text.

use super::check::{Check, Kind};

/// Four significant digits.
pub(super) fn value(x: f64) -> String {
    if x == 0.0 {
        "0".into()
    } else if !x.is_finite() {
        "none".into()
    } else if (1e-2..1e5).contains(&x.abs()) {
        let decimals = 3 - x.abs().log10().floor() as i32;
        format!("{x:.*}", decimals.max(0) as usize)
    } else {
        format!("{x:.3e}")
    }
}

/// What the value should be.
pub(super) fn reference(c: &Check) -> String {
    let bound = match c.kind {
        Kind::AtLeast => ">= ",
        Kind::MoreThan => "> ",
        _ => "",
    };
    c.reference
        .map_or_else(|| "-".into(), |r| format!("{bound}{}", value(r)))
}

/// Relative errors in percent, others in the unit of the quantity.
pub(super) fn error(c: &Check) -> String {
    let Some(e) = c.error else { return "-".into() };
    match c.kind {
        Kind::Relative | Kind::Shown => percent(e, true),
        Kind::Absolute | Kind::AtLeast | Kind::MoreThan | Kind::NoData => value(e),
    }
}

/// The tolerance in the unit of the error.
pub(super) fn tolerance(c: &Check) -> String {
    match (c.tolerance, c.kind) {
        (Some(t), Kind::Relative) => percent(t, false),
        (Some(t), _) => value(t),
        (None, _) => "-".into(),
    }
}

fn percent(x: f64, signed: bool) -> String {
    let p = 100.0 * x;
    if !p.is_finite() {
        return "none".into();
    }
    match (p.abs() < 1e-2 && p != 0.0, signed) {
        (true, true) => format!("{p:+.1e} %"),
        (true, false) => format!("{p:.0e} %"),
        (false, true) => format!("{p:+.2} %"),
        (false, false) => format!("{p} %"),
    }
}

/// pass, MISS, NO DATA, or shown.
pub(super) fn verdict(c: &Check) -> &'static str {
    match (c.passed, c.kind) {
        (_, Kind::Shown) => "shown",
        (_, Kind::NoData) => "NO DATA",
        (true, _) => "pass",
        (false, _) => "MISS",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_four_digits() {
        let shown: Vec<String> = [2.834_549e-7, 0.500_04, 5666.21, 0.0, f64::NAN, -12.0]
            .map(value)
            .into();
        assert_eq!(shown, ["2.835e-7", "0.5000", "5666", "0", "none", "-12.00"]);
        let check = Check::relative("t", "s", (1.0123, 1.0), 0.02, "");
        assert_eq!(
            (error(&check), tolerance(&check)),
            ("+1.23 %".into(), "2 %".into())
        );
        let check = Check::relative("t", "s", (1.0 + 2e-9, 1.0), 1e-6, "");
        assert_eq!(
            (error(&check), tolerance(&check)),
            ("+2.0e-7 %".into(), "1e-4 %".into())
        );
    }
}
