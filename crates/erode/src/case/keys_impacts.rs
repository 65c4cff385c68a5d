//! The keys of repeated impacts: `[impacts]`.

use super::{
    schema::{
        Kind::{Count, List, Quantity},
        Range::{Any, Between, Positive},
        Table, default, optional, required, table,
    },
    units::{LENGTH, NUMBER, PRESSURE, RATE, TIME},
};
use crate::case::schema::Kind::Table as Nested;

pub(crate) static IMPACTS: Table = Table {
    about: "bubbles that collapse one after the other next to the same wall, which settles after each",
    keys: &[
        optional(
            "bubble",
            List(&BUBBLE),
            "the bubbles in their order; what is not given is that of the first bubble of the case",
        ),
        optional("random", Nested(&RANDOM), "bubbles drawn by chance"),
        default(
            "settling",
            Nested(&SETTLING),
            "",
            "how the wall comes to rest after each impact",
        ),
    ],
    one_of: &["bubble", "random"],
};

static BUBBLE: Table = table(
    "one bubble, or several alike",
    &[
        default(
            "times",
            Count(1),
            "1",
            "number of impacts like this, one after the other",
        ),
        optional("radius", Quantity(LENGTH, Positive), "radius"),
        optional(
            "standoff",
            Quantity(NUMBER, Positive),
            "distance from the bubble's centre to the wall / radius",
        ),
        default(
            "position",
            Quantity(LENGTH, Any),
            "0",
            "place along the wall; 0: all bubbles lie on the axis, or on the plane of symmetry",
        ),
        optional(
            "driving_pressure",
            Quantity(PRESSURE, Positive),
            "pressure step that arrives from the far side",
        ),
        optional(
            "duration",
            Quantity(TIME, Positive),
            "time until the liquid is taken away; run.end_time, or what the setup proposes, when absent",
        ),
    ],
);

static RANDOM: Table = table(
    "bubbles drawn by chance: the same seed gives the same bubbles",
    &[
        required("count", Count(1), "number of impacts that are drawn"),
        default("seed", Count(0), "1", "seed of the random numbers"),
        optional(
            "radius",
            Nested(&RADIUS),
            "distribution of the radii; that of the case when absent",
        ),
        optional(
            "standoff",
            Nested(&STANDOFF),
            "distribution of the stand-offs; that of the case when absent",
        ),
    ],
);

static RADIUS: Table = Table {
    about: "distribution of radii",
    keys: &[
        optional(
            "uniform",
            Nested(&UNIFORM_RADIUS),
            "evenly between two radii",
        ),
        optional("lognormal", Nested(&LOGNORMAL), "normal in the logarithm"),
    ],
    one_of: &["uniform", "lognormal"],
};

static UNIFORM_RADIUS: Table = table(
    "evenly between two radii",
    &[
        required("smallest", Quantity(LENGTH, Positive), "smallest radius"),
        required("largest", Quantity(LENGTH, Positive), "largest radius"),
    ],
);

static LOGNORMAL: Table = table(
    "normal in the logarithm",
    &[
        required("median", Quantity(LENGTH, Positive), "median radius"),
        required(
            "deviation",
            Quantity(NUMBER, Positive),
            "standard deviation of the logarithm",
        ),
    ],
);

static STANDOFF: Table = Table {
    about: "distribution of stand-offs",
    keys: &[optional(
        "uniform",
        Nested(&UNIFORM_STANDOFF),
        "evenly between two stand-offs",
    )],
    one_of: &["uniform"],
};

static UNIFORM_STANDOFF: Table = table(
    "evenly between two stand-offs",
    &[
        required("smallest", Quantity(NUMBER, Positive), "smallest stand-off"),
        required("largest", Quantity(NUMBER, Positive), "largest stand-off"),
    ],
);

static SETTLING: Table = table(
    "mass damping of the wall without liquid until next to nothing of its motion is left",
    &[
        default(
            "residual",
            Quantity(NUMBER, Between(0.0, 1.0)),
            "1e-6",
            "kinetic energy of the wall at which it counts as settled / largest since the impact began",
        ),
        optional(
            "damping",
            Quantity(RATE, Positive),
            "velocities fall as exp(-damping t); 2 x longitudinal wave speed / longer side of the wall when absent",
        ),
        optional(
            "longest",
            Quantity(TIME, Positive),
            "the next bubble comes after this time in any case; 50 / damping when absent",
        ),
    ],
);
