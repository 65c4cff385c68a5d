//! A table as Parquet: texts as UTF-8, numbers as doubles, both optional; units as metadata of the file.

use super::table::{Cell, Column, Table};
use crate::output::OutputError;
use crate::output::atomic::write_atomic;
use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::data_type::{ByteArray, ByteArrayType, DataType, DoubleType};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::Type;
use std::path::Path;
use std::sync::Arc;

/// Writes a table, whole or not at all; units are metadata `unit.NAME`.
///
/// # Errors
/// If the file cannot be written.
pub(super) fn write(path: &Path, table: &Table) -> Result<(), OutputError> {
    let bytes =
        encoded(table).map_err(|e| OutputError::content("results.parquet", e.to_string()))?;
    write_atomic(path, |file| file.write_all(&bytes))
}

fn encoded(table: &Table) -> Result<Vec<u8>, ParquetError> {
    let fields = table.columns.iter().map(field);
    let fields = fields.collect::<Result<Vec<_>, _>>()?;
    let schema = Type::group_type_builder("results").with_fields(fields);
    let units = table.columns.iter().filter(|c| !c.is_text());
    let units = units.map(|c| KeyValue::new(format!("unit.{}", c.name), c.unit.clone()));
    let properties = WriterProperties::builder()
        .set_key_value_metadata(Some(units.collect()))
        .build();
    let mut writer =
        SerializedFileWriter::new(Vec::new(), Arc::new(schema.build()?), Arc::new(properties))?;
    let mut group = writer.next_row_group()?;
    for column in &table.columns {
        if column.is_text() {
            let text = |c: &Cell| match c {
                Cell::Text(t) => Some(ByteArray::from(t.as_str())),
                _ => None,
            };
            append::<ByteArrayType>(&mut group, column, text)?;
        } else {
            let number = |c: &Cell| match c {
                Cell::Number(x) => Some(*x),
                _ => None,
            };
            append::<DoubleType>(&mut group, column, number)?;
        }
    }
    group.close()?;
    writer.into_inner()
}

fn field(column: &Column) -> Result<Arc<Type>, ParquetError> {
    let (physical, logical) = if column.is_text() {
        (Physical::BYTE_ARRAY, Some(LogicalType::String))
    } else {
        (Physical::DOUBLE, None)
    };
    let builder = Type::primitive_type_builder(&column.name, physical)
        .with_repetition(Repetition::OPTIONAL)
        .with_logical_type(logical);
    Ok(Arc::new(builder.build()?))
}

/// Adds a column; an entry without a value is null.
fn append<T: DataType>(
    group: &mut SerializedRowGroupWriter<'_, Vec<u8>>,
    column: &Column,
    value: impl Fn(&Cell) -> Option<T::T>,
) -> Result<(), ParquetError> {
    let values: Vec<Option<T::T>> = column.cells.iter().map(value).collect();
    let present: Vec<i16> = values.iter().map(|v| i16::from(v.is_some())).collect();
    let values: Vec<T::T> = values.into_iter().flatten().collect();
    if let Some(mut writer) = group.next_column()? {
        writer
            .typed::<T>()
            .write_batch(&values, Some(&present), None)?;
        writer.close()?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::table::example;
    use super::*;
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::RowAccessor;

    #[test]
    fn a_table_comes_back() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("results.parquet");
        write(&path, &example()).unwrap();
        let reader = SerializedFileReader::new(std::fs::File::open(&path).unwrap()).unwrap();
        let rows: Vec<_> = reader
            .get_row_iter(None)
            .unwrap()
            .map(Result::unwrap)
            .collect();
        assert_eq!(rows.len(), 2);
        assert_eq!(rows[0].get_string(0).unwrap(), "a=1,b=\"x\"");
        assert_eq!(rows[0].get_double(1).unwrap(), 0.1);
        // Null, as it is not known yet.
        assert!(rows[1].get_double(1).is_err());
        assert!(rows[0].get_double(2).unwrap().is_nan());
        let metadata = reader
            .metadata()
            .file_metadata()
            .key_value_metadata()
            .unwrap()
            .clone();
        assert!(
            metadata
                .iter()
                .any(|m| m.key == "unit.p" && m.value.as_deref() == Some("Pa"))
        );
    }
}
