//! What all kinds of runs have in common: they advance, and end in one of three ways.

use super::RunError;
use super::drive::Ended;
use super::observer::Observer;
use crate::output::State;
use std::sync::atomic::AtomicBool;

/// A run in progress.
pub(super) trait Course {
    /// Advances to the end, or until it is asked to stop; whether it reached the end.
    fn advance(&mut self, stop: &AtomicBool, observer: &mut dyn Observer)
    -> Result<bool, RunError>;

    /// Last files, summary and report.
    fn complete(&mut self, observer: &mut dyn Observer) -> Result<Ended, RunError>;

    /// Writes a state to go on from.
    fn save(&mut self) -> Result<(), RunError>;

    /// Writes `status.json`.
    fn tell(&self, state: State, message: Option<&str>) -> Result<(), RunError>;

    /// Simulated time, s.
    fn time(&self) -> f64;

    /// Advances to the end, or until it is asked to stop or fails; `status.json` tells which.
    ///
    /// # Errors
    /// If the calculation fails or a file cannot be written.
    fn go(&mut self, stop: &AtomicBool, observer: &mut dyn Observer) -> Result<Ended, RunError> {
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
            // On a full disk the status may fail as well; the first error is the one to tell.
            let _ = self.tell(State::Failed, Some(&error.to_string()));
        }
        ended
    }

    /// Ends because it was asked to.
    fn interrupt(&mut self) -> Result<Ended, RunError> {
        self.save()?;
        self.tell(State::Interrupted, Some("asked to stop"))?;
        Ok(Ended::Interrupted { time: self.time() })
    }
}
