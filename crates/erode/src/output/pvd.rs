//! The collection `fields.pvd`: which snapshot file belongs to which time and body. ParaView opens it as one data set
//! in time.

use super::atomic::write_atomic;
use super::error::OutputError;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

/// One snapshot file of one body.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    /// Time, s.
    pub time: f64,
    /// Number of the body.
    pub part: usize,
    /// Name of the body.
    pub name: String,
    /// Path relative to the collection, with forward slashes.
    pub file: String,
}

/// The list of all snapshots of a run, in the order of writing.
#[derive(Debug, Clone, PartialEq)]
pub struct Collection {
    path: PathBuf,
    entries: Vec<Entry>,
}

impl Collection {
    /// An empty collection; the file `path` appears with the first snapshot.
    pub fn new(path: impl Into<PathBuf>) -> Self {
        Self {
            path: path.into(),
            entries: Vec::new(),
        }
    }

    /// Reads a collection that [`Collection::add`] wrote.
    ///
    /// # Errors
    /// [`OutputError::Read`]; [`OutputError::Malformed`] with the line.
    pub fn read(path: &Path) -> Result<Self, OutputError> {
        let text = fs::read_to_string(path).map_err(|cause| OutputError::Read {
            path: path.into(),
            cause,
        })?;
        let malformed = |what: String| OutputError::Malformed {
            path: path.into(),
            what,
        };
        if !text.contains("<VTKFile type=\"Collection\"")
            || !text.trim_end().ends_with("</VTKFile>")
        {
            return Err(malformed("it is not a complete VTK collection".into()));
        }
        let mut entries = Vec::new();
        for (number, line) in text.lines().enumerate() {
            if line.trim_start().starts_with("<DataSet ") {
                let entry = parse(line)
                    .ok_or_else(|| malformed(format!("line {} is not a data set", number + 1)))?;
                entries.push(entry);
            }
        }
        Ok(Self {
            path: path.into(),
            entries,
        })
    }

    /// The snapshots, in the order of writing.
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// Adds the snapshots of one time (one per body) and rewrites the file.
    ///
    /// # Errors
    /// [`OutputError::Write`]; [`OutputError::Content`] for names that are not plain text.
    pub fn add(&mut self, entries: impl IntoIterator<Item = Entry>) -> Result<(), OutputError> {
        for entry in entries {
            if (entry.name.clone() + &entry.file).contains(['<', '>', '&', '"', '\n']) {
                return Err(OutputError::content(
                    &entry.name,
                    "the name is not plain text",
                ));
            }
            self.entries.push(entry);
        }
        self.write()
    }

    /// Goes back to the time of a checkpoint: removes all later snapshots, their files too, and rewrites the file.
    /// Snapshots at exactly `time` stay: a checkpoint is written after the snapshot of its step. Returns how many were
    /// removed.
    ///
    /// # Errors
    /// [`OutputError::Write`].
    pub fn truncate(&mut self, time: f64) -> Result<usize, OutputError> {
        let (kept, removed): (Vec<_>, Vec<_>) =
            self.entries.drain(..).partition(|entry| entry.time <= time);
        self.entries = kept;
        self.write()?;
        for entry in &removed {
            let path = self.path.with_file_name(&entry.file);
            match fs::remove_file(&path) {
                Err(cause) if cause.kind() != std::io::ErrorKind::NotFound => {
                    return Err(OutputError::Write { path, cause });
                }
                _ => {}
            }
        }
        Ok(removed.len())
    }

    fn write(&self) -> Result<(), OutputError> {
        let mut text = String::from(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n  <Collection>\n",
        );
        for Entry {
            time,
            part,
            name,
            file,
        } in &self.entries
        {
            // Writing to a String cannot fail.
            let _ = writeln!(
                text,
                "    <DataSet timestep=\"{time:?}\" group=\"\" part=\"{part}\" name=\"{name}\" file=\"{file}\"/>"
            );
        }
        text.push_str("  </Collection>\n</VTKFile>\n");
        write_atomic(&self.path, |out| out.write_all(text.as_bytes()))
    }
}

fn parse(line: &str) -> Option<Entry> {
    let attribute = |name: &str| {
        let (_, rest) = line.split_once(&format!(" {name}=\""))?;
        Some(rest.split_once('"')?.0)
    };
    Some(Entry {
        time: attribute("timestep")?.parse().ok()?,
        part: attribute("part")?.parse().ok()?,
        name: attribute("name")?.into(),
        file: attribute("file")?.into(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(time: f64, index: usize) -> [Entry; 2] {
        ["liquid", "wall"].map(|name| Entry {
            time,
            part: usize::from(name == "wall"),
            name: name.into(),
            file: format!("fields/{name}_{index:06}.vtu"),
        })
    }

    #[test]
    fn comes_back_and_is_cut_to_a_time_with_its_files() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("fields.pvd");
        fs::create_dir(folder.path().join("fields")).unwrap();
        let mut collection = Collection::new(&path);
        for (index, time) in [0.0, 0.1 + 0.2, 0.7].into_iter().enumerate() {
            for entry in at(time, index) {
                fs::write(folder.path().join(entry.file), "x").unwrap();
            }
            collection.add(at(time, index)).unwrap();
        }
        assert_eq!(Collection::read(&path).unwrap(), collection);
        let mut again = Collection::read(&path).unwrap();
        assert_eq!(again.truncate(0.1 + 0.2).unwrap(), 2);
        assert_eq!(again.entries(), [at(0.0, 0), at(0.1 + 0.2, 1)].concat());
        assert_eq!(Collection::read(&path).unwrap(), again);
        assert!(folder.path().join("fields/wall_000001.vtu").exists());
        assert!(!folder.path().join("fields/wall_000002.vtu").exists());
        again.add(at(0.7, 2)).unwrap();
        assert_eq!(again, collection);
    }

    #[test]
    fn an_incomplete_file_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("fields.pvd");
        Collection::new(&path).add(at(0.0, 0)).unwrap();
        let text = fs::read_to_string(&path).unwrap();
        fs::write(&path, &text[..text.len() - 12]).unwrap();
        assert!(matches!(
            Collection::read(&path),
            Err(OutputError::Malformed { .. })
        ));
    }
}
