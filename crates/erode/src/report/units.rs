//! Numbers as an engineer writes them: SI prefixes, round ticks, few digits.

/// How values of one axis or table cell are shown: `shown = value / factor`, followed by `unit`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Scale {
    /// What one shown unit is in SI (1e-6 for µs).
    pub(crate) factor: f64,
    /// The unit with its prefix (`µs`, `MPa`, `10⁶ 1/s`); empty for plain numbers.
    pub(crate) unit: String,
}

const PREFIXES: [(i32, &str); 11] = [
    (-15, "f"),
    (-12, "p"),
    (-9, "n"),
    (-6, "µ"),
    (-3, "m"),
    (0, ""),
    (3, "k"),
    (6, "M"),
    (9, "G"),
    (12, "T"),
    (15, "P"),
];

impl Scale {
    /// The scale in which a quantity of SI unit `unit` with largest magnitude `largest` has one to three digits
    /// before the point.
    ///
    /// Units that take a prefix: s, m, Pa, J, N, W, Hz, also m2 and m3 (squared and cubed prefixes). Others (`m/s`,
    /// `kg/m3`, `1/s`) keep their unit and get a power of ten when the numbers would be unwieldy.
    pub(crate) fn for_magnitude(largest: f64, unit: &str) -> Self {
        let largest = largest.abs();
        let known = largest.is_finite() && largest > 0.0;
        let power = if known { largest.log10() } else { 0.0 };
        match unit {
            "s" | "m" | "Pa" | "J" | "N" | "W" | "Hz" => prefixed(power, unit, 1, ""),
            "m2" | "m^2" => prefixed(power, "m", 2, "²"),
            "m3" | "m^3" => prefixed(power, "m", 3, "³"),
            _ => powered(power, unit),
        }
    }

    /// The unit in square brackets, or nothing for a plain number.
    pub(crate) fn bracketed(&self) -> String {
        if self.unit.is_empty() {
            String::new()
        } else {
            format!(" [{}]", self.unit)
        }
    }
}

/// Rounding up of 999.5 µm to 1 mm happens here and not in the digits.
const ROUND_UP: f64 = 0.000_22;

fn prefixed(power: f64, unit: &str, dimension: i32, superscript: &str) -> Scale {
    let step = 3 * dimension;
    // Squared and cubed steps are 6 and 9 decades wide: rather 14 10⁻³ mm³ than 14 10⁶ µm³.
    let lower = if dimension == 1 {
        0.0
    } else {
        f64::from(dimension)
    };
    let wanted = ((power + lower + ROUND_UP) / f64::from(step)).floor() as i32 * 3;
    // k, M, ... of metres and seconds are not in use where erosion happens.
    let largest = if matches!(unit, "s" | "m") {
        0
    } else {
        i32::MAX
    };
    let (exponent, prefix) = PREFIXES
        .iter()
        .copied()
        .filter(|(exponent, _)| *exponent <= largest)
        .min_by_key(|(exponent, _)| (exponent - wanted).abs())
        .unwrap_or((0, ""));
    let unit = format!("{prefix}{unit}{superscript}");
    let left = power - f64::from(exponent * dimension);
    let rest = if dimension == 1 || (-1.0..2.999_78).contains(&left) {
        Scale { factor: 1.0, unit }
    } else {
        in_thousands(left, &unit)
    };
    Scale {
        factor: rest.factor * 10f64.powi(exponent * dimension),
        ..rest
    }
}

fn powered(power: f64, unit: &str) -> Scale {
    let unit = pretty_unit(unit);
    if (-3.0..4.999).contains(&power) || (unit == "%" && power > 0.0) {
        return Scale { factor: 1.0, unit };
    }
    in_thousands(power, &unit)
}

/// A unit with a power of a thousand in front of it.
fn in_thousands(power: f64, unit: &str) -> Scale {
    let exponent = ((power + ROUND_UP) / 3.0).floor() as i32 * 3;
    Scale {
        factor: 10f64.powi(exponent),
        unit: format!("10{} {unit}", superscript(exponent))
            .trim_end()
            .to_string(),
    }
}

/// `m3` as `m³`, `-` as nothing.
fn pretty_unit(unit: &str) -> String {
    match unit.trim() {
        "-" | "1" | "" => String::new(),
        other => other
            .replace("m3", "m³")
            .replace("m2", "m²")
            .replace("m^3", "m³"),
    }
}

/// An integer in superscript digits.
pub(crate) fn superscript(number: i32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    number
        .to_string()
        .chars()
        .map(|c| c.to_digit(10).map_or('⁻', |d| DIGITS[d as usize]))
        .collect()
}

/// A number with `digits` significant digits and no exponent, trailing zeros kept (they tell the precision).
pub(crate) fn significant(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return "not a number".to_string();
    }
    if value == 0.0 {
        return "0".to_string();
    }
    // Formatting first rounds 9.999 to 10.0 before the decimals are counted.
    let rounded: f64 = format!("{value:.*e}", digits.saturating_sub(1))
        .parse()
        .unwrap_or(value);
    let magnitude = rounded.abs().log10().floor() as i32;
    let decimals = (digits as i32 - 1 - magnitude).max(0) as usize;
    minus(format!("{rounded:.decimals$}"))
}

/// A quantity with unit for tables: `1.23 GPa`, `0.231 %`, `2 400`.
pub fn quantity(value: f64, unit: &str) -> String {
    if pretty_unit(unit).is_empty() && value.fract() == 0.0 && value.abs() < 1e15 {
        return grouped(value);
    }
    let scale = Scale::for_magnitude(value, unit);
    let number = significant(value / scale.factor, 4);
    let times = if scale.unit.starts_with("10") {
        "×"
    } else {
        " "
    };
    format!("{number}{times}{}", scale.unit)
        .trim_end()
        .to_string()
}

/// A whole number with thin spaces between groups of three digits.
pub(crate) fn grouped(value: f64) -> String {
    let digits = format!("{:.0}", value.abs());
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push('\u{2009}');
        }
        text.push(digit);
    }
    if value < 0.0 {
        format!("−{text}")
    } else {
        text
    }
}

/// Round positions (steps of 1, 2 or 5 times a power of ten) covering `[low, high]`, about `count` of them, with their
/// labels. Values are in shown units.
pub(crate) fn ticks(low: f64, high: f64, count: usize) -> Vec<(f64, String)> {
    let span = high - low;
    if !(span.is_finite() && span > 0.0) {
        return Vec::new();
    }
    let raw = span / count.max(1) as f64;
    let base = 10f64.powf(raw.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .map(|m| m * base)
        .min_by(|a, b| (a / raw).ln().abs().total_cmp(&(b / raw).ln().abs()))
        .unwrap_or(base);
    let decimals = (-(step.log10() + 1e-9).floor()).max(0.0) as usize;
    let first = (low / step - 1e-9).ceil() as i64;
    let last = (high / step + 1e-9).floor() as i64;
    (first..=last)
        .map(|k| {
            let value = k as f64 * step;
            (value, minus(format!("{value:.decimals$}")))
        })
        .collect()
}

/// Powers of ten inside `[low, high]` with their labels.
pub(crate) fn decades(low: f64, high: f64) -> Vec<(f64, String)> {
    let first = (low.log10() - 1e-9).ceil() as i32;
    let last = (high.log10() + 1e-9).floor() as i32;
    let every = ((last - first) / 7 + 1) as usize;
    (first..=last)
        .step_by(every)
        .map(|k| (10f64.powi(k), format!("10{}", superscript(k))))
        .collect()
}

/// A name of the files as words: `max_plastic_strain` as `Max plastic strain`.
pub(crate) fn in_words(name: &str) -> String {
    let words = name.replace('_', " ");
    let mut letters = words.chars();
    letters.next().map_or(String::new(), |first| {
        first.to_uppercase().chain(letters).collect()
    })
}

/// The true minus sign, which is as wide as the digits; "-0" becomes "0".
fn minus(text: String) -> String {
    match text.strip_prefix('-') {
        Some(rest) if rest.chars().all(|c| c == '0' || c == '.') => rest.to_string(),
        Some(rest) => format!("−{rest}"),
        None => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prefixes_follow_the_magnitude() {
        assert_eq!(Scale::for_magnitude(1.5e-6, "s").unit, "µs");
        assert_eq!(Scale::for_magnitude(5.0e7, "Pa").unit, "MPa");
        assert_eq!(Scale::for_magnitude(0.000_15, "m").unit, "µm");
        assert_eq!(Scale::for_magnitude(2000.0, "m").unit, "m");
        // The bubble of 0.15 mm radius and one of 15 µm.
        assert_eq!(Scale::for_magnitude(1.4e-11, "m3").unit, "10⁻³ mm³");
        assert_eq!(Scale::for_magnitude(1.4e-14, "m3").unit, "10³ µm³");
        let scale = Scale::for_magnitude(1.4e-11, "m3");
        assert!((1.4e-11 / scale.factor - 14.0).abs() < 1e-9);
        assert_eq!(Scale::for_magnitude(3.0e6, "1/s").unit, "10⁶ 1/s");
        assert_eq!(Scale::for_magnitude(0.0, "Pa").unit, "Pa");
    }

    #[test]
    fn quantities_read_as_written_by_hand() {
        assert_eq!(quantity(1.2345e9, "Pa"), "1.234 GPa");
        assert_eq!(quantity(0.231, "%"), "0.2310 %");
        assert_eq!(quantity(320_000.0, "-"), "320\u{2009}000");
        assert_eq!(grouped(320_000.0), "320\u{2009}000");
        assert_eq!(quantity(1000.0, "kg/m3"), "1000 kg/m³");
        assert_eq!(significant(-0.001_234_5, 3), "−0.00123");
        assert_eq!(significant(9.9999, 3), "10.0");
    }

    #[test]
    fn ticks_are_round_and_inside() {
        let labels: Vec<String> = ticks(-0.31, 0.72, 5).into_iter().map(|t| t.1).collect();
        assert_eq!(labels, ["−0.2", "0.0", "0.2", "0.4", "0.6"]);
        for (low, high) in [(0.0, 1.0), (-3.0, 17.0), (1e-9, 2e-9), (0.0, 49.0)] {
            let found = ticks(low, high, 6);
            assert!((3..=13).contains(&found.len()), "{low}..{high}: {found:?}");
            assert!(
                found
                    .iter()
                    .all(|(v, _)| *v >= low - 1e-12 && *v <= high + 1e-12)
            );
        }
    }

    #[test]
    fn decades_of_a_log_axis() {
        assert_eq!(
            decades(2e-3, 50.0)
                .iter()
                .map(|t| t.1.as_str())
                .collect::<Vec<_>>(),
            ["10⁻²", "10⁻¹", "10⁰", "10¹"]
        );
    }
}
