//! Errors of a case, each with its place in the text; all of one pass are kept together.

use miette::{Diagnostic, LabeledSpan, NamedSource, SourceCode};
use std::{fmt, path::Path, sync::Arc};

/// A place in one of the texts that make up a case.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Span {
    pub(crate) source: usize,
    pub(crate) start: usize,
    pub(crate) end: usize,
}

/// A text that the case is read from: the case file, a `--set`, a material file.
#[derive(Debug, Clone)]
pub(crate) struct Source {
    pub(crate) name: String,
    pub(crate) text: Arc<str>,
}

/// One thing wrong with a case.
#[derive(Debug, Clone)]
pub struct CaseError {
    /// What is wrong.
    pub message: String,
    /// What is allowed, or how to go on.
    pub help: Option<String>,
    place: Option<Box<Place>>,
}

#[derive(Debug, Clone)]
struct Place {
    source: NamedSource<Arc<str>>,
    start: usize,
    end: usize,
    line: usize,
    column: usize,
    label: String,
}

impl CaseError {
    /// An error about a file as a whole.
    pub(crate) fn whole(message: impl Into<String>, help: impl Into<String>) -> Self {
        Self {
            message: message.into(),
            help: Some(help.into()),
            place: None,
        }
    }

    /// The same error with the run of a sweep whose setting it is in; one in the case itself stays as it is.
    pub(crate) fn of_run(mut self, run: &str, sweep: &Path) -> Self {
        if self.position().is_some_and(|(name, ..)| name == "--set") {
            self.message = format!("run `{run}` of {}: {}", sweep.display(), self.message);
        }
        self
    }

    /// File (or `--set`), line and column, counted from 1, if the error has a place.
    #[must_use]
    pub fn position(&self) -> Option<(&str, usize, usize)> {
        self.place
            .as_ref()
            .map(|p| (p.source.name(), p.line, p.column))
    }
}

impl fmt::Display for CaseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for CaseError {}

impl Diagnostic for CaseError {
    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        self.help
            .as_ref()
            .map(|h| Box::new(h) as Box<dyn fmt::Display>)
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        self.place.as_ref().map(|p| &p.source as &dyn SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let p = self.place.as_ref()?;
        let label = Some(p.label.clone()).filter(|l| !l.is_empty());
        Some(Box::new(std::iter::once(LabeledSpan::new(
            label,
            p.start,
            p.end - p.start,
        ))))
    }
}

/// Everything wrong with a case.
#[derive(Debug, Clone)]
pub struct CaseErrors {
    /// The errors in the order of the text; never empty.
    pub errors: Vec<CaseError>,
}

impl From<CaseError> for CaseErrors {
    fn from(error: CaseError) -> Self {
        Self {
            errors: vec![error],
        }
    }
}

impl fmt::Display for CaseErrors {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, e) in self.errors.iter().enumerate() {
            if i > 0 {
                writeln!(f)?;
            }
            if let Some((name, line, column)) = e.position() {
                write!(f, "{name}:{line}:{column}: ")?;
            }
            write!(f, "{e}")?;
            if let Some(help) = &e.help {
                write!(f, " ({help})")?;
            }
        }
        Ok(())
    }
}

impl std::error::Error for CaseErrors {}

/// The texts of a case and the errors found so far.
#[derive(Debug, Default)]
pub(crate) struct Findings {
    pub(crate) sources: Vec<Source>,
    found: Vec<(Option<Span>, CaseError)>,
}

impl Findings {
    /// Adds a text and returns its number.
    pub(crate) fn add_source(&mut self, name: impl Into<String>, text: &str) -> usize {
        self.sources.push(Source {
            name: name.into(),
            text: text.into(),
        });
        self.sources.len() - 1
    }

    /// Records an error at a place.
    pub(crate) fn error(
        &mut self,
        span: Span,
        message: impl Into<String>,
        label: impl Into<String>,
        help: impl Into<String>,
    ) {
        let source = &self.sources[span.source];
        let start = char_floor(&source.text, span.start);
        let end = char_floor(&source.text, span.end).max(start);
        let before = &source.text[..start];
        let line = before.matches('\n').count() + 1;
        let column = before.chars().rev().take_while(|c| *c != '\n').count() + 1;
        let named = NamedSource::new(&source.name, Arc::clone(&source.text));
        let place = Some(Box::new(Place {
            source: named,
            start,
            end,
            line,
            column,
            label: label.into(),
        }));
        let help = Some(help.into()).filter(|h: &String| !h.is_empty());
        self.found.push((
            Some(span),
            CaseError {
                message: message.into(),
                help,
                place,
            },
        ));
    }

    /// Number of errors so far.
    pub(crate) fn count(&self) -> usize {
        self.found.len()
    }

    /// The errors in the order of the texts, or nothing.
    pub(crate) fn into_errors(mut self) -> Option<CaseErrors> {
        self.found
            .sort_by_key(|(span, _)| span.map(|s| (s.source, s.start)));
        let errors: Vec<CaseError> = self.found.into_iter().map(|(_, e)| e).collect();
        if errors.is_empty() {
            None
        } else {
            Some(CaseErrors { errors })
        }
    }
}

/// The nearest character boundary at or before `at`.
fn char_floor(text: &str, at: usize) -> usize {
    let mut i = at.min(text.len());
    while !text.is_char_boundary(i) {
        i -= 1;
    }
    i
}
