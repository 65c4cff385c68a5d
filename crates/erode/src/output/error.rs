//! What can go wrong with a run folder, as sentences.

use super::checkpoint::Refused;
use std::fmt::{Display, Write};
use std::io::{self, ErrorKind};
use std::path::PathBuf;

/// A failure to write or read something in a run folder. The text says what, where and why; [`OutputError::hint`] says
/// what to do about it.
#[derive(Debug, thiserror::Error)]
pub enum OutputError {
    /// The folder for a new run already holds something.
    #[error("the folder {path} is not empty, it holds {found}; nothing in it was changed")]
    Occupied {
        /// The folder.
        path: PathBuf,
        /// What it holds, in words.
        found: String,
        /// Whether what it holds is a run that can be continued.
        is_run: bool,
    },
    /// The path of a run folder is a file.
    #[error("{path} is a file, so it cannot be a run folder")]
    NotAFolder {
        /// The file.
        path: PathBuf,
    },
    /// The folder cannot be created or written to.
    #[error("the run folder {path} cannot be written: {}", in_words(.cause))]
    NotWritable {
        /// The folder.
        path: PathBuf,
        /// What the operating system said.
        cause: io::Error,
    },
    /// The folder is not one that Erode made.
    #[error("{path} is not a run folder: {missing} is missing")]
    NotARun {
        /// The folder.
        path: PathBuf,
        /// What was looked for.
        missing: String,
    },
    /// The case in the folder is no longer the one that the run began with.
    #[error("{path} was changed since the run began (-: as it was, +: as it is):\n{difference}")]
    CaseChanged {
        /// The file.
        path: PathBuf,
        /// What differs, line by line.
        difference: String,
    },
    /// Another process writes to the folder.
    #[error("the run folder {path} is in use by another process{}", .holder.map_or(String::new(), |pid| format!(" (number {pid})")))]
    Locked {
        /// The folder.
        path: PathBuf,
        /// Number of that process, when it is known.
        holder: Option<u32>,
    },
    /// A file could not be written.
    #[error("{path} could not be written: {}", in_words(.cause))]
    Write {
        /// The file.
        path: PathBuf,
        /// What the operating system said.
        cause: io::Error,
    },
    /// A file could not be read.
    #[error("{path} could not be read: {}", in_words(.cause))]
    Read {
        /// The file.
        path: PathBuf,
        /// What the operating system said.
        cause: io::Error,
    },
    /// A file does not have the form in which Erode writes it.
    #[error("{path} is not as Erode writes it: {what}")]
    Malformed {
        /// The file.
        path: PathBuf,
        /// The first thing that is wrong.
        what: String,
    },
    /// The data handed over for writing contradict themselves.
    #[error("`{name}` cannot be stored: {what}")]
    Content {
        /// Field, column or array.
        name: String,
        /// What is wrong with it.
        what: String,
    },
    /// No checkpoint can be used.
    #[error("there is no usable checkpoint in {folder}{}", listed(.refused))]
    NoCheckpoint {
        /// Where checkpoints were looked for.
        folder: PathBuf,
        /// The files that are there, each with the reason why it is refused.
        refused: Vec<Refused>,
    },
}

impl OutputError {
    /// What the user can do about it, as a sentence.
    pub fn hint(&self) -> String {
        match self {
            Self::Occupied { path, is_run: true, .. } => format!(
                "Continue that run with `erode resume {}`, or start the new one in another folder with `-o DIR`.",
                path.display()
            ),
            Self::Occupied { .. } => "Choose an empty or new folder with `-o DIR`.".into(),
            Self::NotAFolder { .. } | Self::NotWritable { .. } => "Choose another folder with `-o DIR`.".into(),
            Self::NotARun { .. } => "Give the folder that `erode run` printed when it started.".into(),
            Self::CaseChanged { path, .. } => format!(
                "A run goes on with the case that it began with: undo the change, or start a new run with `erode run {} -o DIR`.",
                path.display()
            ),
            Self::Locked { .. } => "Wait for it or stop it, or choose another folder with `-o DIR`.".into(),
            Self::Write { cause, .. } => write_hint(cause),
            Self::Read { .. } => "Check that the file is there and may be read.".into(),
            Self::Malformed { .. } => "The file was changed or is incomplete; restore it or run the case again.".into(),
            Self::Content { .. } => "This is a mistake in Erode; please report it with the case file.".into(),
            Self::NoCheckpoint { .. } => {
                "Start again with `erode run` on the `case.toml` of that folder and another `-o DIR`.".into()
            }
        }
    }

    pub(crate) fn content(name: &str, what: impl Into<String>) -> Self {
        Self::Content {
            name: name.into(),
            what: what.into(),
        }
    }
}

impl miette::Diagnostic for OutputError {
    fn help<'a>(&'a self) -> Option<Box<dyn Display + 'a>> {
        Some(Box::new(self.hint()))
    }
}

fn write_hint(cause: &io::Error) -> String {
    let first = match cause.kind() {
        ErrorKind::StorageFull | ErrorKind::QuotaExceeded => "Free some space",
        _ => "Make the folder writable again",
    };
    format!(
        "{first}, then continue with `erode resume DIR`: finished files, the checkpoints among them, are complete and \
         unchanged."
    )
}

/// The cause of an input or output error in plain words.
pub(crate) fn in_words(cause: &io::Error) -> String {
    match cause.kind() {
        ErrorKind::StorageFull => "the disk is full".into(),
        ErrorKind::QuotaExceeded => "the disk quota is used up".into(),
        ErrorKind::PermissionDenied => "permission is denied".into(),
        ErrorKind::ReadOnlyFilesystem => "the file system is read-only".into(),
        ErrorKind::NotFound => "there is no such file or folder".into(),
        ErrorKind::NotADirectory => "a part of the path is a file, not a folder".into(),
        ErrorKind::IsADirectory => "it is a folder, not a file".into(),
        ErrorKind::FileTooLarge => "the file would be larger than the system allows".into(),
        _ => cause.to_string(),
    }
}

fn listed(refused: &[Refused]) -> String {
    let mut text = String::new();
    for file in refused {
        // Writing to a String cannot fail.
        let _ = write!(text, "; {file}");
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_full_disk_reads_as_a_sentence_with_a_way_on() {
        let error = OutputError::Write {
            path: "out/checkpoints/a".into(),
            cause: ErrorKind::StorageFull.into(),
        };
        assert_eq!(
            error.to_string(),
            "out/checkpoints/a could not be written: the disk is full"
        );
        assert!(
            error
                .hint()
                .starts_with("Free some space, then continue with `erode resume")
        );
        assert!(miette::Diagnostic::help(&error).is_some());
    }

    #[test]
    fn a_denied_permission_is_named() {
        let error = OutputError::NotWritable {
            path: "out".into(),
            cause: ErrorKind::PermissionDenied.into(),
        };
        assert_eq!(
            error.to_string(),
            "the run folder out cannot be written: permission is denied"
        );
    }
}
