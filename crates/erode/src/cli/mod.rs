//! Commands: what they are called, what they take, where they go.

mod args;
mod bench;
mod check;
mod environment;
mod failure;
mod format;
mod json;
mod materials;
mod names;
mod new;
mod progress;
mod reproduce;
mod run;
mod say;
mod status;
mod sweep;
mod validate;

use args::{Cli, Command};
use clap::Parser;
use failure::Outcome;
use std::process::ExitCode;

/// Reads the command line, runs the command, turns its outcome into an exit code.
pub(crate) fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(e) => {
            // Help and version are no errors; a wrong command line is wrong input.
            let code = if e.use_stderr() {
                failure::WRONG_INPUT
            } else {
                0
            };
            // Nothing can be reported when the terminal is gone.
            let _ = e.print();
            return ExitCode::from(code);
        }
    };
    match environment::check().and_then(|()| dispatch(&cli.command)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}

fn dispatch(command: &Command) -> Outcome {
    match command {
        Command::New(args) => new::new(args),
        Command::Check(args) => check::check(args),
        Command::Materials(args) => materials::materials(args),
        Command::Run(args) => run::run(args),
        Command::Resume(args) => run::resume(args),
        Command::Report(args) => status::report(args),
        Command::Sweep(args) => sweep::sweep(args),
        Command::Validate(args) => validate::run(args),
        Command::Reproduce(args) => reproduce::run(args),
        Command::Status(args) => status::status(args),
        Command::Bench(args) => bench::run(args),
    }
}
