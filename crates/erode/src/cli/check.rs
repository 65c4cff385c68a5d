//! `erode check`: what was understood, how large it is, how long it takes.

use super::{
    args::CheckArgs,
    failure::{Failure, Outcome},
    format::{columns, count, duration, si, significant},
    say::say,
};
use erode::case::{
    Body, BodyKind, Case, Impact, Impacts, Loaded, Simulation, Solid, check_advice,
    estimate::{self, Estimate, PARTICLE_STEPS_PER_SECOND, bytes, estimate},
    json_schema,
};
use erode::case::{bubbles::SingleBubble, cloud::BubbleCloud};
use erode_physics::bubble::{BubbleModel, blake_pressure, critical_radius, equilibrium_radius};
use erode_sph::Geometry;

/// Runs the command.
pub(crate) fn check(args: &CheckArgs) -> Outcome {
    let Some(case) = args.case.as_ref().filter(|_| !args.schema) else {
        let text = serde_json::to_string_pretty(&json_schema());
        say!(
            "{}",
            text.map_err(|e| Failure::input(format!("the schema cannot be written: {e}"), ""))?
        );
        return Ok(());
    };
    let loaded = Case::load(case, &args.set, &[])?;
    if args.resolved {
        say!("{}", loaded.resolved_toml.trim_end());
    } else {
        print_summary(&loaded);
    }
    Ok(())
}

fn print_summary(loaded: &Loaded) {
    let s = &loaded.simulation;
    say!("{}: the case is correct", loaded.file.display());
    say!("{}\n", s.title);
    if let Some(bubble) = &s.single_bubble {
        columns(&bubble_facts(s, bubble))
            .iter()
            .for_each(|l| say!("{l}"));
    } else if let Some(cloud) = &s.bubble_cloud {
        columns(&cloud_facts(s, cloud))
            .iter()
            .for_each(|l| say!("{l}"));
    } else {
        print_bodies(s);
    }
    let advice = check_advice(s);
    if !advice.is_empty() {
        say!("\nWorth a look:");
        advice.iter().for_each(|a| say!("- {a}"));
    }
    say!(
        "\nEvery default: erode check {} --resolved",
        loaded.file.display()
    );
}

fn print_bodies(s: &Simulation) {
    let e = estimate(s);
    for line in columns(&facts(s)) {
        say!("{line}");
    }
    say!();
    for line in columns(&bodies(s, &e)) {
        say!("{line}");
    }
    say!();
    for line in columns(&cost(s, &e)) {
        say!("{line}");
    }
}

/// What is known of a cloud before it runs.
fn cloud_facts(s: &Simulation, c: &BubbleCloud) -> Vec<Vec<String>> {
    let row = |name: &str, text: String| vec![name.to_owned(), text];
    let o = &s.output;
    let every = format!(
        "history every {}, fields every {}, checkpoint every {}",
        si(o.history_every, "s"),
        si(o.fields_every, "s"),
        si(o.checkpoint_every, "s")
    );
    vec![
        row(
            "bubbles",
            format!("{}, mean radius {}", c.count, si(c.nuclei.mean(), "m")),
        ),
        row(
            "law",
            format!(
                "`{}`, tolerance {}",
                c.model.name(),
                significant(c.tolerance)
            ),
        ),
        row("end time", si(s.run.end_time, "s")),
        row("output", every),
    ]
}

/// What is known of a single bubble before it runs.
fn bubble_facts(s: &Simulation, b: &SingleBubble) -> Vec<Vec<String>> {
    let row = |name: &str, text: String| vec![name.to_owned(), text];
    let pressure = b.ambient_pressure.at_start();
    let gas = format!(
        "{} at a radius of {}, exponent {}",
        si(b.gas.pressure, "Pa"),
        si(b.gas.radius, "m"),
        significant(b.gas.polytropic_exponent)
    );
    let rest = equilibrium_radius(&b.liquid, &b.gas, pressure).map_or_else(
        |e| e.to_string(),
        |r| format!("radius {} at {}", si(r, "m"), si(pressure, "Pa")),
    );
    let blake = format!(
        "{}: below it no equilibrium, above a radius of {} none that is stable",
        si(blake_pressure(&b.liquid, &b.gas), "Pa"),
        si(critical_radius(&b.liquid, &b.gas), "m")
    );
    let o = &s.output;
    let every = format!(
        "history every {} and where the radius changes, checkpoint every {}",
        si(o.history_every, "s"),
        si(o.checkpoint_every, "s")
    );
    let mut rows = vec![
        row(
            "bubble",
            format!("radius {} at the start", si(b.radius, "m")),
        ),
        row(
            "law",
            format!(
                "`{}`, tolerance {}",
                b.model.name(),
                significant(b.tolerance)
            ),
        ),
        row("gas", gas),
        row("equilibrium", rest),
    ];
    if b.gas.pressure > 0.0 {
        rows.push(row("Blake threshold", blake));
    }
    rows.push(row("end time", si(s.run.end_time, "s")));
    rows.push(row("output", every));
    rows
}

fn facts(s: &Simulation) -> Vec<Vec<String>> {
    let geometry = match s.geometry {
        Geometry::Axisymmetric => "axisymmetric, (r, z)",
        Geometry::Plane => "plane strain, (x, y)",
    };
    let row = |name: &str, text: String| vec![name.to_owned(), text];
    let mut rows = vec![row("geometry", geometry.to_owned())];
    if let Some(b) = &s.bubble {
        let mut text = format!(
            "radius {}, driven by {}",
            si(b.radius, "m"),
            si(b.driving_pressure, "Pa")
        );
        if let Some(d) = b.wall_distance {
            text.push_str(&format!(", stand-off {}", significant(d / b.radius)));
        }
        if let Some(gas) = b.gas {
            text.push_str(&format!(
                ", gas at {}, exponent {}",
                si(gas.pressure, "Pa"),
                significant(gas.polytropic_exponent)
            ));
        }
        rows.push(row("bubble", text));
    }
    if let Some(i) = &s.impacts {
        rows.push(row("impacts", sequence(i)));
        rows.push(row("settling", settling(i)));
    }
    let o = &s.output;
    let every = |name: &str, t: f64| format!("{name} every {}", si(t, "s"));
    let text = [
        every("fields", o.fields_every),
        every("history", o.history_every),
        every("checkpoint", o.checkpoint_every),
    ];
    rows.push(row("output", text.join(", ")));
    if !s.probes.is_empty() {
        let names: Vec<&str> = s.probes.iter().map(|p| p.name.as_str()).collect();
        rows.push(row("probes", names.join(", ")));
    }
    rows
}

/// The bubbles of a sequence in one line.
fn sequence(i: &Impacts) -> String {
    let range = |of: fn(&Impact) -> f64, unit: &str| {
        let values = || i.bubbles.iter().map(of);
        let (low, high) = (
            values().fold(f64::INFINITY, f64::min),
            values().fold(0.0, f64::max),
        );
        let shown = |x| {
            if unit == "-" {
                significant(x)
            } else {
                si(x, unit)
            }
        };
        if low == high {
            shown(low)
        } else {
            format!("{} to {}", shown(low), shown(high))
        }
    };
    format!(
        "{}, radius {}, stand-off {}, driven by {}, {} each",
        i.bubbles.len(),
        range(|b| b.radius, "m"),
        range(|b| b.standoff, "-"),
        range(|b| b.driving_pressure, "Pa"),
        range(|b| b.duration, "s")
    )
}

fn settling(i: &Impacts) -> String {
    let s = &i.settling;
    format!(
        "damping {:.1e} 1/s until {:e} of the kinetic energy are left, {} at most",
        s.damping,
        s.residual,
        si(s.longest, "s")
    )
}

fn bodies(s: &Simulation, e: &Estimate) -> Vec<Vec<String>> {
    let head = ["body", "kind", "material", "extent", "spacing", "particles"];
    let mut rows = vec![head.map(str::to_owned).to_vec()];
    rows.extend(s.bodies.iter().zip(&e.particles).map(|(b, n)| body(b, *n)));
    rows
}

fn body(b: &Body, particles: f64) -> Vec<String> {
    let (kind, material) = match &b.kind {
        BodyKind::Fluid(f) => ("liquid", f.material.clone()),
        BodyKind::Solid(f) => ("solid", layered(f)),
    };
    let (l, u) = b.shape.bounding_box();
    let (finest, coarsest) = (si(b.spacing.finest, "m"), si(b.spacing.coarsest, "m"));
    let spacing = if b.spacing.core.is_some() && finest != coarsest {
        format!("{finest} to {coarsest}")
    } else {
        finest
    };
    vec![
        b.name.clone(),
        kind.to_owned(),
        material,
        format!("{} x {}", si(u[0] - l[0], "m"), si(u[1] - l[1], "m")),
        spacing,
        format!("about {}", count(particles)),
    ]
}

/// "copper_ofhc 20 um on steel_a2205"
fn layered(s: &Solid) -> String {
    let layers = s.layers.iter();
    let layers = layers.map(|l| format!("{} {} on ", l.material, si(l.thickness, "m")));
    layers.collect::<String>() + &s.material
}

fn cost(s: &Simulation, e: &Estimate) -> Vec<Vec<String>> {
    let row = |name: &str, text: String| vec![name.to_owned(), text];
    let total: f64 = e.particles.iter().sum();
    let mut rows = vec![
        row("end time", si(estimate::duration(s), "s")),
        row(
            "time step",
            format!("about {}, limited by `{}`", si(e.step, "s"), e.limited_by),
        ),
        row("steps", format!("about {}", count(e.steps))),
        row("particles", format!("about {}", count(total))),
        row("memory", format!("about {}", bytes(e.memory))),
        row(
            "wall time",
            format!(
                "{} at an assumed {} million particle steps per second",
                duration(e.wall_time),
                significant(PARTICLE_STEPS_PER_SECOND / 1e6)
            ),
        ),
    ];
    if let Some(r) = e.refined {
        let text = format!(
            "{} particles per radius down to {} of the first: spacing {}, time step about {} there; particles, steps and wall \
             time above are without it",
            significant(r.asked.per_radius),
            significant(r.asked.smallest),
            si(r.spacing, "m"),
            si(r.step, "s")
        );
        rows.push(row("refinement", text));
    }
    rows
}
