//! The keys of damage laws, in materials and bodies.

use super::{
    schema::{
        Kind::{Property, Table as Nested},
        Range::{Any, NotNegative, Positive},
        Table, optional, table,
    },
    units::{NUMBER, RATE},
};

pub(crate) static DAMAGE: Table = Table {
    about: "damage law: when material fails and is removed",
    keys: &[
        optional(
            "rupture_strain",
            Nested(&RUPTURE_STRAIN),
            "fails at a plastic strain, sound until then",
        ),
        optional(
            "linear_modulus_loss",
            Nested(&RUPTURE_STRAIN),
            "fails at a plastic strain; modulus and stress fall linearly until then (Joshi 2018, eq. 4.8)",
        ),
        optional(
            "johnson_cook",
            Nested(&JOHNSON_COOK_DAMAGE),
            "failure strain (d1 + d2 exp(d3 sigma*))(1 + d4 ln(rate/reference_rate))(1 + d5 T*)",
        ),
    ],
    one_of: &["rupture_strain", "linear_modulus_loss", "johnson_cook"],
};

static RUPTURE_STRAIN: Table = table(
    "fails at a plastic strain",
    &[optional(
        "rupture_strain",
        Property(NUMBER, Positive),
        "equivalent plastic strain at failure",
    )],
);

static JOHNSON_COOK_DAMAGE: Table = table(
    "Johnson-Cook damage; T* by the temperatures of the Johnson-Cook yield law",
    &[
        optional("d1", Property(NUMBER, Any), "failure strain without D2"),
        optional(
            "d2",
            Property(NUMBER, NotNegative),
            "share that triaxiality changes",
        ),
        optional(
            "d3",
            Property(NUMBER, Any),
            "exponent of mean stress/von Mises stress, negative where tension makes brittle",
        ),
        optional("d4", Property(NUMBER, Any), "rate coefficient"),
        optional("d5", Property(NUMBER, Any), "temperature coefficient"),
        optional(
            "reference_rate",
            Property(RATE, Positive),
            "plastic strain rate at which d4 has no effect",
        ),
    ],
);
