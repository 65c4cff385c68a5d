//! Runs of the real program: what they write, that they go on after any end, and what they say when they cannot.

mod cases;
mod common;
mod failures;
mod folders;
#[cfg(unix)]
mod resume;
