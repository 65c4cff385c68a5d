//! Physics checks of a correct case: what will run, but may not mean much.

use super::{
    estimate::estimate,
    format::si,
    layers,
    simulation::{Body, BodyKind, Bubble, BubbleGas, Side, Simulation},
};

/// Sentences about a case that a user should read before a long run.
#[must_use]
pub fn check_advice(simulation: &Simulation) -> Vec<String> {
    let mut advice = Vec::new();
    if simulation.single_bubble.is_some() || simulation.bubble_cloud.is_some() {
        many_rows(simulation, &mut advice);
        return advice;
    }
    if let Some(bubble) = &simulation.bubble {
        bubble_advice(simulation, bubble, &mut advice);
    }
    impacts_advice(simulation, &mut advice);
    for body in &simulation.bodies {
        interface_advice(simulation, body, &mut advice);
        layer_advice(body, &mut advice);
    }
    load_advice(simulation, &mut advice);
    let safety = simulation.run.safety;
    if safety > 0.5 {
        advice.push(format!(
            "run.safety = {safety} is above 0.5: the time step is probably unstable; 0.3 is tried"
        ));
    }
    let e = estimate(simulation);
    if simulation.run.max_steps.is_none() && simulation.run.end_time < 10.0 * e.step {
        advice
            .push("the run ends after less than 10 time steps: is run.end_time right?".to_owned());
    }
    let o = &simulation.output;
    if simulation.run.end_time / o.fields_every > 2000.0 {
        advice.push(format!(
            "{:.0} field files will be written: is output.fields_every right?",
            simulation.run.end_time / o.fields_every
        ));
    }
    advice
}

fn many_rows(s: &Simulation, advice: &mut Vec<String>) {
    let rows = s.run.end_time / s.output.history_every;
    if rows > 1e6 {
        advice.push(format!(
            "{rows:.0} rows will be written: is output.history_every right?"
        ));
    }
}

/// A gas bubble that grows swings past its equilibrium before it rests there: by a third from 20 times the pressure of the
/// liquid, here by half.
const SWING: f64 = 1.5;

/// Gas must have room to grow.
fn gas_advice(bubble: &Bubble, advice: &mut Vec<String>) {
    let Some(gas) = bubble.gas else { return };
    let rest = gas.equilibrium(bubble.driving_pressure);
    if rest * SWING > BubbleGas::REACH {
        advice.push(format!(
            "the gas is at rest at {rest:.2} radii of the bubble and swings beyond that; it is followed to {} radii, and cut there",
            BubbleGas::REACH
        ));
    }
}

fn bubble_advice(s: &Simulation, bubble: &Bubble, advice: &mut Vec<String>) {
    gas_advice(bubble, advice);
    for body in &s.bodies {
        let BodyKind::Fluid(fluid) = &body.kind else {
            continue;
        };
        let per_radius = bubble.radius / body.spacing.finest;
        if per_radius < 9.999 {
            advice.push(format!(
                "{per_radius:.0} particles per bubble radius in `{}` show the collapse in outline only; 30 resolve it",
                body.name
            ));
        }
        let (l, u) = body.shape.bounding_box();
        let edge = (u[0] - bubble.centre[0]).min(u[1] - bubble.centre[1]) / bubble.radius;
        if edge < 3.9999 {
            advice.push(format!(
                "`{}` ends {edge:.1} bubble radii from the bubble's centre: below 4 its edge acts on the collapse",
                body.name
            ));
        }
        let rayleigh =
            0.915 * bubble.radius * (fluid.eos.reference_density / bubble.driving_pressure).sqrt();
        let arrival = arrival_time(body, bubble, u[1] - l[1]);
        if s.run.end_time < arrival + rayleigh {
            advice.push(format!(
                "the run ends at {:.3e} s, before the bubble can collapse (step arrives at {arrival:.3e} s, collapse takes {rayleigh:.3e} s)",
                s.run.end_time
            ));
        }
    }
}

/// Every bubble of a sequence needs time to collapse, and room.
fn impacts_advice(s: &Simulation, advice: &mut Vec<String>) {
    let (Some(impacts), Some(first)) = (&s.impacts, &s.bubble) else {
        return;
    };
    for body in &s.bodies {
        let BodyKind::Fluid(fluid) = &body.kind else {
            continue;
        };
        let (lower, upper) = body.shape.bounding_box();
        let first_way = arrival_time(body, first, upper[1] - lower[1]);
        for (k, b) in impacts.bubbles.iter().enumerate() {
            let number = k + 1;
            let density = fluid.eos.reference_density;
            let rayleigh = 0.915 * b.radius * (density / b.driving_pressure).sqrt();
            let arrival = first_way * b.radius / first.radius;
            if b.duration < arrival + rayleigh {
                advice.push(format!(
                    "bubble {number} of the sequence has {:.3e} s, too little for its collapse (step arrives after {arrival:.3e} s, collapse takes {rayleigh:.3e} s)",
                    b.duration
                ));
            }
            let edge = upper[0] / b.radius;
            if edge < 3.9999 {
                advice.push(format!(
                    "`{}` ends {edge:.1} radii beside bubble {number} of the sequence: below 4 its edge acts on the collapse",
                    body.name
                ));
            }
        }
    }
}

/// When the first wave that enters through the top reaches the bubble, s; 0 without a wave.
fn arrival_time(body: &Body, bubble: &Bubble, height: f64) -> f64 {
    let (
        Side::NonReflecting {
            wave: Some(wave), ..
        },
        BodyKind::Fluid(fluid),
    ) = (&body.sides.top, &body.kind)
    else {
        return 0.0;
    };
    let (lower, _) = body.shape.bounding_box();
    let path = (lower[1] + height - bubble.centre[1] - bubble.radius).max(0.0);
    wave.start + path / fluid.eos.sound_speed
}

/// A load narrower than this many spacings (radius of load or contact) is not resolved: the first rows spread it.
const PER_LOAD: f64 = 10.0;

/// Loads must be resolved, and slow enough where they are meant to be static.
fn load_advice(s: &Simulation, advice: &mut Vec<String>) {
    let mut across = |body: &str, radius: f64, what: &str| {
        let Some(b) = s.body(body) else { return };
        let count = radius / b.spacing.finest;
        if count < PER_LOAD * 0.9999 {
            advice.push(format!(
                "{count:.1} particles across the radius of the {what} on `{body}` ({radius:.2e} m) do not resolve it: {PER_LOAD} or more do"
            ));
        }
    };
    for p in &s.loads.pressures {
        across(&p.body, 0.5 * p.gaussian.diameter, "pressure");
    }
    let Some(i) = &s.loads.indenter else { return };
    across(&i.body, (2.0 * i.radius * i.depth).sqrt(), "contact");
    if let Some(body) = s.body(&i.body)
        && let BodyKind::Solid(solid) = &body.kind
    {
        let (lower, upper) = body.shape.bounding_box();
        let transits =
            i.ramp.rise * solid.elastic.longitudinal_speed(solid.density) / (upper[1] - lower[1]);
        if transits < 4.0 {
            advice.push(format!(
                "the indenter goes down within {transits:.1} transits of a wave through `{}`: below 4 inertia matters",
                i.body
            ));
        }
        if i.depth > 0.2 * (upper[1] - lower[1]) {
            advice.push(format!(
                "the indenter goes down by {:.0} % of the height of `{}`: its lower side acts on the result",
                100.0 * i.depth / (upper[1] - lower[1]),
                i.body
            ));
        }
    }
}

/// A layer thinner than the spacing at the far end of the body is not what was asked for there.
fn layer_advice(body: &Body, advice: &mut Vec<String>) {
    let BodyKind::Solid(solid) = &body.kind else {
        return;
    };
    for (k, layer) in solid.layers.iter().enumerate() {
        let [_, coarsest] = layers::spacings(body, &solid.layers, k);
        if layer.thickness * (1.0 + 1e-9) < coarsest {
            advice.push(format!(
                "layer {} ({}) of `{}` is {} thick, less than the spacing of {} at its far end: whole rows make it thicker there, or leave it out",
                k + 1,
                layer.material,
                body.name,
                si(layer.thickness, "m"),
                si(coarsest, "m")
            ));
        }
    }
}

/// Spacings on both sides of an interface should be alike.
fn interface_advice(s: &Simulation, body: &Body, advice: &mut Vec<String>) {
    let (BodyKind::Fluid(_), Side::Interface { with }) = (&body.kind, &body.sides.bottom) else {
        return;
    };
    let Some(other) = s.body(with) else { return };
    let ratio = other.spacing.finest / body.spacing.finest;
    if !(0.6..=1.7).contains(&ratio) {
        advice.push(format!(
            "the spacings of `{}` and `{with}` differ by a factor of {ratio:.2} at their interface",
            body.name
        ));
    }
}
