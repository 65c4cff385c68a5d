//! Reading back what `write` wrote (one array per line, appended raw or zlib); not a general VTK reader.

use super::{Data, Field, Snapshot};
use crate::output::error::OutputError;
use flate2::read::ZlibDecoder;
use std::fs;
use std::io::Read;
use std::path::Path;

const START_OF_DATA: &[u8] = b"<AppendedData encoding=\"raw\">\n_";

pub(super) fn read(path: &Path) -> Result<Snapshot, OutputError> {
    let bytes = fs::read(path).map_err(|cause| OutputError::Read {
        path: path.into(),
        cause,
    })?;
    parse(&bytes).map_err(|what| OutputError::Malformed {
        path: path.into(),
        what,
    })
}

fn parse(bytes: &[u8]) -> Result<Snapshot, String> {
    let start = bytes
        .windows(START_OF_DATA.len())
        .position(|part| part == START_OF_DATA);
    let start = start.ok_or("it has no appended raw data")?;
    let header = str::from_utf8(&bytes[..start]).map_err(|_| "its header is not text")?;
    let data = &bytes[start + START_OF_DATA.len()..];
    if !header.contains("type=\"UnstructuredGrid\"") || !header.contains("header_type=\"UInt64\"") {
        return Err("it is not an unstructured grid with 64-bit headers".into());
    }
    let compressed = header.contains("compressor=\"vtkZLibDataCompressor\"");
    let mut snapshot = Snapshot {
        time: f64::NAN,
        points: Vec::new(),
        fields: Vec::new(),
    };
    for line in header
        .lines()
        .map(str::trim)
        .filter(|line| line.starts_with("<DataArray"))
    {
        match attribute(line, "Name")? {
            "TimeValue" => snapshot.time = number(content(line).trim())?,
            "connectivity" | "offsets" | "types" => {}
            "points" => snapshot.points = points(&field(line, data, compressed)?)?,
            _ => snapshot.fields.push(field(line, data, compressed)?),
        }
    }
    let count: usize = number(attribute(header, "NumberOfPoints")?)?;
    if snapshot.points.len() != count {
        return Err(format!(
            "it promises {count} points and has {}",
            snapshot.points.len()
        ));
    }
    snapshot.check().map_err(|error| error.to_string())?;
    Ok(snapshot)
}

fn field(line: &str, data: &[u8], compressed: bool) -> Result<Field, String> {
    let name = attribute(line, "Name")?;
    let offset: usize = number(attribute(line, "offset")?)?;
    let block = data.get(offset..).ok_or_else(|| cut_short(name))?;
    let bytes = if compressed {
        inflate(block)
    } else {
        raw(block)
    }
    .ok_or_else(|| cut_short(name))?;
    Ok(Field {
        name: name.into(),
        unit: content(content(line)).into(),
        components: number(attribute(line, "NumberOfComponents")?)?,
        data: from_little_endian(attribute(line, "type")?, &bytes)?,
    })
}

fn cut_short(name: &str) -> String {
    format!("the array `{name}` is damaged or cut short")
}

fn points(field: &Field) -> Result<Vec<[f64; 3]>, String> {
    match (&field.data, field.components) {
        (Data::F64(values), 3) => Ok(values.as_chunks().0.to_vec()),
        _ => Err("its points are not three numbers of double precision".into()),
    }
}

/// Value of an attribute of the first element in `text` that has it.
fn attribute<'a>(text: &'a str, name: &str) -> Result<&'a str, String> {
    let start = text
        .find(&format!(" {name}=\""))
        .map(|at| at + name.len() + 3);
    let rest = start.map(|at| &text[at..]);
    rest.and_then(|rest| rest.split_once('"'))
        .map(|(value, _)| value)
        .ok_or(format!("the attribute {name} is missing"))
}

/// Text between the first opening and the last closing tag; empty if there is none.
fn content(line: &str) -> &str {
    match (line.find('>'), line.rfind("</")) {
        (Some(open), Some(close)) if open < close => &line[open + 1..close],
        _ => "",
    }
}

fn number<T: std::str::FromStr>(text: &str) -> Result<T, String> {
    text.parse()
        .map_err(|_| format!("`{text}` is not a number that fits"))
}

fn size(block: &[u8], index: usize) -> Option<usize> {
    let bytes = block.get(8 * index..8 * index + 8)?;
    usize::try_from(u64::from_le_bytes(bytes.try_into().ok()?)).ok()
}

fn raw(block: &[u8]) -> Option<Vec<u8>> {
    let end = size(block, 0)?.checked_add(8)?;
    block.get(8..end).map(<[u8]>::to_vec)
}

fn inflate(block: &[u8]) -> Option<Vec<u8>> {
    let (count, full, last) = (size(block, 0)?, size(block, 1)?, size(block, 2)?);
    let mut start = count.checked_mul(8)?.checked_add(24)?;
    let mut out = Vec::new();
    for index in 0..count {
        let end = start.checked_add(size(block, 3 + index)?)?;
        let before = out.len();
        ZlibDecoder::new(block.get(start..end)?)
            .read_to_end(&mut out)
            .ok()?;
        let expected = if index + 1 == count && last > 0 {
            last
        } else {
            full
        };
        if out.len() - before != expected {
            return None;
        }
        start = end;
    }
    Some(out)
}

fn from_little_endian(kind: &str, bytes: &[u8]) -> Result<Data, String> {
    Ok(match kind {
        "Float64" => Data::F64(
            bytes
                .as_chunks()
                .0
                .iter()
                .map(|&b| f64::from_le_bytes(b))
                .collect(),
        ),
        "Float32" => Data::F32(
            bytes
                .as_chunks()
                .0
                .iter()
                .map(|&b| f32::from_le_bytes(b))
                .collect(),
        ),
        "UInt8" => Data::U8(bytes.to_vec()),
        "UInt32" => Data::U32(
            bytes
                .as_chunks()
                .0
                .iter()
                .map(|&b| u32::from_le_bytes(b))
                .collect(),
        ),
        "Int64" => Data::I64(
            bytes
                .as_chunks()
                .0
                .iter()
                .map(|&b| i64::from_le_bytes(b))
                .collect(),
        ),
        other => return Err(format!("arrays of type {other} are not written by Erode")),
    })
}
