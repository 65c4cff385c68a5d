//! One writer per run folder.
//!
//! The lock is that of the operating system on the file `.lock`, so it ends with the process, however that ends. The
//! file holds the number of the process; a number without a lock is what a killed process left (a stale lock).

use super::error::OutputError;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, ErrorKind, Read, Seek, Write};
use std::path::Path;

/// Name of the lock file in a run folder.
pub const LOCK_FILE: &str = ".lock";

/// Held while a process writes to a run folder; given back on drop.
#[derive(Debug)]
pub struct RunLock {
    file: File,
    /// Number of the process that had the folder before and ended without giving it back.
    pub stale: Option<u32>,
}

impl RunLock {
    /// Takes the lock of the existing folder `root`.
    ///
    /// # Errors
    /// [`OutputError::Locked`] if another process has it, [`OutputError::NotWritable`] if the file cannot be written.
    pub fn acquire(root: &Path) -> Result<Self, OutputError> {
        let error = |cause| OutputError::NotWritable {
            path: root.into(),
            cause,
        };
        let mut options = OpenOptions::new();
        options.read(true).write(true).create(true).truncate(false);
        let mut file = options.open(root.join(LOCK_FILE)).map_err(error)?;
        let before = read_pid(&mut file);
        match file.try_lock() {
            Ok(()) => {}
            Err(TryLockError::Error(cause))
                if cause.kind() == ErrorKind::Unsupported && !before.is_some_and(alive) => {}
            Err(TryLockError::Error(cause)) if cause.kind() != ErrorKind::Unsupported => {
                return Err(error(cause));
            }
            Err(_) => {
                return Err(OutputError::Locked {
                    path: root.into(),
                    holder: before,
                });
            }
        }
        write_pid(&mut file).map_err(error)?;
        Ok(Self {
            file,
            stale: before,
        })
    }
}

impl Drop for RunLock {
    fn drop(&mut self) {
        // Only tidiness: the lock itself ends with the file, and a number left behind is recognised as stale.
        let _ = self.file.set_len(0);
    }
}

/// Number of the process that writes to the run folder `root` now; `None` if there is none.
pub fn holder(root: &Path) -> Option<u32> {
    let mut file = File::open(root.join(LOCK_FILE)).ok()?;
    let pid = read_pid(&mut file)?;
    match file.try_lock_shared() {
        Ok(()) => None,
        Err(TryLockError::WouldBlock) => Some(pid),
        Err(TryLockError::Error(_)) => alive(pid).then_some(pid),
    }
}

/// For file systems without locks: whether a process of that number runs on this machine.
fn alive(pid: u32) -> bool {
    Path::new("/proc").join(pid.to_string()).exists()
}

fn read_pid(file: &mut File) -> Option<u32> {
    let mut text = String::new();
    file.read_to_string(&mut text).ok()?;
    text.trim().parse().ok()
}

fn write_pid(file: &mut File) -> io::Result<()> {
    file.set_len(0)?;
    file.rewind()?;
    writeln!(file, "{}", std::process::id())
}

/// Whether `path` is the lock file.
pub(crate) fn is_lock(path: &Path) -> bool {
    path.file_name().is_some_and(|name| name == LOCK_FILE)
        && fs::metadata(path).is_ok_and(|m| m.is_file())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_second_is_refused_until_the_first_gives_back() {
        let folder = tempfile::tempdir().unwrap();
        assert_eq!(holder(folder.path()), None);
        let first = RunLock::acquire(folder.path()).unwrap();
        assert_eq!(holder(folder.path()), Some(std::process::id()));
        let error = RunLock::acquire(folder.path()).unwrap_err();
        assert!(
            error
                .to_string()
                .contains(&format!("(number {})", std::process::id())),
            "{error}"
        );
        drop(first);
        assert_eq!(holder(folder.path()), None);
        assert_eq!(RunLock::acquire(folder.path()).unwrap().stale, None);
    }

    #[test]
    fn the_number_of_a_killed_process_is_recognised_as_stale() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join(LOCK_FILE), "4194999\n").unwrap();
        assert_eq!(holder(folder.path()), None);
        assert_eq!(
            RunLock::acquire(folder.path()).unwrap().stale,
            Some(4_194_999)
        );
    }
}
