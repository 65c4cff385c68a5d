//! What a command ends with when it does not end well.

use erode::case::CaseErrors;
use erode::output::OutputError;
use miette::{Diagnostic, GraphicalReportHandler, GraphicalTheme};
use std::{io::IsTerminal, process::ExitCode};

/// Exit code: the case or the command line is wrong.
pub(crate) const WRONG_INPUT: u8 = 1;
/// Exit code: the run failed, or a tolerance was missed.
pub(crate) const FAILED: u8 = 2;

/// Exit code: interrupted, a checkpoint is written.
pub(crate) const INTERRUPTED: u8 = 3;

/// Outcome of a command.
pub(crate) type Outcome = Result<(), Failure>;

/// Why a command did not succeed.
#[derive(Debug)]
pub(crate) enum Failure {
    /// Errors with their places in a case.
    Case(CaseErrors),
    /// Anything else: exit code, what happened, what to do.
    Other {
        code: u8,
        message: String,
        help: String,
    },
}

impl From<CaseErrors> for Failure {
    fn from(errors: CaseErrors) -> Self {
        Self::Case(errors)
    }
}

impl From<OutputError> for Failure {
    /// A folder that was badly chosen is wrong input; files that cannot be written or read are a failure.
    fn from(error: OutputError) -> Self {
        use OutputError::{CaseChanged, Locked, NotAFolder, NotARun, NotWritable, Occupied};
        let code = match &error {
            Occupied { .. }
            | NotAFolder { .. }
            | NotWritable { .. }
            | NotARun { .. }
            | CaseChanged { .. }
            | Locked { .. } => WRONG_INPUT,
            _ => FAILED,
        };
        Self::Other {
            code,
            message: error.to_string(),
            help: error.hint(),
        }
    }
}

impl Failure {
    /// Something that was asked for failed.
    pub(crate) fn failed(message: impl Into<String>, help: impl Into<String>) -> Self {
        Self::Other {
            code: FAILED,
            message: message.into(),
            help: help.into(),
        }
    }

    /// Something wrong with what was asked.
    pub(crate) fn input(message: impl Into<String>, help: impl Into<String>) -> Self {
        Self::Other {
            code: WRONG_INPUT,
            message: message.into(),
            help: help.into(),
        }
    }

    /// Prints the failure and gives its exit code.
    pub(crate) fn report(&self) -> ExitCode {
        match self {
            Self::Case(errors) => {
                report_case(errors);
                ExitCode::from(WRONG_INPUT)
            }
            Self::Other {
                code,
                message,
                help,
            } => {
                eprintln!("error: {message}");
                if !help.is_empty() {
                    eprintln!("  help: {help}");
                }
                ExitCode::from(*code)
            }
        }
    }
}

fn report_case(errors: &CaseErrors) {
    let colour = std::io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none();
    let theme = if colour {
        GraphicalTheme::unicode()
    } else {
        GraphicalTheme::unicode_nocolor()
    };
    let handler = GraphicalReportHandler::new_themed(theme)
        .with_width(110)
        .with_links(false);
    for error in &errors.errors {
        let mut text = String::new();
        if handler
            .render_report(&mut text, error as &dyn Diagnostic)
            .is_err()
        {
            text = format!("{error}\n");
        }
        eprintln!("{}", text.trim_end_matches('\n'));
        eprintln!();
    }
    match errors.errors.len() {
        1 => eprintln!("1 error: nothing was run."),
        n => eprintln!("{n} errors: nothing was run."),
    }
}
