//! The keys of bubbles in a liquid that is given: `[setup.single_bubble]` and what it shares with other setups of bubbles.

use super::{
    schema::{
        Kind::Quantity,
        Range::{Any, Between, NotNegative, Positive, Within},
        Table, default, optional, required, table,
    },
    units::{DENSITY, LENGTH, NUMBER, PRESSURE, RATE, SURFACE_TENSION, TIME, VELOCITY, VISCOSITY},
};
use crate::case::schema::Kind::Table as Nested;

pub(crate) static SINGLE_BUBBLE: Table = table(
    "one spherical bubble of gas and vapour in unbounded liquid whose pressure is given over time",
    &[
        required("radius", Quantity(LENGTH, Positive), "radius at the start"),
        default(
            "wall_velocity",
            Quantity(VELOCITY, Any),
            "0",
            "rate of the radius at the start, positive in growth",
        ),
        required(
            "ambient_pressure",
            Nested(&AMBIENT_PRESSURE),
            "pressure of the liquid far from the bubble",
        ),
        default(
            "gas",
            Nested(&GAS),
            "equilibrium",
            "permanent gas in the bubble",
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
            "1e-10",
            "error allowed in each step, relative to radius and wall velocity",
        ),
    ],
);

static AMBIENT_PRESSURE: Table = Table {
    about: "pressure of the liquid over time",
    keys: &[
        optional("constant", Nested(&CONSTANT), "the same at all times"),
        optional(
            "sine",
            Nested(&SINE),
            "mean - amplitude sin(2 pi frequency t)",
        ),
        optional(
            "ramp",
            Nested(&RAMP),
            "one pressure, then a straight line to another",
        ),
    ],
    one_of: &["constant", "sine", "ramp"],
};

static CONSTANT: Table = table(
    "the same pressure at all times",
    &[required("pressure", Quantity(PRESSURE, Any), "pressure")],
);

static SINE: Table = table(
    "an acoustic wave, first below its mean: mean - amplitude sin(2 pi frequency t)",
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

static RAMP: Table = table(
    "one pressure until a time, then a straight line to another that stays",
    &[
        required("from", Quantity(PRESSURE, Any), "pressure before"),
        required("to", Quantity(PRESSURE, Any), "pressure afterwards"),
        default(
            "start",
            Quantity(TIME, NotNegative),
            "0",
            "when it begins to change",
        ),
        required("duration", Quantity(TIME, Positive), "how long it changes"),
    ],
);

pub(crate) static GAS: Table = Table {
    about: "permanent gas in a bubble, p = p0 (R0/R)^(3 k)",
    keys: &[
        optional(
            "equilibrium",
            Nested(&EQUILIBRIUM),
            "as much gas as keeps a bubble at rest",
        ),
        optional("given", Nested(&GIVEN), "pressure of the gas at a radius"),
    ],
    one_of: &["equilibrium", "given"],
};

/// Polytropic exponents.
pub(super) const EXPONENT: super::schema::Kind = Quantity(NUMBER, Within(1.0, 5.0 / 3.0));
const ABOUT_EXPONENT: &str = "polytropic exponent k of the gas: 1 isothermal, 4/3 or 1.4 adiabatic";

static EQUILIBRIUM: Table = table(
    "gas of a bubble that rests at a radius and a pressure of the liquid",
    &[
        optional(
            "radius",
            Quantity(LENGTH, Positive),
            "radius of that bubble; that at the start when absent",
        ),
        optional(
            "pressure",
            Quantity(PRESSURE, Any),
            "pressure of the liquid around it; that at the start when absent",
        ),
        default(
            "polytropic_exponent",
            EXPONENT,
            "1.3333333333333333",
            ABOUT_EXPONENT,
        ),
    ],
);

static GIVEN: Table = table(
    "gas by its pressure at a radius",
    &[
        required(
            "pressure",
            Quantity(PRESSURE, NotNegative),
            "pressure of the gas, zero for a bubble of vapour alone",
        ),
        optional(
            "radius",
            Quantity(LENGTH, Positive),
            "radius at which it has this pressure; that at the start when absent",
        ),
        default(
            "polytropic_exponent",
            EXPONENT,
            "1.3333333333333333",
            ABOUT_EXPONENT,
        ),
    ],
);

pub(crate) static LIQUID: Table = table(
    "constants of the liquid; the defaults are those of water at 20 C (surface tension of Peters and el Moctar 2020)",
    &[
        default("density", Quantity(DENSITY, Positive), "998.2", "density"),
        default(
            "sound_speed",
            Quantity(VELOCITY, Positive),
            "1482",
            "sound speed",
        ),
        default(
            "viscosity",
            Quantity(VISCOSITY, NotNegative),
            "1e-3",
            "dynamic viscosity",
        ),
        default(
            "surface_tension",
            Quantity(SURFACE_TENSION, NotNegative),
            "0.0725",
            "surface tension",
        ),
        default(
            "vapour_pressure",
            Quantity(PRESSURE, NotNegative),
            "2337",
            "vapour pressure",
        ),
    ],
);

static NO_KEYS: Table = table("no keys", &[]);

pub(crate) static MODEL: Table = Table {
    about: "law of the radius of a spherical bubble",
    keys: &[
        optional(
            "rayleigh_plesset",
            Nested(&NO_KEYS),
            "incompressible liquid",
        ),
        optional(
            "keller_miksis",
            Nested(&NO_KEYS),
            "compressible to first order in the Mach number",
        ),
        optional(
            "gilmore",
            Nested(&GILMORE),
            "compressible with the enthalpy of the liquid",
        ),
        optional(
            "tomita_shima",
            Nested(&DENSITY_FACTOR),
            "compressible, eq. 3.37 of the source",
        ),
        optional(
            "switching",
            Nested(&DENSITY_FACTOR),
            "Rayleigh-Plesset in growth, Tomita-Shima in collapse, as in the source",
        ),
    ],
    one_of: &[
        "rayleigh_plesset",
        "keller_miksis",
        "gilmore",
        "tomita_shima",
        "switching",
    ],
};

static GILMORE: Table = table(
    "Gilmore's law with Tait's equation of state",
    &[
        default(
            "tait_exponent",
            Quantity(NUMBER, Between(1.0, 20.0)),
            "7",
            "exponent of Tait's equation",
        ),
        default(
            "reference_pressure",
            Quantity(PRESSURE, Any),
            "1e5",
            "pressure at which the liquid has its density and sound speed",
        ),
    ],
);

static DENSITY_FACTOR: Table = table(
    "Tomita-Shima's law",
    &[default(
        "density_factor",
        Quantity(NUMBER, Within(0.5, 1.0)),
        "0.99881",
        "1 - density of the bubble / density of the liquid",
    )],
);
