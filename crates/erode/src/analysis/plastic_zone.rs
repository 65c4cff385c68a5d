//! How deep the metal yielded beneath the points of its surface.

use crate::report::map::nearest;

/// Plastic strain above which a particle counts as yielded: far above rounding, far below what any load leaves.
pub const YIELDED: f64 = 1e-6;

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
            let column = &mut depth[nearest(radii, x[0])];
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
        let column = &mut largest[nearest(radii, x[0])];
        *column = column.max(*strain);
    }
    largest
}

/// Plastic strain along a line parallel to the surface at the height `level`, m: at each of `radii` that of the nearest
/// particle. Empty without particles.
#[must_use]
pub fn along_level(
    position: &[[f64; 2]],
    plastic_strain: &[f64],
    level: f64,
    radii: &[f64],
) -> Vec<[f64; 2]> {
    let at = |r: &f64| {
        let gap = |x: &[f64; 2]| (x[0] - r).hypot(x[1] - level);
        let all = position.iter().zip(plastic_strain);
        let found = all.min_by(|a, b| gap(a.0).total_cmp(&gap(b.0)));
        found.map(|(_, strain)| [*r, *strain])
    };
    radii.iter().filter_map(at).collect()
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

    /// A field r + 100 depth: a line at one depth sees the growth along r alone, unlike the largest value of each column.
    #[test]
    fn a_line_at_one_depth_sees_that_depth_only() {
        let grid =
            (0..20).flat_map(|i| (0..20).map(move |j| [f64::from(i) + 0.5, -f64::from(j) - 0.5]));
        let position: Vec<[f64; 2]> = grid.collect();
        let strain: Vec<f64> = position.iter().map(|x| x[0] - 100.0 * x[1]).collect();
        let line = along_level(&position, &strain, -3.4, &[0.5, 7.5, 19.6]);
        assert_eq!(line, [[0.5, 350.5], [7.5, 357.5], [19.6, 369.5]]);
        assert_eq!(largest_in_column(&position, &strain, &[7.5])[0], 1969.5);
        assert!(along_level(&[], &[], 0.0, &[1.0]).is_empty());
    }
}
