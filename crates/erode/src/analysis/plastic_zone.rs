//! How deep the metal yielded beneath the points of its surface.

/// Depth of the deepest particle with a plastic strain above `yielded`, m, in the column of each of `radii` (increasing,
/// m): a particle belongs to the nearest radius. Zero where nothing yielded. `position` (r, z) in m, `top` height of the
/// surface.
#[must_use]
pub fn zone_depth(
    position: &[[f64; 2]],
    plastic_strain: &[f64],
    top: f64,
    radii: &[f64],
    yielded: f64,
) -> Vec<f64> {
    let mut depth = vec![0.0_f64; radii.len()];
    if radii.is_empty() {
        return depth;
    }
    for (x, strain) in position.iter().zip(plastic_strain) {
        if *strain > yielded {
            let column = &mut depth[crate::report::map::nearest(radii, x[0])];
            *column = column.max(top - x[1]);
        }
    }
    depth
}

/// Largest plastic strain in the column of each of `radii`, as for [`zone_depth`].
#[must_use]
pub fn largest_in_column(position: &[[f64; 2]], plastic_strain: &[f64], radii: &[f64]) -> Vec<f64> {
    let mut largest = vec![0.0_f64; radii.len()];
    if radii.is_empty() {
        return largest;
    }
    for (x, strain) in position.iter().zip(plastic_strain) {
        let column = &mut largest[crate::report::map::nearest(radii, x[0])];
        *column = column.max(*strain);
    }
    largest
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A zone under a parabola: depth 20 (1 - (r/10)^2).
    #[test]
    fn the_outline_of_a_zone_is_found() {
        let mut position = Vec::new();
        let mut strain = Vec::new();
        for i in 0..20 {
            for j in 0..40 {
                let (r, depth) = (f64::from(i) + 0.5, f64::from(j) + 0.5);
                let inside = depth < 20.0 * (1.0 - (r / 10.0).powi(2));
                position.push([r, 5.0 - depth]);
                strain.push(if inside { 1e-3 * depth } else { 0.0 });
            }
        }
        let radii: Vec<f64> = (0..20).map(|i| f64::from(i) + 0.5).collect();
        let depth = zone_depth(&position, &strain, 5.0, &radii, 1e-6);
        for (r, d) in radii.iter().zip(&depth) {
            let exact = (20.0 * (1.0 - (r / 10.0).powi(2))).max(0.0);
            assert!((d - exact).abs() <= 1.0, "{r}: {d} {exact}");
        }
        let largest = largest_in_column(&position, &strain, &radii);
        assert!((largest[0] - 1e-3 * depth[0]).abs() < 1e-15 && largest[15] == 0.0);
        assert!(zone_depth(&position, &strain, 5.0, &[], 1e-6).is_empty());
    }
}
