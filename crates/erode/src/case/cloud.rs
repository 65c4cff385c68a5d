//! A cloud of bubbles of a case: `[setup.bubble_cloud]`.

use super::{
    bubbles::{liquid, liquid_items, model, model_item},
    cloud_flow::Flow,
    error::Findings,
    node::Fields,
    resolved::{Item, Items},
};
use erode_fv::bubbles::NewBubble;
use erode_fv::bubbles::carrier::Carrier;
use erode_fv::bubbles::forces::{DragLaw, Forces, LiftLaw, PressureForce, volume};
use erode_physics::bubble::{Liquid, Model, equilibrium_gas};
use erode_physics::nuclei::{NucleiDistribution, Stream};
use serde::{Deserialize, Serialize};

/// Many bubbles in a flow that is given.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BubbleCloud {
    /// Bubbles at the start.
    pub count: u64,
    /// Seed of places and sizes.
    pub seed: u64,
    /// Intervals of x, y, z, m.
    pub region: [[f64; 2]; 3],
    /// Radii at the start.
    pub nuclei: NucleiDistribution,
    /// The flow with its wall.
    pub flow: Flow,
    /// Half side (m) of the square of the wall on which impacts are counted, and elements along its side.
    pub map: Option<(f64, u64)>,
    /// Pressure of rest, Pa; that of the flow if none.
    pub equilibrium_pressure: Option<f64>,
    /// Of the gas.
    pub polytropic_exponent: f64,
    /// Density of the bubbles at the start, kg/m3.
    pub gas_density: f64,
    /// The liquid.
    pub liquid: Liquid,
    /// Law of the radius.
    pub model: Model,
    /// Error allowed in each step of a radius.
    pub tolerance: f64,
    /// Forces.
    pub forces: Forces,
    /// Whether the flow is averaged over surfaces.
    pub surface_average: bool,
    /// Whether the slip lowers the pressure.
    pub slip: bool,
    /// Bubbles with a table of their path.
    pub followed: u64,
}

impl BubbleCloud {
    /// The bubbles at the start: places uniform in the region, radii of the distribution, at the speed of the flow.
    ///
    /// # Errors
    /// A sentence about the first bubble that cannot be.
    pub fn bubbles(&self) -> Result<Vec<NewBubble>, String> {
        let stream = Stream { seed: self.seed };
        let [sizes, x, y, z] = [0, 1, 2, 3].map(|k| stream.branch(k));
        (0..self.count)
            .map(|i| {
                let place = |axis: usize, stream: Stream| {
                    let [from, to] = self.region[axis];
                    from + (to - from) * stream.uniform(i)
                };
                let position = [place(0, x), place(1, y), place(2, z)];
                self.bubble(position, self.nuclei.sample(sizes, i))
                    .map_err(|why| format!("bubble {i}: {why}"))
            })
            .collect()
    }

    fn bubble(&self, position: [f64; 3], radius: f64) -> Result<NewBubble, String> {
        let flow = self.flow.at(position, 0.0).map_err(|e| e.to_string())?;
        let rest = self.equilibrium_pressure.unwrap_or(flow.pressure);
        let gas = equilibrium_gas(&self.liquid, radius, rest, self.polytropic_exponent)
            .map_err(|e| e.to_string())?;
        Ok(NewBubble {
            position,
            velocity: flow.velocity,
            radius,
            wall_velocity: 0.0,
            gas,
            mass: self.gas_density * volume(radius),
        })
    }
}

/// Reads `[setup.bubble_cloud]`.
pub(crate) fn bubble_cloud(f: Fields<'_>, findings: &mut Findings) -> Option<BubbleCloud> {
    let region = region(f, findings);
    let liquid = liquid(f.table("liquid")?)?;
    let wall = f.table("wall");
    let forces = forces(f.table("forces")?)?;
    let flow = Flow::read(f, &liquid, wall.is_some(), forces.gravity[2])?;
    let cloud = BubbleCloud {
        count: whole(f, "count")?,
        seed: whole(f, "seed")?,
        region: region?,
        nuclei: nuclei(f)?,
        map: match wall {
            Some(w) => Some((w.number("extent")?, whole(w, "elements")?)),
            None => None,
        },
        equilibrium_pressure: match f.node("equilibrium_pressure") {
            Some(_) => Some(f.number("equilibrium_pressure")?),
            None => None,
        },
        polytropic_exponent: f.number("polytropic_exponent")?,
        gas_density: f.number("gas_density")?,
        model: model(f)?,
        tolerance: f.number("tolerance")?,
        surface_average: f.switch("surface_average")?,
        slip: f.switch("slip")?,
        followed: whole(f, "followed")?,
        flow,
        liquid,
        forces,
    };
    if let Err(why) = cloud.bubbles() {
        let help = "move the region into the flow, raise the pressure above the threshold, or give an equilibrium_pressure";
        let message = format!("the cloud cannot start: {why}");
        findings.error(f.at("region"), message, "bubbles start here", help);
        return None;
    }
    Some(cloud)
}

#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
// checked to be a whole number below 2^53
fn whole(f: Fields<'_>, key: &str) -> Option<u64> {
    f.number(key).map(|x| x as u64)
}

fn region(f: Fields<'_>, findings: &mut Findings) -> Option<[[f64; 2]; 3]> {
    let r = f.table("region")?;
    let mut all = [[0.0; 2]; 3];
    for (interval, key) in all.iter_mut().zip(["x", "y", "z"]) {
        *interval = r.pair(key)?;
        if interval[0] > interval[1] {
            let help = "write the smaller number first";
            findings.error(
                r.at(key),
                format!("`{key}` runs from a larger to a smaller number"),
                "reversed",
                help,
            );
        }
    }
    Some(all)
}

fn nuclei(f: Fields<'_>) -> Option<NucleiDistribution> {
    let (name, n) = f.chosen("nuclei")?;
    Some(match name {
        "constant" => NucleiDistribution::Constant {
            radius: n.number("radius")?,
        },
        "lognormal" => NucleiDistribution::Lognormal {
            median: n.number("median")?,
            deviation: n.number("deviation")?,
        },
        "rayleigh" => NucleiDistribution::Rayleigh {
            mode: n.number("mode")?,
        },
        _ => NucleiDistribution::Measured,
    })
}

fn forces(f: Fields<'_>) -> Option<Forces> {
    let on = |key| f.switch(key);
    Some(Forces {
        pressure: if on("pressure_gradient")? {
            PressureForce::Acceleration
        } else {
            PressureForce::Off
        },
        added_mass: on("added_mass")?,
        volume_change: on("volume_change")?,
        drag: if on("drag")? {
            DragLaw::HabermanMorton
        } else {
            DragLaw::Off
        },
        lift: if on("lift")? {
            LiftLaw::Inviscid
        } else {
            LiftLaw::Off
        },
        gravity: [0.0, 0.0, -f.number("gravity")?],
    })
}

/// What `resolved.toml` says of it.
pub(crate) fn bubble_cloud_items(c: &BubbleCloud) -> Items {
    let mut items = vec![
        ("count", Item::Whole(c.count)),
        ("seed", Item::Whole(c.seed)),
        ("polytropic_exponent", Item::Number(c.polytropic_exponent)),
        ("gas_density", Item::Number(c.gas_density)),
        ("tolerance", Item::Number(c.tolerance)),
        ("surface_average", Item::Switch(c.surface_average)),
        ("slip", Item::Switch(c.slip)),
        ("followed", Item::Whole(c.followed)),
    ];
    items.extend(
        c.equilibrium_pressure
            .map(|p| ("equilibrium_pressure", Item::Number(p))),
    );
    let axes = ["x", "y", "z"].into_iter().zip(c.region);
    items.push((
        "region",
        Item::Table(axes.map(|(k, v)| (k, Item::Pair(v))).collect()),
    ));
    items.push(("nuclei", nuclei_item(c.nuclei)));
    items.push(("flow", c.flow.item()));
    items.extend(c.map.map(|(extent, elements)| {
        let keys = vec![
            ("extent", Item::Number(extent)),
            ("elements", Item::Whole(elements)),
        ];
        ("wall", Item::Table(keys))
    }));
    items.push(("liquid", Item::Table(liquid_items(&c.liquid))));
    items.push(("model", model_item(&c.model)));
    items.push(("forces", forces_item(&c.forces)));
    items
}

fn nuclei_item(n: NucleiDistribution) -> Item {
    let number = |key, x| (key, Item::Number(x));
    let (name, keys) = match n {
        NucleiDistribution::Constant { radius } => ("constant", vec![number("radius", radius)]),
        NucleiDistribution::Lognormal { median, deviation } => (
            "lognormal",
            vec![number("median", median), number("deviation", deviation)],
        ),
        NucleiDistribution::Rayleigh { mode } => ("rayleigh", vec![number("mode", mode)]),
        NucleiDistribution::Measured => ("measured", Vec::new()),
    };
    Item::Table(vec![(name, Item::Table(keys))])
}

fn forces_item(f: &Forces) -> Item {
    Item::Table(vec![
        (
            "pressure_gradient",
            Item::Switch(f.pressure != PressureForce::Off),
        ),
        ("added_mass", Item::Switch(f.added_mass)),
        ("volume_change", Item::Switch(f.volume_change)),
        ("drag", Item::Switch(f.drag != DragLaw::Off)),
        ("lift", Item::Switch(f.lift != LiftLaw::Off)),
        ("gravity", Item::Number(-f.gravity[2])),
    ])
}
