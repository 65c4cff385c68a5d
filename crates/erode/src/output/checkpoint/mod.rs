//! Checkpoints: named arrays of exact numbers with a few words about the run, protected by checksums.

mod format;
mod store;

use super::error::OutputError;
use serde::{Deserialize, Serialize};
use std::fmt::{self, Display};
use std::path::PathBuf;

pub use format::SCHEMA;
pub use store::{CheckpointStore, KEPT, Loaded};

/// Words about the run. Numbers that must be exact belong into the arrays; `time` is exact as well.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CheckpointMeta {
    /// Version of the program that wrote it.
    pub code_version: String,
    /// Fingerprint of the resolved case.
    pub case_hash: String,
    /// Simulated time, s.
    pub time: f64,
    /// Number of steps done.
    pub step: u64,
    /// Whatever else the run needs, such as the number of rows of each table.
    #[serde(default)]
    pub extra: serde_json::Value,
}

/// The numbers of one section.
#[derive(Debug, Clone, PartialEq)]
pub enum Array {
    /// Double precision, bit for bit.
    F64(Vec<f64>),
    /// Counters.
    U64(Vec<u64>),
    /// Indices.
    U32(Vec<u32>),
    /// Flags, or any bytes.
    U8(Vec<u8>),
}

impl From<Vec<f64>> for Array {
    fn from(values: Vec<f64>) -> Self {
        Self::F64(values)
    }
}
impl From<Vec<u64>> for Array {
    fn from(values: Vec<u64>) -> Self {
        Self::U64(values)
    }
}
impl From<Vec<u32>> for Array {
    fn from(values: Vec<u32>) -> Self {
        Self::U32(values)
    }
}
impl From<Vec<u8>> for Array {
    fn from(values: Vec<u8>) -> Self {
        Self::U8(values)
    }
}

/// The whole state of a run at the end of a step.
#[derive(Debug, Clone, PartialEq)]
pub struct Checkpoint {
    /// Words about the run.
    pub meta: CheckpointMeta,
    arrays: Vec<(String, Array)>,
}

impl Checkpoint {
    /// A checkpoint without arrays.
    pub fn new(meta: CheckpointMeta) -> Self {
        Self {
            meta,
            arrays: Vec::new(),
        }
    }

    /// Adds an array under a name that no other has, such as `liquid.density`.
    ///
    /// # Errors
    /// [`OutputError::Content`] if the name is taken.
    pub fn push(&mut self, name: &str, values: impl Into<Array>) -> Result<(), OutputError> {
        if self.arrays.iter().any(|(other, _)| other == name) {
            return Err(OutputError::content(
                name,
                "the checkpoint has that array already",
            ));
        }
        self.arrays.push((name.into(), values.into()));
        Ok(())
    }

    /// Adds vectors or tensors of `N` components each.
    ///
    /// # Errors
    /// [`OutputError::Content`] if the name is taken.
    pub fn push_vectors<const N: usize>(
        &mut self,
        name: &str,
        values: &[[f64; N]],
    ) -> Result<(), OutputError> {
        self.push(name, values.as_flattened().to_vec())
    }

    /// The arrays, in the order of adding.
    pub fn arrays(&self) -> &[(String, Array)] {
        &self.arrays
    }

    /// The array `name` of double precision.
    ///
    /// # Errors
    /// [`OutputError::Content`] if it is missing or of another type; so for the other types.
    pub fn f64(&self, name: &str) -> Result<&[f64], OutputError> {
        match self.array(name)? {
            Array::F64(values) => Ok(values),
            _ => Err(other_type(name)),
        }
    }

    /// The array `name` of 64-bit counters.
    ///
    /// # Errors
    /// As [`Checkpoint::f64`].
    pub fn u64(&self, name: &str) -> Result<&[u64], OutputError> {
        match self.array(name)? {
            Array::U64(values) => Ok(values),
            _ => Err(other_type(name)),
        }
    }

    /// The array `name` of 32-bit indices.
    ///
    /// # Errors
    /// As [`Checkpoint::f64`].
    pub fn u32(&self, name: &str) -> Result<&[u32], OutputError> {
        match self.array(name)? {
            Array::U32(values) => Ok(values),
            _ => Err(other_type(name)),
        }
    }

    /// The array `name` of bytes.
    ///
    /// # Errors
    /// As [`Checkpoint::f64`].
    pub fn bytes(&self, name: &str) -> Result<&[u8], OutputError> {
        match self.array(name)? {
            Array::U8(values) => Ok(values),
            _ => Err(other_type(name)),
        }
    }

    /// What [`Checkpoint::push_vectors`] added.
    ///
    /// # Errors
    /// As [`Checkpoint::f64`], and if the length is not a multiple of `N`.
    pub fn vectors<const N: usize>(&self, name: &str) -> Result<Vec<[f64; N]>, OutputError> {
        match self.f64(name)?.as_chunks() {
            (vectors, []) => Ok(vectors.to_vec()),
            _ => Err(OutputError::content(
                name,
                format!("its length is not a multiple of {N}"),
            )),
        }
    }

    fn array(&self, name: &str) -> Result<&Array, OutputError> {
        let found = self.arrays.iter().find(|(other, _)| other == name);
        found
            .map(|(_, array)| array)
            .ok_or_else(|| OutputError::content(name, "the checkpoint has no such array"))
    }
}

fn other_type(name: &str) -> OutputError {
    OutputError::content(name, "the array in the checkpoint is of another type")
}

/// Why a checkpoint file is not used.
#[derive(Debug, thiserror::Error)]
pub enum Refusal {
    /// It does not begin as a checkpoint does.
    #[error("it is not an Erode checkpoint: it does not begin like one")]
    Foreign,
    /// It is shorter than it says.
    #[error("it is cut short: {found} of {expected} bytes are there")]
    Truncated {
        /// Bytes that are there.
        found: u64,
        /// Bytes that should be there.
        expected: u64,
    },
    /// A checksum is wrong.
    #[error("{region} is damaged: the checksum is wrong")]
    Damaged {
        /// Which part.
        region: String,
    },
    /// It is complete, but of another form.
    #[error(
        "it has checkpoint schema {found}, and this program reads schema {SCHEMA}: only the version of Erode that wrote it can go on with it"
    )]
    OtherSchema {
        /// The schema of the file.
        found: u32,
    },
    /// It is complete, but of another case.
    #[error(
        "it belongs to another case: its case hash is {found}, that of this case is {expected}"
    )]
    OtherCase {
        /// Case hash of the file.
        found: String,
        /// Case hash asked for.
        expected: String,
    },
    /// The operating system does not let us read it.
    #[error("it cannot be read: {0}")]
    Unreadable(std::io::Error),
}

/// A checkpoint file that is not used, and why; its text is a clause such as `checkpoints/x.erode is refused: ...`.
#[derive(Debug)]
pub struct Refused {
    /// The file.
    pub path: PathBuf,
    /// Why.
    pub reason: Refusal,
}

impl Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} is refused: {}", self.path.display(), self.reason)
    }
}
