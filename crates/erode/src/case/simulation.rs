//! What a run needs: a case after checking, every default filled in, SI throughout.

use super::{bubbles::SingleBubble, cloud::BubbleCloud, impacts::Impacts, loads::Loads};
use erode_physics::{Elastic, damage::Damage, eos::Tait, strength::Strength};
use erode_sph::{Geometry, packing::Spacing, shapes::Shape};
use serde::{Deserialize, Serialize};

/// A checked case. Nothing behind this type reads user text.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Simulation {
    /// One line for people.
    pub title: String,
    /// Plane or axisymmetric.
    pub geometry: Geometry,
    /// Bodies in the order of the case file; names are unique.
    pub bodies: Vec<Body>,
    /// Duration and stepping.
    pub run: Run,
    /// What is written, and how often.
    pub output: Output,
    /// Points where fields are recorded; names are unique.
    pub probes: Vec<Probe>,
    /// Where the cavity is at the start, for monitors and theory.
    pub bubble: Option<Bubble>,
    /// What acts on the solids.
    #[serde(default)]
    pub loads: Loads,
    /// Bubbles that collapse one after the other next to the same wall; `run.end_time` is then the time of the first one.
    #[serde(default)]
    pub impacts: Option<Impacts>,
    /// A spherical bubble in unbounded liquid; there are no bodies then.
    pub single_bubble: Option<SingleBubble>,
    /// A cloud of bubbles in a given flow; there are no bodies then.
    pub bubble_cloud: Option<BubbleCloud>,
}

impl Simulation {
    /// The body of that name.
    #[must_use]
    pub fn body(&self, name: &str) -> Option<&Body> {
        self.bodies.iter().find(|b| b.name == name)
    }
}

/// Duration and stepping of a run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Run {
    /// Simulated time at the end, s.
    pub end_time: f64,
    /// Step as a fraction of h / wave speed, dimensionless.
    pub safety: f64,
    /// Stop after this many steps, if given.
    pub max_steps: Option<u64>,
}

/// Intervals of output, all in seconds of simulated time.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Output {
    /// Field files.
    pub fields_every: f64,
    /// Rows of `history.csv` and of the probes.
    pub history_every: f64,
    /// Checkpoints.
    pub checkpoint_every: f64,
}

/// A point fixed in space where the fields of one body are recorded.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Probe {
    /// Name of the probe and of its file.
    pub name: String,
    /// Body whose fields are read.
    pub body: String,
    /// (r, z) or (x, y), m.
    pub position: [f64; 2],
}

/// The empty cavity at the start.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Bubble {
    /// Centre, m.
    pub centre: [f64; 2],
    /// Radius, m.
    pub radius: f64,
    /// Distance of the centre from the wall, m; none without a wall.
    pub wall_distance: Option<f64>,
    /// Pressure that drives the collapse, Pa.
    pub driving_pressure: f64,
    /// Gas in it; empty without.
    #[serde(default)]
    pub gas: Option<BubbleGas>,
}

/// Gas in the cavity.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct BubbleGas {
    /// Pressure at the start, Pa.
    pub pressure: f64,
    /// Exponent k in p V^k = constant.
    pub polytropic_exponent: f64,
}

impl BubbleGas {
    /// Cavities hold gas within this many radii of the bubble's centre: it may grow to that.
    pub const REACH: f64 = 2.5;

    /// Radius at rest in a liquid of this pressure (Pa) / radius at the start.
    #[must_use]
    pub fn equilibrium(&self, pressure: f64) -> f64 {
        (self.pressure / pressure).powf(1.0 / (3.0 * self.polytropic_exponent))
    }
}

/// A region filled with particles of one material.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Body {
    /// Unique name.
    pub name: String,
    /// Liquid or solid, with its laws.
    pub kind: BodyKind,
    /// Region.
    pub shape: Shape,
    /// Regions left empty.
    pub holes: Vec<Shape>,
    /// Particle spacing.
    pub spacing: Spacing,
    /// What lies at the four sides.
    pub sides: Sides,
}

/// Liquid or solid.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum BodyKind {
    /// A compressible liquid.
    Fluid(Fluid),
    /// An elastic-plastic solid.
    Solid(Solid),
}

/// A compressible liquid.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Fluid {
    /// Name in the material library.
    pub material: String,
    /// Equation of state.
    pub eos: Tait,
    /// Discrete form.
    pub formulation: FluidFormulation,
    /// Pressure at the start, Pa.
    pub pressure: f64,
    /// Velocity at the start, m/s.
    pub velocity: [f64; 2],
}

impl Fluid {
    /// Refinement that follows the cavity, if the case asks for it.
    #[must_use]
    pub fn refinement(&self) -> Option<Refinement> {
        match self.formulation {
            FluidFormulation::Corrected { refinement, .. } => refinement,
            FluidFormulation::Joshi { .. } => None,
        }
    }
}

/// Discrete forms of the liquid.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum FluidFormulation {
    /// Corrected divergence, Riemann pair values, shifting that carries mass.
    Corrected {
        /// Strength k of the shifting velocity, dimensionless.
        shifting: f64,
        /// Refinement that follows the cavity.
        #[serde(default)]
        refinement: Option<Refinement>,
    },
    /// The published form: summation density with f1, artificial viscosity (Joshi 2018, eqs 5.29, 6.7 to 6.9).
    Joshi {
        /// Linear artificial viscosity.
        alpha: f64,
        /// Quadratic artificial viscosity.
        beta: f64,
    },
}

/// Wanted spacing near a cavity: its radius / `per_radius` + `growth` times distance.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Refinement {
    /// Particles per radius that the cavity has now.
    pub per_radius: f64,
    /// Growth of the spacing per distance from the surface.
    pub growth: f64,
    /// Least radius that is followed, in units of that at the start.
    pub smallest: f64,
}

/// A layer of another material at the top of a solid.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Layer {
    /// Thickness, m.
    pub thickness: f64,
    /// Name in the material library.
    pub material: String,
    /// Density at rest, kg/m3.
    pub density: f64,
    /// Elastic constants.
    pub elastic: Elastic,
    /// Yield law.
    pub strength: Strength,
    /// When it fails.
    pub damage: Damage,
}

/// An elastic-plastic solid.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Solid {
    /// Name in the material library; of what lies below the layers.
    pub material: String,
    /// Layers of other materials at the top, the first one uppermost.
    #[serde(default)]
    pub layers: Vec<Layer>,
    /// Density at rest, kg/m3.
    pub density: f64,
    /// Elastic constants.
    pub elastic: Elastic,
    /// Yield law; without the strain-rate term its `c` is zero.
    pub strength: Strength,
    /// When it fails.
    #[serde(default)]
    pub damage: Damage,
    /// Discrete form.
    pub formulation: SolidFormulation,
    /// Velocity at the start, m/s.
    pub velocity: [f64; 2],
}

/// Discrete forms of the solid.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SolidFormulation {
    /// Neighbours and gradients of the reference configuration.
    TotalLagrangian {
        /// Linear viscosity alpha on approach, dimensionless.
        viscosity: f64,
        /// Hourglass penalty zeta, dimensionless.
        hourglass: f64,
        /// Stretch at which the reference configuration is renewed; never when absent.
        #[serde(default)]
        renewal: Option<f64>,
    },
    /// The published updated form (Joshi 2018, eqs 5.46, 5.47).
    Joshi {
        /// Linear artificial viscosity.
        alpha: f64,
        /// Quadratic artificial viscosity.
        beta: f64,
        /// Share of the neighbours' velocity in the motion; 0 is off.
        xsph: f64,
    },
}

/// The four sides of a rectangle; what a disc has none of stays free.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Sides {
    /// Smallest first coordinate.
    pub left: Side,
    /// Largest first coordinate.
    pub right: Side,
    /// Smallest second coordinate.
    pub bottom: Side,
    /// Largest second coordinate.
    pub top: Side,
}

/// What lies behind a side.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Side {
    /// The axis of symmetry, r = 0.
    Axis,
    /// A frictionless wall at rest: a mirror.
    Rigid,
    /// A wall at rest to which a solid is bonded.
    Clamped,
    /// Nothing: zero traction.
    #[default]
    Free,
    /// The body goes on without end; outgoing waves leave.
    NonReflecting {
        /// Pressure far away at the start, Pa.
        pressure: f64,
        /// A wave that enters through this side.
        wave: Option<Wave>,
    },
    /// Contact with another body.
    Interface {
        /// Its name.
        with: String,
    },
}

/// A pressure step that enters through a side and stays on.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Wave {
    /// Rise of pressure, Pa.
    pub pressure: f64,
    /// When the step enters, s.
    pub start: f64,
}
