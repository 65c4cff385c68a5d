//! Runs of the real program: what they write, that they go on after any end, and what they say when they cannot.

#![allow(clippy::unwrap_used)] // a test may panic, its helpers too

mod cases;
mod common;
mod failures;
mod folders;
#[cfg(unix)]
mod resume;
