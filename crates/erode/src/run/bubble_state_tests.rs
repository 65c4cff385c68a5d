use super::*;
use crate::case::Case;

/// A gas bubble that has grown beyond the window of an empty one is still measured as a whole.
#[test]
fn a_bubble_that_grew_is_measured_as_a_whole() {
    let text = include_str!("../../../../cases/gas-rebound/case.toml");
    let grown = |radius: f64, gas: bool| {
        let set = [
            "particles_per_radius=8".to_owned(),
            format!("radius={radius}"),
            "domain=6".to_owned(),
        ];
        let set = set.map(|s| format!("setup.bubble_in_liquid.{s}"));
        let simulation = Case::parse("case.toml", text, &set).unwrap();
        let world = crate::run::world(&simulation).unwrap();
        let now = simulation.bubble.unwrap();
        let first = Bubble {
            radius: 1e-4,
            gas: now.gas.filter(|_| gas),
            ..now
        };
        let spacing = simulation.bodies[0].spacing.finest;
        let state = bubble(&world, &first, 0.5 * spacing);
        equivalent_radius(state.volume, simulation.geometry)
    };
    // Eight particles per radius know it to a few percent.
    for radius in [1e-4, 1.6e-4, 2.2e-4] {
        let found = grown(radius, true);
        assert!((found / radius - 1.0).abs() < 0.03, "{radius}: {found}");
    }
    // Without gas it can only shrink, and the window is small.
    assert!(grown(2.2e-4, false) < 1.8e-4);
}
