//! One number of a validation beside what it should be.

use serde::Serialize;

/// How a value is judged.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// error = value/reference - 1; |error| at most the tolerance.
    Relative,
    /// error = value - reference in the unit of the quantity; |error| at most the tolerance.
    Absolute,
    /// value at least the reference.
    AtLeast,
    /// value more than the reference.
    MoreThan,
    /// To be judged, but a number that it needs could not be determined: never passed.
    NoData,
    /// Only shown beside its reference (error relative to it), not judged.
    Shown,
}

/// A number with its reference, error and tolerance.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Check {
    /// What was measured.
    pub quantity: String,
    /// Unit, SI; `-` for a pure number.
    pub unit: String,
    /// What the program computes.
    pub value: f64,
    /// What it should be; absent where nothing is known.
    pub reference: Option<f64>,
    /// How it is judged.
    pub kind: Kind,
    /// Difference as `kind` says.
    pub error: Option<f64>,
    /// Largest error; absent where the value is not judged or has only a lower bound.
    pub tolerance: Option<f64>,
    /// Why the tolerance is what it is.
    pub reason_for_tolerance: String,
    /// Whether it was kept; true for values that are only shown.
    pub passed: bool,
}

impl Check {
    fn new(quantity: impl Into<String>, unit: &str, value: f64, kind: Kind) -> Self {
        Self {
            quantity: quantity.into(),
            unit: unit.into(),
            value,
            reference: None,
            kind,
            error: None,
            tolerance: None,
            reason_for_tolerance: String::new(),
            passed: true,
        }
    }

    fn judged(mut self, reference: f64, error: f64, tolerance: f64, reason: &str) -> Self {
        self.reference = Some(reference);
        self.error = Some(error);
        self.tolerance = Some(tolerance);
        self.reason_for_tolerance = reason.into();
        // Not a number is a miss.
        self.passed = error.abs() <= tolerance;
        self
    }

    /// A value with a tolerance relative to its reference.
    #[must_use]
    pub fn relative(
        quantity: impl Into<String>,
        unit: &str,
        (value, reference): (f64, f64),
        tolerance: f64,
        reason: &str,
    ) -> Self {
        let error = value / reference - 1.0;
        Self::new(quantity, unit, value, Kind::Relative).judged(reference, error, tolerance, reason)
    }

    /// A value with a tolerance in its own unit.
    #[must_use]
    pub fn absolute(
        quantity: impl Into<String>,
        unit: &str,
        (value, reference): (f64, f64),
        tolerance: f64,
        reason: &str,
    ) -> Self {
        let error = value - reference;
        Self::new(quantity, unit, value, Kind::Absolute).judged(reference, error, tolerance, reason)
    }

    /// A value that must not be smaller than `least`.
    #[must_use]
    pub fn at_least(
        quantity: impl Into<String>,
        unit: &str,
        value: f64,
        least: f64,
        reason: &str,
    ) -> Self {
        Self {
            reference: Some(least),
            error: Some(value - least),
            reason_for_tolerance: reason.into(),
            passed: value.is_finite() && value >= least,
            ..Self::new(quantity, unit, value, Kind::AtLeast)
        }
    }

    /// A value that must be larger than `bound`.
    #[must_use]
    pub fn more_than(
        quantity: impl Into<String>,
        unit: &str,
        value: f64,
        bound: f64,
        reason: &str,
    ) -> Self {
        Self {
            kind: Kind::MoreThan,
            passed: value.is_finite() && value > bound,
            ..Self::at_least(quantity, unit, value, bound, reason)
        }
    }

    /// The same check, not judged because of what is not known.
    #[must_use]
    pub fn without_data(self, why: &str) -> Self {
        Self {
            kind: Kind::NoData,
            error: None,
            tolerance: None,
            reason_for_tolerance: format!(
                "not judged: {why}; to be judged: {}",
                self.reason_for_tolerance
            ),
            passed: false,
            ..self
        }
    }

    /// Whether it was judged.
    #[must_use]
    pub fn is_judged(&self) -> bool {
        !matches!(self.kind, Kind::Shown | Kind::NoData)
    }

    /// A value that is shown, beside its reference where there is one; `reason` says why it is not judged.
    #[must_use]
    pub fn shown(
        quantity: impl Into<String>,
        unit: &str,
        value: f64,
        reference: Option<f64>,
        reason: &str,
    ) -> Self {
        Self {
            reference,
            error: reference.map(|r| value / r - 1.0),
            reason_for_tolerance: reason.into(),
            ..Self::new(quantity, unit, value, Kind::Shown)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tolerances_are_kept_or_missed() {
        let relative = |value| Check::relative("t", "s", (value, 2.0), 0.02, "").passed;
        assert!(relative(2.039) && relative(1.961) && !relative(2.041) && !relative(1.959));
        let absolute = |value| Check::absolute("a", "m", (value, 0.0), 1e-3, "").passed;
        assert!(absolute(-9e-4) && !absolute(-1.1e-3));
        assert!(!Check::at_least("order", "-", 0.79, 0.8, "").passed);
        assert!(Check::at_least("order", "-", 0.8, 0.8, "").passed);
    }

    #[test]
    fn a_bound_that_must_be_exceeded_is_not_met_by_equality() {
        let more = |value| Check::more_than("ratio", "-", value, 1.0, "").passed;
        assert!(more(1.0 + 1e-12) && !more(1.0) && !more(f64::NAN));
    }

    #[test]
    fn a_check_without_data_is_neither_judged_nor_passed() {
        let check = Check::at_least("ratio", "-", 2.0, 1.0, "so it says");
        assert!(check.passed);
        let check = check.without_data("the metal did not yield");
        assert!(!check.passed && !check.is_judged());
        assert!(
            check
                .reason_for_tolerance
                .starts_with("not judged: the metal did not yield")
        );
    }

    #[test]
    fn what_is_not_a_number_is_missed() {
        let nan = f64::NAN;
        assert!(!Check::relative("t", "s", (nan, 2.0), 0.02, "").passed);
        assert!(!Check::absolute("t", "s", (nan, 2.0), 0.02, "").passed);
        assert!(!Check::at_least("t", "s", nan, 2.0, "").passed);
        // A ratio to nothing proves nothing.
        assert!(!Check::at_least("t", "s", f64::INFINITY, 2.0, "").passed);
        assert!(!Check::more_than("t", "s", f64::INFINITY, 2.0, "").passed);
    }
}
