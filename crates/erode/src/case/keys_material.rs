//! The keys of a material: `materials/NAME.toml`, and `[material.NAME]` in a case.

use super::{
    keys_damage::DAMAGE,
    schema::{
        Kind::{Property, Table as Nested, Text, Texts},
        Range::{Between, NotNegative, Positive, Within},
        Table, optional, table,
    },
    units::{DENSITY, HEAT_CAPACITY, NUMBER, PRESSURE, RATE, TEMPERATURE, VELOCITY},
};

pub(crate) static MATERIAL: Table = table(
    "a material",
    &[
        optional("title", Text, "what it is"),
        optional("notes", Text, "what a user should know"),
        optional(
            "sources",
            Texts,
            "where the numbers come from; each number names one of these",
        ),
        optional(
            "missing",
            Texts,
            "properties that the sources do not give, and why",
        ),
        optional("fluid", Nested(&FLUID), "as a liquid"),
        optional("solid", Nested(&SOLID), "as a solid"),
    ],
);

static FLUID: Table = table(
    "a liquid",
    &[optional("tait", Nested(&TAIT), "Tait equation of state")],
);

pub(crate) static TAIT: Table = table(
    "Tait equation of state, p = rho0 c0^2/gamma ((rho/rho0)^gamma - 1)",
    &[
        optional(
            "reference_density",
            Property(DENSITY, Positive),
            "density at zero pressure, rho0",
        ),
        optional(
            "sound_speed",
            Property(VELOCITY, Positive),
            "sound speed at zero pressure, c0",
        ),
        optional("gamma", Property(NUMBER, Within(1.01, 20.0)), "exponent"),
    ],
);

static SOLID: Table = table(
    "a solid",
    &[
        optional("density", Property(DENSITY, Positive), "density at rest"),
        optional("elastic", Nested(&ELASTIC), "isotropic elasticity"),
        optional("strength", Nested(&STRENGTH), "yield law"),
        optional("damage", Nested(&DAMAGE), "damage law"),
    ],
);

pub(crate) static ELASTIC: Table = table(
    "isotropic elasticity",
    &[
        optional(
            "young_modulus",
            Property(PRESSURE, Positive),
            "Young's modulus",
        ),
        optional(
            "poisson_ratio",
            Property(NUMBER, Between(-1.0, 0.5)),
            "Poisson's ratio",
        ),
    ],
);

pub(crate) static STRENGTH: Table = Table {
    about: "yield law",
    keys: &[
        optional("elastic", Nested(&EMPTY), "never yields"),
        optional(
            "perfectly_plastic",
            Nested(&PERFECTLY_PLASTIC),
            "constant yield stress",
        ),
        optional(
            "linear_hardening",
            Nested(&LINEAR_HARDENING),
            "yield stress growing linearly with plastic strain",
        ),
        optional(
            "johnson_cook",
            Nested(&JOHNSON_COOK),
            "(a + b eps^n)(1 + c ln(rate/reference_rate))(1 - T*^m)",
        ),
    ],
    one_of: &[
        "elastic",
        "perfectly_plastic",
        "linear_hardening",
        "johnson_cook",
    ],
};

static EMPTY: Table = table("no keys", &[]);

static PERFECTLY_PLASTIC: Table = table(
    "constant yield stress",
    &[optional(
        "yield_stress",
        Property(PRESSURE, Positive),
        "yield stress",
    )],
);

static LINEAR_HARDENING: Table = table(
    "yield stress growing linearly with plastic strain",
    &[
        optional(
            "yield_stress",
            Property(PRESSURE, Positive),
            "yield stress at zero plastic strain",
        ),
        optional(
            "hardening_modulus",
            Property(PRESSURE, NotNegative),
            "slope of the yield stress",
        ),
    ],
);

static JOHNSON_COOK: Table = table(
    "Johnson-Cook yield stress, (a + b eps^n)(1 + c ln(rate/reference_rate))(1 - T*^m)",
    &[
        optional(
            "a",
            Property(PRESSURE, Positive),
            "yield stress at zero plastic strain",
        ),
        optional("b", Property(PRESSURE, NotNegative), "hardening"),
        optional(
            "n",
            Property(NUMBER, Within(0.01, 2.0)),
            "hardening exponent",
        ),
        optional("c", Property(NUMBER, Within(0.0, 0.2)), "rate coefficient"),
        optional(
            "reference_rate",
            Property(RATE, Positive),
            "plastic strain rate at which c has no effect",
        ),
        optional(
            "m",
            Property(NUMBER, Positive),
            "exponent of thermal softening",
        ),
        optional(
            "reference_temperature",
            Property(TEMPERATURE, Positive),
            "temperature at the start",
        ),
        optional(
            "melting_temperature",
            Property(TEMPERATURE, Positive),
            "temperature without strength",
        ),
        optional(
            "heat_capacity",
            Property(HEAT_CAPACITY, Positive),
            "specific heat capacity",
        ),
        optional(
            "taylor_quinney",
            Property(NUMBER, Within(0.0, 1.0)),
            "share of plastic work that heats",
        ),
    ],
);
