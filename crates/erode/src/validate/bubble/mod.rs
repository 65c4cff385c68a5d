//! Validations of spherical bubbles.

mod acoustic;
mod rayleigh;
mod sampler;

pub(super) use acoustic::VALIDATION as ACOUSTIC;
pub(super) use rayleigh::VALIDATION as RAYLEIGH;

use super::Failure;

/// Rows of a reference table.
fn rows<const N: usize>(text: &str) -> Result<Vec<[f64; N]>, Failure> {
    let wrong =
        |line: &str| Failure::Absent(format!("a row of the reference is not understood: {line}"));
    let row = |line: &str| {
        let cells: Result<Vec<f64>, _> = line.split(',').map(str::parse).collect();
        let cells = cells.map_err(|_| wrong(line))?;
        <[f64; N]>::try_from(cells).map_err(|_| wrong(line))
    };
    text.lines().skip(1).map(row).collect()
}
