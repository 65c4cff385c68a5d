//! Printing to the standard output.

use std::{
    fmt::Arguments,
    io::{self, ErrorKind, Write},
};

/// Prints a line as `println!` does, without its panic when the output cannot take it.
macro_rules! say {
    () => { $crate::cli::say::line(format_args!("")) };
    ($($arg:tt)*) => { $crate::cli::say::line(format_args!($($arg)*)) };
}
pub(crate) use say;

/// Prints a line. A reader that has gone away, as in `erode materials | head -1`, is no failure; a full disk is.
pub(crate) fn line(text: Arguments<'_>) {
    let Err(e) = writeln!(io::stdout().lock(), "{text}") else {
        return;
    };
    if e.kind() == ErrorKind::BrokenPipe {
        std::process::exit(0);
    }
    eprintln!("error: the output cannot be written: {e}");
    std::process::exit(i32::from(super::failure::FAILED));
}

/// Prints a line of progress. A run goes on when nobody can hear of it any more.
pub(crate) fn say_if_heard(text: &str) {
    let _ = writeln!(io::stdout().lock(), "{text}");
}
