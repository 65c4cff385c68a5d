//! The final numbers of a run and their comparison with the source.

use super::bubble_state::equivalent_radius;
use super::layers;
use super::ledger::Ledger;
use super::metal::Metal;
use super::monitor::{Record, liquid, solid};
use super::strain_profile::{Column, columns, off_axis_maximum};
use crate::analysis::published::{ATTACHED_STRAIN, DETACHED_STRAIN};
use crate::analysis::{YIELDED, bubble_energy, plastic_potential};
use crate::case::{BodyKind, Bubble, Simulation};
use crate::output::Summary;
use erode_physics::strength::Strength;
use erode_sph::fluid::corrected::Account;
use erode_sph::world::{Body, World};
use serde_json::{Value, json};

/// Rayleigh's collapse time of an empty bubble in units of R sqrt(rho/p) (exact: 0.914681).
const RAYLEIGH: f64 = 0.914_681;

/// Summary of a finished (or stopped) run.
#[must_use]
pub(crate) fn summary(
    world: &World,
    simulation: &Simulation,
    record: &Record,
    wall_time: f64,
    threads: usize,
) -> Summary {
    let mut s = Summary::default();
    bubble(&mut s, world, simulation, record);
    metal(&mut s, world, simulation, record);
    s.set(
        "energy_drift",
        "-",
        record.energy_drift / record.energy_scale.max(f64::MIN_POSITIVE),
    );
    s.set("energy_residual", "J", record.energy_drift);
    if let Some(drift) = record.largest_mass_drift(world) {
        s.set("mass_drift", "-", drift);
    }
    let present = world.bodies.iter().map(|b| match &b.body {
        Body::Fluid(f) => f.len() as u64,
        Body::Solid(s) => s.len() as u64,
    });
    // A liquid that was taken away belongs to the run as well.
    let gone = if liquid(world).is_none() {
        world.departed.particles
    } else {
        0
    };
    s.set_count("particles", present.sum::<u64>() + gone);
    s.set_count("steps", world.step);
    s.set("end_time", "s", world.time);
    s.set("wall_time", "s", wall_time);
    s.set_count("threads", threads as u64);
    s.set_version("erode", env!("CARGO_PKG_VERSION"));
    for (name, value) in Ledger::of(world).entries() {
        s.set_ledger(name, "J", value);
    }
    counts(&mut s, world);
    for (part, seconds) in &record.seconds {
        s.set_seconds(part, *seconds);
    }
    for (name, steps) in &record.limiters {
        s.set_limiter(name, *steps);
    }
    s.set_layers(layers::rows(world, simulation));
    s.set_comparison(comparison(simulation, &s));
    s
}

fn bubble(s: &mut Summary, world: &World, simulation: &Simulation, record: &Record) {
    let Some(b) = &simulation.bubble else { return };
    let density = simulation.bodies.iter().find_map(|body| match &body.kind {
        BodyKind::Fluid(f) => Some(f.eos.density(f.pressure)),
        BodyKind::Solid(_) => None,
    });
    let none = f64::NAN;
    s.set(
        "collapse_time",
        "s",
        record.collapsed.map_or(none, |t| t - arrival(simulation)),
    );
    s.set("collapse_instant", "s", record.collapsed.unwrap_or(none));
    if let Some(rho) = density {
        s.set(
            "rayleigh_time",
            "s",
            RAYLEIGH * b.radius * (rho / b.driving_pressure).sqrt(),
        );
    }
    s.set(
        "smallest_bubble_radius",
        "m",
        equivalent_radius(record.smallest_volume, simulation.geometry),
    );
    if b.wall_distance.is_some() {
        s.set(
            "jet_speed",
            "m/s",
            record
                .jet_speed
                .filter(|_| record.jet_time.is_some())
                .unwrap_or(none),
        );
        s.set("jet_time", "s", record.jet_time.unwrap_or(none));
    }
    s.set("max_pressure", "Pa", record.max_pressure);
    if b.gas.is_some() {
        let (gone, gas) = (&world.departed, liquid(world).and_then(|f| f.gas.as_ref()));
        s.set("max_gas_pressure", "Pa", record.max_gas_pressure);
        s.set_count("gas_parts", gas.map_or(0, |g| g.pockets.len() as u64));
        let closed = gone.gas_closed + gas.map_or(0, |g| g.closed);
        s.set_ledger("gas_pockets_closed", "-", closed as f64);
        s.set_ledger(
            "gas_energy_lost",
            "J",
            gone.gas_lost + gas.map_or(0.0, |g| g.lost),
        );
        let cut = gone.gas_cut + gas.map_or(0, |g| g.cut);
        s.set_ledger("gas_steps_cut", "-", cut as f64);
    }
    let energy = bubble_energy(b.radius, b.driving_pressure, simulation.geometry);
    if simulation.geometry == erode_sph::Geometry::Axisymmetric {
        s.set("bubble_energy", "J", energy);
        if let Some(metal) = solid(world) {
            s.set(
                "plastic_deformation_potential_share",
                "-",
                plastic_potential(Metal::of(metal).plastic_work, energy),
            );
        }
    }
}

/// When the step reaches the top of the bubble, s: at the speed of a weak shock, c0 + (gamma + 1)/4 u.
fn arrival(simulation: &Simulation) -> f64 {
    let Some(b) = &simulation.bubble else {
        return 0.0;
    };
    simulation
        .bodies
        .iter()
        .find_map(|body| {
            let BodyKind::Fluid(f) = &body.kind else {
                return None;
            };
            let crate::case::Side::NonReflecting {
                wave: Some(wave), ..
            } = body.sides.top
            else {
                return None;
            };
            let (_, upper) = body.shape.bounding_box();
            let u = f.eos.riemann_integral(f.eos.density(wave.pressure));
            let speed = f.eos.sound_speed + 0.25 * (f.eos.gamma + 1.0) * u;
            Some(wave.start + (upper[1] - b.centre[1] - b.radius) / speed)
        })
        .unwrap_or(0.0)
}

fn metal(s: &mut Summary, world: &World, simulation: &Simulation, record: &Record) {
    let Some(body) = solid(world) else { return };
    let metal = Metal::of(body);
    if simulation.loads.indenter.is_none() || !simulation.loads.pressures.is_empty() {
        s.set("peak_wall_pressure", "Pa", record.peak_wall_pressure[0]);
        s.set("peak_wall_pressure_r", "m", record.peak_wall_pressure[1]);
        s.set("peak_wall_pressure_time", "s", record.peak_wall_pressure[2]);
    }
    s.set("max_plastic_strain", "-", metal.max_plastic_strain);
    s.set("max_plastic_strain_r", "m", metal.place[0]);
    s.set("max_plastic_strain_depth", "m", metal.place[1]);
    let off_axis = off_axis_maximum(&columns(body));
    let of = |f: fn(&Column) -> f64| off_axis.as_ref().map_or(f64::NAN, f);
    s.set("off_axis_plastic_strain", "-", of(|c| c.plastic_strain));
    s.set("off_axis_plastic_strain_r", "m", of(|c| c.r));
    s.set("max_strain_rate", "1/s", record.max_strain_rate);
    s.set("plastic_work", "J", metal.plastic_work);
    s.set("plastic_volume", "m3", metal.plastic_volume);
    s.set("pit_depth", "m", metal.depth);
    if simulation.loads.indenter.is_some() {
        s.set("max_indenter_force", "N", record.max_indenter_force);
    }
    if !simulation.loads.is_empty() {
        // Far below 1: the load was slow enough to be called static.
        s.set("inertia_share", "-", body.inertia_share());
    }
    let lost = body.state.work.lost;
    s.set("lost_mass", "kg", lost.mass);
    s.set_ledger("particles_failed", "-", lost.failed as f64);
    s.set_ledger("particles_loose", "-", lost.loose as f64);
}

/// What was counted instead of being lost in silence.
fn counts(s: &mut Summary, world: &World) {
    let gone = (world.departed.liquids > 0).then_some(&world.departed.account);
    let present = world.bodies.iter().filter_map(|b| match &b.body {
        Body::Fluid(f) => Some(&f.account),
        Body::Solid(_) => None,
    });
    let all: Vec<&Account> = present.chain(gone).collect();
    if all.is_empty() {
        return;
    }
    let sum = |of: fn(&Account) -> u64| all.iter().map(|a| of(a)).sum::<u64>();
    let entries = [
        ("axis_crossings", sum(|a| a.axis_crossings)),
        ("wall_crossings", sum(|a| a.wall_crossings)),
        ("tension_removed", sum(|a| a.cavitating)),
        ("fragments_kept_whole", sum(|a| a.parted)),
        ("limited_exchanges", sum(|a| a.limited_exchanges)),
        ("particles_halved", sum(|a| a.refinement.splits)),
        ("particles_merged", sum(|a| a.refinement.merges)),
    ];
    for (name, count) in entries {
        s.set_ledger(name, "-", count as f64);
    }
    let energy = all.iter().map(|a| a.refinement.energy).sum::<f64>() + 0.0;
    s.set_ledger("refinement_energy_loss", "J", energy);
}

/// Whether bubble and wall are what the thesis computed: nothing in the bubble, bare A-2205 with its growth with the rate.
fn is_of_thesis(simulation: &Simulation, bubble: &Bubble) -> bool {
    let same = |a: f64, b: f64| (a / b - 1.0).abs() < 0.01;
    let wall = simulation.bodies.iter().find_map(|body| match &body.kind {
        BodyKind::Solid(s) => Some(s),
        BodyKind::Fluid(_) => None,
    });
    simulation.geometry == erode_sph::Geometry::Axisymmetric
        && bubble.gas.is_none()
        && same(bubble.driving_pressure, 50e6)
        && same(bubble.radius, 0.15e-3)
        && wall.is_some_and(|w| {
            w.layers.is_empty()
                && w.material == "steel_a2205"
                && matches!(w.strength, Strength::JohnsonCook(law) if law.c > 0.0)
        })
}

/// Values that the thesis states for its two cases of chapter 6.
fn comparison(simulation: &Simulation, s: &Summary) -> Vec<Value> {
    let Some(b) = simulation.bubble.filter(|b| is_of_thesis(simulation, b)) else {
        return Vec::new();
    };
    let Some(distance) = b.wall_distance else {
        return Vec::new();
    };
    let standoff = distance / b.radius;
    let same = |a: f64, b: f64| (a / b - 1.0).abs() < 0.01;
    let row = |quantity: &str, value: Value, reference: Value, unit: &str, source: &str| json!({ "quantity": quantity, "value": value, "reference": reference, "unit": unit, "source": source });
    let spacing = simulation
        .bodies
        .iter()
        .map(|body| body.spacing.finest)
        .fold(f64::INFINITY, f64::min);
    let strain = s.get("max_plastic_strain").filter(|e| *e > YIELDED);
    let radius = s.get("max_plastic_strain_r").filter(|_| strain.is_some());
    // Two spacings tell a place from the axis.
    let place = radius.map(|r| {
        if r > 2.0 * spacing {
            "off the axis"
        } else {
            "on the axis"
        }
    });
    if same(standoff, 1.33) {
        let source = "Joshi 2018, section 6.4.1, figure 6.7";
        vec![
            row(
                "max_plastic_strain",
                json!(strain),
                json!(DETACHED_STRAIN),
                "-",
                source,
            ),
            row(
                "place_of_max_plastic_strain",
                json!(place),
                json!("off the axis"),
                "-",
                source,
            ),
            row(
                "off_axis_plastic_strain",
                json!(s.get("off_axis_plastic_strain").filter(|v| v.is_finite())),
                json!(DETACHED_STRAIN),
                "-",
                source,
            ),
            row(
                "off_axis_plastic_strain_r",
                json!(s.get("off_axis_plastic_strain_r").filter(|v| v.is_finite())),
                json!("between 0.1 mm and 0.2 mm"),
                "m",
                "Joshi 2018, section 6.4.4.2, figure 6.14",
            ),
        ]
    } else if same(standoff, 0.66) {
        let source = "Joshi 2018, section 6.4.1, figure 6.8";
        vec![
            row(
                "max_plastic_strain",
                json!(strain),
                json!(ATTACHED_STRAIN),
                "-",
                source,
            ),
            row(
                "place_of_max_plastic_strain",
                json!(place),
                json!("on the axis"),
                "-",
                source,
            ),
        ]
    } else {
        Vec::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::Case;

    #[test]
    fn only_the_bubble_and_wall_of_the_thesis_are_compared_with_it() {
        let text = include_str!("../../../../cases/bubble-near-steel/case.toml");
        let rows = |set: &[&str]| {
            let key = |s: &&str| format!("setup.bubble_near_wall.{s}");
            let set: Vec<String> = set.iter().map(key).collect();
            let simulation = Case::parse("case.toml", text, &set).unwrap();
            comparison(&simulation, &Summary::default()).len()
        };
        assert_eq!((rows(&[]), rows(&["standoff=0.66"])), (4, 2));
        for other in [
            "gas={pressure=\"100 kPa\"}",
            "wall_layers=[{material=\"copper_ofhc\", thickness=\"20 um\"}]",
            "wall=copper_ofhc",
            "strain_rate=false",
            "radius=\"0.2 mm\"",
            "driving_pressure=\"40 MPa\"",
        ] {
            assert_eq!(rows(&[other]), 0, "{other}");
        }
    }
}
