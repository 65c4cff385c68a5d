//! The keys of loads on solids: `[indenter]`, `[[pressure]]`, `[settling]`, and the setups made of them.

use super::{
    keys_body::{LAYER, SOLID_FORMULATION},
    keys_damage::DAMAGE,
    schema::{
        Kind::{Count, List, Quantity, Switch, Table as Nested, Text},
        Range::{Any, NotNegative, Positive, Within},
        Table, default, optional, required, table,
    },
    units::{LENGTH, NUMBER, PRESSURE, RATE, TIME},
};

pub(crate) static INDENTER: Table = table(
    "a rigid sphere (axisymmetry) or cylinder (plane strain) without friction, pressed on the upper side of a solid",
    &[
        required("body", Text, "name of the solid"),
        required("radius", Quantity(LENGTH, Positive), "radius"),
        required(
            "depth",
            Quantity(LENGTH, Positive),
            "how far it is pushed below the place where it first touches",
        ),
        default(
            "centre",
            Quantity(LENGTH, Any),
            "0",
            "place along the side; 0 in axisymmetry",
        ),
        required("ramp", Nested(&RAMP), "how the depth follows time"),
    ],
);

pub(crate) static LOAD: Table = Table {
    about: "a Gaussian pressure on the upper side of a solid, amplitude exp(-(2 r/diameter)^2)",
    keys: &[
        required("body", Text, "name of the solid"),
        required(
            "amplitude",
            Quantity(PRESSURE, Positive),
            "largest pressure",
        ),
        required(
            "diameter",
            Quantity(LENGTH, Positive),
            "extent: at half of it from the centre the pressure is 1/e of the largest",
        ),
        default(
            "centre",
            Quantity(LENGTH, Any),
            "0",
            "place along the side; 0 in axisymmetry",
        ),
        optional("ramp", Nested(&RAMP), "it rises, is held and taken away"),
        optional(
            "pulse",
            Nested(&PULSE),
            "it comes and goes as exp(-((t - peak_time)/rise_time)^2)",
        ),
    ],
    one_of: &["ramp", "pulse"],
};

static RAMP: Table = table(
    "a smooth rise, a hold, a smooth fall",
    &[
        default(
            "start",
            Quantity(TIME, NotNegative),
            "0",
            "when the rise begins",
        ),
        required(
            "rise",
            Quantity(TIME, Positive),
            "time of the rise; several transits of a wave through the body load it without inertia",
        ),
        default("hold", Quantity(TIME, NotNegative), "0", "time at the top"),
        default(
            "fall",
            Quantity(TIME, NotNegative),
            "0",
            "time in which the load is taken away; 0: it stays",
        ),
    ],
);

static PULSE: Table = table(
    "a Gaussian course in time",
    &[
        required(
            "peak_time",
            Quantity(TIME, NotNegative),
            "when the pressure is largest",
        ),
        required(
            "rise_time",
            Quantity(TIME, Positive),
            "before and after it the pressure is 1/e of the largest",
        ),
    ],
);

pub(crate) static SETTLING: Table = table(
    "mass damping of the solids, to come to rest after a load",
    &[
        required("start", Quantity(TIME, NotNegative), "when it begins"),
        default(
            "damping",
            Quantity(RATE, Positive),
            "5e6",
            "velocities fall as exp(-damping t)",
        ),
    ],
);

pub(crate) static INDENTATION: Table = table(
    "a rigid sphere or cylinder pressed slowly into a block and taken away again; the surface is z = 0",
    &[
        required("material", Text, "material of the block"),
        optional(
            "layers",
            List(&LAYER),
            "layers of other materials at the top, the first one uppermost",
        ),
        required(
            "radius",
            Quantity(LENGTH, Positive),
            "radius of the indenter",
        ),
        required(
            "depth",
            Quantity(LENGTH, Positive),
            "how far it is pushed in",
        ),
        required(
            "spacing",
            Quantity(LENGTH, Positive),
            "particle spacing beneath it",
        ),
        default(
            "width",
            Quantity(LENGTH, Positive),
            "0.001",
            "extent of the block from the axis",
        ),
        default(
            "height",
            Quantity(LENGTH, Positive),
            "0.0008",
            "height of the block",
        ),
        default(
            "coarsening",
            Quantity(NUMBER, Within(1.0, 32.0)),
            "4",
            "coarsest / finest particle spacing",
        ),
        optional(
            "rise",
            Quantity(TIME, Positive),
            "time of loading; 8 transits of a wave through the height when absent",
        ),
        default(
            "unload",
            Switch,
            "true",
            "whether the indenter is taken away again",
        ),
        default(
            "strain_rate",
            Switch,
            "false",
            "whether the yield stress grows with the strain rate: the computed rate is not that of a slow test",
        ),
        optional(
            "damage",
            Nested(&DAMAGE),
            "damage law; without it nothing fails",
        ),
        default(
            "formulation",
            Nested(&SOLID_FORMULATION),
            "total_lagrangian",
            "discrete form",
        ),
    ],
);

pub(crate) static PRESSURE_PULSE: Table = table(
    "a block hit by a Gaussian pressure in space and time, as of a cavitation impact; the surface is z = 0",
    &[
        required("material", Text, "material of the block"),
        optional(
            "layers",
            List(&LAYER),
            "layers of other materials at the top, the first one uppermost",
        ),
        required(
            "amplitude",
            Quantity(PRESSURE, Positive),
            "largest pressure",
        ),
        required(
            "diameter",
            Quantity(LENGTH, Positive),
            "extent: at half of it from the centre the pressure is 1/e of the largest",
        ),
        required(
            "rise_time",
            Quantity(TIME, Positive),
            "before and after its peak the pressure is 1/e of the largest",
        ),
        required(
            "particles_per_radius",
            Count(2),
            "resolution: half the diameter / finest particle spacing",
        ),
        default(
            "extent",
            Quantity(NUMBER, Positive),
            "6",
            "width and height of the block / half the diameter",
        ),
        default(
            "coarsening",
            Quantity(NUMBER, Within(1.0, 32.0)),
            "4",
            "coarsest / finest particle spacing",
        ),
        default(
            "strain_rate",
            Switch,
            "true",
            "whether the yield stress grows with the strain rate",
        ),
        optional(
            "damage",
            Nested(&DAMAGE),
            "damage law; without it nothing fails",
        ),
        default(
            "formulation",
            Nested(&SOLID_FORMULATION),
            "total_lagrangian",
            "discrete form",
        ),
    ],
);
