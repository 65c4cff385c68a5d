//! The parts of a simulation under the keys of a case file.

use super::{
    body::named,
    bubbles::single_bubble_items,
    cloud::bubble_cloud_items,
    impacts::impacts_items,
    resolved::{Item, Items},
    resolved_loads::load_items,
    simulation::{
        Body, BodyKind, Bubble, Fluid, FluidFormulation, Layer, Probe, Side, Sides, Simulation,
        Solid, SolidFormulation,
    },
};
use erode_physics::damage::Damage;
use erode_physics::strength::{JohnsonCook, Strength};
use erode_sph::{Geometry, packing::Spacing, shapes::Shape};

/// The whole case.
pub(crate) fn case_items(s: &Simulation) -> Items {
    if let Some(bubble) = &s.single_bubble {
        return bubble_case_items(
            s,
            choice("single_bubble", single_bubble_items(bubble)),
            false,
        );
    }
    if let Some(cloud) = &s.bubble_cloud {
        return bubble_case_items(s, choice("bubble_cloud", bubble_cloud_items(cloud)), true);
    }
    let geometry = match s.geometry {
        Geometry::Axisymmetric => "axisymmetric",
        Geometry::Plane => "plane",
    };
    let mut run = vec![
        ("end_time", Item::Number(s.run.end_time)),
        ("safety", Item::Number(s.run.safety)),
    ];
    run.extend(s.run.max_steps.map(|n| ("max_steps", Item::Whole(n))));
    let output = vec![
        ("fields_every", Item::Number(s.output.fields_every)),
        ("history_every", Item::Number(s.output.history_every)),
    ];
    let mut items = vec![
        ("title", Item::Text(s.title.clone())),
        ("geometry", choice(geometry, Vec::new())),
    ];
    items.push((
        "body",
        Item::List(s.bodies.iter().map(body_items).collect()),
    ));
    items.extend(s.bubble.map(|b| ("bubble", Item::Table(bubble_items(&b)))));
    items.extend(load_items(&s.loads));
    items.extend(
        s.impacts
            .as_ref()
            .map(|i| ("impacts", Item::Table(impacts_items(i)))),
    );
    items.push(("run", Item::Table(run)));
    items.push(("output", Item::Table(output)));
    items.push((
        "checkpoint",
        Item::Table(vec![("every", Item::Number(s.output.checkpoint_every))]),
    ));
    items.push((
        "probe",
        Item::List(s.probes.iter().map(probe_items).collect()),
    ));
    items
}

/// A case of bubbles without bodies.
fn bubble_case_items(s: &Simulation, setup: Item, fields: bool) -> Items {
    let mut run = vec![("end_time", Item::Number(s.run.end_time))];
    run.extend(s.run.max_steps.map(|n| ("max_steps", Item::Whole(n))));
    let mut output = vec![("history_every", Item::Number(s.output.history_every))];
    if fields {
        output.push(("fields_every", Item::Number(s.output.fields_every)));
    }
    let every = ("every", Item::Number(s.output.checkpoint_every));
    vec![
        ("title", Item::Text(s.title.clone())),
        ("setup", setup),
        ("run", Item::Table(run)),
        ("output", Item::Table(output)),
        ("checkpoint", Item::Table(vec![every])),
    ]
}

fn choice(name: &'static str, items: Items) -> Item {
    Item::Table(vec![(name, Item::Table(items))])
}

fn bubble_items(b: &Bubble) -> Items {
    let mut items = vec![
        ("centre", Item::Pair(b.centre)),
        ("radius", Item::Number(b.radius)),
    ];
    items.extend(b.wall_distance.map(|d| ("wall_distance", Item::Number(d))));
    items.push(("driving_pressure", Item::Number(b.driving_pressure)));
    items.extend(b.gas.map(|g| {
        let gas = vec![
            ("pressure", Item::Number(g.pressure)),
            ("polytropic_exponent", Item::Number(g.polytropic_exponent)),
        ];
        ("gas", Item::Table(gas))
    }));
    items
}

fn probe_items(p: &Probe) -> Items {
    vec![
        ("name", Item::Text(p.name.clone())),
        ("body", Item::Text(p.body.clone())),
        ("position", Item::Pair(p.position)),
    ]
}

fn body_items(b: &Body) -> Items {
    let kind = match &b.kind {
        BodyKind::Fluid(f) => ("fluid", Item::Table(fluid_items(f))),
        BodyKind::Solid(s) => ("solid", Item::Table(solid_items(s))),
    };
    let mut items = vec![
        ("name", Item::Text(b.name.clone())),
        kind,
        ("shape", shape_item(&b.shape)),
    ];
    if !b.holes.is_empty() {
        let holes = b.holes.iter().map(|h| vec![shape_alternative(h)]);
        items.push(("hole", Item::List(holes.collect())));
    }
    items.push(("spacing", Item::Table(spacing_items(&b.spacing))));
    items.push(("sides", Item::Table(sides_items(&b.sides))));
    items
}

fn shape_item(shape: &Shape) -> Item {
    Item::Table(vec![shape_alternative(shape)])
}

fn shape_alternative(shape: &Shape) -> (&'static str, Item) {
    match *shape {
        Shape::Rectangle { lower, upper } => (
            "rectangle",
            Item::Table(vec![
                ("lower", Item::Pair(lower)),
                ("upper", Item::Pair(upper)),
            ]),
        ),
        Shape::Disc { centre, radius } => (
            "disc",
            Item::Table(vec![
                ("centre", Item::Pair(centre)),
                ("radius", Item::Number(radius)),
            ]),
        ),
    }
}

fn spacing_items(s: &Spacing) -> Items {
    let mut items = vec![
        ("finest", Item::Number(s.finest)),
        ("coarsest", Item::Number(s.coarsest)),
        ("growth", Item::Number(s.growth)),
    ];
    items.extend(s.core.as_ref().map(|c| ("core", shape_item(c))));
    items
}

fn sides_items(sides: &Sides) -> Items {
    named(sides)
        .into_iter()
        .map(|(name, side)| (name, side_item(side)))
        .collect()
}

fn side_item(side: &Side) -> Item {
    match side {
        Side::Axis => choice("axis", Vec::new()),
        Side::Rigid => choice("rigid", Vec::new()),
        Side::Clamped => choice("clamped", Vec::new()),
        Side::Free => choice("free", Vec::new()),
        Side::Interface { with } => choice("interface", vec![("with", Item::Text(with.clone()))]),
        Side::NonReflecting { pressure, wave } => {
            let mut items = vec![("pressure", Item::Number(*pressure))];
            items.extend(wave.map(|w| {
                let wave = vec![
                    ("pressure", Item::Number(w.pressure)),
                    ("start", Item::Number(w.start)),
                ];
                ("wave", Item::Table(wave))
            }));
            choice("non_reflecting", items)
        }
    }
}

fn fluid_items(f: &Fluid) -> Items {
    let tait = vec![
        ("reference_density", Item::Number(f.eos.reference_density)),
        ("sound_speed", Item::Number(f.eos.sound_speed)),
        ("gamma", Item::Number(f.eos.gamma)),
    ];
    let formulation = match f.formulation {
        FluidFormulation::Corrected {
            shifting,
            refinement,
        } => {
            let mut items = vec![("shifting", Item::Number(shifting))];
            items.extend(refinement.map(|r| {
                let of = vec![
                    ("per_radius", Item::Number(r.per_radius)),
                    ("growth", Item::Number(r.growth)),
                    ("smallest", Item::Number(r.smallest)),
                ];
                ("refinement", Item::Table(of))
            }));
            choice("corrected", items)
        }
        FluidFormulation::Joshi { alpha, beta } => choice(
            "joshi",
            vec![("alpha", Item::Number(alpha)), ("beta", Item::Number(beta))],
        ),
    };
    vec![
        ("material", Item::Text(f.material.clone())),
        ("tait", Item::Table(tait)),
        ("pressure", Item::Number(f.pressure)),
        ("velocity", Item::Pair(f.velocity)),
        ("formulation", formulation),
    ]
}

fn solid_items(s: &Solid) -> Items {
    let elastic = vec![
        ("young_modulus", Item::Number(s.elastic.young_modulus)),
        ("poisson_ratio", Item::Number(s.elastic.poisson_ratio)),
    ];
    let formulation = match s.formulation {
        SolidFormulation::TotalLagrangian {
            viscosity,
            hourglass,
            renewal,
        } => {
            let mut items = vec![
                ("viscosity", Item::Number(viscosity)),
                ("hourglass", Item::Number(hourglass)),
            ];
            items.extend(renewal.map(|r| ("renewal", Item::Number(r))));
            choice("total_lagrangian", items)
        }
        SolidFormulation::Joshi { alpha, beta, xsph } => choice(
            "joshi",
            vec![
                ("alpha", Item::Number(alpha)),
                ("beta", Item::Number(beta)),
                ("xsph", Item::Number(xsph)),
            ],
        ),
    };
    let mut items = vec![
        ("material", Item::Text(s.material.clone())),
        ("density", Item::Number(s.density)),
        ("elastic", Item::Table(elastic)),
        ("strength", strength_item(&s.strength)),
        ("strain_rate", Item::Switch(true)),
        ("thermal_softening", Item::Switch(is_thermal(&s.strength))),
        ("velocity", Item::Pair(s.velocity)),
        ("formulation", formulation),
    ];
    items.extend(damage_item(&s.damage).map(|d| ("damage", d)));
    if !s.layers.is_empty() {
        let layers = s.layers.iter().map(layer_items).collect();
        items.push(("layers", Item::List(layers)));
    }
    items
}

fn layer_items(l: &Layer) -> Items {
    let elastic = vec![
        ("young_modulus", Item::Number(l.elastic.young_modulus)),
        ("poisson_ratio", Item::Number(l.elastic.poisson_ratio)),
    ];
    let mut items = vec![
        ("thickness", Item::Number(l.thickness)),
        ("material", Item::Text(l.material.clone())),
        ("density", Item::Number(l.density)),
        ("elastic", Item::Table(elastic)),
        ("strength", strength_item(&l.strength)),
        ("strain_rate", Item::Switch(true)),
        ("thermal_softening", Item::Switch(is_thermal(&l.strength))),
    ];
    items.extend(damage_item(&l.damage).map(|d| ("damage", d)));
    items
}

fn is_thermal(strength: &Strength) -> bool {
    matches!(
        strength,
        Strength::JohnsonCook(JohnsonCook {
            thermal: Some(_),
            ..
        })
    )
}

fn damage_item(damage: &Damage) -> Option<Item> {
    match damage {
        Damage::None => None,
        Damage::RuptureStrain(law) => {
            let name = if law.modulus_loss {
                "linear_modulus_loss"
            } else {
                "rupture_strain"
            };
            let strain = Item::Number(law.rupture_strain);
            Some(choice(name, vec![("rupture_strain", strain)]))
        }
        Damage::JohnsonCook(law) => Some(choice(
            "johnson_cook",
            vec![
                ("d1", Item::Number(law.d1)),
                ("d2", Item::Number(law.d2)),
                ("d3", Item::Number(law.d3)),
                ("d4", Item::Number(law.d4)),
                ("d5", Item::Number(law.d5)),
                ("reference_rate", Item::Number(law.reference_rate)),
            ],
        )),
    }
}

fn strength_item(strength: &Strength) -> Item {
    match *strength {
        Strength::Elastic => choice("elastic", Vec::new()),
        Strength::PerfectlyPlastic { yield_stress } => choice(
            "perfectly_plastic",
            vec![("yield_stress", Item::Number(yield_stress))],
        ),
        Strength::LinearHardening {
            yield_stress,
            hardening_modulus,
        } => choice(
            "linear_hardening",
            vec![
                ("yield_stress", Item::Number(yield_stress)),
                ("hardening_modulus", Item::Number(hardening_modulus)),
            ],
        ),
        Strength::JohnsonCook(jc) => choice("johnson_cook", johnson_cook_items(&jc)),
    }
}

fn johnson_cook_items(jc: &JohnsonCook) -> Items {
    let mut items = vec![
        ("a", Item::Number(jc.a)),
        ("b", Item::Number(jc.b)),
        ("n", Item::Number(jc.n)),
        ("c", Item::Number(jc.c)),
        ("reference_rate", Item::Number(jc.reference_rate)),
    ];
    if let Some(t) = jc.thermal {
        items.push(("m", Item::Number(t.m)));
        items.push((
            "reference_temperature",
            Item::Number(t.reference_temperature),
        ));
        items.push(("melting_temperature", Item::Number(t.melting_temperature)));
        items.push(("heat_capacity", Item::Number(t.heat_capacity)));
        items.push(("taylor_quinney", Item::Number(t.taylor_quinney)));
    }
    items
}
