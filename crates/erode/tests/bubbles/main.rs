//! Cases of bubbles in a liquid that is given, with the real program.

#![allow(clippy::unwrap_used)]

mod cloud;
mod common;
mod reproduce;
mod single;
mod sweep;
