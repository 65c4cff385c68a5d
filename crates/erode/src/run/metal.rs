//! What the metal suffered.

use crate::analysis::{YIELDED, absorbed_energy, plastic_volume};
use erode_sph::geometry::Vec2;
use erode_sph::solid::{Side, Solid};

/// What the metal suffered.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Metal {
    /// Largest plastic strain.
    pub max_plastic_strain: f64,
    /// Its distance from the axis and depth below the undeformed surface, m; not a number where nothing yielded.
    pub place: Vec2,
    /// Plastic work, J.
    pub plastic_work: f64,
    /// Volume that yielded, m3.
    pub plastic_volume: f64,
    /// Largest depth of the surface below its undeformed place relative to its rim (elastic part included), m.
    pub depth: f64,
}

impl Metal {
    /// Of a solid as it is now.
    #[must_use]
    pub fn of(s: &Solid) -> Self {
        let strain = &s.state.plastic_strain;
        let worst = (0..s.len())
            .max_by(|&a, &b| strain[a].total_cmp(&strain[b]))
            .unwrap_or(0);
        let at = s.reference.position[worst];
        let place = [at[0], s.block.upper[1] - at[1]];
        let volume = &s.reference.volume;
        Self {
            max_plastic_strain: strain[worst],
            place: if strain[worst] > YIELDED {
                place
            } else {
                [f64::NAN; 2]
            },
            plastic_work: absorbed_energy(&s.state.plastic_work, volume),
            plastic_volume: plastic_volume(strain, volume, YIELDED),
            depth: pit_depth(s),
        }
    }
}

/// Force that the solid puts on its indenter upwards, N (per metre in plane).
pub(crate) fn indenter_force(s: &Solid) -> f64 {
    -s.indenter_force()[1]
}

/// Depth of the deepest surface point below the mean of the outer third of the surface, what failed taken out, m.
fn pit_depth(s: &Solid) -> f64 {
    let Some(surface) = s.surface(Side::Top) else {
        return f64::NAN;
    };
    let sunk: Vec<f64> = (0..surface.position.len())
        .map(|j| {
            let height = if s.is_removed(surface.particle[j]) {
                ground(s, surface.reference_position[j][0], surface.width[j])
            } else {
                surface.position[j][1]
            };
            surface.reference_position[j][1] - height
        })
        .collect();
    let outer = &sunk[2 * sunk.len() / 3..];
    let rim = outer.iter().sum::<f64>() / outer.len() as f64;
    sunk.iter()
        .map(|d| d - rim)
        .fold(f64::NEG_INFINITY, f64::max)
}

/// Height of what is left in a column of the reference where the surface has failed, m.
fn ground(s: &Solid, column: f64, width: f64) -> f64 {
    (0..s.len())
        .filter(|&a| !s.is_removed(a))
        .filter(|&a| (s.reference.position[a][0] - column).abs() <= 0.5 * width)
        .map(|a| s.state.position[a][1] + 0.5 * s.reference.area[a].sqrt())
        .fold(s.block.lower[1], f64::max)
}

#[cfg(test)]
#[path = "metal_tests.rs"]
mod tests;
