//! How a table of a case file is described: the checker, the JSON schema and `resolved.toml` all read this.

use super::units::Dimension;

/// A table and the keys it may have.
pub(crate) struct Table {
    /// What the table describes.
    pub(crate) about: &'static str,
    /// Allowed keys.
    pub(crate) keys: &'static [Key],
    /// Exactly one of these keys must be there.
    pub(crate) one_of: &'static [&'static str],
}

/// A key of a table.
pub(crate) struct Key {
    pub(crate) name: &'static str,
    pub(crate) kind: Kind,
    pub(crate) need: Need,
    /// What it means, for the schema and for comments.
    pub(crate) about: &'static str,
}

/// What a value must be.
#[derive(Clone, Copy)]
pub(crate) enum Kind {
    /// Any text.
    Text,
    /// A text that can be a file name.
    Name,
    /// true or false.
    Switch,
    /// A whole number, at least this.
    Count(u32),
    /// A number with unit.
    Quantity(Dimension, Range),
    /// Two numbers with unit.
    Pair(Dimension),
    /// A number with unit and, in material files, its source.
    Property(Dimension, Range),
    /// A table.
    Table(&'static Table),
    /// An array of tables.
    List(&'static Table),
    /// Tables under names of the user's choice.
    Map(&'static Table),
    /// Texts under names of the user's choice.
    Texts,
}

/// Whether a key must be there.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Need {
    Required,
    Optional,
    /// Taken when absent: a number or quantity as written, `true`/`false`, the name of an alternative, or nothing for
    /// a table of defaults.
    Default(&'static str),
}

/// Allowed values of a number.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Range {
    Any,
    Positive,
    NotNegative,
    /// Between these, without the ends.
    Between(f64, f64),
    /// Between these, ends included.
    Within(f64, f64),
}

impl Range {
    pub(crate) fn contains(self, x: f64) -> bool {
        match self {
            Self::Any => true,
            Self::Positive => x > 0.0,
            Self::NotNegative => x >= 0.0,
            Self::Between(a, b) => x > a && x < b,
            Self::Within(a, b) => x >= a && x <= b,
        }
    }

    /// "must be ..."
    pub(crate) fn rule(self) -> String {
        match self {
            Self::Any => "any finite number".to_owned(),
            Self::Positive => "greater than zero".to_owned(),
            Self::NotNegative => "zero or greater".to_owned(),
            Self::Between(a, b) => format!("greater than {a} and less than {b}"),
            Self::Within(a, b) => format!("from {a} to {b}"),
        }
    }
}

impl Table {
    /// The dimension of the number or pair at `path.to.key`, as `--set` has it; none for texts, switches, counts, and for
    /// what is no key.
    pub(crate) fn dimension(&'static self, path: &str) -> Option<Dimension> {
        let (first, rest) = path.split_once('.').unwrap_or((path, ""));
        match self.key(first)?.kind {
            Kind::Quantity(d, _) | Kind::Pair(d) if rest.is_empty() => Some(d),
            Kind::Property(d, _) if matches!(rest, "" | "value") => Some(d),
            Kind::Table(table) => table.dimension(rest),
            // The next part is the name or number of the element.
            Kind::List(table) | Kind::Map(table) => table.dimension(rest.split_once('.')?.1),
            _ => None,
        }
    }

    pub(crate) fn key(&self, name: &str) -> Option<&'static Key> {
        self.keys.iter().find(|k| k.name == name)
    }
}

/// A required key.
pub(crate) const fn required(name: &'static str, kind: Kind, about: &'static str) -> Key {
    Key {
        name,
        kind,
        need: Need::Required,
        about,
    }
}

/// An optional key.
pub(crate) const fn optional(name: &'static str, kind: Kind, about: &'static str) -> Key {
    Key {
        name,
        kind,
        need: Need::Optional,
        about,
    }
}

/// A key with a default, written as in a case file.
pub(crate) const fn default(
    name: &'static str,
    kind: Kind,
    value: &'static str,
    about: &'static str,
) -> Key {
    Key {
        name,
        kind,
        need: Need::Default(value),
        about,
    }
}

/// A table with independent keys.
pub(crate) const fn table(about: &'static str, keys: &'static [Key]) -> Table {
    Table {
        about,
        keys,
        one_of: &[],
    }
}
