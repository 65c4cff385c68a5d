//! Files that are either complete or absent: written beside their name, flushed to the disk, then renamed.

use super::error::OutputError;
use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// Ending of a file that is still being written.
const TEMPORARY: &str = "tmp";

/// Writes the file `path` through `fill`. A reader sees the old file or the complete new one, after a crash as well;
/// when it fails, the old file is unchanged and nothing is left behind.
///
/// # Errors
/// [`OutputError::Write`] with the path and what the operating system said.
pub fn write_atomic(
    path: &Path,
    fill: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), OutputError> {
    let temporary = temporary_name(path);
    write_and_rename(path, &temporary, fill).map_err(|cause| {
        // The half-written file would keep a full disk full. Should removing it fail too, the first cause matters more
        // and `clean_temporaries` removes it later.
        let _ = fs::remove_file(&temporary);
        OutputError::Write {
            path: path.into(),
            cause,
        }
    })
}

/// Removes files that an interrupted [`write_atomic`] left in `folder`; returns how many.
///
/// # Errors
/// [`OutputError::Read`] if the folder cannot be listed, [`OutputError::Write`] if a file cannot be removed.
pub fn clean_temporaries(folder: &Path) -> Result<usize, OutputError> {
    let mut removed = 0;
    for path in list(folder)? {
        if path.extension().is_some_and(|ending| ending == TEMPORARY) && path.is_file() {
            fs::remove_file(&path).map_err(|cause| OutputError::Write {
                path: path.clone(),
                cause,
            })?;
            removed += 1;
        }
    }
    Ok(removed)
}

/// The entries of a folder, sorted by name.
pub(crate) fn list(folder: &Path) -> Result<Vec<PathBuf>, OutputError> {
    let error = |cause| OutputError::Read {
        path: folder.into(),
        cause,
    };
    let mut paths = Vec::new();
    for entry in fs::read_dir(folder).map_err(error)? {
        paths.push(entry.map_err(error)?.path());
    }
    paths.sort();
    Ok(paths)
}

fn temporary_name(path: &Path) -> PathBuf {
    let mut name = OsString::from(path);
    name.push(".");
    name.push(TEMPORARY);
    name.into()
}

fn write_and_rename(
    path: &Path,
    temporary: &Path,
    fill: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let mut writer = BufWriter::new(File::create(temporary)?);
    fill(&mut writer)?;
    let file = writer
        .into_inner()
        .map_err(io::IntoInnerError::into_error)?;
    file.sync_all()?;
    drop(file);
    fs::rename(temporary, path)?;
    sync_folder(path)
}

/// The rename itself survives a power failure only once the folder is on the disk.
fn sync_folder(path: &Path) -> io::Result<()> {
    match path.parent() {
        Some(folder) if cfg!(unix) && !folder.as_os_str().is_empty() => {
            File::open(folder)?.sync_all()
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failed_write_leaves_the_old_file_and_no_rest() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("status.json");
        write_atomic(&path, |w| w.write_all(b"old")).unwrap();
        let error = write_atomic(&path, |w| {
            w.write_all(b"half of the n")?;
            Err(io::ErrorKind::StorageFull.into())
        })
        .unwrap_err();
        assert!(
            error
                .to_string()
                .ends_with("status.json could not be written: the disk is full")
        );
        assert_eq!(fs::read(&path).unwrap(), b"old");
        assert_eq!(list(folder.path()).unwrap(), [path]);
    }

    /// /dev/full answers every write as a full disk does.
    #[cfg(target_os = "linux")]
    #[test]
    fn a_really_full_device_is_reported_and_the_old_file_kept() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("summary.json");
        fs::write(&path, "old").unwrap();
        std::os::unix::fs::symlink("/dev/full", temporary_name(&path)).unwrap();
        let error = write_atomic(&path, |w| w.write_all(&[1; 100_000])).unwrap_err();
        assert!(error.to_string().ends_with("the disk is full"), "{error}");
        assert_eq!(fs::read(&path).unwrap(), b"old");
        assert_eq!(list(folder.path()).unwrap(), [path]);
    }

    #[test]
    fn leftovers_are_cleaned_and_only_they() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("a.vtu.tmp"), "x").unwrap();
        fs::write(folder.path().join("a.vtu"), "x").unwrap();
        assert_eq!(clean_temporaries(folder.path()).unwrap(), 1);
        assert_eq!(list(folder.path()).unwrap(), [folder.path().join("a.vtu")]);
    }
}
