//! A bar on a terminal, plain lines elsewhere.

use super::say::say_if_heard;
use indicatif::{ProgressBar, ProgressStyle};
use std::io::IsTerminal;
use std::time::{Duration, Instant};

/// Positions of the bar: per mille of the work.
const BAR: u64 = 1000;
/// Without a terminal, one line of progress in so many seconds.
const LINE_EVERY: Duration = Duration::from_secs(10);

/// What is shown while something is computed.
pub(crate) struct Screen {
    bar: Option<ProgressBar>,
    line: Option<Instant>,
}

impl Screen {
    pub(crate) fn new() -> Self {
        let bar = std::io::stderr().is_terminal().then(|| {
            let bar = ProgressBar::new(BAR);
            let style = ProgressStyle::with_template("[{bar:30}] {percent}% {msg}");
            bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
            bar
        });
        Self { bar, line: None }
    }

    /// A sentence.
    pub(crate) fn say(&self, text: &str) {
        match &self.bar {
            Some(bar) => bar.println(text),
            None => say_if_heard(text),
        }
    }

    /// Where it stands: part that is done, and words; as a line at once if it is `news`, else now and then.
    pub(crate) fn show(&mut self, done: f64, text: String, news: bool) {
        match &self.bar {
            Some(bar) => {
                bar.set_position((done * BAR as f64) as u64);
                bar.set_message(text);
            }
            None if news || self.line.is_none_or(|l| l.elapsed() >= LINE_EVERY) => {
                self.line = Some(Instant::now());
                say_if_heard(&text);
            }
            None => {}
        }
    }

    /// Takes the bar away.
    pub(crate) fn finish(&mut self) {
        if let Some(bar) = self.bar.take() {
            bar.finish_and_clear();
        }
    }
}
