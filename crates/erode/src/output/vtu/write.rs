//! Writing: first all arrays as blocks of bytes, then the XML with their offsets, then the blocks.

use super::{Data, Encoding, Field, Snapshot};
use crate::output::atomic::write_atomic;
use crate::output::error::OutputError;
use flate2::Compression;
use flate2::write::ZlibEncoder;
use rayon::prelude::*;
use std::fmt::Write as _;
use std::io::{self, Write};
use std::path::Path;

/// Bytes that are compressed together.
const BLOCK: usize = 1 << 18;
/// VTK's number for a cell of one point.
const VERTEX: u8 = 1;

pub(super) fn write(
    path: &Path,
    snapshot: &Snapshot,
    encoding: Encoding,
) -> Result<(), OutputError> {
    let arrays = arrays(snapshot);
    let blocks: io::Result<Vec<Vec<u8>>> = arrays
        .par_iter()
        .map(|array| block(&array.data, encoding))
        .collect();
    let blocks = blocks.map_err(|cause| OutputError::Write {
        path: path.into(),
        cause,
    })?;
    let header = header(snapshot, &arrays, &blocks, encoding);
    write_atomic(path, |file| {
        file.write_all(header.as_bytes())?;
        for block in &blocks {
            file.write_all(block)?;
        }
        file.write_all(b"\n  </AppendedData>\n</VTKFile>\n")
    })
}

/// All arrays of the file: points, connectivity, offsets, types, then the fields.
fn arrays(snapshot: &Snapshot) -> Vec<Field> {
    let count = snapshot.points.len() as i64;
    let cell = |name: &str, data| Field::scalar(name, "", data);
    let mut arrays = vec![
        Field::vector("points", "m", &snapshot.points),
        cell("connectivity", Data::I64((0..count).collect())),
        cell("offsets", Data::I64((1..=count).collect())),
        cell("types", Data::U8(vec![VERTEX; snapshot.points.len()])),
    ];
    arrays.extend(snapshot.fields.iter().cloned());
    arrays
}

fn header(snapshot: &Snapshot, arrays: &[Field], blocks: &[Vec<u8>], encoding: Encoding) -> String {
    let compressor = match encoding {
        Encoding::Raw => "",
        Encoding::Zlib => " compressor=\"vtkZLibDataCompressor\"",
    };
    let mut offset = 0;
    let mut lines = arrays.iter().zip(blocks).map(|(array, block)| {
        let line = array_line(array, offset);
        offset += block.len();
        line
    });
    let mut next = |count: usize| lines.by_ref().take(count).collect::<String>();
    let (points, cells, fields) = (next(1), next(3), next(usize::MAX));
    let (time, count) = (snapshot.time, snapshot.points.len());
    format!(
        "<?xml version=\"1.0\"?>\n\
         <VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\"{compressor}>\n\
         \x20 <UnstructuredGrid>\n\
         \x20   <FieldData>\n\
         \x20     <DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{time:?}</DataArray>\n\
         \x20   </FieldData>\n\
         \x20   <Piece NumberOfPoints=\"{count}\" NumberOfCells=\"{count}\">\n\
         \x20     <PointData>\n{fields}      </PointData>\n\
         \x20     <CellData>\n      </CellData>\n\
         \x20     <Points>\n{points}      </Points>\n\
         \x20     <Cells>\n{cells}      </Cells>\n\
         \x20   </Piece>\n\
         \x20 </UnstructuredGrid>\n\
         \x20 <AppendedData encoding=\"raw\">\n_"
    )
}

fn array_line(array: &Field, offset: usize) -> String {
    let Field {
        name,
        unit,
        components,
        data,
    } = array;
    let kind = match data {
        Data::F64(_) => "Float64",
        Data::F32(_) => "Float32",
        Data::U8(_) => "UInt8",
        Data::U32(_) => "UInt32",
        Data::I64(_) => "Int64",
    };
    let mut line = format!(
        "        <DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\""
    );
    if *components == 6 {
        for (index, label) in ["XX", "YY", "ZZ", "XY", "YZ", "XZ"].iter().enumerate() {
            // Writing to a String cannot fail.
            let _ = write!(line, " ComponentName{index}=\"{label}\"");
        }
    }
    let _ = write!(line, " format=\"appended\" offset=\"{offset}\">");
    if !unit.is_empty() {
        let _ = write!(
            line,
            "<InformationKey name=\"UNITS_LABEL\" location=\"vtkDataArray\">{unit}</InformationKey>"
        );
    }
    line + "</DataArray>\n"
}

/// The bytes of an array as they stand in the file. Raw: their number, then they. Zlib: number of blocks, size of a
/// block, size of the last one if it is smaller (else 0), the compressed sizes, then the compressed blocks.
fn block(data: &Data, encoding: Encoding) -> io::Result<Vec<u8>> {
    let bytes = little_endian(data);
    if encoding == Encoding::Raw {
        return Ok([(bytes.len() as u64).to_le_bytes().as_slice(), &bytes].concat());
    }
    let compressed = bytes
        .chunks(BLOCK)
        .map(compress)
        .collect::<io::Result<Vec<_>>>()?;
    let head = [compressed.len(), BLOCK, bytes.len() % BLOCK];
    let sizes = head.into_iter().chain(compressed.iter().map(Vec::len));
    let mut out: Vec<u8> = sizes.flat_map(|size| (size as u64).to_le_bytes()).collect();
    compressed.iter().for_each(|block| out.extend(block));
    Ok(out)
}

fn compress(bytes: &[u8]) -> io::Result<Vec<u8>> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::fast());
    encoder.write_all(bytes)?;
    encoder.finish()
}

fn little_endian(data: &Data) -> Vec<u8> {
    match data {
        Data::F64(v) => v.iter().flat_map(|x| x.to_le_bytes()).collect(),
        Data::F32(v) => v.iter().flat_map(|x| x.to_le_bytes()).collect(),
        Data::U8(v) => v.clone(),
        Data::U32(v) => v.iter().flat_map(|x| x.to_le_bytes()).collect(),
        Data::I64(v) => v.iter().flat_map(|x| x.to_le_bytes()).collect(),
    }
}
