//! A case after the check against its keys: SI numbers with their places, defaults filled in.

use super::{error::Span, units::Dimension};

/// A checked value.
#[derive(Debug, Clone)]
pub(crate) struct Node {
    pub(crate) span: Span,
    pub(crate) data: Data,
}

/// Kinds of checked values.
#[derive(Debug, Clone)]
pub(crate) enum Data {
    Number(f64),
    Property {
        value: f64,
        dimension: Dimension,
        source: Option<String>,
    },
    Text(String),
    Switch(bool),
    Pair([f64; 2]),
    Table(Vec<(String, Node)>),
    List(Vec<Node>),
    /// There, but wrong; the error is already recorded.
    Bad,
}

/// A checked table, for reading.
#[derive(Clone, Copy)]
pub(crate) struct Fields<'a> {
    pub(crate) span: Span,
    pub(crate) entries: &'a [(String, Node)],
}

impl Node {
    /// The node as a table.
    pub(crate) fn fields(&self) -> Option<Fields<'_>> {
        match &self.data {
            Data::Table(entries) => Some(Fields {
                span: self.span,
                entries,
            }),
            _ => None,
        }
    }
}

impl<'a> Fields<'a> {
    pub(crate) fn node(&self, key: &str) -> Option<&'a Node> {
        self.entries.iter().find(|(k, _)| k == key).map(|(_, n)| n)
    }

    /// Place of a key's value, or of the table when the value is a default.
    pub(crate) fn at(&self, key: &str) -> Span {
        self.node(key).map_or(self.span, |n| n.span)
    }

    pub(crate) fn number(&self, key: &str) -> Option<f64> {
        match self.node(key)?.data {
            Data::Number(x) | Data::Property { value: x, .. } => Some(x),
            _ => None,
        }
    }

    pub(crate) fn text(&self, key: &str) -> Option<&'a str> {
        match &self.node(key)?.data {
            Data::Text(s) => Some(s),
            _ => None,
        }
    }

    pub(crate) fn switch(&self, key: &str) -> Option<bool> {
        match self.node(key)?.data {
            Data::Switch(b) => Some(b),
            _ => None,
        }
    }

    pub(crate) fn pair(&self, key: &str) -> Option<[f64; 2]> {
        match self.node(key)?.data {
            Data::Pair(p) => Some(p),
            _ => None,
        }
    }

    pub(crate) fn table(&self, key: &str) -> Option<Fields<'a>> {
        self.node(key)?.fields()
    }

    pub(crate) fn list(&self, key: &str) -> &'a [Node] {
        match self.node(key).map(|n| &n.data) {
            Some(Data::List(list)) => list,
            _ => &[],
        }
    }

    /// The alternative of a table that has exactly one.
    pub(crate) fn choice(&self) -> Option<(&'a str, Fields<'a>)> {
        let (name, node) = self.entries.first()?;
        Some((name, node.fields()?))
    }

    /// The alternative chosen under `key`.
    pub(crate) fn chosen(&self, key: &str) -> Option<(&'a str, Fields<'a>)> {
        self.table(key)?.choice()
    }
}
