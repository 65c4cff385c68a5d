//! The front of Erode: case files, runs, reports.

pub mod output;
pub mod report;
