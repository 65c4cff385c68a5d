//! The keys of `[[body]]`.

use super::{
    keys::ANY_PRESSURE,
    keys_damage::DAMAGE,
    keys_material::{ELASTIC, STRENGTH, TAIT},
    keys_region::{SHAPE, SIDES},
    schema::{
        Key,
        Kind::{List, Name, Pair, Property, Quantity, Switch, Table as Nested, Text},
        Range::{NotNegative, Positive, Within},
        Table, default, optional, required, table,
    },
    units::{DENSITY, LENGTH, NUMBER, VELOCITY},
};

pub(crate) static BODY: Table = Table {
    about: "a region filled with particles of one material",
    keys: &[
        required("name", Name, "unique name"),
        optional("fluid", Nested(&FLUID), "the body is a liquid"),
        optional(
            "solid",
            Nested(&SOLID),
            "the body is an elastic-plastic solid",
        ),
        required("shape", Nested(&SHAPE), "region"),
        optional("hole", List(&SHAPE), "a region left empty"),
        required("spacing", Nested(&SPACING), "particle spacing"),
        optional(
            "sides",
            Nested(&SIDES),
            "what lies behind the four sides of a rectangle",
        ),
    ],
    one_of: &["fluid", "solid"],
};

static FLUID: Table = table(
    "a compressible liquid",
    &[
        required("material", Text, "name in the material library"),
        optional(
            "tait",
            Nested(&TAIT),
            "constants that replace those of the material",
        ),
        default("pressure", ANY_PRESSURE, "0", "pressure at the start"),
        default("velocity", Pair(VELOCITY), "0", "velocity at the start"),
        default(
            "formulation",
            Nested(&FLUID_FORMULATION),
            "corrected",
            "discrete form",
        ),
    ],
);

pub(crate) static FLUID_FORMULATION: Table = Table {
    about: "discrete form of a liquid",
    keys: &[
        optional(
            "corrected",
            Nested(&CORRECTED),
            "corrected divergence, Riemann pair values, shifting",
        ),
        optional(
            "joshi",
            Nested(&JOSHI_FLUID),
            "as published (Joshi 2018): summation density, artificial viscosity",
        ),
    ],
    one_of: &["corrected", "joshi"],
};

static CORRECTED: Table = table(
    "corrected divergence, Riemann pair values, shifting that carries mass",
    &[
        default(
            "shifting",
            Quantity(NUMBER, NotNegative),
            "10",
            "strength k of the shifting velocity",
        ),
        optional(
            "refinement",
            Nested(&REFINEMENT),
            "particles are halved near the cavity as it shrinks, and merged again; without this key they never are",
        ),
    ],
);

static REFINEMENT: Table = table(
    "wanted spacing near the cavity: its radius / per_radius + growth * distance from its surface",
    &[
        default(
            "per_radius",
            Quantity(NUMBER, Within(4.0, 200.0)),
            "20",
            "particles per radius that the cavity has now",
        ),
        default(
            "growth",
            Quantity(NUMBER, Within(0.02, 1.0)),
            "0.06",
            "growth of the spacing per distance from the surface",
        ),
        default(
            "smallest",
            Quantity(NUMBER, Within(0.01, 1.0)),
            "0.05",
            "a cavity is followed down to this radius / radius of the bubble at the start",
        ),
    ],
);

const ALPHA_KEY: Key = default(
    "alpha",
    Quantity(NUMBER, NotNegative),
    "1",
    "linear artificial viscosity",
);
const BETA_KEY: Key = default(
    "beta",
    Quantity(NUMBER, NotNegative),
    "2",
    "quadratic artificial viscosity",
);

static JOSHI_FLUID: Table = table(
    "as published (Joshi 2018): summation density with f1, artificial viscosity",
    &[ALPHA_KEY, BETA_KEY],
);

const DENSITY_KEY: Key = optional(
    "density",
    Property(DENSITY, Positive),
    "density; replaces the material's",
);
const ELASTIC_KEY: Key = optional(
    "elastic",
    Nested(&ELASTIC),
    "constants that replace those of the material",
);
const STRENGTH_KEY: Key = optional(
    "strength",
    Nested(&STRENGTH),
    "yield law that replaces that of the material",
);
const STRAIN_RATE_KEY: Key = default(
    "strain_rate",
    Switch,
    "true",
    "whether the yield stress grows with the strain rate",
);

/// Layers of other materials at the top of a solid; also in setups.
pub(crate) static LAYER: Table = table(
    "a layer of another material, a coating; the first of a list lies at the top",
    &[
        required(
            "thickness",
            Quantity(LENGTH, Positive),
            "thickness, at least one particle spacing",
        ),
        required("material", Text, "name in the material library"),
        DENSITY_KEY,
        ELASTIC_KEY,
        STRENGTH_KEY,
        optional(
            "damage",
            Nested(&DAMAGE),
            "law by which the layer fails; constants not given are the material's, without this key it never fails",
        ),
        STRAIN_RATE_KEY,
        default(
            "thermal_softening",
            Switch,
            "false",
            "whether the yield stress falls as plastic work heats the layer",
        ),
    ],
);

static SOLID: Table = table(
    "an elastic-plastic solid",
    &[
        required("material", Text, "name in the material library"),
        optional(
            "layers",
            List(&LAYER),
            "layers of other materials at the top, the first one uppermost",
        ),
        DENSITY_KEY,
        ELASTIC_KEY,
        STRENGTH_KEY,
        optional(
            "damage",
            Nested(&DAMAGE),
            "law by which it fails; constants not given are the material's, without this key it never fails",
        ),
        STRAIN_RATE_KEY,
        default(
            "thermal_softening",
            Switch,
            "false",
            "whether the yield stress falls as plastic work heats the body",
        ),
        default("velocity", Pair(VELOCITY), "0", "velocity at the start"),
        default(
            "formulation",
            Nested(&SOLID_FORMULATION),
            "total_lagrangian",
            "discrete form",
        ),
    ],
);

pub(crate) static SOLID_FORMULATION: Table = Table {
    about: "discrete form of a solid",
    keys: &[
        optional(
            "total_lagrangian",
            Nested(&TOTAL_LAGRANGIAN),
            "neighbours and gradients of the reference configuration",
        ),
        optional(
            "joshi",
            Nested(&JOSHI_SOLID),
            "as published (Joshi 2018): updated configuration",
        ),
    ],
    one_of: &["total_lagrangian", "joshi"],
};

static TOTAL_LAGRANGIAN: Table = table(
    "neighbours and gradients of the reference configuration",
    &[
        default(
            "viscosity",
            Quantity(NUMBER, NotNegative),
            "0.2",
            "linear viscosity on approach",
        ),
        default(
            "hourglass",
            Quantity(NUMBER, NotNegative),
            "0.1",
            "penalty on motion that the gradient does not see",
        ),
        optional(
            "renewal",
            Quantity(NUMBER, Within(1.05, 100.0)),
            "stretch since the last one at which the present configuration becomes the reference; never when absent",
        ),
    ],
);

static JOSHI_SOLID: Table = table(
    "as published (Joshi 2018): updated configuration",
    &[
        ALPHA_KEY,
        BETA_KEY,
        default(
            "xsph",
            Quantity(NUMBER, Within(0.0, 1.0)),
            "0",
            "share of the neighbours' velocity in the motion",
        ),
    ],
);

static SPACING: Table = table(
    "particle spacing",
    &[
        required(
            "finest",
            Quantity(LENGTH, Positive),
            "spacing inside the core",
        ),
        optional(
            "coarsest",
            Quantity(LENGTH, Positive),
            "largest spacing; `finest` when absent",
        ),
        default(
            "growth",
            Quantity(NUMBER, Within(0.0, 0.2)),
            "0.06",
            "increase of spacing per distance from the core",
        ),
        optional(
            "core",
            Nested(&SHAPE),
            "where the spacing is finest; everywhere when absent",
        ),
    ],
);
