//! The front of Erode: case files, runs, reports.

pub mod analysis;
pub mod bench;
pub mod case;
pub mod erosion;
pub mod materials;
pub mod output;
pub mod report;
pub mod reproduce;
pub mod run;
pub mod sweep;
pub mod validate;
