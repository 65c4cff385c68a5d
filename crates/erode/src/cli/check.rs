//! `erode check`: what was understood, how large it is, how long it takes.

use super::{
    args::CheckArgs,
    failure::{Failure, Outcome},
    format::{columns, count, duration, si, significant},
    say::say,
};
use erode::case::{
    Body, BodyKind, Case, Loaded, Simulation, check_advice,
    estimate::{Estimate, PARTICLE_STEPS_PER_SECOND, bytes, estimate},
    json_schema,
};
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
    let e = estimate(s);
    say!("{}: the case is correct", loaded.file.display());
    say!("{}\n", s.title);
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
        rows.push(row("bubble", text));
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

fn bodies(s: &Simulation, e: &Estimate) -> Vec<Vec<String>> {
    let head = ["body", "kind", "material", "extent", "spacing", "particles"];
    let mut rows = vec![head.map(str::to_owned).to_vec()];
    rows.extend(s.bodies.iter().zip(&e.particles).map(|(b, n)| body(b, *n)));
    rows
}

fn body(b: &Body, particles: f64) -> Vec<String> {
    let (kind, material) = match &b.kind {
        BodyKind::Fluid(f) => ("liquid", &f.material),
        BodyKind::Solid(f) => ("solid", &f.material),
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
        material.clone(),
        format!("{} x {}", si(u[0] - l[0], "m"), si(u[1] - l[1], "m")),
        spacing,
        format!("about {}", count(particles)),
    ]
}

fn cost(s: &Simulation, e: &Estimate) -> Vec<Vec<String>> {
    let row = |name: &str, text: String| vec![name.to_owned(), text];
    let total: f64 = e.particles.iter().sum();
    vec![
        row("end time", si(s.run.end_time, "s")),
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
    ]
}
