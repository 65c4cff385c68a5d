//! A table with texts and numbers, and its form as CSV.

use crate::output::OutputError;
use crate::output::atomic::write_atomic;
use std::path::Path;

/// One entry.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// Nothing: not known yet, or not given.
    Empty,
    /// A number; NaN could not be determined.
    Number(f64),
    /// A text.
    Text(String),
}

/// One column.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Name.
    pub name: String,
    /// SI unit; `-` for pure numbers and texts.
    pub unit: String,
    /// One entry per row.
    pub cells: Vec<Cell>,
}

impl Column {
    /// Whether it holds texts.
    #[must_use]
    pub fn is_text(&self) -> bool {
        self.cells.iter().any(|c| matches!(c, Cell::Text(_)))
    }

    /// `name [unit]`; without the unit for texts.
    #[must_use]
    pub fn heading(&self) -> String {
        if self.is_text() {
            self.name.clone()
        } else {
            format!("{} [{}]", self.name, self.unit)
        }
    }
}

/// Columns of equal length.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Table {
    /// The columns.
    pub columns: Vec<Column>,
}

impl Table {
    /// Number of rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, |c| c.cells.len())
    }

    /// As CSV (RFC 4180), `name [unit]` in the header.
    #[must_use]
    pub fn to_csv(&self) -> String {
        let mut text = String::new();
        let mut line = |cells: Vec<String>| {
            text.push_str(&cells.join(","));
            text.push('\n');
        };
        line(self.columns.iter().map(|c| quoted(&c.heading())).collect());
        for k in 0..self.rows() {
            line(self.columns.iter().map(|c| cell(&c.cells[k])).collect());
        }
        text
    }
}

fn cell(cell: &Cell) -> String {
    match cell {
        Cell::Empty => String::new(),
        Cell::Number(x) => format!("{x:?}"),
        Cell::Text(t) => quoted(t),
    }
}

fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}

/// Writes a table as CSV, whole or not at all.
///
/// # Errors
/// If the file cannot be written.
pub fn write_csv(path: &Path, table: &Table) -> Result<(), OutputError> {
    write_atomic(path, |file| file.write_all(table.to_csv().as_bytes()))
}

#[cfg(test)]
pub(super) fn example() -> Table {
    let column = |name: &str, unit: &str, cells: Vec<Cell>| Column {
        name: name.into(),
        unit: unit.into(),
        cells,
    };
    Table {
        columns: vec![
            column(
                "run",
                "-",
                vec![Cell::Text("a=1,b=\"x\"".into()), Cell::Text("b".into())],
            ),
            column("p", "Pa", vec![Cell::Number(0.1), Cell::Empty]),
            column("s", "-", vec![Cell::Number(f64::NAN), Cell::Number(-1e-9)]),
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_with_commas_are_quoted_and_nothing_is_nothing() {
        assert_eq!(
            example().to_csv(),
            "run,p [Pa],s [-]\n\"a=1,b=\"\"x\"\"\",0.1,NaN\nb,,-1e-9\n"
        );
    }
}
