//! Tables of numbers over time: `time [s],bubble_radius [m],...`, one row per line.
//!
//! Numbers are written with the fewest digits that give the same `f64` back; not-a-number is `NaN`. Rows reach the
//! file whole, at least once a second while rows come in and whenever [`TableWriter::sync`] is called. A checkpoint
//! records [`TableWriter::rows`]; [`TableWriter::resume`] cuts the table back to them, so the table of a resumed run
//! is byte for byte that of an uninterrupted one.

use super::error::OutputError;
use std::fmt::Write as _;
use std::fs::{self, File, OpenOptions};
use std::io::{Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Longest time that a row waits before it is written, while rows come in.
const LONGEST_WAIT: Duration = Duration::from_secs(1);
/// Most bytes that wait.
const LARGEST_WAIT: usize = 1 << 20;

/// Name and unit of a column; the unit of a pure number is `-`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Column {
    /// Name as in the code.
    pub name: String,
    /// Unit, SI.
    pub unit: String,
}

impl Column {
    /// A column of `name` in `unit`.
    pub fn new(name: impl Into<String>, unit: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            unit: unit.into(),
        }
    }

    fn check(&self) -> Result<(), OutputError> {
        let plain =
            |text: &str| !text.is_empty() && !text.contains([',', '[', ']', '"', '\n', '\r']);
        if plain(&self.name) && plain(&self.unit) && !self.name.contains(' ') {
            Ok(())
        } else {
            Err(OutputError::content(
                &self.name,
                format!("the unit `{}` or the name does not fit a header", self.unit),
            ))
        }
    }
}

/// Appends rows to a table.
#[derive(Debug)]
pub struct TableWriter {
    path: PathBuf,
    file: File,
    waiting: String,
    since: Instant,
    columns: usize,
    rows: u64,
}

impl TableWriter {
    /// Starts the table `path` with a header; an existing file is replaced.
    ///
    /// # Errors
    /// [`OutputError::Write`]; [`OutputError::Content`] if a name or unit cannot stand in a header.
    pub fn create(path: &Path, columns: &[Column]) -> Result<Self, OutputError> {
        let header = header(columns)?;
        let error = |cause| OutputError::Write {
            path: path.into(),
            cause,
        };
        let mut file = File::create(path).map_err(error)?;
        file.write_all(header.as_bytes()).map_err(error)?;
        Ok(Self::at_end(path, file, columns.len(), 0))
    }

    /// Continues the table `path` after its first `rows` rows; later ones are removed.
    ///
    /// # Errors
    /// [`OutputError::Malformed`] if the columns are not these or rows are missing; [`OutputError::Read`],
    /// [`OutputError::Write`].
    pub fn resume(path: &Path, columns: &[Column], rows: u64) -> Result<Self, OutputError> {
        let text = fs::read(path).map_err(|cause| OutputError::Read {
            path: path.into(),
            cause,
        })?;
        let malformed = |what: String| OutputError::Malformed {
            path: path.into(),
            what,
        };
        let header = header(columns)?;
        if !text.starts_with(header.as_bytes()) {
            return Err(malformed("its columns are not those of this case".into()));
        }
        let end = end_of_row(&text, header.len(), rows).map_err(|there| {
            malformed(format!("the checkpoint needs {rows} rows, it has {there}"))
        })?;
        let error = |cause| OutputError::Write {
            path: path.into(),
            cause,
        };
        let mut file = OpenOptions::new().write(true).open(path).map_err(error)?;
        file.set_len(end as u64).map_err(error)?;
        file.seek(SeekFrom::End(0)).map_err(error)?;
        Ok(Self::at_end(path, file, columns.len(), rows))
    }

    fn at_end(path: &Path, file: File, columns: usize, rows: u64) -> Self {
        Self {
            path: path.into(),
            file,
            waiting: String::new(),
            since: Instant::now(),
            columns,
            rows,
        }
    }

    /// Appends a row of one value per column.
    ///
    /// # Errors
    /// [`OutputError::Content`] for another number of values, [`OutputError::Write`].
    pub fn write_row(&mut self, values: &[f64]) -> Result<(), OutputError> {
        if values.len() != self.columns {
            let what = format!(
                "a row has {} values for {} columns",
                values.len(),
                self.columns
            );
            return Err(OutputError::content(&self.path.to_string_lossy(), what));
        }
        if self.waiting.is_empty() {
            self.since = Instant::now();
        }
        for (index, value) in values.iter().enumerate() {
            let comma = if index == 0 { "" } else { "," };
            // Writing to a String cannot fail.
            let _ = write!(self.waiting, "{comma}{value:?}");
        }
        self.waiting.push('\n');
        self.rows += 1;
        if self.waiting.len() > LARGEST_WAIT || self.since.elapsed() > LONGEST_WAIT {
            self.flush()?;
        }
        Ok(())
    }

    /// Number of columns.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Number of rows so far; a checkpoint records it.
    pub fn rows(&self) -> u64 {
        self.rows
    }

    /// Hands the waiting rows to the operating system: other programs see them.
    ///
    /// # Errors
    /// [`OutputError::Write`].
    pub fn flush(&mut self) -> Result<(), OutputError> {
        // Taken out first: rows that were partly written must not be written again on drop.
        let waiting = std::mem::take(&mut self.waiting);
        self.file
            .write_all(waiting.as_bytes())
            .map_err(|cause| OutputError::Write {
                path: self.path.clone(),
                cause,
            })
    }

    /// Flushes and waits until the rows are on the disk. To be called before a checkpoint is written and at the end.
    ///
    /// # Errors
    /// [`OutputError::Write`].
    pub fn sync(&mut self) -> Result<(), OutputError> {
        self.begin_sync()?.finish()
    }

    /// The same in two parts: flushes; what comes back waits, on any thread, until these rows are on the disk.
    ///
    /// # Errors
    /// [`OutputError::Write`].
    pub fn begin_sync(&mut self) -> Result<Sync, OutputError> {
        self.flush()?;
        let path = self.path.clone();
        match self.file.try_clone() {
            Ok(file) => Ok(Sync { path, file }),
            Err(cause) => Err(OutputError::Write { path, cause }),
        }
    }
}

/// Rows of a table on their way to the disk.
#[derive(Debug)]
#[must_use]
pub struct Sync {
    path: PathBuf,
    file: File,
}

impl Sync {
    /// Waits until they are there.
    ///
    /// # Errors
    /// [`OutputError::Write`].
    pub fn finish(self) -> Result<(), OutputError> {
        let path = self.path;
        self.file
            .sync_data()
            .map_err(|cause| OutputError::Write { path, cause })
    }
}

impl Drop for TableWriter {
    /// Writes what still waits when a run ends by an error; whoever wants to hear of failures calls `sync` before.
    fn drop(&mut self) {
        let _ = self.flush();
    }
}

fn header(columns: &[Column]) -> Result<String, OutputError> {
    columns.iter().try_for_each(Column::check)?;
    let names: Vec<_> = columns
        .iter()
        .map(|column| format!("{} [{}]", column.name, column.unit))
        .collect();
    Ok(names.join(",") + "\n")
}

/// Offset just after row number `rows`, or how many complete rows there are.
fn end_of_row(text: &[u8], start: usize, rows: u64) -> Result<usize, u64> {
    let mut end = start;
    for there in 0..rows {
        end += text[end..]
            .iter()
            .position(|&byte| byte == b'\n')
            .ok_or(there)?
            + 1;
    }
    Ok(end)
}

/// A table in memory.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// Names and units.
    pub columns: Vec<Column>,
    /// One vector per column.
    pub values: Vec<Vec<f64>>,
    /// The last line had no end and was left out: the table is being written or its writer was killed.
    pub unfinished: bool,
}

impl Table {
    /// Reads a table that [`TableWriter`] wrote.
    ///
    /// # Errors
    /// [`OutputError::Read`]; [`OutputError::Malformed`] with the line.
    pub fn read(path: &Path) -> Result<Self, OutputError> {
        let text = fs::read_to_string(path).map_err(|cause| OutputError::Read {
            path: path.into(),
            cause,
        })?;
        Self::parse(&text).map_err(|what| OutputError::Malformed {
            path: path.into(),
            what,
        })
    }

    fn parse(text: &str) -> Result<Self, String> {
        let whole = text.rfind('\n').map_or("", |end| &text[..=end]);
        let mut lines = whole.lines();
        let header = lines.next().ok_or("it has no header line")?;
        let columns = header
            .split(',')
            .map(parse_column)
            .collect::<Result<Vec<_>, _>>()?;
        let mut values = vec![Vec::new(); columns.len()];
        for (number, line) in lines.enumerate() {
            let row = line
                .split(',')
                .map(str::parse)
                .collect::<Result<Vec<f64>, _>>();
            let row =
                row.map_err(|_| format!("line {} has something that is not a number", number + 2))?;
            if row.len() != columns.len() {
                return Err(format!(
                    "line {} has {} values for {} columns",
                    number + 2,
                    row.len(),
                    columns.len()
                ));
            }
            for (column, value) in values.iter_mut().zip(row) {
                column.push(value);
            }
        }
        Ok(Self {
            columns,
            values,
            unfinished: whole.len() < text.len(),
        })
    }

    /// The values of the column `name`.
    pub fn column(&self, name: &str) -> Option<&[f64]> {
        let index = self.columns.iter().position(|column| column.name == name)?;
        Some(&self.values[index])
    }

    /// The unit of the column `name`.
    pub fn unit(&self, name: &str) -> Option<&str> {
        Some(&self.columns.iter().find(|column| column.name == name)?.unit)
    }

    /// The rows with a `time` within these two; all rows of a table without times.
    #[must_use]
    pub fn between(&self, begin: f64, end: f64) -> Self {
        let Some(time) = self.column("time") else {
            return self.clone();
        };
        let inside = |k: usize| (begin..=end).contains(&time[k]);
        let keep = |column: &Vec<f64>| {
            let rows = column.iter().enumerate();
            rows.filter(|(k, _)| inside(*k)).map(|(_, v)| *v).collect()
        };
        Self {
            columns: self.columns.clone(),
            values: self.values.iter().map(keep).collect(),
            unfinished: self.unfinished,
        }
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.values.first().map_or(0, Vec::len)
    }
}

fn parse_column(text: &str) -> Result<Column, String> {
    text.strip_suffix(']')
        .and_then(|text| text.split_once(" ["))
        .map(|(name, unit)| Column::new(name, unit))
        .ok_or_else(|| format!("the header `{text}` is not of the form `name [unit]`"))
}

#[cfg(test)]
#[path = "csv_tests.rs"]
mod tests;
