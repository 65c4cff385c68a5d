//! A key of the case with a value, as `--set` takes it.

/// A value of a key as it goes into `--set`.
#[derive(Debug, Clone, PartialEq)]
pub struct Value {
    /// As written, in TOML.
    pub text: String,
    /// For people: as written, without quotes.
    pub shown: String,
    /// As a number in SI; switches are 0 and 1, words are none.
    pub number: Option<f64>,
    /// SI unit of the number; `-` for a pure one.
    pub unit: String,
}

/// A key of the case and its value in one run.
#[derive(Debug, Clone, PartialEq)]
pub struct Setting {
    /// `path.to.key`
    pub key: String,
    /// Its value.
    pub value: Value,
}

impl Setting {
    /// A setting of a number.
    #[must_use]
    pub fn number(key: &str, number: f64, unit: &str) -> Self {
        Self {
            key: key.to_owned(),
            value: Value {
                text: format!("{number:?}"),
                shown: format!("{number}"),
                number: Some(number),
                unit: unit.to_owned(),
            },
        }
    }

    /// A setting of a value in TOML that is no number.
    #[must_use]
    pub fn text(key: &str, text: &str) -> Self {
        let number = match text {
            "true" => Some(1.0),
            "false" => Some(0.0),
            _ => None,
        };
        Self {
            key: key.to_owned(),
            value: Value {
                text: text.to_owned(),
                shown: text.to_owned(),
                number,
                unit: "-".to_owned(),
            },
        }
    }

    /// As `--set` takes it.
    #[must_use]
    pub fn to_override(&self) -> String {
        format!("{}={}", self.key, self.value.text)
    }
}
