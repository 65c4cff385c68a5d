//! The keys of `[setup.bubble_cloud]`.

use super::{
    keys_bubbles::{EXPONENT, LIQUID, MODEL},
    schema::{
        Kind::{Count, Pair, Quantity, Switch},
        Range::{Any, NotNegative, Positive, Within},
        Table, default, optional, required, table,
    },
    units::{ACCELERATION, CIRCULATION, DENSITY, LENGTH, NUMBER, PRESSURE, RATE},
};
use crate::case::schema::Kind::Table as Nested;

pub(crate) static BUBBLE_CLOUD: Table = table(
    "many spherical bubbles that a given flow carries; a wall, if there is one, is z = 0 with the liquid above it",
    &[
        required("count", Count(1), "number of bubbles at the start"),
        default(
            "seed",
            Count(0),
            "1",
            "seed of the random places and sizes; the same seed gives the same cloud",
        ),
        required("region", Nested(&REGION), "box in which the bubbles start"),
        required(
            "nuclei",
            Nested(&NUCLEI),
            "distribution of their radii at the start",
        ),
        required(
            "flow",
            Nested(&FLOW),
            "the flow that carries them; it does not feel them",
        ),
        optional(
            "wall",
            Nested(&WALL),
            "a plane wall z = 0 on which impacts are counted",
        ),
        optional(
            "equilibrium_pressure",
            Quantity(PRESSURE, Any),
            "pressure at which the bubbles rest with their gas; that of the flow at their place when absent",
        ),
        default(
            "polytropic_exponent",
            EXPONENT,
            "1.3333333333333333",
            "polytropic exponent of the gas",
        ),
        default(
            "gas_density",
            Quantity(DENSITY, NotNegative),
            "1.2",
            "density of the bubbles at the start",
        ),
        default(
            "liquid",
            Nested(&LIQUID),
            "",
            "constants of the liquid; water at 20 C when absent",
        ),
        default(
            "model",
            Nested(&MODEL),
            "keller_miksis",
            "law of the radius",
        ),
        default(
            "tolerance",
            Quantity(NUMBER, Within(1e-13, 1e-3)),
            "1e-8",
            "error allowed in each step of a radius",
        ),
        default("forces", Nested(&FORCES), "", "forces on the bubbles"),
        default(
            "surface_average",
            Switch,
            "false",
            "whether the flow is averaged over the surface of each bubble",
        ),
        default(
            "slip",
            Switch,
            "false",
            "whether the slip lowers the pressure on a bubble (last term of eq. 3.36)",
        ),
        default(
            "followed",
            Count(0),
            "10",
            "the first so many bubbles get a table of their path",
        ),
    ],
);

static REGION: Table = table(
    "a box; a point where both ends of an interval are equal",
    &[
        required("x", Pair(LENGTH), "from, to"),
        required("y", Pair(LENGTH), "from, to"),
        required("z", Pair(LENGTH), "from, to"),
    ],
);

static NUCLEI: Table = Table {
    about: "distribution of radii",
    keys: &[
        optional("constant", Nested(&CONSTANT), "all alike"),
        optional("lognormal", Nested(&LOGNORMAL), "normal in the logarithm"),
        optional("rayleigh", Nested(&RAYLEIGH), "Rayleigh's distribution"),
        optional(
            "measured",
            Nested(&NONE),
            "measured in a cavitating jet (eq. 3.44, normalised)",
        ),
    ],
    one_of: &["constant", "lognormal", "rayleigh", "measured"],
};

static NONE: Table = table("no keys", &[]);

static CONSTANT: Table = table(
    "all alike",
    &[required("radius", Quantity(LENGTH, Positive), "radius")],
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

static RAYLEIGH: Table = table(
    "Rayleigh's distribution",
    &[required(
        "mode",
        Quantity(LENGTH, Positive),
        "most frequent radius",
    )],
);

static FLOW: Table = Table {
    about: "a flow that is given",
    keys: &[
        optional("still", Nested(&STILL), "liquid at rest"),
        optional(
            "acoustic",
            Nested(&ACOUSTIC),
            "liquid at rest whose pressure swings everywhere alike",
        ),
        optional(
            "vortex",
            Nested(&VORTEX),
            "a Lamb-Oseen vortex around the z axis",
        ),
        optional(
            "stagnation",
            Nested(&STAGNATION),
            "axisymmetric flow against the wall z = 0",
        ),
    ],
    one_of: &["still", "acoustic", "vortex", "stagnation"],
};

static STILL: Table = table(
    "liquid at rest",
    &[required(
        "pressure",
        Quantity(PRESSURE, Any),
        "pressure at z = 0",
    )],
);

static ACOUSTIC: Table = table(
    "mean - amplitude sin(2 pi frequency t) everywhere",
    &[
        required(
            "mean",
            Quantity(PRESSURE, Any),
            "pressure around which it swings",
        ),
        required(
            "amplitude",
            Quantity(PRESSURE, Any),
            "largest departure from the mean",
        ),
        required("frequency", Quantity(RATE, Positive), "periods per second"),
    ],
);

static VORTEX: Table = table(
    "a vortex around the z axis, counter-clockwise for a positive circulation",
    &[
        required(
            "circulation",
            Quantity(CIRCULATION, Any),
            "circulation far from the axis",
        ),
        required(
            "core_radius",
            Quantity(LENGTH, Positive),
            "radius of the fastest flow",
        ),
        required(
            "far_pressure",
            Quantity(PRESSURE, Any),
            "pressure far from the axis",
        ),
        default(
            "balanced",
            Switch,
            "true",
            "whether pressure and speed are in balance; if not, as in the source with the outer speed corrected",
        ),
    ],
);

static STAGNATION: Table = table(
    "u = a (x, y, -2 z); its wall is z = 0",
    &[
        required("strain_rate", Quantity(RATE, Positive), "a"),
        required(
            "pressure",
            Quantity(PRESSURE, Any),
            "pressure at the stagnation point",
        ),
    ],
);

static WALL: Table = table(
    "a square of the plane z = 0 around the origin, in equal elements",
    &[
        required(
            "extent",
            Quantity(LENGTH, Positive),
            "half the side of the square",
        ),
        default("elements", Count(1), "20", "elements along a side"),
    ],
);

static FORCES: Table = table(
    "which forces act on a bubble (eqs 3.24 to 3.32, corrected)",
    &[
        default(
            "pressure_gradient",
            Switch,
            "true",
            "acceleration of the liquid around it",
        ),
        default("added_mass", Switch, "true", "added mass"),
        default(
            "volume_change",
            Switch,
            "true",
            "change of the added mass with the volume",
        ),
        default("drag", Switch, "true", "drag of Haberman and Morton"),
        default("lift", Switch, "true", "inviscid lift"),
        default(
            "gravity",
            Quantity(ACCELERATION, NotNegative),
            "0",
            "weight and buoyancy, along -z",
        ),
    ],
);
