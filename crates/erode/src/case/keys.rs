//! The keys of a case file. This is the only list of them.

use super::{
    keys_body::{BODY, FLUID_FORMULATION, LAYER, SOLID_FORMULATION},
    keys_bubbles::SINGLE_BUBBLE,
    keys_cloud::BUBBLE_CLOUD,
    keys_damage::DAMAGE,
    keys_impacts::IMPACTS,
    keys_load::{INDENTATION, INDENTER, LOAD, PRESSURE_PULSE, SETTLING},
    keys_material::MATERIAL,
    schema::{
        Kind::{Count, List, Map, Name, Pair, Quantity, Switch, Text},
        Range::{Any, NotNegative, Positive, Within},
        Table, default, optional, required, table,
    },
    units::{LENGTH, NUMBER, PRESSURE, TIME},
};
use crate::case::schema::Kind::Table as Nested;

/// The whole file.
pub(crate) static CASE: Table = table(
    "an Erode case",
    &[
        default("title", Text, "", "one line for people"),
        default(
            "geometry",
            Nested(&GEOMETRY),
            "axisymmetric",
            "what the two coordinates mean",
        ),
        optional(
            "setup",
            Nested(&SETUP),
            "a ready-made arrangement; it expands into bodies",
        ),
        optional(
            "material",
            Map(&MATERIAL),
            "materials of this case; they complete or replace those of the library",
        ),
        optional(
            "body",
            List(&BODY),
            "a region filled with particles of one material",
        ),
        optional(
            "bubble",
            Nested(&BUBBLE),
            "where the empty cavity is, for monitors and theory; a setup knows it",
        ),
        optional(
            "indenter",
            Nested(&INDENTER),
            "a rigid indenter on the upper side of a solid",
        ),
        optional(
            "pressure",
            List(&LOAD),
            "a pressure on the upper side of a solid",
        ),
        optional(
            "settling",
            Nested(&SETTLING),
            "damping of the solids after a load",
        ),
        optional(
            "impacts",
            Nested(&IMPACTS),
            "bubbles that collapse one after the other next to the same wall",
        ),
        default("run", Nested(&RUN), "", "duration and stepping"),
        default(
            "output",
            Nested(&OUTPUT),
            "",
            "what is written, and how often",
        ),
        default(
            "checkpoint",
            Nested(&CHECKPOINT),
            "",
            "states from which a run can be resumed",
        ),
        optional(
            "probe",
            List(&PROBE),
            "a fixed point where fields are recorded",
        ),
    ],
);

static EMPTY: Table = table("no keys", &[]);

static GEOMETRY: Table = Table {
    about: "what the two coordinates mean",
    keys: &[
        optional(
            "axisymmetric",
            Nested(&EMPTY),
            "(r, z), rotational symmetry about r = 0",
        ),
        optional(
            "plane",
            Nested(&EMPTY),
            "(x, y), plane strain, per metre of thickness",
        ),
    ],
    one_of: &["axisymmetric", "plane"],
};

static SETUP: Table = Table {
    about: "a ready-made arrangement",
    keys: &[
        optional(
            "bubble_near_wall",
            Nested(&BUBBLE_NEAR_WALL),
            "a bubble, empty or with gas, next to a solid wall, hit by a pressure step",
        ),
        optional(
            "bubble_in_liquid",
            Nested(&BUBBLE_IN_LIQUID),
            "a bubble, empty or with gas, in liquid under pressure, far from walls",
        ),
        optional(
            "indentation",
            Nested(&INDENTATION),
            "a rigid sphere or cylinder pressed into a block",
        ),
        optional(
            "pressure_pulse",
            Nested(&PRESSURE_PULSE),
            "a block hit by a Gaussian pressure",
        ),
        optional(
            "single_bubble",
            Nested(&SINGLE_BUBBLE),
            "one spherical bubble of gas and vapour in unbounded liquid: its radius over time",
        ),
        optional(
            "bubble_cloud",
            Nested(&BUBBLE_CLOUD),
            "many bubbles that a given flow carries, and what their collapses announce for a wall",
        ),
    ],
    one_of: &[
        "bubble_near_wall",
        "bubble_in_liquid",
        "indentation",
        "pressure_pulse",
        "single_bubble",
        "bubble_cloud",
    ],
};

static BUBBLE_NEAR_WALL: Table = table(
    "a bubble, empty or with gas, next to a solid wall; the wall's surface is z = 0, the liquid is above it",
    &[
        required("radius", Quantity(LENGTH, Positive), "radius of the bubble"),
        required(
            "standoff",
            Quantity(NUMBER, Positive),
            "distance from the bubble's centre to the wall / radius",
        ),
        required(
            "driving_pressure",
            Quantity(PRESSURE, Positive),
            "pressure step that arrives from the far side",
        ),
        required(
            "particles_per_radius",
            Count(4),
            "resolution: radius / finest particle spacing",
        ),
        required("liquid", Text, "material of the liquid"),
        optional(
            "gas",
            Nested(&GAS),
            "gas in the bubble, in balance with the liquid until the step arrives; empty when absent",
        ),
        required("wall", Text, "material of the wall"),
        optional(
            "wall_layers",
            List(&LAYER),
            "layers of other materials on the wall, the first one uppermost",
        ),
        default(
            "coarsening",
            Quantity(NUMBER, Within(1.0, 32.0)),
            "8",
            "coarsest / finest particle spacing",
        ),
        default(
            "width",
            Quantity(NUMBER, Positive),
            "8",
            "radius of the domain / radius of the bubble",
        ),
        default(
            "height",
            Quantity(NUMBER, Positive),
            "4",
            "liquid above the bubble's centre / radius",
        ),
        default(
            "wall_depth",
            Quantity(NUMBER, Positive),
            "5",
            "thickness of the wall that is computed / radius",
        ),
        default(
            "liquid_formulation",
            Nested(&FLUID_FORMULATION),
            "corrected",
            "discrete form of the liquid",
        ),
        default(
            "wall_formulation",
            Nested(&SOLID_FORMULATION),
            "total_lagrangian",
            "discrete form of the wall",
        ),
        optional(
            "damage",
            Nested(&DAMAGE),
            "law by which the wall fails; constants not given are the material's, without this key it never fails",
        ),
        default(
            "strain_rate",
            Switch,
            "true",
            "whether the yield stress grows with the strain rate",
        ),
        default(
            "thermal_softening",
            Switch,
            "false",
            "whether the yield stress falls as plastic work heats the wall",
        ),
    ],
);

static BUBBLE_IN_LIQUID: Table = table(
    "a bubble, empty or with gas, in liquid under pressure from the start; its centre is (0, 0)",
    &[
        required("radius", Quantity(LENGTH, Positive), "radius of the bubble"),
        required(
            "pressure",
            Quantity(PRESSURE, Positive),
            "pressure everywhere in the liquid at the start",
        ),
        required(
            "particles_per_radius",
            Count(4),
            "resolution: radius / finest particle spacing",
        ),
        required("liquid", Text, "material of the liquid"),
        optional("gas", Nested(&GAS), "gas in the bubble; empty when absent"),
        default(
            "coarsening",
            Quantity(NUMBER, Within(1.0, 32.0)),
            "8",
            "coarsest / finest particle spacing",
        ),
        default(
            "domain",
            Quantity(NUMBER, Positive),
            "8",
            "extent of the liquid from the centre / radius",
        ),
        default(
            "liquid_formulation",
            Nested(&FLUID_FORMULATION),
            "corrected",
            "discrete form of the liquid",
        ),
    ],
);

/// Gas in the cavity at the start.
static GAS: Table = table(
    "gas in the bubble, of uniform pressure that follows its volume: p V^k is constant in each piece of it",
    &[
        required(
            "pressure",
            Quantity(PRESSURE, Positive),
            "pressure at the start",
        ),
        default(
            "polytropic_exponent",
            Quantity(NUMBER, Within(1.0, 5.0 / 3.0)),
            "1.4",
            "k: 1 isothermal, 1.4 adiabatic for air",
        ),
    ],
);

static BUBBLE: Table = table(
    "the cavity at the start, empty or with gas",
    &[
        required("centre", Pair(LENGTH), "centre"),
        required("radius", Quantity(LENGTH, Positive), "radius"),
        optional(
            "wall_distance",
            Quantity(LENGTH, NotNegative),
            "distance of the centre from the wall",
        ),
        required(
            "driving_pressure",
            Quantity(PRESSURE, Positive),
            "pressure that drives the collapse",
        ),
        optional("gas", Nested(&GAS), "gas in it; empty when absent"),
    ],
);

static RUN: Table = table(
    "duration and stepping",
    &[
        optional(
            "end_time",
            Quantity(TIME, Positive),
            "simulated time; a setup proposes one",
        ),
        default(
            "safety",
            Quantity(NUMBER, Positive),
            "0.3",
            "time step / (smoothing length / wave speed)",
        ),
        optional("max_steps", Count(1), "stop after this many steps"),
    ],
);

static OUTPUT: Table = table(
    "what is written, and how often in simulated time",
    &[
        optional(
            "fields_every",
            Quantity(TIME, Positive),
            "interval of field files; end_time / 40 when absent",
        ),
        optional(
            "history_every",
            Quantity(TIME, Positive),
            "interval of rows in history.csv and probes; end_time / 1000 when absent",
        ),
    ],
);

static CHECKPOINT: Table = table(
    "states from which a run can be resumed",
    &[optional(
        "every",
        Quantity(TIME, Positive),
        "interval in simulated time; end_time / 20 when absent",
    )],
);

static PROBE: Table = table(
    "a fixed point where fields are recorded",
    &[
        required("name", Name, "name of the probe and of its file"),
        required("body", Text, "name of the body whose fields are read"),
        required("position", Pair(LENGTH), "(r, z) or (x, y)"),
    ],
);

/// Initial or far pressure.
pub(crate) const ANY_PRESSURE: super::schema::Kind = Quantity(PRESSURE, Any);
