//! Snapshots are compressed and written beside the calculation: one at a time, so that at most one waits in memory.

use crate::output::{Encoding, Entry, OutputError, Snapshot};
use std::path::PathBuf;
use std::thread::JoinHandle;

/// One snapshot of a body: where it goes, what stands in it, how the collection lists it.
pub(super) struct Part {
    pub(super) path: PathBuf,
    pub(super) snapshot: Snapshot,
    pub(super) entry: Entry,
}

/// The snapshot that is being written, if one is.
#[derive(Default)]
pub(super) struct Background {
    writer: Option<JoinHandle<Result<Vec<Entry>, OutputError>>>,
}

impl Background {
    /// Begins to write; [`Self::settle`] must have been called since the last time.
    pub(super) fn begin(&mut self, parts: Vec<Part>) {
        self.writer = Some(std::thread::spawn(move || {
            for part in &parts {
                part.snapshot.write(&part.path, Encoding::Zlib)?;
            }
            Ok(parts.into_iter().map(|part| part.entry).collect())
        }));
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
    /// A run that ends early leaves no half-written file.
    fn drop(&mut self) {
        if let Some(writer) = self.writer.take() {
            // The run has failed for another reason already, which is the one to tell.
            let _ = writer.join();
        }
    }
}
