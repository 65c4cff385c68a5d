//! Tests of reading cases.

use super::*;
use erode_physics::strength::Strength;
use erode_sph::{Geometry, shapes::Shape};

mod rules;
mod schema;

const NEAR_STEEL: &str = include_str!("../../../../cases/bubble-near-steel/case.toml");
const ATTACHED: &str = include_str!("../../../../cases/bubble-attached/case.toml");
const IN_LIQUID: &str = include_str!("../cli/templates/bubble-in-liquid.toml");
const GAS: &str = include_str!("../../../../cases/gas-rebound/case.toml");
const OWN_BODIES: &str = include_str!("../cli/templates/own-bodies.toml");

/// Everything that can be chosen and is not in the templates: a body of each, as bodies of a kind do not go together.
const UNUSUAL: [&str; 3] = [BALL, HOT, REST];
const BALL: &str = r#"
title = "quotes \" and \\ and µ"
[[body]]
name = "ball"
solid.material = "clay"
solid.density = "2 g/cm^3"
solid.elastic = { young_modulus = "1 GPa", poisson_ratio = 0.25 }
solid.strength.linear_hardening = { yield_stress = "1 MPa", hardening_modulus = "10 MPa" }
solid.velocity = [0, "-100 m/s"]
solid.formulation.joshi = { xsph = 0.5 }
shape.disc = { centre = [0, "2 mm"], radius = "1 mm" }
spacing.finest = "0.1 mm"
[run]
end_time = "1 us"
"#;
const HOT: &str = r#"
[[body]]
name = "hot"
solid.material = "steel_a2205"
solid.thermal_softening = true
solid.strength.johnson_cook = { m = 1, reference_temperature = "293.15 K", melting_temperature = "1700 K", heat_capacity = "500 J/(kg K)", taylor_quinney = 0.9 }
shape.rectangle = { lower = [0, "-1 mm"], upper = ["1 mm", "1 mm"] }
spacing = { finest = "0.1 mm", coarsest = "0.3 mm", growth = 0.1, core.disc = { centre = [0, 0], radius = "0.3 mm" } }
sides.right.non_reflecting = { wave = { pressure = "1 MPa", start = "3 ns" } }
[run]
end_time = "1 us"
max_steps = 12345678901
"#;
const REST: &str = r#"
[[body]]
name = "rest"
solid.material = "steel_a2205"
solid.strength.elastic = {}
shape.rectangle = { lower = ["2 mm", "-1 mm"], upper = ["3 mm", "1 mm"] }
spacing.finest = "0.1 mm"
[run]
end_time = "1 us"
"#;

fn read(text: &str, overrides: &[&str]) -> Simulation {
    let overrides: Vec<String> = overrides.iter().map(|s| (*s).to_owned()).collect();
    Case::parse("case.toml", text, &overrides).unwrap_or_else(|e| panic!("{e}"))
}

fn errors(text: &str, overrides: &[&str]) -> Vec<String> {
    let overrides: Vec<String> = overrides.iter().map(|s| (*s).to_owned()).collect();
    let errors = Case::parse("case.toml", text, &overrides).unwrap_err();
    errors
        .errors
        .iter()
        .map(|e| format!("{:?} {e} {}", e.position(), e.help.as_deref().unwrap_or("")))
        .collect()
}

#[test]
fn the_setup_of_the_thesis_expands_as_described() {
    let s = read(NEAR_STEEL, &[]);
    assert_eq!(s.geometry, Geometry::Axisymmetric);
    let (r, d, dx) = (1.5e-4, 1.33 * 1.5e-4, 1.5e-4 / 30.0);
    let liquid = s.body("liquid").unwrap();
    assert_eq!(
        liquid.shape,
        Shape::Rectangle {
            lower: [0.0, 0.0],
            upper: [8.0 * r, d + 4.0 * r]
        }
    );
    assert_eq!(
        liquid.holes,
        [Shape::Disc {
            centre: [0.0, d],
            radius: r
        }]
    );
    assert_eq!(
        (liquid.spacing.finest, liquid.spacing.coarsest),
        (dx, 8.0 * dx)
    );
    assert_eq!(liquid.sides.left, Side::Axis);
    assert_eq!(liquid.sides.right, Side::Rigid);
    assert_eq!(
        liquid.sides.bottom,
        Side::Interface {
            with: "wall".to_owned()
        }
    );
    let wave = Some(Wave {
        pressure: 50e6,
        start: 0.0,
    });
    assert_eq!(
        liquid.sides.top,
        Side::NonReflecting {
            pressure: 0.0,
            wave
        }
    );
    let wall = s.body("wall").unwrap();
    assert_eq!(
        wall.shape,
        Shape::Rectangle {
            lower: [0.0, -5.0 * r],
            upper: [8.0 * r, 0.0]
        }
    );
    let BodyKind::Solid(solid) = &wall.kind else {
        panic!("the wall is a solid")
    };
    let Strength::JohnsonCook(jc) = solid.strength else {
        panic!("the wall is Johnson-Cook")
    };
    // Joshi 2018, table 7.1.
    assert_eq!(
        (
            solid.density,
            solid.elastic.young_modulus,
            solid.elastic.poisson_ratio
        ),
        (7800.0, 186e9, 0.3)
    );
    assert_eq!(
        (jc.a, jc.b, jc.n, jc.c, jc.reference_rate, jc.thermal),
        (508e6, 832e6, 0.29, 0.031, 0.05, None)
    );
    let bubble = s.bubble.unwrap();
    assert_eq!(
        (bubble.centre, bubble.radius, bubble.wall_distance),
        ([0.0, d], r, Some(d))
    );
    // Step to the bubble's top over 3 R, 1.25 collapse times, 4 R at the speed of sound.
    let collapse = 0.915 * r * (1000.0_f64 / 50e6).sqrt();
    let end = 3.0 * r / 1500.0 + 1.25 * collapse + 4.0 * r / 1500.0;
    assert!((s.run.end_time / end - 1.0).abs() < 1e-12);
    assert_eq!(
        (s.output.fields_every, s.output.checkpoint_every),
        (40e-9, 100e-9)
    );
}

#[test]
fn switches_of_the_setup_reach_the_bodies() {
    let s = read(
        NEAR_STEEL,
        &[
            "setup.bubble_near_wall.strain_rate=false",
            "setup.bubble_near_wall.liquid_formulation.joshi.alpha=0.2",
            "setup.bubble_near_wall.wall_formulation.joshi={}",
            "geometry.plane={}",
        ],
    );
    let BodyKind::Fluid(f) = &s.bodies[0].kind else {
        panic!("the liquid is first")
    };
    assert_eq!(
        f.formulation,
        FluidFormulation::Joshi {
            alpha: 0.2,
            beta: 2.0
        }
    );
    let BodyKind::Solid(w) = &s.bodies[1].kind else {
        panic!("the wall is second")
    };
    assert_eq!(
        w.formulation,
        SolidFormulation::Joshi {
            alpha: 1.0,
            beta: 2.0,
            xsph: 0.0
        }
    );
    assert!(matches!(w.strength, Strength::JohnsonCook(jc) if jc.c == 0.0));
    assert_eq!(
        (s.geometry, &s.bodies[0].sides.left),
        (Geometry::Plane, &Side::Rigid)
    );
}

#[test]
fn resolved_reads_back_as_the_same_simulation() {
    let templates = [NEAR_STEEL, ATTACHED, IN_LIQUID, OWN_BODIES];
    for text in templates.into_iter().chain(UNUSUAL) {
        for overrides in [
            &[][..],
            &["run.end_time=3.3333333333333335e-7", "run.max_steps=7"],
        ] {
            let s = read(text, overrides);
            let resolved = resolved::write(&s);
            let again = Case::parse("resolved.toml", &resolved, &[])
                .unwrap_or_else(|e| panic!("{e}\n{resolved}"));
            assert_eq!(s, again);
            assert_eq!(resolved, resolved::write(&again));
        }
    }
}

#[test]
fn simulation_survives_serde() {
    let s = read(HOT, &[]);
    let json = serde_json::to_string(&s).unwrap();
    assert_eq!(serde_json::from_str::<Simulation>(&json).unwrap(), s);
}

#[test]
fn own_bodies_get_the_defaults_that_follow_from_their_place() {
    let left = |text: &str| read(text, &[]).bodies[0].sides.left.clone();
    assert_eq!(UNUSUAL.map(left), [Side::Axis, Side::Axis, Side::Free]);
    let s = read(HOT, &[]);
    let own = read(OWN_BODIES, &[]);
    assert_eq!(
        own.body("plate").unwrap().sides.bottom,
        Side::NonReflecting {
            pressure: 0.0,
            wave: None
        }
    );
    assert_eq!(s.run.max_steps, Some(12_345_678_901));
    let BodyKind::Solid(hot) = &s.body("hot").unwrap().kind else {
        panic!("hot is a solid")
    };
    let Strength::JohnsonCook(jc) = hot.strength else {
        panic!("hot is Johnson-Cook")
    };
    // Given on the spot and from the library, in one law.
    assert_eq!(
        (jc.a, jc.thermal.map(|t| t.heat_capacity)),
        (508e6, Some(500.0))
    );
}

#[test]
fn damage_is_asked_for_by_the_case_and_completed_by_the_library() {
    use erode_physics::damage::Damage;
    let with = |set: &[&str]| read(HOT, set).body("hot").unwrap().kind.clone();
    let of = |set: &[&str]| match with(set) {
        BodyKind::Solid(s) => s.damage,
        BodyKind::Fluid(_) => panic!("hot is a solid"),
    };
    assert_eq!(of(&[]), Damage::None);
    // A-2205 has a rupture strain in the library; the case may give another.
    let Damage::RuptureStrain(law) = of(&["body.hot.solid.damage.linear_modulus_loss={}"]) else {
        panic!("a rupture strain")
    };
    assert!(law.modulus_loss && law.rupture_strain == 0.25);
    let own = of(&["body.hot.solid.damage.rupture_strain.rupture_strain=0.03"]);
    let Damage::RuptureStrain(law) = own else {
        panic!("a rupture strain")
    };
    assert!(!law.modulus_loss && law.rupture_strain == 0.03);
}

#[test]
fn overrides_replace_add_and_address_blocks_by_name_or_number() {
    let s = read(
        NEAR_STEEL,
        &[
            "setup.bubble_near_wall.radius=0.2 mm",
            "probe.wall_centre.position=[0, \"20 um\"]",
            "probe.1.name=deep",
            "title=\"a = b\"",
            "setup.bubble_near_wall.liquid_formulation.joshi={}",
            "setup.bubble_near_wall.liquid_formulation.corrected.shifting=20",
        ],
    );
    assert_eq!(s.bubble.unwrap().radius, 2e-4);
    assert_eq!(s.probes[0].position, [0.0, 20e-6]);
    assert_eq!(
        (s.probes[1].name.as_str(), s.title.as_str()),
        ("deep", "a = b")
    );
    let BodyKind::Fluid(f) = &s.bodies[0].kind else {
        panic!("the liquid is first")
    };
    assert_eq!(
        f.formulation,
        FluidFormulation::Corrected {
            shifting: 20.0,
            refinement: None
        }
    );
}

#[test]
fn an_empty_list_takes_a_coating_away() {
    let layers = |set: &[&str]| {
        let s = read(NEAR_STEEL, set);
        let BodyKind::Solid(wall) = &s.bodies[1].kind else {
            panic!("the wall is second")
        };
        wall.layers.len()
    };
    let coated =
        "setup.bubble_near_wall.wall_layers=[{material=\"copper_ofhc\", thickness=\"20 um\"}]";
    assert_eq!(layers(&[coated]), 1);
    assert_eq!(
        layers(&[coated, "setup.bubble_near_wall.wall_layers=[]"]),
        0
    );
}

#[test]
fn errors_of_overrides_point_to_the_override() {
    let found = errors(
        NEAR_STEEL,
        &["run.endtime=1", "setup.bubble_near_wall.wall=steel_a2250"],
    );
    assert!(
        found[0].contains("\"--set\", 1, 5") && found[0].contains("did you mean `end_time`"),
        "{}",
        found[0]
    );
    assert!(
        found[1].contains("\"--set\", 1, 29") && found[1].contains("did you mean `steel_a2205`"),
        "{}",
        found[1]
    );
    assert_eq!(found.len(), 2);
}

#[test]
fn an_error_in_one_block_does_not_hide_those_in_others() {
    let found = errors(
        OWN_BODIES,
        &[
            "title=3",
            "geometry={ plain = {} }",
            "body.water.shape.rectangle.lower=[1, 1]",
            "body.water.hole=[{ disc = { centre = 0, radius = -1 } }]",
            "body.water.spacing.coarsest=1 um",
            "body.plate.solid.strain_rate=3",
            "body.plate.solid.material=steel_3161",
            "probe.0.position=[inf, 0]",
            "run.end_time=-1",
        ],
    )
    .join("\n");
    for phrase in [
        "`title` must be a text",
        "did you mean `plane`",
        "no area",
        "`centre` must be an array",
        "`radius` must be greater than zero",
        "smaller than `finest`",
        "`strain_rate` must be true or false",
        "did you mean `steel_316l`",
        "`position` must be finite",
        "`end_time` must be greater than zero",
    ] {
        assert!(found.contains(phrase), "{phrase}: {found}");
    }
    assert_eq!(found.lines().count(), 10, "{found}");
}

#[test]
fn a_case_can_complete_a_material_of_the_library() {
    let wall = "setup.bubble_near_wall.wall=titanium_6al4v";
    let found = errors(NEAR_STEEL, &[wall]);
    assert!(
        found[0].contains("it lacks solid.strength.johnson_cook.reference_rate"),
        "{}",
        found[0]
    );
    assert!(found[0].contains("strain_rate = false"), "{}", found[0]);
    let rate = "material.titanium_6al4v.solid.strength.johnson_cook.reference_rate=\"1 1/s\"";
    let s = read(NEAR_STEEL, &[wall, rate]);
    let BodyKind::Solid(w) = &s.bodies[1].kind else {
        panic!("the wall is second")
    };
    assert!(
        matches!(w.strength, Strength::JohnsonCook(jc) if jc.reference_rate == 1.0 && jc.b == 1092e6)
    );
    read(
        NEAR_STEEL,
        &[wall, "setup.bubble_near_wall.strain_rate=false"],
    );
}

#[test]
fn no_text_makes_the_reader_panic() {
    // Every prefix of a case, and every character replaced by ones that matter to the grammar.
    let whole =
        "[setup.bubble_in_liquid]\nradius = \"1 mm\"\npressure = 1e6\n[[probe]]\nname = \"µ\"\n";
    for (i, c) in whole.char_indices() {
        let _ = Case::parse("case.toml", &whole[..i], &[]);
        let _ = Case::parse("case.toml", NEAR_STEEL, &[whole[..i].to_owned()]);
        for new in ["", "\"", "[", "=", "\n", ".", "{", "-", "9", "µ"] {
            let text = format!("{}{new}{}", &whole[..i], &whole[i + c.len_utf8()..]);
            let _ = Case::parse("case.toml", &text, std::slice::from_ref(&text));
        }
    }
}
