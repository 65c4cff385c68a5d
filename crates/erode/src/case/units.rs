//! Quantities with units, as written in case files: `"0.15 mm"`, `"50 MPa"`, `"7800 kg/m^3"`.
//!
//! All units are powers of ten of the SI base units m, kg, s, K, so a value is read as one decimal number and
//! rounded once: `"0.15 mm"` is exactly the same as `1.5e-4`.

use std::fmt;

/// Exponents of metre, kilogram, second, kelvin.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Dimension(pub(crate) [i8; 4]);

pub(crate) const NUMBER: Dimension = Dimension([0, 0, 0, 0]);
pub(crate) const LENGTH: Dimension = Dimension([1, 0, 0, 0]);
pub(crate) const TIME: Dimension = Dimension([0, 0, 1, 0]);
pub(crate) const TEMPERATURE: Dimension = Dimension([0, 0, 0, 1]);
pub(crate) const VELOCITY: Dimension = Dimension([1, 0, -1, 0]);
pub(crate) const PRESSURE: Dimension = Dimension([-1, 1, -2, 0]);
pub(crate) const DENSITY: Dimension = Dimension([-3, 1, 0, 0]);
pub(crate) const CIRCULATION: Dimension = Dimension([2, 0, -1, 0]);
pub(crate) const ACCELERATION: Dimension = Dimension([1, 0, -2, 0]);
pub(crate) const VISCOSITY: Dimension = Dimension([-1, 1, -1, 0]);
pub(crate) const SURFACE_TENSION: Dimension = Dimension([0, 1, -2, 0]);
pub(crate) const RATE: Dimension = Dimension([0, 0, -1, 0]);
pub(crate) const HEAT_CAPACITY: Dimension = Dimension([2, 0, -2, -1]);

/// (dimension, its name with article, SI unit, an example to show in messages)
const NAMED: &[(Dimension, &str, &str, &str)] = &[
    (NUMBER, "a number without unit", "1", "0.3"),
    (LENGTH, "a length", "m", "\"0.15 mm\""),
    (TIME, "a time", "s", "\"20 ns\""),
    (TEMPERATURE, "a temperature", "K", "\"293.15 K\""),
    (VELOCITY, "a velocity", "m/s", "\"1500 m/s\""),
    (PRESSURE, "a pressure", "Pa", "\"50 MPa\""),
    (DENSITY, "a density", "kg/m^3", "\"7800 kg/m^3\""),
    (CIRCULATION, "a circulation", "m^2/s", "\"0.29 m^2/s\""),
    (ACCELERATION, "an acceleration", "m/s^2", "\"9.81 m/s^2\""),
    (VISCOSITY, "a viscosity", "Pa s", "\"1 mPa s\""),
    (SURFACE_TENSION, "a surface tension", "N/m", "\"72.5 mN/m\""),
    (RATE, "a rate", "1/s", "\"0.05 1/s\""),
    (
        HEAT_CAPACITY,
        "a specific heat capacity",
        "J/(kg K)",
        "\"500 J/kg/K\"",
    ),
    (Dimension([2, 0, 0, 0]), "an area", "m^2", "\"1 mm^2\""),
    (Dimension([3, 0, 0, 0]), "a volume", "m^3", "\"1 mm^3\""),
    (Dimension([0, 1, 0, 0]), "a mass", "kg", "\"1 g\""),
    (Dimension([1, 1, -2, 0]), "a force", "N", "\"1 N\""),
    (Dimension([2, 1, -2, 0]), "an energy", "J", "\"1 mJ\""),
    (Dimension([2, 1, -3, 0]), "a power", "W", "\"1 W\""),
];

impl Dimension {
    fn named(self) -> Option<&'static (Dimension, &'static str, &'static str, &'static str)> {
        NAMED.iter().find(|n| n.0 == self)
    }

    /// "a pressure", or the exponents when the dimension has no name.
    pub(crate) fn name(self) -> String {
        self.named()
            .map_or_else(|| format!("a quantity in {self}"), |n| n.1.to_owned())
    }

    /// An example as it is written in a case file.
    pub(crate) fn example(self) -> &'static str {
        self.named().map_or("a plain number in SI", |n| n.3)
    }

    fn add(&mut self, other: Self, power: i8) -> Option<()> {
        for (a, b) in self.0.iter_mut().zip(other.0) {
            *a = a.checked_add(b.checked_mul(power)?)?;
        }
        Some(())
    }
}

/// The SI unit.
impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(n) = self.named() {
            return f.write_str(n.2);
        }
        let parts: Vec<String> = ["m", "kg", "s", "K"]
            .iter()
            .zip(self.0)
            .filter(|(_, e)| *e != 0)
            .map(|(u, e)| {
                if e == 1 {
                    (*u).to_owned()
                } else {
                    format!("{u}^{e}")
                }
            })
            .collect();
        f.write_str(&parts.join(" "))
    }
}

/// (symbol, dimension, power of ten of its SI value, may carry a prefix)
const UNITS: &[(&str, Dimension, i32, bool)] = &[
    ("m", LENGTH, 0, true),
    ("g", Dimension([0, 1, 0, 0]), -3, true),
    ("s", TIME, 0, true),
    ("K", TEMPERATURE, 0, true),
    ("Pa", PRESSURE, 0, true),
    ("N", Dimension([1, 1, -2, 0]), 0, true),
    ("J", Dimension([2, 1, -2, 0]), 0, true),
    ("W", Dimension([2, 1, -3, 0]), 0, true),
    ("Hz", RATE, 0, true),
    ("bar", PRESSURE, 5, true),
    ("L", Dimension([3, 0, 0, 0]), -3, true),
    ("%", NUMBER, -2, false),
    ("1", NUMBER, 0, false),
];

const PREFIXES: &[(&str, i32)] = &[
    ("p", -12),
    ("n", -9),
    ("u", -6),
    ("µ", -6),
    ("μ", -6),
    ("m", -3),
    ("c", -2),
    ("k", 3),
    ("M", 6),
    ("G", 9),
];

/// Symbols offered when a unit is unknown.
const COMMON: &[&str] = &[
    "m", "cm", "mm", "um", "nm", "s", "ms", "us", "ns", "Pa", "kPa", "MPa", "GPa", "bar", "m/s",
    "km/s", "kg/m^3", "g/cm^3", "1/s", "K", "J/kg/K", "Hz", "kHz", "MHz", "N", "J", "W", "%",
];

/// Why a text is no quantity.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{why}; {hint}")]
pub(crate) struct QuantityError {
    /// Short.
    pub(crate) why: String,
    /// What is allowed.
    pub(crate) hint: String,
}

fn wrong(why: impl Into<String>, hint: impl Into<String>) -> QuantityError {
    QuantityError {
        why: why.into(),
        hint: hint.into(),
    }
}

/// A number with the dimension of its unit; `None` when no unit was written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Quantity {
    /// SI value.
    pub(crate) value: f64,
    /// Dimension of the unit, if there was one.
    pub(crate) dimension: Option<Dimension>,
}

/// Reads `NUMBER [UNIT]`.
///
/// # Errors
/// When the number or the unit cannot be understood; the message says why and what is allowed.
pub(crate) fn parse(text: &str) -> Result<Quantity, QuantityError> {
    let text = text.trim();
    let split = number_length(text);
    let (number, unit) = (text[..split].replace('_', ""), text[split..].trim());
    if !number.contains(|c: char| c.is_ascii_digit()) {
        let why = if text.is_empty() {
            "the text is empty"
        } else {
            "it does not begin with a number"
        };
        return Err(wrong(why, "write a number and a unit"));
    }
    if unit.starts_with(',') {
        return Err(wrong(
            "a decimal comma is not understood",
            "write a decimal point",
        ));
    }
    let (dimension, power) = if unit.is_empty() {
        (None, 0)
    } else {
        parse_unit(unit).map(|(d, p)| (Some(d), p))?
    };
    let value = decimal(&number, power).ok_or_else(|| {
        wrong(
            format!("`{number}` is not a number"),
            "write it like 1.5e-3",
        )
    })?;
    Ok(Quantity { value, dimension })
}

/// Length in bytes of the number at the start.
fn number_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let digits = |mut i: usize| {
        while i < bytes.len() && (bytes[i].is_ascii_digit() || bytes[i] == b'_' || bytes[i] == b'.')
        {
            i += 1;
        }
        i
    };
    let sign = |i: usize| i + usize::from(matches!(bytes.get(i), Some(b'+' | b'-')));
    let end = digits(sign(0));
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let start = sign(end + 1);
        if bytes.get(start).is_some_and(u8::is_ascii_digit) {
            return digits(start);
        }
    }
    end
}

/// number * 10^power, rounded once.
fn decimal(number: &str, power: i32) -> Option<f64> {
    let (mantissa, exponent) = match number.split_once(['e', 'E']) {
        Some((m, e)) => (m, e.parse::<i32>().ok()?),
        None => (number, 0),
    };
    format!("{mantissa}e{}", exponent.checked_add(power)?)
        .parse()
        .ok()
}

/// Reads products and quotients of powers: `kg/m^3`, `J/(kg K)`, `m s^-2`, `1/s`.
fn parse_unit(text: &str) -> Result<(Dimension, i32), QuantityError> {
    let (mut dimension, mut power) = (NUMBER, 0_i32);
    let (mut sign, mut in_group) = (1_i8, false);
    let mut rest = text;
    let malformed = || {
        wrong(
            format!("`{text}` is not a unit"),
            "write units like `kg/m^3`",
        )
    };
    while let Some(c) = rest.chars().next() {
        match c {
            ' ' | '*' | '·' => rest = &rest[c.len_utf8()..],
            '/' if !in_group => {
                sign = -1;
                rest = &rest[1..];
            }
            '(' if !in_group => {
                in_group = true;
                rest = &rest[1..];
            }
            ')' if in_group => {
                (in_group, sign) = (false, 1);
                rest = &rest[1..];
            }
            _ => {
                let (symbol, exponent, next) = factor(rest).ok_or_else(malformed)?;
                let (d, p) = find_unit(symbol).ok_or_else(|| unknown_unit(symbol))?;
                let e = exponent.checked_mul(sign).ok_or_else(malformed)?;
                dimension.add(d, e).ok_or_else(malformed)?;
                power += p * i32::from(e);
                if !in_group {
                    sign = 1;
                }
                rest = next;
            }
        }
    }
    if in_group {
        Err(malformed())
    } else {
        Ok((dimension, power))
    }
}

/// One `symbol^exponent`: symbol, exponent, what follows.
fn factor(text: &str) -> Option<(&str, i8, &str)> {
    let end = text
        .find([' ', '*', '·', '/', '(', ')', '^'])
        .unwrap_or(text.len());
    let (symbol, rest) = text.split_at(end);
    if symbol.is_empty() {
        return None;
    }
    let Some(after) = rest.strip_prefix('^') else {
        return Some((symbol, 1, rest));
    };
    let digits = after
        .char_indices()
        .find(|(i, c)| !(c.is_ascii_digit() || (*i == 0 && *c == '-')))
        .map_or(after.len(), |(i, _)| i);
    Some((symbol, after[..digits].parse().ok()?, &after[digits..]))
}

fn find_unit(symbol: &str) -> Option<(Dimension, i32)> {
    if let Some(u) = UNITS.iter().find(|u| u.0 == symbol) {
        return Some((u.1, u.2));
    }
    PREFIXES.iter().find_map(|(prefix, p)| {
        let rest = symbol.strip_prefix(prefix)?;
        UNITS
            .iter()
            .find(|u| u.3 && u.0 == rest)
            .map(|u| (u.1, u.2 + p))
    })
}

fn unknown_unit(symbol: &str) -> QuantityError {
    let hint = super::suggest::closest(symbol, COMMON.iter().copied()).map_or_else(
        || format!("known units are {}", COMMON.join(", ")),
        |s| format!("did you mean `{s}`?"),
    );
    wrong(format!("`{symbol}` is not a known unit"), hint)
}

#[cfg(test)]
mod tests;
