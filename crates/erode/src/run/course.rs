//! What all kinds of runs have in common: they advance, and end in one of three ways.

use super::RunError;
use super::drive::Ended;
use super::observer::{Observer, Progress};
use super::status;
use crate::output::{RunPaths, State, Summary};
use std::sync::atomic::AtomicBool;

/// A run in progress.
pub(super) trait Course {
    /// Advances to the end, or until it is asked to stop; whether it reached the end.
    fn advance(&mut self, stop: &AtomicBool, observer: &mut dyn Observer)
    -> Result<bool, RunError>;

    /// Writes a state to go on from.
    fn write_checkpoint(&mut self) -> Result<(), RunError>;

    /// Brings to the disk what is still being written beside the calculation.
    fn settle(&mut self) -> Result<(), RunError> {
        Ok(())
    }

    /// Where it stands.
    fn progress(&self) -> Progress<'_>;

    /// Writes files that only the end has; its final numbers and a sentence about them.
    fn results(&mut self) -> Result<(Summary, String), RunError>;

    /// Its folder.
    fn paths(&self) -> &RunPaths;

    /// Hash of `resolved.toml`.
    fn hash(&self) -> &str;

    /// Advances to the end, or until it is asked to stop or fails; `status.json` tells which.
    ///
    /// # Errors
    /// If the calculation fails or a file cannot be written.
    fn go(&mut self, stop: &AtomicBool, observer: &mut dyn Observer) -> Result<Ended, RunError> {
        observer.begin(&self.progress());
        let ended = self.advance(stop, observer);
        observer.finish();
        let ended = match ended {
            Ok(true) => self.complete(observer),
            Ok(false) => self.interrupt(),
            Err(error) => Err(error),
        };
        if let Err(error) = &ended
            && !matches!(error, RunError::Report(_))
        {
            // On a full disk these may fail as well; the first error is the one to end with.
            if let Err(another) = self.settle() {
                observer.say(&format!("the last snapshot is not listed: {another}"));
            }
            let _ = self.write_status(State::Failed, Some(&error.to_string()));
        }
        ended
    }

    /// Ends at the end time.
    fn complete(&mut self, observer: &mut dyn Observer) -> Result<Ended, RunError> {
        self.write_checkpoint()?;
        let (mut summary, words) = self.results()?;
        summary.set_input_hash("resolved.toml", self.hash());
        summary.write(&self.paths().summary())?;
        self.write_status(State::Done, None)?;
        observer.say(&words);
        let report = crate::report::build(self.paths().root())?;
        Ok(Ended::Done { report })
    }

    /// Ends because it was asked to.
    fn interrupt(&mut self) -> Result<Ended, RunError> {
        self.write_checkpoint()?;
        self.write_status(State::Interrupted, Some("asked to stop"))?;
        let time = self.progress().time;
        Ok(Ended::Interrupted { time })
    }

    /// Writes `status.json`.
    fn write_status(&self, state: State, message: Option<&str>) -> Result<(), RunError> {
        let status = status::of(&self.progress(), state, message);
        Ok(status.write(&self.paths().status())?)
    }
}
