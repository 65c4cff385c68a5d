//! Rows of reference tables whose columns are known by number.

use super::Failure;

/// The wanted columns of a table with one line of header.
pub(super) fn columns<const N: usize>(
    text: &str,
    wanted: [usize; N],
) -> Result<Vec<[f64; N]>, Failure> {
    text.lines().skip(1).map(|line| row(line, wanted)).collect()
}

fn row<const N: usize>(line: &str, wanted: [usize; N]) -> Result<[f64; N], Failure> {
    let cells: Vec<&str> = line.split(',').collect();
    let mut out = [0.0; N];
    for (value, column) in out.iter_mut().zip(wanted) {
        let parsed = cells.get(column).and_then(|c| c.trim().parse().ok());
        *value = parsed.ok_or_else(|| {
            Failure::Absent(format!("a row of the reference is not understood: {line}"))
        })?;
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wanted_columns_or_an_error() {
        assert_eq!(columns("a,b,c\n1,2,3\n", [2, 0]).unwrap(), [[3.0, 1.0]]);
        assert!(columns("a\nx\n", [0]).is_err() && columns("a\n1\n", [1]).is_err());
    }
}
