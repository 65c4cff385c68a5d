//! The command line of Erode.
fn main() {}
