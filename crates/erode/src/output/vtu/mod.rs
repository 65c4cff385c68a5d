//! Snapshots of particles as VTK XML UnstructuredGrid files (`.vtu`), which ParaView opens without plugins.
//!
//! Each particle is a vertex cell. Arrays are appended little-endian binary with 64-bit headers (`header_type="UInt64"`),
//! raw or compressed with zlib. Units are the information key `UNITS_LABEL` of each array. Source of the format: VTK file
//! formats, <https://docs.vtk.org/en/latest/vtk_file_formats/vtkxml_file_format.html>.

mod read;
mod write;

use super::error::OutputError;
use erode_physics::tensor::Sym3;
use std::path::Path;

/// The numbers of a field; for several components, those of one particle follow each other.
#[derive(Debug, Clone, PartialEq)]
pub enum Data {
    /// Double precision.
    F64(Vec<f64>),
    /// Single precision.
    F32(Vec<f32>),
    /// Small codes and flags.
    U8(Vec<u8>),
    /// Numbers of particles or bodies.
    U32(Vec<u32>),
    /// Signed integers.
    I64(Vec<i64>),
}

impl Data {
    /// How many numbers there are.
    pub fn len(&self) -> usize {
        match self {
            Self::F64(v) => v.len(),
            Self::F32(v) => v.len(),
            Self::U8(v) => v.len(),
            Self::U32(v) => v.len(),
            Self::I64(v) => v.len(),
        }
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The `components` numbers of each of the particles `chosen`.
    fn select(&self, chosen: &[usize], components: usize) -> Self {
        fn pick<T: Copy>(values: &[T], chosen: &[usize], components: usize) -> Vec<T> {
            let start = chosen.iter().map(|particle| particle * components);
            start
                .flat_map(|at| values[at..at + components].iter().copied())
                .collect()
        }
        match self {
            Self::F64(v) => Self::F64(pick(v, chosen, components)),
            Self::F32(v) => Self::F32(pick(v, chosen, components)),
            Self::U8(v) => Self::U8(pick(v, chosen, components)),
            Self::U32(v) => Self::U32(pick(v, chosen, components)),
            Self::I64(v) => Self::I64(pick(v, chosen, components)),
        }
    }
}

/// A named quantity on all particles of a snapshot.
#[derive(Debug, Clone, PartialEq)]
pub struct Field {
    /// Name as in the code.
    pub name: String,
    /// Unit, SI; `-` for a pure number.
    pub unit: String,
    /// 1 scalar, 3 vector, 6 symmetric tensor in the order of VTK (xx, yy, zz, xy, yz, xz), 9 tensor by rows.
    pub components: usize,
    /// `components` numbers per particle.
    pub data: Data,
}

impl Field {
    /// A scalar.
    pub fn scalar(name: &str, unit: &str, data: Data) -> Self {
        Self {
            name: name.into(),
            unit: unit.into(),
            components: 1,
            data,
        }
    }

    /// A vector in the plane or in space; missing components are 0, as ParaView wants three.
    pub fn vector<const D: usize>(name: &str, unit: &str, vectors: &[[f64; D]]) -> Self {
        let data = Data::F64(
            vectors
                .iter()
                .flat_map(|&vector| in_space(vector))
                .collect(),
        );
        Self {
            name: name.into(),
            unit: unit.into(),
            components: 3,
            data,
        }
    }

    /// A symmetric tensor; the components of axisymmetry (r, z, hoop) appear as (XX, YY, ZZ).
    pub fn symmetric(name: &str, unit: &str, tensors: &[Sym3]) -> Self {
        let data = Data::F64(
            tensors
                .iter()
                .flat_map(|t| [t.xx, t.yy, t.zz, t.xy, t.yz, t.xz])
                .collect(),
        );
        Self {
            name: name.into(),
            unit: unit.into(),
            components: 6,
            data,
        }
    }
}

/// Particles at one time with their fields.
#[derive(Debug, Clone, PartialEq)]
pub struct Snapshot {
    /// Time, s.
    pub time: f64,
    /// Places, m; in axisymmetry (r, z, 0).
    pub points: Vec<[f64; 3]>,
    /// The fields, in the order of writing.
    pub fields: Vec<Field>,
}

/// How the arrays are stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Encoding {
    /// As they are.
    Raw,
    /// Compressed with zlib in blocks, without loss.
    Zlib,
}

impl Snapshot {
    /// Particles at `positions` (in the plane or in space), without fields.
    pub fn new<const D: usize>(time: f64, positions: &[[f64; D]]) -> Self {
        Self {
            time,
            points: positions
                .iter()
                .map(|&position| in_space(position))
                .collect(),
            fields: Vec::new(),
        }
    }

    /// The same with one more field.
    #[must_use]
    pub fn with(mut self, field: Field) -> Self {
        self.fields.push(field);
        self
    }

    /// The field `name`.
    pub fn field(&self, name: &str) -> Option<&Field> {
        self.fields.iter().find(|field| field.name == name)
    }

    /// The numbers of the field `name`, if it is one of double precision.
    pub fn values(&self, name: &str) -> Option<&[f64]> {
        match &self.field(name)?.data {
            Data::F64(values) => Some(values),
            _ => None,
        }
    }

    /// The particles `chosen` alone, in that order.
    ///
    /// # Errors
    /// [`OutputError::Content`] if a field does not fit the particles or a chosen one is not there.
    pub fn select(&self, chosen: &[usize]) -> Result<Self, OutputError> {
        self.check()?;
        if let Some(missing) = chosen
            .iter()
            .find(|&&particle| particle >= self.points.len())
        {
            return Err(OutputError::content(
                "points",
                format!("there is no particle {missing}"),
            ));
        }
        let fields = self.fields.iter().map(|f| Field {
            data: f.data.select(chosen, f.components),
            ..f.clone()
        });
        Ok(Self {
            time: self.time,
            points: chosen
                .iter()
                .map(|&particle| self.points[particle])
                .collect(),
            fields: fields.collect(),
        })
    }

    /// Writes the file `path`, complete or not at all.
    ///
    /// # Errors
    /// [`OutputError::Write`]; [`OutputError::Content`] if a field does not fit the particles or its name is taken.
    pub fn write(&self, path: &Path, encoding: Encoding) -> Result<(), OutputError> {
        self.check()?;
        write::write(path, self, encoding)
    }

    /// Reads a file that [`Snapshot::write`] wrote.
    ///
    /// # Errors
    /// [`OutputError::Read`]; [`OutputError::Malformed`] with what is wrong.
    pub fn read(path: &Path) -> Result<Self, OutputError> {
        read::read(path)
    }

    fn check(&self) -> Result<(), OutputError> {
        for (index, field) in self.fields.iter().enumerate() {
            let error = |what: String| Err(OutputError::content(&field.name, what));
            if ![1, 3, 6, 9].contains(&field.components) {
                return error(format!(
                    "{} components are not 1, 3, 6 or 9",
                    field.components
                ));
            }
            if field.data.len() != field.components * self.points.len() {
                let (there, particles) = (field.data.len(), self.points.len());
                return error(format!(
                    "{there} numbers of {} components for {particles} particles",
                    field.components
                ));
            }
            if field.name.is_empty()
                || (field.name.clone() + &field.unit).contains(['<', '>', '&', '"', '\n'])
            {
                return error(format!(
                    "the name or the unit `{}` is empty or not plain text",
                    field.unit
                ));
            }
            if self.fields[..index]
                .iter()
                .any(|other| other.name == field.name)
            {
                return error("the name is used twice".into());
            }
        }
        Ok(())
    }
}

fn in_space<const D: usize>(vector: [f64; D]) -> [f64; 3] {
    std::array::from_fn(|axis| vector.get(axis).copied().unwrap_or(0.0))
}

#[cfg(test)]
mod tests;
