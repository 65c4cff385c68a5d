//! From checked values to the simulation: setups expand, then everything is checked against everything else.

use super::{
    body::{self, Built},
    bubbles, cloud,
    error::{Findings, Span},
    estimate,
    impacts::{self, Impacts},
    loads::{self, Loads},
    node::{Fields, Node},
    relations,
    setups::{self, Expansion},
    simulation::{Bubble, BubbleGas, Output, Probe, Run, Simulation},
};
use crate::materials::Library;
use erode_sph::Geometry;

/// Builds the simulation; nothing when an error keeps a part of it from existing.
///
/// Where an error leaves a choice open, its default stands in, so that what follows is still checked.
pub(crate) fn simulation(
    root: &Node,
    library: &mut Library,
    findings: &mut Findings,
) -> Option<Simulation> {
    let f = root.fields()?;
    for (name, material) in f.table("material").map_or(&[][..], |t| t.entries) {
        library.add(name, material);
    }
    if let Some((name @ ("single_bubble" | "bubble_cloud"), setup)) = f.chosen("setup") {
        return bubbles(f, name, setup, findings);
    }
    let geometry = match f.chosen("geometry") {
        Some(("plane", _)) => Geometry::Plane,
        _ => Geometry::Axisymmetric,
    };
    let setup = f.chosen("setup");
    let setup = setup.and_then(|(name, s)| setups::expand(name, s, geometry, library, findings));
    let run = run(f, setup.as_ref(), findings);
    let (bodies, complete) = bodies(f, setup.as_ref(), geometry, library, findings);
    let of_setup = setup.as_ref().and_then(|s| s.bubble);
    let bubble = own_bubble(f, &bodies, of_setup, complete, findings).or(of_setup);
    let loads = loads(f, setup.as_ref(), &bodies, complete, geometry, findings);
    let sequence = sequence(f, setup.as_ref(), &bodies, bubble, findings);
    let probes = probes(f, &bodies, complete, findings);
    relations::check(&bodies, complete, geometry, findings);
    let holder = f.table("bubble").or(f.chosen("setup").map(|(_, s)| s));
    if let (Some(bubble), Some(holder)) = (&bubble, holder) {
        relations::check_gas(bubble, &bodies, holder.at("gas"), findings);
    }
    relations::check_refinement(&bodies, bubble.is_some() || !complete, findings);
    estimate::check_memory(&bodies, geometry, findings);
    let title = f.text("title")?;
    let number = sequence.as_ref().map_or(1, |i| i.bubbles.len());
    let title = setup.filter(|_| title.is_empty()).map_or_else(
        || title.to_owned(),
        |s| match number {
            1 => s.title,
            n => format!("{}, {n} impacts", s.title),
        },
    );
    let mut run = run?;
    let impacts = match f.node("impacts") {
        Some(_) => Some(sequence?),
        None => None,
    };
    if let Some(first) = impacts.as_ref().and_then(|i| i.bubbles.first()) {
        run.end_time = first.duration;
    }
    let output = output(f, run.end_time)?;
    let bodies = bodies.into_iter().map(|b| b.body).collect();
    Some(Simulation {
        title,
        geometry,
        bodies,
        run,
        output,
        probes,
        bubble,
        loads: loads?,
        impacts,
        single_bubble: None,
        bubble_cloud: None,
    })
}

/// A case of bubbles whose liquid is not filled with particles: nothing but their setup, duration and output.
fn bubbles(
    f: Fields<'_>,
    name: &str,
    setup: Fields<'_>,
    findings: &mut Findings,
) -> Option<Simulation> {
    for key in [
        "body", "bubble", "probe", "geometry", "indenter", "pressure", "settling", "impacts",
    ] {
        // The default geometry has the place of the whole file.
        if f.node(key).is_some_and(|n| n.span != f.span) {
            let help = format!("leave `{key}` out: this setup has no bodies of particles");
            let message = format!("`{key}` has no meaning beside [setup.{name}]");
            findings.error(f.at(key), message, "not used here", help);
        }
    }
    let (mut single_bubble, mut bubble_cloud, mut proposed) = (None, None, None);
    let usual;
    if name == "single_bubble" {
        let (bubble, end) = bubbles::single_bubble(setup, findings)?;
        (single_bubble, proposed) = (Some(bubble), Some(end));
        usual = "Spherical bubble in unbounded liquid";
    } else {
        bubble_cloud = cloud::bubble_cloud(setup, findings);
        usual = "Bubbles in a flow";
    }
    let r = f.table("run")?;
    if r.node("end_time").is_none() && proposed.is_none() {
        let help = "a cloud goes on as long as you want; write for example end_time = \"1 ms\"";
        findings.error(r.span, "[run] lacks `end_time`", "needed here", help);
    }
    let end_time = match r.node("end_time") {
        Some(_) => r.number("end_time")?,
        None => proposed?,
    };
    if single_bubble.is_none() && bubble_cloud.is_none() {
        return None;
    }
    let title = f.text("title").filter(|t| !t.is_empty());
    Some(Simulation {
        title: title.unwrap_or(usual).to_owned(),
        geometry: Geometry::Axisymmetric,
        bodies: Vec::new(),
        run: Run {
            end_time,
            safety: r.number("safety")?,
            max_steps: max_steps(r)?,
        },
        output: output(f, end_time)?,
        probes: Vec::new(),
        bubble: None,
        loads: Loads::default(),
        impacts: None,
        single_bubble,
        bubble_cloud,
    })
}

/// The bodies of the setup and of the file, and whether none is missing because of an error.
fn bodies(
    f: Fields<'_>,
    setup: Option<&Expansion>,
    geometry: Geometry,
    library: &Library,
    findings: &mut Findings,
) -> (Vec<Built>, bool) {
    let own = f.list("body");
    if f.node("setup").is_none() && f.node("body").is_none() {
        let help = "write a setup such as [setup.bubble_near_wall], or [[body]] blocks; `erode new` has templates";
        findings.error(
            f.span,
            "the case has neither a setup nor a body",
            "nothing to compute",
            help,
        );
    }
    let mut bodies = setup.map(|s| s.bodies.clone()).unwrap_or_default();
    let expected = bodies.len() + own.len();
    bodies.extend(
        own.iter()
            .filter_map(|b| body::read(b, geometry, library, findings)),
    );
    let setup_failed = f.node("setup").is_some() && setup.is_none();
    let complete = bodies.len() == expected && !setup_failed;
    (bodies, complete)
}

fn run(f: Fields<'_>, setup: Option<&Expansion>, findings: &mut Findings) -> Option<Run> {
    let r = f.table("run")?;
    if r.node("end_time").is_none() && f.node("setup").is_none() {
        let help =
            "only a setup knows how long its process takes; write for example end_time = \"2 us\"";
        findings.error(r.span, "[run] lacks `end_time`", "needed here", help);
    }
    let end_time = match r.node("end_time") {
        Some(_) => r.number("end_time"),
        None => setup.map(|s| s.end_time),
    };
    let safety = r.number("safety")?;
    Some(Run {
        end_time: end_time?,
        safety,
        max_steps: max_steps(r)?,
    })
}

/// The largest number of steps if one is given; nothing if it is wrong.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
// checked to be a whole number below 2^53
fn max_steps(r: Fields<'_>) -> Option<Option<u64>> {
    match r.node("max_steps") {
        Some(_) => Some(Some(r.number("max_steps")? as u64)),
        None => Some(None),
    }
}

fn output(f: Fields<'_>, end_time: f64) -> Option<Output> {
    let interval = |table: &str, key: &str, parts: f64| {
        let t = f.table(table)?;
        if t.node(key).is_some() {
            t.number(key)
        } else {
            Some(end_time / parts)
        }
    };
    Some(Output {
        fields_every: interval("output", "fields_every", 40.0)?,
        history_every: interval("output", "history_every", 1000.0)?,
        checkpoint_every: interval("checkpoint", "every", 20.0)?,
    })
}

/// The loads of the setup, or those of the file; both at once would be told twice.
fn loads(
    f: Fields<'_>,
    setup: Option<&Expansion>,
    bodies: &[Built],
    complete: bool,
    geometry: Geometry,
    findings: &mut Findings,
) -> Option<Loads> {
    let own = loads::read(f, bodies, complete, geometry, findings)?;
    match setup.map(|s| &s.loads).filter(|l| !l.is_empty()) {
        None => Some(own),
        Some(of_setup) if own == Loads::default() => Some(of_setup.clone()),
        Some(_) => {
            let keys = ["indenter", "pressure", "settling"];
            let at = keys
                .iter()
                .find_map(|k| f.node(k))
                .map_or(f.span, |n| n.span);
            let help = "leave it out, or write the bodies and loads out as `erode check --resolved` shows them";
            findings.error(at, "the setup already brings a load", "told twice", help);
            None
        }
    }
}

/// The sequence of impacts, if the case asks for one and nothing is wrong with it.
fn sequence(
    f: Fields<'_>,
    setup: Option<&Expansion>,
    bodies: &[Built],
    bubble: Option<Bubble>,
    findings: &mut Findings,
) -> Option<Impacts> {
    f.node("impacts")?;
    let failed = f.node("setup").is_some() && setup.is_none();
    if failed || (bubble.is_none() && f.node("bubble").is_some()) {
        return None;
    }
    let given = f.table("run").filter(|r| r.node("end_time").is_some());
    let duration = |radius: f64, pressure: f64| match given {
        Some(run) => run.number("end_time"),
        None => setup?.duration(radius, pressure),
    };
    let loads = ["indenter", "pressure", "settling"];
    let around = impacts::Around {
        bodies,
        bubble,
        duration: &duration,
        loads: loads.iter().any(|k| f.node(k).is_some())
            || setup.is_some_and(|s| !s.loads.is_empty()),
    };
    impacts::read(f, &around, findings)
}

/// Gas of a bubble, if it has any; nothing if it is wrong.
pub(crate) fn gas(f: Fields<'_>) -> Option<Option<BubbleGas>> {
    let Some(gas) = f.table("gas") else {
        return Some(None);
    };
    Some(Some(BubbleGas {
        pressure: gas.number("pressure")?,
        polytropic_exponent: gas.number("polytropic_exponent")?,
    }))
}

fn own_bubble(
    f: Fields<'_>,
    bodies: &[Built],
    of_setup: Option<Bubble>,
    complete: bool,
    findings: &mut Findings,
) -> Option<Bubble> {
    let b = f.table("bubble")?;
    if of_setup.is_some() {
        let help =
            "leave [bubble] out, or write the bodies out as `erode check --resolved` shows them";
        findings.error(
            b.span,
            "the setup already tells where the bubble is",
            "told twice",
            help,
        );
        return None;
    }
    let wall_distance = match b.node("wall_distance") {
        Some(_) => Some(b.number("wall_distance")?),
        None => None,
    };
    let bubble = Bubble {
        centre: b.pair("centre")?,
        radius: b.number("radius")?,
        wall_distance,
        driving_pressure: b.number("driving_pressure")?,
        gas: gas(b)?,
    };
    if complete {
        relations::check_bubble(&bubble, bodies, b.at("centre"), findings);
    }
    Some(bubble)
}

fn probes(f: Fields<'_>, bodies: &[Built], complete: bool, findings: &mut Findings) -> Vec<Probe> {
    let mut probes: Vec<(Probe, Span)> = Vec::new();
    for node in f.list("probe") {
        let Some(p) = node.fields() else { continue };
        let (name, body, position) = (p.text("name"), p.text("body"), p.pair("position"));
        let (Some(name), Some(body), Some(position)) = (name, body, position) else {
            continue;
        };
        if probes.iter().any(|(other, _)| other.name == name) {
            let help = "each probe writes a file of its name";
            findings.error(
                p.at("name"),
                format!("there are two probes called `{name}`"),
                "used twice",
                help,
            );
        }
        let probe = Probe {
            name: name.to_owned(),
            body: body.to_owned(),
            position,
        };
        if complete {
            relations::check_probe(&probe, bodies, p.at("body"), p.at("position"), findings);
        }
        probes.push((probe, p.span));
    }
    probes.into_iter().map(|(probe, _)| probe).collect()
}
