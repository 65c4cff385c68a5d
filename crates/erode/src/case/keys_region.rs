//! The keys of shapes and sides of a body.

use super::{
    keys::ANY_PRESSURE,
    schema::{
        Kind::{Pair, Quantity, Table as Nested, Text},
        Range::{NotNegative, Positive},
        Table, default, optional, required, table,
    },
    units::{LENGTH, PRESSURE, TIME},
};

pub(crate) static SHAPE: Table = Table {
    about: "a region of the plane",
    keys: &[
        optional(
            "rectangle",
            Nested(&RECTANGLE),
            "a rectangle with sides along the axes",
        ),
        optional(
            "disc",
            Nested(&DISC),
            "a disc; a ball in axisymmetry when centred on the axis",
        ),
    ],
    one_of: &["rectangle", "disc"],
};

static RECTANGLE: Table = table(
    "a rectangle with sides along the axes",
    &[
        required(
            "lower",
            Pair(LENGTH),
            "corner with the smallest coordinates",
        ),
        required("upper", Pair(LENGTH), "corner with the largest coordinates"),
    ],
);

static DISC: Table = table(
    "a disc",
    &[
        required("centre", Pair(LENGTH), "centre"),
        required("radius", Quantity(LENGTH, Positive), "radius"),
    ],
);

pub(crate) static SIDES: Table = table(
    "what lies behind the four sides of a rectangle",
    &[
        optional(
            "left",
            Nested(&SIDE),
            "smallest r or x; the axis when it lies at r = 0, else free",
        ),
        default("right", Nested(&SIDE), "free", "largest r or x"),
        default("bottom", Nested(&SIDE), "free", "smallest z or y"),
        default("top", Nested(&SIDE), "free", "largest z or y"),
    ],
);

static EMPTY: Table = table("no keys", &[]);

static SIDE: Table = Table {
    about: "what lies behind a side",
    keys: &[
        optional("axis", Nested(&EMPTY), "the axis of symmetry, r = 0"),
        optional("rigid", Nested(&EMPTY), "a frictionless wall at rest"),
        optional(
            "clamped",
            Nested(&EMPTY),
            "a wall at rest to which a solid is bonded",
        ),
        optional("free", Nested(&EMPTY), "nothing: zero traction"),
        optional(
            "non_reflecting",
            Nested(&NON_REFLECTING),
            "the body goes on without end; outgoing waves leave",
        ),
        optional("interface", Nested(&INTERFACE), "contact with another body"),
    ],
    one_of: &[
        "axis",
        "rigid",
        "clamped",
        "free",
        "non_reflecting",
        "interface",
    ],
};

static NON_REFLECTING: Table = table(
    "the body goes on without end",
    &[
        optional(
            "pressure",
            ANY_PRESSURE,
            "pressure far away at the start; that of the body when absent",
        ),
        optional(
            "wave",
            Nested(&WAVE),
            "a pressure step that enters through this side and stays on",
        ),
    ],
);

static WAVE: Table = table(
    "a pressure step that enters through a side and stays on",
    &[
        required("pressure", Quantity(PRESSURE, Positive), "rise of pressure"),
        default("start", Quantity(TIME, NotNegative), "0", "when it enters"),
    ],
);

static INTERFACE: Table = table(
    "contact with another body",
    &[required("with", Text, "name of the other body")],
);
