//! The flow of a cloud of bubbles, chosen by the case.

use super::{node::Fields, resolved::Item};
use erode_fv::bubbles::carrier::{
    Acoustic, Carrier, CarrierError, CarrierPoint, LambOseen, Stagnation, Still, VortexForm,
    WallPoint, Wave,
};
use erode_physics::bubble::Liquid;
use serde::{Deserialize, Serialize};

/// A flow with its liquid; with a wall the liquid is above z = 0.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Flow {
    kind: Kind,
    density: f64,
    viscosity: f64,
    sound_speed: f64,
    gravity: f64,
    wall: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Kind {
    Still {
        pressure: f64,
    },
    Acoustic {
        mean: f64,
        amplitude: f64,
        frequency: f64,
    },
    Vortex {
        circulation: f64,
        core_radius: f64,
        far_pressure: f64,
        balanced: bool,
    },
    Stagnation {
        strain_rate: f64,
        pressure: f64,
    },
}

impl Flow {
    /// Reads `flow`; `gravity` along z, m/s2.
    pub(super) fn read(f: Fields<'_>, liquid: &Liquid, wall: bool, gravity: f64) -> Option<Self> {
        let (name, k) = f.chosen("flow")?;
        let kind = match name {
            "still" => Kind::Still {
                pressure: k.number("pressure")?,
            },
            "acoustic" => Kind::Acoustic {
                mean: k.number("mean")?,
                amplitude: k.number("amplitude")?,
                frequency: k.number("frequency")?,
            },
            "vortex" => Kind::Vortex {
                circulation: k.number("circulation")?,
                core_radius: k.number("core_radius")?,
                far_pressure: k.number("far_pressure")?,
                balanced: k.switch("balanced")?,
            },
            _ => Kind::Stagnation {
                strain_rate: k.number("strain_rate")?,
                pressure: k.number("pressure")?,
            },
        };
        Some(Self {
            kind,
            density: liquid.density,
            viscosity: liquid.viscosity,
            sound_speed: liquid.sound_speed,
            gravity,
            wall,
        })
    }

    /// What `resolved.toml` says of it.
    pub(super) fn item(&self) -> Item {
        let number = |key, x| (key, Item::Number(x));
        let (name, keys) = match self.kind {
            Kind::Still { pressure } => ("still", vec![number("pressure", pressure)]),
            Kind::Acoustic {
                mean,
                amplitude,
                frequency,
            } => (
                "acoustic",
                vec![
                    number("mean", mean),
                    number("amplitude", amplitude),
                    number("frequency", frequency),
                ],
            ),
            Kind::Vortex {
                circulation,
                core_radius,
                far_pressure,
                balanced,
            } => (
                "vortex",
                vec![
                    number("circulation", circulation),
                    number("core_radius", core_radius),
                    number("far_pressure", far_pressure),
                    ("balanced", Item::Switch(balanced)),
                ],
            ),
            Kind::Stagnation {
                strain_rate,
                pressure,
            } => (
                "stagnation",
                vec![
                    number("strain_rate", strain_rate),
                    number("pressure", pressure),
                ],
            ),
        };
        Item::Table(vec![(name, Item::Table(keys))])
    }

    /// Calls `f` with the flow.
    fn with<R>(&self, f: impl Fn(&dyn Carrier) -> R) -> R {
        let (density, viscosity) = (self.density, self.viscosity);
        match self.kind {
            Kind::Still { pressure } => {
                let gravity = [0.0, 0.0, self.gravity];
                f(&Still {
                    pressure,
                    density,
                    viscosity,
                    gravity,
                })
            }
            Kind::Acoustic {
                mean,
                amplitude,
                frequency,
            } => f(&Acoustic {
                wave: Wave::Uniform,
                mean,
                amplitude,
                frequency,
                density,
                sound_speed: self.sound_speed,
                viscosity,
            }),
            Kind::Vortex {
                circulation,
                core_radius,
                far_pressure,
                balanced,
            } => f(&LambOseen {
                form: if balanced {
                    VortexForm::Balanced
                } else {
                    VortexForm::OuterSpeedCorrected
                },
                circulation,
                core_radius,
                far_pressure,
                density,
                viscosity,
            }),
            Kind::Stagnation {
                strain_rate,
                pressure,
            } => f(&Stagnation {
                strain_rate,
                pressure,
                density,
                viscosity,
            }),
        }
    }
}

impl Carrier for Flow {
    fn at(&self, position: [f64; 3], time: f64) -> Result<CarrierPoint, CarrierError> {
        if self.wall && position[2] < 0.0 {
            return Err(CarrierError::Outside { position });
        }
        self.with(|flow| flow.at(position, time))
    }

    fn wall(&self, position: [f64; 3]) -> Option<WallPoint> {
        let own = self.wall.then_some(WallPoint {
            distance: position[2],
            normal: [0.0, 0.0, 1.0],
        });
        own.or_else(|| self.with(|flow| flow.wall(position)))
    }

    fn length_scale(&self, position: [f64; 3]) -> f64 {
        self.with(|flow| flow.length_scale(position))
    }

    fn time_scale(&self) -> f64 {
        self.with(|flow| flow.time_scale())
    }
}
