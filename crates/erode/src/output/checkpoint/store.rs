//! The folder of checkpoints: the last two are kept, the newest that is whole is loaded.

use super::{Checkpoint, Refusal, Refused, format};
use crate::output::atomic::{clean_temporaries, list, write_atomic};
use crate::output::error::OutputError;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

/// How many checkpoints are kept.
pub const KEPT: usize = 2;
const ENDING: &str = "erode";
/// Ending of refused files that were set aside.
const ASIDE: &str = "refused";

/// The checkpoints of a run.
#[derive(Debug, Clone)]
pub struct CheckpointStore {
    folder: PathBuf,
}

/// The newest usable checkpoint.
#[derive(Debug)]
pub struct Loaded {
    /// It.
    pub checkpoint: Checkpoint,
    /// Its file.
    pub path: PathBuf,
    /// Newer files that are not used, newest first; to be shown to the user.
    pub refused: Vec<Refused>,
}

impl CheckpointStore {
    /// The checkpoints in the existing folder `folder`.
    pub fn new(folder: impl Into<PathBuf>) -> Self {
        Self {
            folder: folder.into(),
        }
    }

    /// Writes a checkpoint and, once it is safely on the disk, removes all but the newest [`KEPT`]. When it fails, the
    /// earlier checkpoints are intact. Returns the file.
    ///
    /// # Errors
    /// [`OutputError::Write`], [`OutputError::Content`].
    pub fn write(&self, checkpoint: &Checkpoint) -> Result<PathBuf, OutputError> {
        let step = checkpoint.meta.step;
        let path = self.folder.join(format!("checkpoint_{step:012}.{ENDING}"));
        let bytes = format::encode(checkpoint)?;
        write_atomic(&path, |file| file.write_all(&bytes))?;
        // Files of later steps are refused ones that nobody set aside; they are neither counted nor touched.
        let older = self
            .files()?
            .into_iter()
            .filter(|file| step_of(file).is_some_and(|other| other <= step));
        for old in older.skip(KEPT) {
            fs::remove_file(&old).map_err(|cause| OutputError::Write { path: old, cause })?;
        }
        Ok(path)
    }

    /// Loads the newest checkpoint that is whole and of the case with fingerprint `case_hash`. Half-written files of a
    /// killed process are not looked at.
    ///
    /// # Errors
    /// [`OutputError::NoCheckpoint`] with every file and the reason why it is refused; [`OutputError::Read`] if the
    /// folder cannot be listed.
    pub fn load_newest(&self, case_hash: &str) -> Result<Loaded, OutputError> {
        let mut refused = Vec::new();
        for path in self.files()? {
            match load(&path, case_hash) {
                Ok(checkpoint) => {
                    return Ok(Loaded {
                        checkpoint,
                        path,
                        refused,
                    });
                }
                Err(reason) => refused.push(Refused { path, reason }),
            }
        }
        Err(OutputError::NoCheckpoint {
            folder: self.folder.clone(),
            refused,
        })
    }

    /// Renames refused files (`.refused` is appended), so that they are neither loaded nor counted nor lost when the run
    /// goes on, and removes half-written ones. Returns the new names.
    ///
    /// # Errors
    /// [`OutputError::Write`], [`OutputError::Read`].
    pub fn set_aside(&self, refused: &[Refused]) -> Result<Vec<PathBuf>, OutputError> {
        clean_temporaries(&self.folder)?;
        refused
            .iter()
            .map(|file| rename_aside(&file.path))
            .collect()
    }

    /// All checkpoint files, newest first; those whose name tells no step come last.
    fn files(&self) -> Result<Vec<PathBuf>, OutputError> {
        let mut files = list(&self.folder)?;
        files.retain(|path| path.extension().is_some_and(|ending| ending == ENDING));
        files.sort_by_key(|path| std::cmp::Reverse(step_of(path)));
        Ok(files)
    }
}

fn load(path: &Path, case_hash: &str) -> Result<Checkpoint, Refusal> {
    let bytes = fs::read(path).map_err(Refusal::Unreadable)?;
    let checkpoint = format::decode(&bytes)?;
    if checkpoint.meta.case_hash == case_hash {
        Ok(checkpoint)
    } else {
        Err(Refusal::OtherCase {
            found: checkpoint.meta.case_hash,
            expected: case_hash.into(),
        })
    }
}

fn step_of(path: &Path) -> Option<u64> {
    path.file_stem()?
        .to_str()?
        .strip_prefix("checkpoint_")?
        .parse()
        .ok()
}

fn rename_aside(path: &Path) -> Result<PathBuf, OutputError> {
    let mut name = OsString::from(path);
    name.push(".");
    name.push(ASIDE);
    let aside = PathBuf::from(name);
    fs::rename(path, &aside).map_err(|cause| OutputError::Write {
        path: path.into(),
        cause,
    })?;
    Ok(aside)
}

#[cfg(test)]
mod tests {
    use super::super::CheckpointMeta;
    use super::*;
    use tempfile::TempDir;

    fn at(step: u64) -> Checkpoint {
        let (code_version, case_hash) = ("0.1.0".into(), "this".into());
        let meta = CheckpointMeta {
            code_version,
            case_hash,
            time: step as f64,
            step,
            extra: serde_json::Value::Null,
        };
        let mut checkpoint = Checkpoint::new(meta);
        checkpoint.push("density", vec![step as f64; 100]).unwrap();
        checkpoint
    }

    fn store() -> (TempDir, CheckpointStore) {
        let folder = tempfile::tempdir().unwrap();
        let store = CheckpointStore::new(folder.path());
        (folder, store)
    }

    fn damage(path: &Path) {
        let mut bytes = fs::read(path).unwrap();
        let middle = bytes.len() / 2;
        bytes[middle] ^= 4;
        fs::write(path, bytes).unwrap();
    }

    #[test]
    fn the_newest_two_are_kept_and_the_newest_is_loaded() {
        let (_folder, store) = store();
        for step in [5, 10, 1_000_000_000_000, 1_000_000_000_001] {
            store.write(&at(step)).unwrap();
        }
        assert_eq!(store.files().unwrap().len(), KEPT);
        let loaded = store.load_newest("this").unwrap();
        assert_eq!(loaded.checkpoint, at(1_000_000_000_001));
        assert!(loaded.refused.is_empty());
    }

    #[test]
    fn a_damaged_one_is_refused_by_name_and_the_previous_one_used() {
        let (_folder, store) = store();
        store.write(&at(1)).unwrap();
        let newest = store.write(&at(2)).unwrap();
        damage(&newest);
        let loaded = store.load_newest("this").unwrap();
        assert_eq!(loaded.checkpoint, at(1));
        let text = loaded.refused[0].to_string();
        assert!(
            text.contains("checkpoint_000000000002.erode is refused: array 1 of 1 is damaged"),
            "{text}"
        );
        // Set aside, it does not push out the whole one when the run goes on.
        store.set_aside(&loaded.refused).unwrap();
        store.write(&at(3)).unwrap();
        assert_eq!(store.load_newest("this").unwrap().checkpoint, at(3));
        damage(&store.files().unwrap()[0]);
        assert_eq!(store.load_newest("this").unwrap().checkpoint, at(1));
        assert!(newest.with_extension("erode.refused").exists());
    }

    #[test]
    fn foreign_files_and_other_cases_have_their_own_sentences() {
        let (folder, store) = store();
        store.write(&at(1)).unwrap();
        fs::write(
            folder.path().join("checkpoint_000000000002.erode"),
            "PK\x03\x04 something else",
        )
        .unwrap();
        fs::write(folder.path().join("notes.erode"), "").unwrap();
        let error = store.load_newest("that").unwrap_err();
        let text = error.to_string();
        assert!(
            text.contains(
                "checkpoint_000000000002.erode is refused: it is not an Erode checkpoint"
            ),
            "{text}"
        );
        assert!(
            text.contains("its case hash is this, that of this case is that"),
            "{text}"
        );
        assert!(
            text.contains("notes.erode is refused: it is cut short: 0 of 32 bytes"),
            "{text}"
        );
        assert_eq!(store.load_newest("this").unwrap().refused.len(), 1);
    }

    #[test]
    fn no_checkpoint_at_all_says_so() {
        let (_folder, store) = store();
        let error = store.load_newest("this").unwrap_err();
        assert!(
            error
                .to_string()
                .starts_with("there is no usable checkpoint in "),
            "{error}"
        );
    }

    /// What SIGKILL leaves at any moment of writing: some bytes under the temporary name, the old files whole.
    #[test]
    fn half_written_files_are_ignored_and_cleaned() {
        let (folder, store) = store();
        store.write(&at(1)).unwrap();
        let whole = fs::read(store.write(&at(2)).unwrap()).unwrap();
        let temporary = folder.path().join("checkpoint_000000000003.erode.tmp");
        fs::write(&temporary, &whole[..whole.len() / 2]).unwrap();
        let loaded = store.load_newest("this").unwrap();
        assert_eq!((loaded.checkpoint, loaded.refused.len()), (at(2), 0));
        store.set_aside(&loaded.refused).unwrap();
        assert!(!temporary.exists());
    }

    /// /dev/full answers every write as a full disk does.
    #[cfg(target_os = "linux")]
    #[test]
    fn a_full_disk_leaves_the_earlier_checkpoints() {
        let (folder, store) = store();
        store.write(&at(1)).unwrap();
        store.write(&at(2)).unwrap();
        let temporary = folder.path().join("checkpoint_000000000003.erode.tmp");
        std::os::unix::fs::symlink("/dev/full", temporary).unwrap();
        let error = store.write(&at(3)).unwrap_err();
        assert!(
            error
                .to_string()
                .contains("checkpoint_000000000003.erode could not be written: the disk is full")
        );
        assert!(
            error.hint().contains("`erode resume DIR`") && error.hint().contains("checkpoints")
        );
        assert_eq!(store.load_newest("this").unwrap().checkpoint, at(2));
        assert_eq!(store.files().unwrap().len(), KEPT);
    }
}
