//! Snapshots and checkpoints are compressed and written beside the calculation: one at a time, so that at most one waits in
//! memory.

use crate::output::{Encoding, Entry, OutputError, Snapshot};
use std::path::PathBuf;
use std::thread::JoinHandle;

/// One snapshot of a body: where it goes, what stands in it, how the collection lists it.
pub(super) struct Part {
    pub(super) path: PathBuf,
    pub(super) snapshot: Snapshot,
    pub(super) entry: Entry,
}

/// What is being written, if anything is.
#[derive(Default)]
pub(super) struct Background {
    writer: Option<JoinHandle<Result<Vec<Entry>, OutputError>>>,
}

impl Background {
    /// Begins to write a snapshot; the entries of the one before.
    ///
    /// # Errors
    /// As [`Self::begin`].
    pub(super) fn begin_snapshot(&mut self, parts: Vec<Part>) -> Result<Vec<Entry>, OutputError> {
        self.begin(move || {
            for part in &parts {
                part.snapshot.write(&part.path, Encoding::Zlib)?;
            }
            Ok(parts.into_iter().map(|part| part.entry).collect())
        })
    }

    /// Waits for what is being written and begins `work`, which tells entries for the collection; the entries of what was
    /// before.
    ///
    /// # Errors
    /// That of the writing before; nothing is begun then.
    pub(super) fn begin(
        &mut self,
        work: impl FnOnce() -> Result<Vec<Entry>, OutputError> + Send + 'static,
    ) -> Result<Vec<Entry>, OutputError> {
        let before = self.settle()?;
        self.writer = Some(std::thread::spawn(work));
        Ok(before)
    }

    /// Waits until all is on the disk; the entries for the collection.
    ///
    /// # Errors
    /// That of the writing.
    pub(super) fn settle(&mut self) -> Result<Vec<Entry>, OutputError> {
        let Some(writer) = self.writer.take() else {
            return Ok(Vec::new());
        };
        match writer.join() {
            Ok(written) => written,
            Err(panic) => std::panic::resume_unwind(panic),
        }
    }
}

impl Drop for Background {
    /// A run that ends by a panic leaves no half-written file; one that fails has settled before (`Course::go`).
    fn drop(&mut self) {
        if let Some(writer) = self.writer.take() {
            // Another fault is the one to tell.
            let _ = writer.join();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn part(folder: &std::path::Path, time: f64) -> Part {
        let file = format!("metal_{time}.vtu");
        Part {
            path: folder.join(&file),
            snapshot: Snapshot::new(time, &[[0.0; 2]]),
            entry: Entry {
                time,
                part: 0,
                name: "metal".into(),
                file,
            },
        }
    }

    #[test]
    fn no_entry_is_lost_between_two_snapshots() {
        let folder = tempfile::tempdir().unwrap();
        let mut background = Background::default();
        let begun = |b: &mut Background, time: f64| {
            b.begin_snapshot(vec![part(folder.path(), time)]).unwrap()
        };
        assert!(begun(&mut background, 1.0).is_empty());
        assert_eq!(begun(&mut background, 2.0)[0].time, 1.0);
        assert_eq!(background.settle().unwrap()[0].time, 2.0);
        assert!(background.settle().unwrap().is_empty());
    }

    #[test]
    fn a_snapshot_that_could_not_be_written_is_told() {
        let folder = tempfile::tempdir().unwrap();
        let mut background = Background::default();
        let nowhere = part(&folder.path().join("nowhere"), 1.0);
        background.begin_snapshot(vec![nowhere]).unwrap();
        let next = vec![part(folder.path(), 2.0)];
        assert!(background.begin_snapshot(next).is_err());
    }
}
