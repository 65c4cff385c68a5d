//! What parts of a case ask of each other, what is advised against, and what a case is estimated to cost.

use super::*;

#[test]
fn relations_between_bodies_are_checked() {
    for (change, phrase) in [
        ("body.plate.name=water", "two bodies called `water`"),
        ("body.plate.shape.rectangle.upper=[2e-4, 1e-4]", "overlap"),
        ("body.plate.shape.rectangle.upper=[2e-4, -1e-5]", "gap"),
        ("body.plate.sides.top.free={}", "does not meet `water`"),
        (
            "body.water={ solid = { material = \"my_steel\", strain_rate = false } }",
            "`water` and `plate` are both solids",
        ),
        (
            "body.water.sides.bottom.interface.with=plates",
            "did you mean `plate`",
        ),
        ("body.water.sides.left.axis={}", "not the axis"),
        ("body.water.spacing.finest=1 mm", "does not fit"),
        ("body.water.spacing.coarsest=1 um", "smaller than `finest`"),
        ("body.water.shape.rectangle.upper=[-1, 1]", "no area"),
        (
            "body.water.hole=[{ disc = { centre = [\"5 mm\", 0], radius = \"0.1 mm\" } }]",
            "hole lies outside",
        ),
        (
            "bubble={ centre = [\"5 mm\", 0], radius = \"0.1 mm\", driving_pressure = 1 }",
            "outside the liquid",
        ),
        ("probe.0.position=[1, 1]", "lies outside `water`"),
        ("probe.0.body=watr", "did you mean `water`"),
        ("body=[]", "neither a setup nor a body"),
        ("bubble=[]", "must be a table"),
        ("geometry={ plane = {}, axisymmetric = {} }", "both"),
    ] {
        let found = errors(OWN_BODIES, &[change]).join("\n");
        assert!(found.contains(phrase), "{change}: {found}");
    }
}

#[test]
fn advice_names_what_will_mean_little() {
    let advice = |overrides: &[&str]| check_advice(&read(NEAR_STEEL, overrides)).join("\n");
    assert_eq!(advice(&[]), "");
    assert!(advice(&["setup.bubble_near_wall.particles_per_radius=8"]).contains("outline only"));
    assert!(advice(&["setup.bubble_near_wall.width=3"]).contains("below 4"));
    assert!(advice(&["run.end_time=0.5 us"]).contains("before the bubble can collapse"));
    assert!(advice(&["run.safety=3"]).contains("unstable"));
    // 40 um between particles at the far end of the wall, 5 um at the axis.
    let coated = |t: &str| {
        format!(
            "setup.bubble_near_wall.wall_layers=[{{material=\"copper_ofhc\", thickness=\"{t}\"}}]"
        )
    };
    let thin = advice(&[&coated("20 um")]);
    assert!(
        thin.contains("20 um thick, less than the spacing of 40 um at its far end"),
        "{thin}"
    );
    assert_eq!(advice(&[&coated("50 um")]), "");
    let gas = |pressure: &str| {
        let gas = format!("setup.bubble_in_liquid.gas={{pressure=\"{pressure}\"}}");
        check_advice(&read(GAS, &[&gas])).join("\n")
    };
    // 20 and 2 times the pressure of the liquid, exponent 1.4: at rest at 2.04 and 1.18 radii.
    assert!(gas("20 MPa").contains("2.04 radii") && gas("20 MPa").contains("2.5 radii"));
    assert_eq!(gas("2 MPa"), "");
}

#[test]
fn size_and_step_are_those_of_the_uniform_plate() {
    let e = estimate::estimate(&read(OWN_BODIES, &[]));
    // 0.2 mm x 1 mm at 10 um, twice.
    for n in &e.particles {
        assert!((n / 2000.0 - 1.0).abs() < 0.01, "{n}");
    }
    // 0.3 * 1.3 * 10 um over the longitudinal speed of E = 200 GPa, nu = 0.3, 7800 kg/m3: 5875 m/s.
    assert!(
        (e.step / (0.39 * 1e-5 / 5875.2) - 1.0).abs() < 1e-4,
        "{}",
        e.step
    );
    assert_eq!(e.limited_by, "plate");
    assert_eq!(e.steps, (1e-6 / e.step).ceil());
}

#[test]
fn gas_needs_a_form_that_has_it_and_a_wave_that_squeezes_it() {
    let gas = "setup.bubble_near_wall.gas={pressure=\"100 kPa\"}";
    let joshi = "setup.bubble_near_wall.liquid_formulation.joshi={}";
    let found = errors(NEAR_STEEL, &[gas, joshi]).join("\n");
    assert!(
        found.contains("published form of the liquid has no gas"),
        "{found}"
    );
    let found = errors(GAS, &["setup.bubble_in_liquid.liquid_formulation.joshi={}"]).join("\n");
    assert!(
        found.contains("published form of the liquid has no gas"),
        "{found}"
    );
    let driven = |p: &str| format!("setup.bubble_near_wall.gas={{pressure=\"{p}\"}}");
    for pressure in ["50 MPa", "60 MPa"] {
        let found = errors(NEAR_STEEL, &[&driven(pressure)]).join("\n");
        assert!(
            found.contains(&format!("the gas is at {pressure}, not less than")),
            "{found}"
        );
    }
    read(NEAR_STEEL, &[&driven("49 MPa")]);
}

/// The spacing that counts is that at the depth of a layer, not the finest of the body.
#[test]
fn a_layer_is_as_thick_as_the_particles_where_it_lies() {
    let layers = |depth: &str| {
        format!(
            "setup.bubble_near_wall.wall_layers=[{{material=\"copper_ofhc\", thickness=\"{depth}\"}}, {{material=\"copper_ofhc\", \
         thickness=\"6 um\"}}]"
        )
    };
    read(NEAR_STEEL, &[&layers("20 um")]);
    // Spacing 5 um down to 0.75 radii, growing by 0.06 below: 5 um + 0.06 x (303 - 112.5) um = 16.4 um.
    let found = errors(NEAR_STEEL, &[&layers("0.30000000000000004 mm")]).join("\n");
    assert!(
        found.contains("layer 2 (copper_ofhc) is 6 um thick, less than the particle spacing of 16.43 um at its depth"),
        "{found}"
    );
    let found = errors(NEAR_STEEL, &[&layers("0.75 mm")]).join("\n");
    assert!(
        found.contains("are 756 um thick together, the body is 750 um high"),
        "{found}"
    );
}
