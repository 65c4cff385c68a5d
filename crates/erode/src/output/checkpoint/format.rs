//! The bytes of a checkpoint file, all numbers little-endian, every checksum CRC-32 (IEEE 802.3).
//!
//! | part | content |
//! | --- | --- |
//! | header, 32 bytes | signature (8), schema u32, number of arrays u32, length of the file u64, length of the words u32, checksum of these 28 bytes u32 |
//! | words | [`CheckpointMeta`] as JSON, checksum u32 |
//! | each array | length of the name u32, type u8, number of elements u64, name, elements, checksum of all this u32 |
//! | end | checksum of everything before, u32 |
//!
//! The header keeps this form in all schemas, so that another schema can be told from damage.

use super::{Array, Checkpoint, CheckpointMeta, Refusal};
use crate::output::error::OutputError;
use crc32fast::hash;

/// Version of the form of checkpoint files and of what the arrays in them mean. 2: liquids have the order of their clusters.
pub const SCHEMA: u32 = 3;
/// Not text, so that a conversion of line ends is noticed.
const SIGNATURE: [u8; 8] = *b"\x89ERODE\r\n";
const HEADER: usize = 32;
const CHECKSUM: usize = 4;

/// The bytes of a checkpoint file.
///
/// # Errors
/// [`OutputError::Content`] if the time is not a number or a part is too long for its length field.
pub(super) fn encode(checkpoint: &Checkpoint) -> Result<Vec<u8>, OutputError> {
    let too_long = |name: &str| OutputError::content(name, "it is too long for a checkpoint");
    if !checkpoint.meta.time.is_finite() {
        return Err(OutputError::content("time", "it is not a finite number"));
    }
    let words = serde_json::to_vec(&checkpoint.meta)
        .map_err(|e| OutputError::content("words", e.to_string()))?;
    let words_length = u32::try_from(words.len()).map_err(|_| too_long("words"))?;
    let count = u32::try_from(checkpoint.arrays.len()).map_err(|_| too_long("list of arrays"))?;
    let mut out = vec![0; HEADER];
    out.extend(&words);
    out.extend(hash(&words).to_le_bytes());
    for (name, array) in &checkpoint.arrays {
        let name_length = u32::try_from(name.len()).map_err(|_| too_long(name))?;
        put_array(&mut out, name, name_length, array);
    }
    let length = (out.len() + CHECKSUM) as u64;
    out[..8].copy_from_slice(&SIGNATURE);
    out[8..12].copy_from_slice(&SCHEMA.to_le_bytes());
    out[12..16].copy_from_slice(&count.to_le_bytes());
    out[16..24].copy_from_slice(&length.to_le_bytes());
    out[24..28].copy_from_slice(&words_length.to_le_bytes());
    let checksum = hash(&out[..28]);
    out[28..32].copy_from_slice(&checksum.to_le_bytes());
    out.extend(hash(&out).to_le_bytes());
    Ok(out)
}

fn put_array(out: &mut Vec<u8>, name: &str, name_length: u32, array: &Array) {
    let start = out.len();
    let (kind, count) = match array {
        Array::F64(v) => (0_u8, v.len()),
        Array::U64(v) => (1, v.len()),
        Array::U32(v) => (2, v.len()),
        Array::U8(v) => (3, v.len()),
    };
    out.extend(name_length.to_le_bytes());
    out.push(kind);
    out.extend((count as u64).to_le_bytes());
    out.extend(name.as_bytes());
    match array {
        Array::F64(v) => v.iter().for_each(|x| out.extend(x.to_le_bytes())),
        Array::U64(v) => v.iter().for_each(|x| out.extend(x.to_le_bytes())),
        Array::U32(v) => v.iter().for_each(|x| out.extend(x.to_le_bytes())),
        Array::U8(v) => out.extend(v),
    }
    out.extend(hash(&out[start..]).to_le_bytes());
}

/// The checkpoint in the bytes of a file, if all of it is as it was written.
pub(super) fn decode(bytes: &[u8]) -> Result<Checkpoint, Refusal> {
    let start = bytes.len().min(SIGNATURE.len());
    if bytes[..start] != SIGNATURE[..start] {
        return Err(Refusal::Foreign);
    }
    let mut rest = Reader { bytes, at: 0 };
    let short = Refusal::Truncated {
        found: bytes.len() as u64,
        expected: HEADER as u64,
    };
    let header = rest.take(HEADER).ok_or(short)?;
    if word(header, 28) != hash(&header[..28]) {
        return Err(damaged("its header"));
    }
    let (schema, count, words_length) = (word(header, 8), word(header, 12), word(header, 24));
    let length = u64::from(word(header, 16)) | u64::from(word(header, 20)) << 32;
    let found = bytes.len() as u64;
    if found < length {
        return Err(Refusal::Truncated {
            found,
            expected: length,
        });
    }
    if schema != SCHEMA {
        return Err(Refusal::OtherSchema { found: schema });
    }
    let words = rest
        .checked(words_length as usize)
        .ok_or_else(|| damaged("the description of the run"))?;
    let meta: CheckpointMeta =
        serde_json::from_slice(words).map_err(|_| damaged("the description of the run"))?;
    let mut checkpoint = Checkpoint::new(meta);
    for number in 1..=count {
        let (name, array) =
            take_array(&mut rest).ok_or_else(|| damaged(&format!("array {number} of {count}")))?;
        checkpoint.arrays.push((name, array));
    }
    let before = rest.at;
    let whole = rest
        .take(CHECKSUM)
        .is_some_and(|end| word(end, 0) == hash(&bytes[..before]));
    if whole && found == length {
        Ok(checkpoint)
    } else {
        Err(damaged("its end"))
    }
}

fn damaged(region: &str) -> Refusal {
    Refusal::Damaged {
        region: region.into(),
    }
}

/// The 32-bit number at `at`; the caller made sure that it is there.
fn word(bytes: &[u8], at: usize) -> u32 {
    u32::from_le_bytes(std::array::from_fn(|index| bytes[at + index]))
}

struct Reader<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Reader<'a> {
    fn take(&mut self, length: usize) -> Option<&'a [u8]> {
        let end = self.at.checked_add(length)?;
        let taken = self.bytes.get(self.at..end)?;
        self.at = end;
        Some(taken)
    }

    /// The next `length` bytes, if the checksum after them is theirs.
    fn checked(&mut self, length: usize) -> Option<&'a [u8]> {
        let content = self.take(length)?;
        (word(self.take(CHECKSUM)?, 0) == hash(content)).then_some(content)
    }
}

fn take_array(rest: &mut Reader<'_>) -> Option<(String, Array)> {
    const FIXED: usize = 13;
    let fixed = rest.bytes.get(rest.at..)?.get(..FIXED)?;
    let name_length = word(fixed, 0) as usize;
    let count =
        usize::try_from(u64::from(word(fixed, 5)) | u64::from(word(fixed, 9)) << 32).ok()?;
    let size = match fixed[4] {
        0 | 1 => 8,
        2 => 4,
        3 => 1,
        _ => return None,
    };
    let length = FIXED
        .checked_add(name_length)?
        .checked_add(count.checked_mul(size)?)?;
    let content = rest.checked(length)?;
    let name = str::from_utf8(&content[FIXED..FIXED + name_length]).ok()?;
    let elements = &content[FIXED + name_length..];
    let array = match fixed[4] {
        0 => Array::F64(
            elements
                .as_chunks()
                .0
                .iter()
                .map(|&b| f64::from_le_bytes(b))
                .collect(),
        ),
        1 => Array::U64(
            elements
                .as_chunks()
                .0
                .iter()
                .map(|&b| u64::from_le_bytes(b))
                .collect(),
        ),
        2 => Array::U32(
            elements
                .as_chunks()
                .0
                .iter()
                .map(|&b| u32::from_le_bytes(b))
                .collect(),
        ),
        _ => Array::U8(elements.to_vec()),
    };
    Some((name.into(), array))
}

#[cfg(test)]
#[path = "format_tests.rs"]
mod tests;
