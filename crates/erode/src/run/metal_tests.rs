use super::*;
use crate::validate::steel_lattice::Lattice;
use erode_sph::Geometry;
use erode_sph::solid::{Face, Formulation};

const SPACING: f64 = 1e-5;
const COLUMNS: usize = 12;

/// A block at rest, 12 by 6 particles.
fn block() -> Solid {
    let lattice = Lattice {
        geometry: Geometry::Plane,
        size: [12.0 * SPACING, 6.0 * SPACING],
        spacing: SPACING,
        faces: [
            Face::Symmetry,
            Face::Symmetry,
            Face::Symmetry,
            Face::Traction,
        ],
        formulation: Formulation::TotalLagrangian,
    };
    lattice.build().unwrap()
}

#[test]
fn a_pit_is_as_deep_as_what_was_taken_out() {
    let mut solid = block();
    assert!(Metal::of(&solid).depth.abs() < 1e-12 * SPACING);
    // Two rows of the first column and one of the second are gone.
    for (column, row) in [(0, 5), (0, 4), (1, 5)] {
        solid.state.removed[row * COLUMNS + column] = 1.0;
    }
    let depth = Metal::of(&solid).depth;
    assert!((depth / SPACING - 2.0).abs() < 1e-9, "{depth}");
    // A column that is gone to its ground.
    for row in 0..4 {
        solid.state.removed[row * COLUMNS] = 1.0;
    }
    let depth = Metal::of(&solid).depth;
    assert!((depth / SPACING - 6.0).abs() < 1e-9, "{depth}");
}

#[test]
fn metal_that_did_not_yield_has_no_place_of_largest_strain() {
    let mut solid = block();
    solid.state.plastic_strain[2 * COLUMNS + 3] = 0.5 * YIELDED;
    let metal = Metal::of(&solid);
    assert!(metal.place.iter().all(|x| x.is_nan()) && metal.plastic_volume == 0.0);
    solid.state.plastic_strain[2 * COLUMNS + 3] = 1e-3;
    let metal = Metal::of(&solid);
    assert!(
        (metal.place[0] / SPACING - 3.5).abs() < 1e-9
            && (metal.place[1] / SPACING - 3.5).abs() < 1e-9
    );
    assert!((metal.plastic_volume / (SPACING * SPACING) - 1.0).abs() < 1e-9);
}
